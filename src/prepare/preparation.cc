#include "prosup/prepare/preparation.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "body_parts.h"
#include "doubts.h"
#include "prosup/core/error.h"
#include "prosup/core/parameters.h"
#include "prosup/image/filters.h"
#include "prosup/prepare/bias_field.h"
#include "prosup/prepare/body_outline.h"
#include "prosup/prepare/tissues.h"
#include "user_masks.h"

namespace prosup::prepare {

using namespace dealii;

namespace {

using image::LabelImage;
using image::ScalarImage;

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
  const bool is_ct = looks_like_ct(scan);
  if (contrast_ == "automatic")
    return is_ct ? Contrast::ct : Contrast::t1; // fat is looked at later
  const auto told = enumerator<Contrast>(contrast_, contrast_names());
  if (is_ct && told != Contrast::ct)
    throw Error(format("The contrast is given as '%s', but the scan has air below -500, as only a "
                       "CT has; leave '--contrast' out, which recognises each scan.",
                       contrast_.c_str()));
  if (told == Contrast::ct && !has_air_of_ct(scan))
    throw Error("The contrast is given as 'ct', but no voxel of the scan is below -500, as air is "
                "in Hounsfield units; leave '--contrast' out, or give a CT in Hounsfield units.");
  return told;
}

ChestWall Preparation::wall_of(const ChestImage& image, const TrunkAxis& axis,
                               const UserMasks& masks, PreparedScan& result) const {
  const bool is_told = image.is_ct || contrast_ != "automatic";
  const auto found = [&] {
    return find_chest_wall(image, axis,
                           is_told ? std::optional(fat_is_bright(result.contrast)) : std::nullopt);
  };
  ChestWall wall;
  if (!masks.chest || !is_told) // the search also tells whether fat is bright
    wall = found();
  else
    wall.fat.is_bright = fat_is_bright(result.contrast);
  if (!is_told)
    result.contrast = wall.fat.is_bright ? Contrast::t1 : Contrast::t1_fat_suppressed;
  return masks.chest ? wall_of_mask(*masks.chest, axis, wall.fat) : wall;
}

PreparedScan Preparation::run(ScalarImage scan, const Log& log, const UserMasks& given) const {
  PreparedScan result;
  const UserMasks masks = on_grid(given, scan.grid);
  result.contrast = contrast_of(scan);
  const bool is_ct = result.contrast == Contrast::ct;
  log.progress("  outline of the body");
  const Outline outline = find_outline(scan, is_ct);
  const std::optional<UnknownRegion> unknown = find_unknown(scan, outline.body);
  if (!is_ct && bias_correction_ == "n4") {
    log.progress("  bias field");
    scan = without_bias(scan, outline.body, outline.threshold);
  }
  log.progress("  chest wall");
  const TrunkAxis axis = find_trunk_axis(outline.body);
  const ChestWall wall = wall_of({scan, outline.body, outline.air, is_ct}, axis, masks, result);
  log.line("  " + describe(result.contrast) +
           (contrast_ == "automatic" ? ", as recognised" : ", as given"));
  LabelImage parts = front_and_chest(outline.body, wall.surface, masks);
  if (unknown) {
    mark_unknown(*unknown, outline.air, scan, parts, log);
    result.unknown_contact = unknown->contact;
  }
  const LabelImage front = image::select_labels(parts, {in_front_of_wall});
  require_whole_front(front);
  const Side side = enumerator<Side>(side_, side_names());
  require_two_sides(section_in_the_middle(front, wall.surface, side), side);
  const CutSection cut = largest_cut(front, wall.surface, side);
  require_whole_breast(cut);
  log.progress("  fat and gland");
  const TissueImage inner{scan, inner_breast(parts, axis, skin_), is_ct, wall.fat.is_bright};
  const Tissues tissues =
      masks.gland ? tissues_of_mask(inner, parts, *masks.gland) : find_tissues(inner);
  const SolidPart solid = largest_solid_part(inner, tissues);
  if (!masks.gland)
    require_no_implant(solid);
  const image::VoxelBox box = breast_box(front, wall.surface, side, margin_);
  result.labels = image::part_of(labels_of(parts, tissues.gland), box);
  result.image = image::part_of(scan, box);
  result.gland = image::part_of(tissues.fraction, box);
  result.fat_volume = volume(result.labels, labels_.fat());
  result.gland_volume = volume(result.labels, labels_.gland);
  result.confidence = judge(wall, tissues);
  result.confidence.cut_share = cut.share;
  result.confidence.solid = solid;
  return result;
}

void Preparation::mark_unknown(const UnknownRegion& region, double air, ScalarImage& scan,
                               LabelImage& parts, const Log& log) const {
  for (std::size_t v = 0; v < parts.values.size(); ++v)
    if (region.mask.values[v] != 0) {
      parts.values[v] = not_shown;
      scan.values[v] = float(air);
    }
  log.line(format("  the scan shows nothing beyond %.1f cm^2 of tissue (%g in all voxels): label "
                  "%u, what is unknown",
                  region.contact, region.value, labels_.unknown));
}

LabelImage Preparation::labels_of(const LabelImage& parts, const LabelImage& gland) const {
  LabelImage labels(parts.grid);
  for (std::size_t v = 0; v < parts.values.size(); ++v)
    if (parts.values[v] != 0)
      labels.values[v] = static_cast<std::uint8_t>(parts.values[v] == behind_wall ? labels_.chest
                                                   : parts.values[v] == not_shown ? labels_.unknown
                                                   : gland.values[v] != 0         ? labels_.gland
                                                                                  : labels_.fat());
  return labels;
}

} // namespace prosup::prepare
