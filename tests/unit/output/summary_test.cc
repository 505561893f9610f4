#include "prosup/output/summary.h"

#include <gtest/gtest.h>

#include <limits>

#include "expect_error.h"
#include "prosup/core/version.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

using namespace prosup::output;

Summary complete_summary() {
  Summary s;
  s.command = "register";
  s.ranks = 2;
  s.breasts.prone = BreastSummary{100, 30, 0.25, 0.5, 1.5};
  s.breasts.supine = BreastSummary{200, 60, 0.125, 0.75, 2.};
  s.quality = QualitySummary{
      "doubtful", {"Look here."}, {{"chest.median", 0.5}, {"chest.p95", 1.5}, {"unloaded.x", 2.}}};
  s.steps = 4000;
  s.similarity = {{"image_forces", 4., 7, 0.5}};
  s.shear_modulus = 325.;
  s.lambda = 1300.;
  s.tre.initial = evaluation::ErrorStatistics{20., 15., 58., 50., 500};
  s.tre.image_forces = evaluation::ErrorStatistics{0.5, 0.25, 3., 1., 500};
  s.time = {1., 2., 3., 4., 10.};
  s.peak_memory = 512.;
  s.converged = true;
  s.warnings = {"landmark \"7\" lies outside"};
  return s;
}

TEST(Summary, HoldsTheAgreedEntries) {
  const TemporaryFolder folder;
  write_summary(complete_summary(), folder / "summary.json");
  EXPECT_EQ(contents(folder / "summary.json"),
            std::string("{\n  \"version\": \"") + version() + R"(",
  "command": "register",
  "ranks": 2,
  "converged": true,
  "quality": {
    "verdict": "doubtful",
    "reasons": [
      "Look here."
    ],
    "chest": {
      "median": 0.5,
      "p95": 1.5
    },
    "unloaded": {
      "x": 2.0
    }
  },
  "mesh": {
    "prone": {
      "cells": 100,
      "nodes": 30,
      "min_quality": 0.25
    },
    "supine": {
      "cells": 200,
      "nodes": 60,
      "min_quality": 0.125
    }
  },
  "min_jacobian": {
    "prone": 0.5,
    "supine": 0.75
  },
  "max_jacobian": {
    "prone": 1.5,
    "supine": 2.0
  },
  "steps": 4000,
  "material": {
    "shear_modulus": 325.0,
    "lambda": 1300.0
  },
  "tre": {
    "initial": {
      "mean": 20.0,
      "std": 15.0,
      "max": 58.0,
      "p95": 50.0,
      "n": 500
    },
    "image_forces": {
      "mean": 0.5,
      "std": 0.25,
      "max": 3.0,
      "p95": 1.0,
      "n": 500
    }
  },
  "time": {
    "mesh": 1.0,
    "unloading": 2.0,
    "material": 3.0,
    "image_forces": 4.0,
    "total": 10.0
  },
  "peak_memory": 512.0,
  "warnings": [
    "landmark \"7\" lies outside"
  ],
  "similarity": [
    {
      "stage": "image_forces",
      "level_mm": 4.0,
      "iteration": 7,
      "value": 0.5
    }
  ]
}
)");
}

TEST(Summary, SaysTheVerdictWithItsReasons) {
  EXPECT_EQ(verdict_text(complete_summary()), "Verdict: doubtful\n  - Look here.");
  EXPECT_EQ(verdict_text(Summary()), "");
}

TEST(Summary, LeavesOutWhatIsNotKnown) {
  const TemporaryFolder folder;
  Summary summary;
  summary.command = "mesh";
  summary.breasts.prone = BreastSummary{1, 4, 1., {}, {}};
  write_summary(summary, folder / "summary.json");
  const std::string text = contents(folder / "summary.json");
  for (const char* absent :
       {"tre", "material", "min_jacobian", "similarity", "steps", "supine", "unloading", "null"})
    EXPECT_EQ(text.find(absent), std::string::npos) << absent << " in " << text;
  EXPECT_NE(text.find("\"warnings\": []"), std::string::npos) << text;
}

TEST(Summary, RefusesNumbersThatAreNotFinite) {
  const TemporaryFolder folder;
  const auto file = folder / "summary.json";
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const auto expect_refused = [&](const Summary& summary, const std::string& name) {
    expect_error([&] { write_summary(summary, file); }, {"'" + name + "'"});
    EXPECT_FALSE(std::filesystem::exists(file));
  };
  Summary summary = complete_summary();
  summary.tre.initial->p95 = not_a_number;
  expect_refused(summary, "tre.initial.p95");
  summary = complete_summary();
  summary.breasts.supine->min_jacobian = -std::numeric_limits<double>::infinity();
  expect_refused(summary, "min_jacobian.supine");
  summary = complete_summary();
  summary.similarity.push_back({"material", 4., 1, not_a_number});
  expect_refused(summary, "similarity.1.value");
}

TEST(Summary, FileThatCannotBeWrittenIsNamed) {
  const TemporaryFolder folder;
  expect_error([&] { write_summary(complete_summary(), folder / "no/summary.json"); },
               {"no/summary.json", "cannot be written"});
}

TEST(Summary, TableHasTheRowsThatAreKnown) {
  EXPECT_EQ(error_table(Summary{}), "");
  const std::string table = error_table(complete_summary());
  EXPECT_LT(table.find("No registration"), table.find("Image forces"));
  EXPECT_EQ(table.find("Material updated"), std::string::npos);
}

} // namespace
} // namespace prosup::tests
