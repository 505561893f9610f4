#include <algorithm>

#include "prosup/core/log.h"
#include "prosup/core/text.h"
#include "scene_findings.h"

namespace prosup::registration {

namespace {

// Limits: see the tables in docs/checks.md.
constexpr double least_ml = 30., most_ml = 5000.; // of a breast
constexpr double beyond_doubt = 4.;               // factor beyond which it is no breast at all
constexpr double least_skin = 0.15, doubtful_skin = 0.3; // of skin and base
constexpr double least_agreement = 0.3;
constexpr double least_covered = 0.3, doubtful_covered = 0.7;
constexpr double least_solid = 0.6, most_solid = 1.6;
constexpr double least_part = 0.3, doubtful_part = 0.9;
constexpr double most_gland_skin = 0.6, doubtful_gland_skin = 0.35;
constexpr double most_cut_front = 0.02; // of the base
constexpr double most_border = 0.4;     // of skin and border
constexpr std::size_t n_labels_named = 5;

using Maybe = std::optional<Finding>;

Maybe unexplained_labels(const BreastMeasures& breast, const char* name, const Labels& meaning) {
  const std::array<bool, 256> is_tissue = tissue_table(meaning);
  std::vector<std::string> numbers, amounts;
  for (unsigned label = 1; label < breast.counts.size(); ++label)
    if (breast.counts[label] > 0 && label != meaning.chest && label != meaning.unknown &&
        !is_tissue[label]) {
      numbers.push_back(std::to_string(label));
      amounts.push_back(format("label %u (%zu voxels, %.3g ml)", label, breast.counts[label],
                               breast.voxel_ml * double(breast.counts[label])));
    }
  if (numbers.empty())
    return {};
  const std::size_t n = numbers.size();
  std::string more;
  if (n > n_labels_named) {
    amounts.resize(n_labels_named);
    more = format(" and %zu more", n - n_labels_named);
  }
  return warning("Section Labels does not explain " + joined(amounts) + more + " of the " + name +
                 " labels, which therefore count as air; add what is part of the breast to "
                 "'Labels/Tissues'.");
}

Maybe implausible_volume(const BreastMeasures& breast, const char* name) {
  const double ml = breast.tissue_ml;
  if (ml >= least_ml && ml <= most_ml)
    return {};
  return finding(ml < least_ml / beyond_doubt || ml > beyond_doubt * most_ml,
                 format("The tissue of the %s labels has a volume of %.3g ml, but a breast has %g "
                        "to %g ml; check the voxel sizes, which have to be in mm, and "
                        "'Labels/Tissues'.",
                        name, ml, least_ml, most_ml));
}

Maybe missing_slices(const BreastMeasures& breast, const char* name) {
  if (breast.solid < least_solid || breast.solid > most_solid)
    return error(format("The %s labels are full of gaps: every n-th voxel of them holds %.2g times "
                        "the tissue of all; segment every slice.",
                        name, breast.solid));
  if (breast.largest_part < doubtful_part)
    return finding(
        breast.largest_part < least_part,
        format("The tissue of the %s labels lies in several pieces, the largest of which "
               "has %.0f %% of it, and only this is used; segment every slice, and one "
               "breast.",
               name, 100. * breast.largest_part));
  return {};
}

/// Whether the chest label is that of some tissue, or a tissue label that of the chest.
Maybe wrong_numbering(const BreastMeasures& breast, const char* name, const Labels& meaning) {
  const std::string numbers = format("'Labels/Chest = %u' and 'Labels/Tissues = %s'", meaning.chest,
                                     joined(meaning.tissues).c_str());
  const double outside = breast.skin_area + breast.base_area;
  if (breast.counts[0] == 0)
    return error(format("The %s labels have no voxel of air (0): they fill the image; mark what "
                        "lies outside of the body as 0.",
                        name));
  if (outside > 0. && breast.skin_area < doubtful_skin * outside)
    return finding(breast.skin_area < least_skin * outside,
                   format("Only %.0f %% of the surface of the tissue in the %s labels is skin, the "
                          "rest touches the chest, as if the numbers meant something else; check "
                          "%s.",
                          100. * breast.skin_area / outside, name, numbers.c_str()));
  if (breast.base_area > 0. && breast.agreement < least_agreement)
    return error(format("The chest of the %s labels is enclosed by tissue instead of lying behind "
                        "it (its normals agree by %.2f, at least %g are expected); check %s.",
                        name, breast.agreement, least_agreement, numbers.c_str()));
  return {};
}

Maybe missing_chest(const BreastMeasures& breast, const char* name) {
  if (!(breast.base_area > 0.))
    return error(format("Nothing holds the tissue of the %s labels: it touches the chest nowhere, "
                        "and 'Supports/Cut planes' cannot replace it; label the chest wall up to "
                        "the tissue.",
                        name));
  if (breast.covered >= doubtful_covered)
    return {};
  return finding(breast.covered < least_covered,
                 format("Only %.0f %% of the tissue of the %s labels has chest behind it, the rest "
                        "would hang on nothing; label the chest wall behind all of the tissue.",
                        100. * breast.covered, name));
}

Maybe gland_outside(const BreastMeasures& breast, const char* name, const Labels& meaning) {
  if (!(breast.skin_area > 0.) || meaning.tissues.size() < 2)
    return {};
  const double share = breast.gland_skin_area / breast.skin_area;
  if (share < doubtful_gland_skin)
    return {};
  return finding(share > most_gland_skin,
                 format("Gland (label %u) forms %.0f %% of the skin of the %s labels, but gland "
                        "lies within fat; exchange the two labels, or set 'Labels/Gland'.",
                        meaning.gland, 100. * share, name));
}

Maybe cut_breast(const BreastMeasures& breast, const char* name) {
  if (breast.front_area > most_cut_front * breast.base_area)
    return warning(format("The %s image cuts the front of the breast off, on %.0f mm2; take an "
                          "image that holds all of the breast.",
                          name, breast.front_area));
  const double outside = breast.skin_area + breast.border_area;
  if (outside > 0. && breast.border_area > most_border * outside)
    return warning(
        format("%.0f %% of the surface of the tissue in the %s labels lies at the border "
               "of the image; take an image that holds all of the breast.",
               100. * breast.border_area / outside, name));
  return {};
}

} // namespace

Findings findings_of(const BreastMeasures& breast, Position position, const Labels& meaning) {
  const char* name = name_of(position);
  Findings result;
  const auto add = [&](const Maybe& found) {
    if (found)
      result.push_back(*found);
    return found && found->severity == Finding::Severity::error;
  };
  add(unexplained_labels(breast, name, meaning));
  // The later ones make sense only if the earlier ones have found no error.
  if (add(implausible_volume(breast, name)) || add(missing_slices(breast, name)) ||
      add(wrong_numbering(breast, name, meaning)) || add(missing_chest(breast, name)))
    return result;
  add(gland_outside(breast, name, meaning));
  add(cut_breast(breast, name));
  return result;
}

} // namespace prosup::registration
