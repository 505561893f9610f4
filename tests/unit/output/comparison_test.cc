#include "prosup/output/comparison.h"

#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

using namespace prosup::output;

ComparisonRow row(const std::string& group, const std::string& name, double seconds, double error) {
  ComparisonRow result;
  result.group = group;
  result.name = name;
  result.status = "ok";
  result.seconds = result.least_seconds = result.most_seconds = seconds;
  result.error = evaluation::ErrorStatistics{error, 0.1, 3. * error, 2. * error, 10};
  return result;
}

Comparison comparison() {
  Comparison result{"study", "a & b", {{"cores", "2"}}, {}, "time", "", {"mean"}, true};
  result.rows = {row("FE", "10", 1., 2.), row("FE", "5", 10., 0.5), row("other", "x", 20., 1.)};
  ComparisonRow failed;
  failed.group = "other";
  failed.name = "bad";
  failed.status = "failed";
  failed.message = "It said \"no\", and stopped.";
  result.rows.push_back(failed);
  return result;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++n;
  return n;
}

TEST(Comparison, HasOneRowPerRunAndTellsWhatFailed) {
  const TemporaryFolder folder;
  write_comparison(comparison(), folder / "");
  const std::string csv = contents(folder / "study.csv");
  EXPECT_EQ(count(csv, "\n"), 5u);
  EXPECT_NE(csv.find("FE,10,1,ok,1,1,1,,,2,0.1,4,6,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\"It said \"\"no\"\", and stopped.\""), std::string::npos) << csv;
  const std::string table = contents(folder / "study.md");
  EXPECT_NE(table.find("| FE | 5 | 1 | 10.0 | 0.500 | 1.00 | 1.50 | ok |"), std::string::npos)
      << table;
  EXPECT_NE(table.find("- other/bad, 1: It said"), std::string::npos) << table;
  EXPECT_EQ(table.find("cells"), std::string::npos) << "a column that no run fills";
}

TEST(Comparison, QuotesInCsvWhatHasToBe) {
  const TemporaryFolder folder;
  Comparison with_words = comparison();
  with_words.rows.front().group = "FE, fine";
  with_words.rows.front().name = "#\"1\"";
  with_words.rows.back().message = "=1+1\nis no error";
  write_comparison(with_words, folder / "");
  const std::string csv = contents(folder / "study.csv");
  EXPECT_NE(csv.find("\n\"FE, fine\",\"#\"\"1\"\"\",1,ok,1,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",\"'=1+1\nis no error\"\n"), std::string::npos)
      << "words of a program must not be a formula: " << csv;
}

TEST(Comparison, PictureHasASignPerRunAndTheFrontOfTheBest) {
  const TemporaryFolder folder;
  write_comparison(comparison(), folder / "");
  const std::string picture = contents(folder / "study.svg");
  EXPECT_EQ(count(picture, "<circle"), 3u);  // two runs, one beside the name
  EXPECT_EQ(count(picture, "<polygon"), 2u); // one run, one beside the name
  EXPECT_NE(picture.find("a &amp; b"), std::string::npos);
  EXPECT_EQ(count(picture, "nan"), 0u);
  const std::size_t front = picture.find("stroke-dasharray");
  ASSERT_NE(front, std::string::npos);
  const std::size_t begin = picture.find("points=\"", front) + 8;
  const std::string points = picture.substr(begin, picture.find('"', begin) - begin);
  EXPECT_EQ(count(points, ","), 2u) << "the third run is slower and worse: " << points;
}

TEST(Comparison, PictureNamesTheQuantityOfTheXAxisOrWhatIsAskedFor) {
  Comparison named = comparison();
  const TemporaryFolder folder;
  write_comparison(named, folder / "");
  EXPECT_NE(contents(folder / "study.svg").find(">wall time, s<"), std::string::npos);
  named.x_label = "edge length, mm";
  write_comparison(named, folder / "");
  const std::string picture = contents(folder / "study.svg");
  EXPECT_NE(picture.find(">edge length, mm<"), std::string::npos);
  EXPECT_EQ(picture.find(">wall time, s<"), std::string::npos);
}

TEST(Comparison, RefusesWhatIsNotFinite) {
  const TemporaryFolder folder;
  Comparison bad = comparison();
  bad.rows[1].min_jacobian = NAN;
  expect_error([&] { write_comparison(bad, folder / ""); }, {"min_jacobian", "FE/5"});
}

TEST(Comparison, RefusesAnAxisThatIsNotKnown) {
  expect_error([] { comparison_quantity("beauty"); }, {"beauty", "mean", "cells"});
}

// Meshing takes 0.5 n, solving 2 n^1.5 r^-0.8, the rest 4 + 0.1 n; memory is 100 r + 3 n.
TEST(CostModel, FindsTheLawThatMadeTheRows) {
  std::vector<ComparisonRow> rows;
  for (const double cells : {1e3, 5e3, 2e4})
    for (const unsigned ranks : {1u, 2u, 4u}) {
      const double n = cells / 1000.;
      const double solve = 2. * std::pow(n, 1.5) * std::pow(ranks, -0.8);
      rows.push_back(row("FE", "", 4. + 0.6 * n + solve, 1.));
      rows.back().mesh_seconds = 0.5 * n;
      rows.back().solve_seconds = solve;
      rows.back().cells = cells;
      rows.back().ranks = ranks;
      rows.back().memory = 100. * ranks + 3. * n;
    }
  const std::string models = cost_models(rows);
  EXPECT_NE(models.find("| FE | 4.00 + 0.100 n | 0.5 n^1.00 r^"), std::string::npos) << models;
  EXPECT_NE(models.find(" | 2 n^1.50 r^-0.80 | 100 r + 3.00 n |"), std::string::npos) << models;
  rows.resize(3); // one mesh only
  EXPECT_EQ(cost_models(rows), "");
}

} // namespace
} // namespace prosup::tests
