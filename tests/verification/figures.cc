#include "figures.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cstdio>

namespace prosup::tests {

void tell_figure(const std::string& what, const std::string& against, const std::string& measured,
                 const std::string& bound) {
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return;
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  std::printf("| %s | %s | %s | %s | %s.%s |\n", what.c_str(), against.c_str(), measured.c_str(),
              bound.c_str(), test->test_suite_name(), test->name());
}

} // namespace prosup::tests
