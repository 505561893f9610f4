#include "prosup/output/hdf5_file.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include "expect_error.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

namespace fs = std::filesystem;
using output::Hdf5Reader;
using output::Hdf5Writer;

constexpr const char* kind = "test";
constexpr const char* advice = "write it again";

/// A folder that all ranks share, and what they write to it.
class Hdf5File : public ::testing::Test {
protected:
  Hdf5File() {
    path_ = dealii::Utilities::MPI::broadcast(world_, (own_ / "").string());
    file_ = fs::path(path_) / "numbers.h5";
  }
  ~Hdf5File() override { MPI_Barrier(world_); }

  /// Rank r has r + 1 rows of a table with two columns; the last one has all integers.
  void write(double offset = 0.) const {
    Hdf5Writer file(file_, kind, world_);
    std::vector<double> mine;
    for (unsigned i = 0; i < 2 * (rank_ + 1); ++i)
      mine.push_back(offset + 100. * rank_ + i);
    file.rows("group/deeper/table", mine, 2);
    file.rows("integers", rank_ + 1 == n_ranks_ ? std::vector<unsigned>{7, 8, 4000000000u}
                                                : std::vector<unsigned>());
    file.rows("group/floats", std::vector<float>{0.1f * static_cast<float>(rank_)});
    file.rows("nothing", std::vector<double>(), 3);
    file.number("group/third", 1. / 3.);
    file.text("group/words", "Größe = 3\nzwei Zeilen");
    file.commit();
  }

  Hdf5Reader read(const std::string& wanted = kind) const {
    return {file_, wanted, world_, advice};
  }

  /// Changes the file on one rank.
  template <typename Work>
  void on_first(const Work& work) const {
    if (rank_ == 0)
      work();
    MPI_Barrier(world_);
  }

  MPI_Comm world_ = MPI_COMM_WORLD;
  unsigned rank_ = dealii::Utilities::MPI::this_mpi_process(world_),
           n_ranks_ = dealii::Utilities::MPI::n_mpi_processes(world_);
  const TemporaryFolder own_;
  std::string path_;
  fs::path file_;
};

TEST_F(Hdf5File, EveryRankReadsWhatAllWrote) {
  write();
  const Hdf5Reader file = read();
  std::vector<double> expected;
  for (unsigned rank = 0; rank < n_ranks_; ++rank)
    for (unsigned i = 0; i < 2 * (rank + 1); ++i)
      expected.push_back(100. * rank + i);
  EXPECT_EQ(file.doubles("group/deeper/table"), expected);
  EXPECT_EQ(file.integers("integers"), (std::vector<unsigned>{7, 8, 4000000000u}));
  EXPECT_EQ(file.floats("group/floats").size(), n_ranks_);
  EXPECT_EQ(file.floats("group/floats").back(), 0.1f * static_cast<float>(n_ranks_ - 1));
  EXPECT_TRUE(file.doubles("nothing").empty());
  EXPECT_EQ(file.number("group/third"), 1. / 3.);
  EXPECT_EQ(file.text("group/words"), "Größe = 3\nzwei Zeilen");
  EXPECT_EQ(file.data_sets("group"), std::vector<std::string>{"floats"});
  EXPECT_EQ(file.attributes("group"), (std::vector<std::string>{"third", "words"}));
  EXPECT_TRUE(file.data_sets("group/missing").empty());
}

TEST_F(Hdf5File, ReadingLeavesTheFileAsItIs) {
  write();
  const std::string before = contents(file_);
  on_first([&] { fs::permissions(file_, fs::perms::owner_read); });
  read();
  EXPECT_EQ(contents(file_), before);
}

TEST_F(Hdf5File, ANewOneTakesThePlaceOfTheOldOne) {
  write();
  write(1000.);
  EXPECT_EQ(read().doubles("group/deeper/table").front(), 1000.);
}

TEST_F(Hdf5File, WithoutCommitNothingChanges) {
  write();
  {
    Hdf5Writer file(file_, kind, world_);
    file.rows("other", std::vector<double>(1000, 1.));
  }
  MPI_Barrier(world_);
  EXPECT_EQ(read().number("group/third"), 1. / 3.);
  EXPECT_EQ(std::distance(fs::directory_iterator(path_), fs::directory_iterator()), 1);
}

TEST_F(Hdf5File, AnyChangedByteIsNoticed) {
  write();
  const std::uintmax_t size = fs::file_size(file_);
  for (const std::uintmax_t at : {std::uintmax_t(0), size / 3, size / 2, size - 30, size - 5}) {
    const auto flip = [&] {
      std::fstream stream(file_, std::ios::binary | std::ios::in | std::ios::out);
      stream.seekg(static_cast<std::streamoff>(at));
      const int byte = stream.get();
      stream.seekp(static_cast<std::streamoff>(at));
      stream.put(static_cast<char>(byte ^ 4));
    };
    on_first(flip);
    expect_error([&] { read(); }, {"numbers.h5", "damaged", advice});
    MPI_Barrier(world_);
    on_first(flip);
  }
  EXPECT_EQ(read().number("group/third"), 1. / 3.);
}

TEST_F(Hdf5File, FilesThatAreNoneAreRefused) {
  expect_error([&] { read(); }, {"numbers.h5", "does not exist", advice});
  write();
  expect_error([&] { read("registration"); }, {"holds a test and no registration", advice});
  const Hdf5Reader file = read();
  expect_error([&] { file.doubles("group/absent"); }, {"lacks 'group/absent'", advice});
  expect_error([&] { file.number("absent/absent"); }, {"lacks 'absent/absent'"});
  for (const std::uintmax_t size : {std::uintmax_t(0), std::uintmax_t(10), std::uintmax_t(500)}) {
    on_first([&] { fs::resize_file(file_, size); });
    expect_error([&] { read(); }, {"numbers.h5", "damaged", advice});
    MPI_Barrier(world_);
  }
}

TEST_F(Hdf5File, AFolderThatIsNotThereIsNamed) {
  file_ = fs::path(path_) / "missing" / "numbers.h5";
  expect_error([&] { write(); }, {"missing", "cannot be written"});
}

// A limit of the file size fails as a full disk does. deal.II's assertions would end the program.
#ifndef DEBUG
TEST_F(Hdf5File, AFullDiskIsAnErrorAndLeavesTheOldFile) {
  write();
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit limit = before;
  limit.rlim_cur = 100000;
  setrlimit(RLIMIT_FSIZE, &limit);
  expect_error(
      [&] {
        Hdf5Writer file(file_, kind, world_);
        file.rows("much", std::vector<double>(100000, 1.));
        file.number("little", 1.);
        file.commit();
      },
      {"numbers.h5", "cannot be written", "disk"});
  setrlimit(RLIMIT_FSIZE, &before);
  MPI_Barrier(world_);
  EXPECT_EQ(read().number("group/third"), 1. / 3.);
}
#endif

} // namespace
} // namespace prosup::tests
