// Unloads bodies that are hard to unload, compares with Newton's method, and
// writes docs/stability.md. Fails if a case comes to anything but what is
// expected of it.

#include <iostream>

#include "../setup.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "table.h"

using namespace prosup;
using namespace prosup::benchmarks;

int main(int argc, char** argv) {
  CLI::App app{"Unloads bodies that are hard to unload.", "benchmark_hard_cases"};
  bool is_small = false;
  std::string only, file;
  app.add_flag("--small", is_small, "Small meshes, as in the tests");
  app.add_option("--case", only, "Runs the case of this name only");
  app.add_option("--write", file, "Writes the page with the table to this file");
  return run_program(argc, argv, app, [&] {
    const bool is_root = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    const Size size = is_small ? Size::small : Size::full;
    std::string page = page_head(size), failures;
    unsigned n_run = 0;
    for (const Case& hard_case : hard_cases()) {
      if (!only.empty() && hard_case.name != only)
        continue;
      const Result result = run(hard_case, size);
      ++n_run;
      page += row(hard_case, result);
      if (!result.as_expected)
        failures += (failures.empty() ? "" : ", ") + hard_case.name;
      if (is_root) {
        std::cout << row(hard_case, result) << std::flush;
        std::cerr << format("%.2f s, Newton's part of the weight %.3f\n", result.seconds,
                            result.newton_fraction);
      }
    }
    if (n_run == 0)
      throw Error("There is no hard case named '" + only + "'; --help lists the options.");
    if (!file.empty() && is_root)
      std::ofstream(file) << page;
    if (!failures.empty())
      throw Error("These hard cases came to something else than expected: " + failures + ".");
  });
}
