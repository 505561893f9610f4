#include "prosup/core/collective.h"

#include <gtest/gtest.h>

#include <string>

namespace prosup::tests {
namespace {

int rank() {
  int r = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &r);
  return r;
}

int n_ranks() {
  int n = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &n);
  return n;
}

TEST(Collective, AllRanksThrowWhatOneThrows) {
  const int last = n_ranks() - 1;
  try {
    prosup::on_every_rank(MPI_COMM_WORLD, [&] {
      if (rank() == last)
        throw prosup::Error("from the last rank");
    });
    FAIL();
  } catch (const prosup::Error& error) {
    EXPECT_EQ(std::string(error.what()), "from the last rank");
  }
}

TEST(Collective, OnRootRunsOnOneRank) {
  int n_runs = 0;
  prosup::on_root(MPI_COMM_WORLD, [&] { ++n_runs; });
  EXPECT_EQ(n_runs, rank() == 0 ? 1 : 0);
  EXPECT_THROW(prosup::on_root(MPI_COMM_WORLD, [] { throw prosup::Error("x"); }), prosup::Error);
}

TEST(Collective, TransferCopiesBetweenTwoRanks) {
  const int last = n_ranks() - 1;
  std::vector<double> values;
  if (rank() == last)
    values = {1., 2., 3.};
  if (rank() == 0 || rank() == last)
    prosup::transfer(values, last, 0, MPI_COMM_WORLD);
  if (rank() == 0) {
    EXPECT_EQ(values, (std::vector<double>{1., 2., 3.}));
  }
}

} // namespace
} // namespace prosup::tests
