#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "prosup/core/log.h"
#include "scene_findings.h"

namespace prosup::registration {

using namespace dealii;

namespace {

// Limits: see the tables in docs/checks.md.
constexpr double least_facing = 0.3, doubtful_facing = 0.85;
constexpr double least_view = 0.3, doubtful_view = 0.6;
constexpr double most_apart = 15., doubtful_median = 2.5, doubtful_p90 = 6.; // mm
constexpr double wrong_gravity = -0.3, doubtful_gravity = 0.5;
constexpr double most_parallel = 45., opposite = 90.; // degrees between the two gravities
constexpr double same_reach = 1.15; // factor within which two images are of the same position
constexpr double least_reach = 0.9, doubtful_reach = 1.1;
constexpr double least_volume = 0.8, most_volume = 1.25;
constexpr double two_breasts = 1.5, other_volume = 2.5;
constexpr double least_gland = 0.7, most_gland = 1.4;
constexpr double clearly_better = 0.02; // sum of two correlations
constexpr double weight_of_chest = 0.1;

using Maybe = std::optional<Finding>;

Maybe chests_without_overlap(const PairMeasures& pair) {
  const double best = std::max(pair.in_view.prone, pair.in_view.supine);
  if (best >= doubtful_view)
    return {};
  return finding(
      best < least_view,
      format("The chests hardly overlap: %.0f %% of the chest behind the prone breast "
             "lies within the supine image, and %.0f %% of that behind the supine breast "
             "within the prone image; check the positions in the headers, and that both "
             "show the same side.",
             100. * pair.in_view.prone, 100. * pair.in_view.supine));
}

Maybe chests_turned(const PairMeasures& pair) {
  if (pair.facing >= doubtful_facing)
    return {};
  const double degrees = 180. / numbers::PI * std::acos(std::clamp(pair.facing, -1., 1.));
  return finding(pair.facing < least_facing,
                 format("The two chests face directions that are %.0f degrees apart; check the "
                        "orientations in the headers (the patient's position at the scanner).",
                        degrees));
}

Maybe chests_apart(const PairMeasures& pair, bool is_aligned) {
  if (!pair.chest_median ||
      (*pair.chest_median <= doubtful_median && *pair.chest_p90 <= doubtful_p90))
    return {};
  const char* advice =
      is_aligned ? "check that both images show the same patient and the same side"
                 : "align them, for instance with 'Pre-alignment/Method = chest intensities', and "
                   "check that both images show the same patient and side";
  return finding(
      *pair.chest_median > most_apart,
      format("The surfaces of the two chests are %.1f mm apart (median; 90 %% are within "
             "%.1f mm)%s; %s.",
             *pair.chest_median, *pair.chest_p90, is_aligned ? " even after their alignment" : "",
             advice));
}

void check_gravity(const PerPosition<BreastMeasures>& breasts, const PairMeasures& pair,
                   const PerPosition<Tensor<1, 3>>& gravity, Findings& result) {
  // Two images of one position, of which one takes the place of the other, are no mistake.
  const bool same_position = pair.gravity_angle < most_parallel && pair.reach_ratio &&
                             *pair.reach_ratio<same_reach&& * pair.reach_ratio> 1. / same_reach;
  if (same_position)
    return;
  for (const Position position : both_positions)
    for (Finding& found : gravity_findings_of(breasts[position], position, gravity[position]))
      result.push_back(std::move(found));
}

Maybe exchanged(const PerPosition<BreastMeasures>& breasts, const PairMeasures& pair) {
  if (!pair.reach_ratio || pair.gravity_angle < opposite || *pair.reach_ratio >= doubtful_reach)
    return {};
  return finding(
      *pair.reach_ratio < least_reach,
      format("The prone breast, which hangs, reaches %.0f mm from the chest, and the "
             "supine one %.0f mm (95 %% of the tissue), but hanging tissue reaches "
             "further; check whether prone and supine are exchanged, or the images of two "
             "patients mixed.",
             *breasts.prone.reach, *breasts.supine.reach));
}

Maybe other_volume_of(const PerPosition<BreastMeasures>& breasts, const PairMeasures& pair) {
  const double ratio = pair.volume_ratio;
  if (ratio >= least_volume && ratio <= most_volume)
    return {};
  const double larger = std::max(ratio, 1. / ratio);
  const double wider = ratio > 1. ? pair.width_ratio : 1. / pair.width_ratio;
  const bool both = larger > two_breasts && wider > two_breasts;
  return finding(both || larger > other_volume,
                 format("The prone breast has %.0f ml and the supine one %.0f ml, a ratio of %.2f; "
                        "%s.",
                        breasts.prone.tissue_ml, breasts.supine.tissue_ml, ratio,
                        both ? "one of the masks seems to hold both breasts: keep the same one in "
                               "both"
                             : "check that both masks hold the same breast of the same patient up "
                               "to the same borders"));
}

Maybe other_gland(const PerPosition<BreastMeasures>& breasts, const PairMeasures& pair) {
  if (breasts.prone.gland_ml == 0. && breasts.supine.gland_ml == 0.)
    return {};
  if (pair.gland_ratio >= least_gland && pair.gland_ratio <= most_gland)
    return {};
  return warning(format("The prone breast has %.0f ml of gland and the supine one %.0f ml; check "
                        "that both masks are of the same patient and mark gland alike.",
                        breasts.prone.gland_ml, breasts.supine.gland_ml));
}

/// How much better than as it is the supine breast fits if it is turned over. The chest wall, which
/// neither deforms nor moves, counts too.
double gain(const PairMeasures& pair, double Turned::*way) {
  const auto fit = [&](double Turned::*w) { return pair.fit.tissue.*w + pair.fit.gland.*w; };
  const double of_chest =
      pair.information.*way > 0. ? 1. - pair.information.as_is / (pair.information.*way) : 0.;
  return fit(way) - fit(&Turned::as_is) + weight_of_chest * std::clamp(of_chest, -2., 1.);
}

Maybe mirrored(const PairMeasures& pair) {
  struct Way {
    double Turned::*way;
    const char* name;
  };
  Way best{&Turned::left_right, "mirrored left to right"};
  for (const Way& other : {Way{&Turned::head_foot, "mirrored head to foot"},
                           Way{&Turned::half_turn, "turned by 180 degrees"}})
    if (gain(pair, other.way) > gain(pair, best.way))
      best = other;
  if (gain(pair, best.way) < clearly_better)
    return {};
  return warning(format("Seen from the front, the supine breast fits the prone one better if it is "
                        "%s (correlations of tissue and gland %.2f and %.2f instead of %.2f and "
                        "%.2f); check that both are the same side, and the orientations in the "
                        "headers.",
                        best.name, pair.fit.tissue.*best.way, pair.fit.gland.*best.way,
                        pair.fit.tissue.as_is, pair.fit.gland.as_is));
}

} // namespace

Findings gravity_findings_of(const BreastMeasures& breast, Position position,
                             const Tensor<1, 3>& gravity) {
  const bool hangs = position == Position::prone;
  const double right = (hangs ? 1. : -1.) * (breast.front * gravity) / gravity.norm();
  if (right >= doubtful_gravity)
    return {};
  const double degrees = 180. / numbers::PI * std::acos(std::clamp(right, -1., 1.));
  return {finding(
      right < wrong_gravity,
      format("In %s, gravity should pull the breast %s the chest, but 'Case/%s gravity' "
             "is %.0f degrees off this direction; check it (LPS: 0,-1,0 is towards the "
             "front of the patient), and the orientation in the header.",
             name_of(position), hangs ? "off" : "onto", hangs ? "Prone" : "Supine", degrees))};
}

Findings findings_of(const PerPosition<BreastMeasures>& breasts, const PairMeasures& pair,
                     const PerPosition<Tensor<1, 3>>& gravity, const SceneOptions& options) {
  Findings result;
  const auto add = [&](const Maybe& found) {
    if (found)
      result.push_back(*found);
    return found && found->severity == Finding::Severity::error;
  };
  // Where the scenes do not fit each other at all, nothing else can be compared.
  if (add(chests_turned(pair)) || add(chests_without_overlap(pair)))
    return result;
  add(chests_apart(pair, options.is_aligned));
  check_gravity(breasts, pair, gravity, result);
  if (add(other_volume_of(breasts, pair)))
    return result;
  if (add(exchanged(breasts, pair)))
    return result;
  add(other_gland(breasts, pair));
  add(mirrored(pair));
  return result;
}

} // namespace prosup::registration
