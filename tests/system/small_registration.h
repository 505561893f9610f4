#ifndef PROSUP_TESTS_SMALL_REGISTRATION_H
#define PROSUP_TESTS_SMALL_REGISTRATION_H

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "program.h"

namespace prosup::tests {

using Json = nlohmann::json;

inline Json read_json(const std::filesystem::path& file) {
  return Json::parse(contents(file));
}

/// Runs `prosup register prm/tests/small.prm` once on 1 rank and once on 2, when
/// first asked for, and keeps the results until the program ends.
class SmallRegistration {
public:
  struct Result {
    std::filesystem::path folder;
    ProgramRun run;
    Json summary;
  };

  static const Result& on_ranks(unsigned n_ranks) {
    static SmallRegistration results;
    Result& result = results.results_[n_ranks - 1];
    if (result.folder.empty()) {
      result.folder = results.folder_ / ("on_" + std::to_string(n_ranks));
      result.run = run_prosup(
          {"register", PROSUP_PRM_FOLDER "/tests/small.prm", "--output", result.folder}, n_ranks);
      if (result.run.exit_code != 0)
        throw std::runtime_error("the registration failed: " + result.run.transcript());
      result.summary = read_json(result.folder / "summary.json");
    }
    return result;
  }

private:
  TemporaryFolder folder_;
  Result results_[2];
};

} // namespace prosup::tests

#endif
