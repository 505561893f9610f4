#ifndef PROSUP_TESTS_ALL_FILES_KNOWN_H
#define PROSUP_TESTS_ALL_FILES_KNOWN_H

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "program.h"

namespace prosup::tests {

/// Whether a command knows, before it computes, of all files that it has written to `result`: over
/// a copy of them without their list, which makes them foreign, it refuses to run, and says how
/// many there are.
inline void expect_all_files_known(const std::filesystem::path& result,
                                   std::vector<std::string> command) {
  const TemporaryFolder folder;
  std::filesystem::copy(result, folder / "copy", std::filesystem::copy_options::recursive);
  std::filesystem::remove(folder / "copy/.prosup-result.json");
  std::size_t n_files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "copy"))
    n_files += entry.is_regular_file();
  command.insert(command.end(), {"--output", folder / "copy"});
  const ProgramRun run = run_prosup(command);
  EXPECT_EQ(run.exit_code, 1) << run.transcript();
  EXPECT_NE(run.err.find("(" + std::to_string(n_files) + " files)"), std::string::npos)
      << n_files << " files, but: " << run.err;
}

} // namespace prosup::tests

#endif
