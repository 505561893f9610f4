#ifndef PROSUP_TESTS_REFUSED_H
#define PROSUP_TESTS_REFUSED_H

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "program.h"

namespace prosup::tests {

using Arguments = std::vector<std::string>;

inline Arguments operator+(Arguments a, const Arguments& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// The lines of `text` that start with "prosup: "; mpirun adds lines of its own.
inline std::vector<std::string> sentences(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (line.rfind("prosup: ", 0) == 0)
      found.push_back(line);
  return found;
}

/// A folder to give as the parent of --output, and what it must hold afterwards.
class Refused : public ::testing::Test {
protected:
  std::string output() const { return folder_ / "results/out"; }

  /// Expects prosup to fail with one line "prosup: ..." on standard error, which
  /// holds all of `key_words`, and to leave no results behind.
  void expect_refused(const Arguments& arguments, const std::vector<std::string>& key_words,
                      unsigned n_ranks = 1) const {
    const ProgramRun run = run_prosup(arguments, n_ranks);
    EXPECT_GT(run.exit_code, 0) << run.transcript();
    const std::vector<std::string> lines = sentences(run.err);
    ASSERT_EQ(lines.size(), 1u) << run.transcript();
    if (n_ranks == 1) {
      EXPECT_EQ(without_warnings(run.err), lines[0] + "\n") << "more than one line";
    }
    EXPECT_EQ(lines[0].find(". "), std::string::npos) << "more than one sentence: " << lines[0];
    for (const std::string& word : key_words)
      EXPECT_NE(lines[0].find(word), std::string::npos)
          << "'" << word << "' is not in: " << lines[0];
    expect_nothing_written();
  }

  void expect_nothing_written() const {
    EXPECT_FALSE(std::filesystem::exists(output()));
    if (!std::filesystem::exists(folder_ / "results"))
      return;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "results"))
      ADD_FAILURE() << "left behind: " << entry.path();
  }

  /// `prosup register` of the small case, which is right, with later arguments
  /// that make it wrong.
  Arguments registering(const Arguments& wrong) const {
    return Arguments{"register", PROSUP_PRM_FOLDER "/tests/small.prm", "--output", output()} +
           wrong;
  }

  std::string write(const std::string& name, const std::string& text) const {
    return text_file(folder_ / name, text);
  }

  const TemporaryFolder folder_;
};

} // namespace prosup::tests

#endif
