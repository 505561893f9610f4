#include "prosup/core/log.h"
#include "scene_findings.h"

namespace prosup::registration {

namespace {

using Tensor = dealii::Tensor<1, 3>;

std::string row(const char* name, double prone, double supine, const char* unit) {
  return format("  %-44s %9.2f %9.2f  %s\n", name, prone, supine, unit);
}

std::string fits(const char* name, const Turned& fit) {
  return format("  %-24s %9.2f %9.2f %9.2f %9.2f\n", name, fit.as_is, fit.left_right, fit.head_foot,
                fit.half_turn);
}

} // namespace

std::string table_of(const PerPosition<BreastMeasures>& breasts,
                     const PerPosition<Tensor>& gravity) {
  const auto& [prone, supine] = breasts;
  const auto ratio = [](double a, double b) { return b > 0. ? a / b : 0.; };
  std::string text = format("  %-44s %9s %9s\n", "", "prone", "supine");
  const auto both = [&](const char* name, const char* unit, const auto& value) {
    text += row(name, value(prone), value(supine), unit);
  };
  both("tissue", "ml", [](const auto& b) { return b.tissue_ml; });
  both("gland", "ml", [](const auto& b) { return b.gland_ml; });
  both("tissue on thinned voxels to all", "", [](const auto& b) { return b.solid; });
  both("tissue in one piece", "", [](const auto& b) { return b.largest_part; });
  both("tissue with chest behind it", "", [](const auto& b) { return b.covered; });
  both("agreement of the normals of its base", "", [](const auto& b) { return b.agreement; });
  text += row("cosine of gravity and front", prone.front * gravity.prone / gravity.prone.norm(),
              supine.front * gravity.supine / gravity.supine.norm(), "");
  both("95 % of the tissue is nearer to the chest than", "mm",
       [](const auto& b) { return b.reach.value_or(0.); });
  both("skin to skin and base", "",
       [&](const auto& b) { return ratio(b.skin_area, b.skin_area + b.base_area); });
  both("gland to skin", "", [&](const auto& b) { return ratio(b.gland_skin_area, b.skin_area); });
  both("tissue cut by the image to base", "",
       [&](const auto& b) { return ratio(b.border_area, b.base_area); });
  both("tissue cut in front to base", "",
       [&](const auto& b) { return ratio(b.front_area, b.base_area); });
  return text;
}

std::string table_of(const PairMeasures& pair) {
  const auto contrast = [](const std::optional<TissueContrast>& c) {
    return c ? c->gland - c->fat : 0.;
  };
  std::string text =
      row("base in view of the other image", pair.in_view.prone, pair.in_view.supine, "");
  text += row("gland brighter than fat by (scaled)", contrast(pair.contrast.prone),
              contrast(pair.contrast.supine), "");
  text +=
      row("intensities in tissue", double(pair.n_values.prone), double(pair.n_values.supine), "");
  const auto single = [&](const char* name, double value, const char* unit) {
    text += format("  %-44s %9.2f            %s\n", name, value, unit);
  };
  single("chests apart, median", pair.chest_median.value_or(-1.), "mm");
  single("chests apart, 90 %", pair.chest_p90.value_or(-1.), "mm");
  single("cosine of the fronts", pair.facing, "");
  single("angle of the gravities", pair.gravity_angle, "degrees");
  single("volume, prone to supine", pair.volume_ratio, "");
  single("gland, prone to supine", pair.gland_ratio, "");
  single("width, prone to supine", pair.width_ratio, "");
  single("reach, prone to supine", pair.reach_ratio.value_or(0.), "");
  single("intensities that both have", pair.common_histogram, "");
  single("same image", pair.same_image, "");
  single("same labels", pair.same_labels, "");
  text += format("  %-24s %9s %9s %9s %9s\n", "supine to prone", "as it is", "mirrored", "up-down",
                 "turned");
  text += fits("tissue, correlation", pair.fit.tissue) +
          fits("gland, correlation", pair.fit.gland) +
          fits("chest wall, information", pair.information);
  return text;
}

} // namespace prosup::registration
