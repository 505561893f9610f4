#include "prosup/registration/scene_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "expect_error.h"
#include "half_ellipsoids.h"
#include "prosup/core/parameters.h"

namespace prosup::tests {
namespace {

using dealii::Point;
using dealii::Tensor;
using image::LabelImage;
using registration::Finding;
using registration::Inputs;
using registration::SceneCheck;
using registration::SceneReport;

constexpr HalfEllipsoid hanging{60., 60.}, lying{36., 76.}; // mm, of one volume

/// A case, and what may be done wrong with it.
struct Case {
  unsigned gland = 3;
  LabelImage prone = hanging.labels(), supine = lying.labels();
  PerPosition<Tensor<1, 3>> gravity{Tensor<1, 3>({0., -1., 0.}), Tensor<1, 3>({0., 1., 0.})};
  bool needs_same_contrast = true;
  std::function<void(Inputs&)> spoil = [](Inputs&) {};

  SceneReport check() const {
    Labels meaning;
    meaning.gland = gland;
    Inputs inputs = inputs_of(prone, supine);
    spoil(inputs);
    return SceneCheck(meaning).check_pair(inputs, gravity, needs_same_contrast);
  }
};

std::string listed(const SceneReport& report) {
  std::string text;
  for (const Finding& finding : report.findings)
    text += (finding.severity == Finding::Severity::error ? "error: " : "warning: ") +
            finding.text + "\n";
  return text + report.measures;
}

/// Expects a finding of this severity with this text.
void expect_finding(const Case& spoilt, Finding::Severity severity, const std::string& text) {
  const SceneReport report = spoilt.check();
  const bool found =
      std::any_of(report.findings.begin(), report.findings.end(), [&](const Finding& finding) {
        return finding.severity == severity && finding.text.find(text) != std::string::npos;
      });
  EXPECT_TRUE(found) << "'" << text << "' is not said:\n" << listed(report);
  for (const Finding& finding : report.findings) {
    EXPECT_EQ(finding.text.back(), '.') << finding.text;
    EXPECT_EQ(finding.text.find(". "), std::string::npos) << finding.text;
  }
}
void expect_error_finding(const Case& spoilt, const std::string& text) {
  expect_finding(spoilt, Finding::Severity::error, text);
}
void expect_warning(const Case& spoilt, const std::string& text) {
  expect_finding(spoilt, Finding::Severity::warning, text);
}

/// Labels that are changed voxel by voxel.
template <typename Change>
LabelImage changed(LabelImage labels, const Change& change) {
  for (std::size_t v = 0; v < labels.values.size(); ++v)
    labels.values[v] = change(labels.values[v], HalfEllipsoid::position(labels.grid, v));
  return labels;
}

LabelImage moved(LabelImage labels, const Tensor<1, 3>& shift) {
  labels.grid.origin += shift;
  return labels;
}

/// Turned by 180 degrees about the long axis of the patient.
LabelImage turned(LabelImage labels) {
  for (unsigned d = 0; d < 2; ++d) {
    labels.grid.direction[d][d] *= -1.;
    labels.grid.origin[d] *= -1.;
  }
  return labels;
}

template <typename T>
image::VoxelImage<T> mirrored(const image::VoxelImage<T>& original) {
  image::VoxelImage<T> result(original.grid);
  const std::size_t row = original.grid.size[0];
  for (std::size_t v = 0; v < original.values.size(); ++v)
    result.values[v - v % row + row - 1 - v % row] = original.values[v];
  return result;
}

TEST(SceneCheck, RightSceneHasNoFinding) {
  const SceneReport report = Case().check();
  EXPECT_TRUE(report.findings.empty()) << listed(report);
  EXPECT_EQ(report.n_errors(), 0u);
}

TEST(SceneCheck, ProneAndSupineExchanged) {
  Case spoilt;
  std::swap(spoilt.prone, spoilt.supine);
  expect_error_finding(spoilt, "exchanged");
}

TEST(SceneCheck, Gravity) {
  Case spoilt;
  spoilt.gravity.prone *= -1.;
  expect_error_finding(spoilt, "'Case/Prone gravity' is 180 degrees off");
  spoilt = Case();
  spoilt.gravity.supine = Tensor<1, 3>({0., -1., 0.}); // both hang
  expect_error_finding(spoilt, "'Case/Supine gravity' is 180 degrees off");
  spoilt.gravity.supine = Tensor<1, 3>({1., 0.2, 0.});
  expect_warning(spoilt, "'Case/Supine gravity'");
  Case tilted;
  tilted.gravity.supine = Tensor<1, 3>({0.3, 1., -0.2});
  EXPECT_TRUE(tilted.check().findings.empty()) << listed(tilted.check());
}

// Two images of one position, of which one takes the place of the other.
TEST(SceneCheck, BothMayHang) {
  Case twice;
  twice.supine = twice.prone;
  twice.gravity.supine = twice.gravity.prone;
  EXPECT_TRUE(twice.check().findings.empty()) << listed(twice.check());
}

TEST(SceneCheck, SameFileTwice) {
  Case spoilt;
  spoilt.supine = spoilt.prone;
  expect_error_finding(spoilt, "images and labels are the same");
  spoilt.spoil = [](Inputs& inputs) { inputs.originals.supine.image.values[0] += 1.f; };
  expect_error_finding(spoilt, "supine labels are the same");
}

TEST(SceneCheck, Chests) {
  Case spoilt;
  spoilt.supine = moved(lying.labels(), Tensor<1, 3>({0., 5., 0.}));
  expect_warning(spoilt, "Pre-alignment/Method");
  spoilt.supine = moved(lying.labels(), Tensor<1, 3>({0., 20., 0.}));
  expect_error_finding(spoilt, "mm apart");
  spoilt.supine = moved(lying.labels(), Tensor<1, 3>({0., 0., 400.}));
  expect_error_finding(spoilt, "hardly overlap: 0 %");
  spoilt.supine = turned(lying.labels());
  expect_error_finding(spoilt, "180 degrees apart");
}

TEST(SceneCheck, MirroredBreast) {
  Case spoilt;
  spoilt.supine = mirrored(lying.labels());
  spoilt.spoil = [](Inputs& inputs) { inputs.images.supine = mirrored(image_of(lying.labels())); };
  expect_warning(spoilt, "mirrored left to right");
}

TEST(SceneCheck, VolumeAndWidth) {
  Case spoilt;
  spoilt.supine = HalfEllipsoid{36., 55.}.labels();
  expect_warning(spoilt, "a ratio of");
  HalfEllipsoid second = lying;
  second.centre = 160.;
  spoilt.supine = HalfEllipsoid{36., 76., 0., 1, 2, 3, 240.}.labels();
  spoilt.supine = changed(spoilt.supine, [&](std::uint8_t label, const Point<3>& x) {
    return label == 0 ? second.label(x) : label;
  });
  expect_error_finding(spoilt, "both breasts");
}

TEST(SceneCheck, VoxelSize) {
  for (const double factor : {0.1, 10.}) {
    Case spoilt;
    for (LabelImage* labels : {&spoilt.prone, &spoilt.supine}) {
      labels->grid.spacing *= factor;
      labels->grid.origin *= factor;
    }
    expect_error_finding(spoilt, "check the voxel sizes");
  }
}

TEST(SceneCheck, UnexplainedLabel) {
  Case spoilt;
  spoilt.prone = changed(hanging.labels(), [](std::uint8_t label, const Point<3>& x) {
    return std::uint8_t(label == 2 && x[1] < -40. ? 7 : label);
  });
  expect_warning(spoilt, "label 7 (");
  // What the image does not show is explained.
  Case cropped;
  cropped.prone = changed(hanging.labels(), [](std::uint8_t label, const Point<3>&) {
    return std::uint8_t(label == 0 ? 255 : label);
  });
  for (const auto& finding : cropped.check().findings)
    EXPECT_EQ(finding.text.find("255"), std::string::npos) << finding.text;
}

TEST(SceneCheck, OtherNumbering) {
  Case spoilt;
  HalfEllipsoid other = hanging;
  other.radius = 150.; // up to the border of the image
  other.chest = 3, other.fat = 1, other.gland = 2;
  spoilt.prone = other.labels();
  expect_error_finding(spoilt, "'Labels/Chest = 1'");
  other.radius = hanging.radius;
  other.chest = 3, other.fat = 2, other.gland = 1;
  spoilt.prone = other.labels();
  expect_error_finding(spoilt, "enclosed by tissue");
}

TEST(SceneCheck, FatAndGlandExchanged) {
  Case spoilt;
  HalfEllipsoid other = hanging;
  std::swap(other.fat, other.gland);
  spoilt.prone = other.labels();
  expect_error_finding(spoilt, "Gland (label 3) forms");
}

TEST(SceneCheck, MissingChest) {
  Case spoilt;
  spoilt.prone = changed(hanging.labels(), [](std::uint8_t label, const Point<3>& x) {
    return std::uint8_t(label == 1 && x[1] < 10. ? 0 : label);
  });
  expect_error_finding(spoilt, "touches the chest nowhere");
  spoilt.prone = changed(hanging.labels(), [](std::uint8_t label, const Point<3>& x) {
    return std::uint8_t(label == 1 && x[0] < 10. ? 0 : label);
  });
  expect_warning(spoilt, "has chest behind it");
}

TEST(SceneCheck, MissingSlices) {
  Case spoilt;
  spoilt.prone = changed(hanging.labels(), [](std::uint8_t label, const Point<3>& x) {
    return std::uint8_t(int(std::lround((x[2] + 80.) / 4.)) % 4 == 0 ? label : 0);
  });
  expect_error_finding(spoilt, "segment every slice");
}

TEST(SceneCheck, FieldOfView) {
  Case spoilt;
  HalfEllipsoid long_breast = hanging;
  long_breast.height = 110.; // the image ends at 92
  spoilt.prone = long_breast.labels();
  expect_warning(spoilt, "cuts the front");
  spoilt.prone = changed(hanging.labels(), [](std::uint8_t label, const Point<3>&) {
    return std::uint8_t(label == 0 ? 2 : label);
  });
  expect_error_finding(spoilt, "no voxel of air");
}

TEST(SceneCheck, Contrast) {
  Case spoilt;
  spoilt.spoil = [](Inputs& inputs) {
    inputs.images.supine = image_of(inputs.scene.labels.supine, 0.1f, 0.8f);
  };
  expect_warning(spoilt, "brighter in the supine one");
  spoilt.needs_same_contrast = false;
  EXPECT_TRUE(spoilt.check().findings.empty()) << listed(spoilt.check());
  Case without_gland; // air is none, though 0 says so
  without_gland.gland = 0;
  without_gland.spoil = [](Inputs& inputs) {
    const auto& labels = inputs.scene.labels.supine.values;
    for (std::size_t v = 0; v < labels.size(); ++v)
      if (labels[v] == 0)
        inputs.images.supine.values[v] = 1.f;
  };
  EXPECT_EQ(listed(without_gland.check()).find("Gland is"), std::string::npos);
  Case mask;
  mask.spoil = [](Inputs& inputs) {
    auto& [image, breast] = inputs.originals.prone;
    std::copy(breast.values.begin(), breast.values.end(), image.values.begin());
  };
  expect_error_finding(mask, "give the image");
}

// The images are scaled by percentiles, which are those of air where a mask is off.
TEST(SceneCheck, TheScaleOfAnImageIsNoContrast) {
  Case scaled;
  scaled.spoil = [](Inputs& inputs) {
    for (float& value : inputs.images.supine.values)
      value = 0.7f * value + 0.2f;
  };
  EXPECT_TRUE(scaled.check().findings.empty()) << listed(scaled.check());
}

TEST(SceneCheck, OneBreastAlone) {
  const Labels meaning;
  const SceneCheck check(meaning);
  const Tensor<1, 3> front({0., -1., 0.});
  EXPECT_TRUE(check.check_one(hanging.labels(), Position::prone, front).findings.empty());
  EXPECT_EQ(check.check_one(lying.labels(), Position::supine, front).n_errors(), 1u);
  EXPECT_TRUE(check.check_one(lying.labels(), Position::supine).findings.empty());
}

TEST(SceneCheck, ErrorsStopTheRunUnlessTheyAreAllowed) {
  Case spoilt;
  spoilt.gravity.prone *= -1., spoilt.gravity.supine *= -1.;
  const SceneReport report = spoilt.check();
  const Labels meaning;
  SceneCheck check(meaning);
  Remarks remarks;
  expect_error([&] { check.accept(report, remarks); },
               {"In prone", "1 more finding:", "prosup check", "Checks/Errors stop the run"});
  read_parameters("", {"Checks/Errors stop the run=false"});
  check.accept(report, remarks);
  EXPECT_EQ(remarks.all().size(), 2u);
}

} // namespace
} // namespace prosup::tests
