#include "prosup/prepare/preparation.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "prosup/core/error.h"
#include "prosup/core/parameters.h"
#include "prosup/image/filters.h"
#include "prosup/prepare/bias_field.h"
#include "prosup/prepare/body_outline.h"
#include "prosup/prepare/chest_wall.h"
#include "prosup/prepare/tissues.h"

namespace prosup::prepare {

using namespace dealii;

namespace {

using image::LabelImage;
using image::ScalarImage;

constexpr double widest_breast = 1.; // rad, to both sides of the front

constexpr std::uint8_t in_front_of_wall = 1, behind_wall = 2;

/// Splits the body at the chest wall.
LabelImage front_and_chest(const LabelImage& body, const TrunkSurface& chest) {
  LabelImage parts(body.grid);
  const auto& size = body.grid.size;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i) {
        if (body(i, j, k) == 0)
          continue;
        const image::Point<3> p = body.grid.physical(double(i), double(j), double(k));
        const TrunkAxis& axis = chest.grid.axis;
        const bool behind = axis.radius(p) < chest(axis.angle(p), p[2]);
        parts(i, j, k) = behind ? behind_wall : in_front_of_wall;
      }
  return parts;
}

/// Voxels of tissue in front of the chest, more than `skin` mm below air, where breasts are: what
/// lies further to the sides is muscle and arm pit.
LabelImage inner_breast(const LabelImage& parts, const TrunkAxis& axis, double skin) {
  LabelImage body(parts.grid);
  for (std::size_t v = 0; v < body.values.size(); ++v)
    body.values[v] = parts.values[v] != 0;
  const ScalarImage distance = image::signed_distance(body);
  LabelImage inner(parts.grid);
  const auto& size = parts.grid.size;
  std::size_t v = 0;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i, ++v)
        inner.values[v] =
            parts.values[v] == in_front_of_wall && double(distance.values[v]) < -skin &&
            std::abs(axis.angle(parts.grid.physical(double(i), double(j), double(k)))) <
                widest_breast;
  return inner;
}

/// Of the voxels with a label, ml.
double volume(const LabelImage& labels, unsigned label) {
  const auto n = std::count(labels.values.begin(), labels.values.end(), label);
  return double(n) * labels.grid.voxel_volume() / 1000.;
}

/// How sure chest wall and tissues are.
void judge(const ChestWall& wall, const Tissues& tissues, Confidence& confidence) {
  constexpr double weak_contrast = 0.1;
  constexpr double too_weak = 0.25;       // share of the chest wall
  constexpr double least_separation = 2.; // standard deviations
  const TrunkGrid& grid = wall.surface.grid;
  std::size_t n = 0, n_weak = 0;
  for (std::size_t column = 0; column < wall.edge.size(); ++column) {
    if (std::abs(grid.angle(column % grid.n_columns)) > widest_breast ||
        wall.edge[column] == ChestWall::no_edge)
      continue;
    ++n;
    n_weak += wall.edge[column] < weak_contrast;
  }
  confidence.weak_edge = n == 0 ? 1. : double(n_weak) / double(n);
  confidence.separation = tissues.separation();
  if (wall.fat.is_doubtful)
    confidence.doubts.push_back(
        std::string("it is not clear whether fat is bright or suppressed; it was taken as ") +
        (wall.fat.is_bright ? "bright" : "suppressed") +
        ", and 'Preparation/Contrast' says which is right.");
  if (confidence.weak_edge > too_weak)
    confidence.doubts.push_back(format(
        "the chest wall has little contrast on %.0f %% of its front; look at the green line in "
        "the pictures, and correct the labels where it is wrong.",
        100. * confidence.weak_edge));
  if (confidence.separation < least_separation)
    confidence.doubts.push_back(
        format("fat and gland differ by %.1f standard deviations only; look at the red lines in "
               "the pictures.",
               confidence.separation));
}

} // namespace

Preparation::Preparation(const Labels& labels)
    : ParameterAcceptor("Preparation"), labels_(labels) {}

void Preparation::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Contrast", contrast_,
                    "What the scans show. automatic: recognised in each. t1, t1fs (fat "
                    "suppressed), t2: MR. ct: CT.",
                    Patterns::Selection("automatic|t1|t1fs|t2|ct"));
  prm.add_parameter("Side", side_,
                    "Breast that is wanted: left or right (of the patient) with its margin, or "
                    "both, which keeps the whole scan.",
                    one_of(side_names()));
  prm.add_parameter("Bias correction", bias_correction_,
                    "Of MR images: n4, or none if it was done before.",
                    Patterns::Selection("n4|none"));
  prm.add_parameter("Skin thickness", skin_,
                    "Depth below the air at which gland may begin; the skin has the intensity of "
                    "gland but the label of fat. Units: mm. Default: the thickness of breast skin "
                    "and half a voxel.",
                    Patterns::Double(0., 10.));
  prm.add_parameter("Margin", margin_,
                    "Kept around a breast that is cut out of the scan. Units: mm. Default: enough "
                    "for what the mechanics need at its borders.",
                    Patterns::Double(0., 200.));
}

Contrast Preparation::contrast_of(const ScalarImage& scan) const {
  if (contrast_ != "automatic")
    return enumerator<Contrast>(contrast_, contrast_names());
  return looks_like_ct(scan) ? Contrast::ct : Contrast::t1; // fat is looked at later
}

PreparedScan Preparation::run(ScalarImage scan, const Log& log) const {
  PreparedScan result;
  result.contrast = contrast_of(scan);
  const bool is_ct = result.contrast == Contrast::ct;
  log.progress("  outline of the body");
  const Outline outline = find_outline(scan, is_ct);
  if (!is_ct && bias_correction_ == "n4") {
    log.progress("  bias field");
    scan = without_bias(scan, outline.body, outline.threshold);
  }
  log.progress("  chest wall");
  const TrunkAxis axis = find_trunk_axis(outline.body);
  const ChestImage chest_image{scan, outline.body, outline.air, is_ct};
  const bool is_told = is_ct || contrast_ != "automatic";
  const ChestWall wall = find_chest_wall(
      chest_image, axis, is_told ? std::optional(fat_is_bright(result.contrast)) : std::nullopt);
  if (!is_told)
    result.contrast = wall.fat.is_bright ? Contrast::t1 : Contrast::t1_fat_suppressed;
  log.line("  " + describe(result.contrast) +
           (contrast_ == "automatic" ? ", as recognised" : ", as given"));
  const LabelImage parts = front_and_chest(outline.body, wall.surface);
  const LabelImage front = image::select_labels(parts, {in_front_of_wall});
  require_whole_front(front);
  log.progress("  fat and gland");
  const LabelImage inner = inner_breast(parts, axis, skin_);
  const Tissues tissues = find_tissues({scan, inner, is_ct, wall.fat.is_bright});
  const image::VoxelBox box =
      breast_box(front, wall.surface, enumerator<Side>(side_, side_names()), margin_);
  result.labels = image::part_of(labels_of(parts, tissues.gland), box);
  result.image = image::part_of(scan, box);
  result.gland = image::part_of(tissues.fraction, box);
  result.fat_volume = volume(result.labels, labels_.fat());
  result.gland_volume = volume(result.labels, labels_.gland);
  judge(wall, tissues, result.confidence);
  return result;
}

LabelImage Preparation::labels_of(const LabelImage& parts, const LabelImage& gland) const {
  LabelImage labels(parts.grid);
  for (std::size_t v = 0; v < parts.values.size(); ++v)
    if (parts.values[v] != 0)
      labels.values[v] = static_cast<std::uint8_t>(parts.values[v] == behind_wall ? labels_.chest
                                                   : gland.values[v] != 0         ? labels_.gland
                                                                                  : labels_.fat());
  return labels;
}

} // namespace prosup::prepare
