#include "prosup/registration/verdict.h"

#include <algorithm>
#include <cmath>

#include "prosup/core/log.h"

namespace prosup::registration {

namespace {

/// Beyond which value a figure is doubtful, and beyond which a registration has failed.
struct Limits {
  double doubtful, failed;
};

constexpr double never = 1e30;

// From the right uses and misuses in docs/verdict.md.
constexpr Limits chest_median{2., 10.};      // mm
constexpr Limits not_shared{0.3, 0.7};       // part of the chest or breast that one image lacks
constexpr Limits outlines{0.03, 0.10};       // 1 - Dice of the breasts at the end
constexpr Limits found_outlines{0.05, 0.25}; // the same before image forces
constexpr Limits gland{0.2, 0.5};            // 1 - Dice of the gland at the end
constexpr Limits volumes{1.1, 1.3};          // larger breast to smaller one
constexpr Limits outside{0.002, 0.1};        // part of a breast far out of the other one
constexpr Limits uncorrelated{0.1, 0.4}; // 1 - correlation, if the metric needs the same contrast
constexpr Limits largest_jacobian{3., 10.}, smallest_jacobian{1. / 0.2, 1. / 0.05};
constexpr Limits inverse{1., never};   // mm
constexpr Limits at_rest{1. / 3., 1.}; // 1/mm, of the mean motion
constexpr double worse_outline = 0.01; // of Dice, that a stage may lose
constexpr unsigned many_doubts = 5;    // right uses have two at most

class Findings {
public:
  void add(Grade grade, const std::string& sentence) {
    verdict_.grade = std::max(verdict_.grade, grade);
    (grade == Grade::failed ? failed_ : doubtful_).push_back(sentence);
  }

  /// Adds the sentence if the value is beyond the limits.
  void judge(double value, const Limits& limits, const std::string& sentence) {
    if (value > limits.doubtful)
      add(value > limits.failed ? Grade::failed : Grade::doubtful, sentence);
  }

  /// Figures that are doubtful one by one say together that nothing fits.
  void fail_if_many() {
    const std::size_t n = doubtful_.size();
    if (verdict_.grade == Grade::doubtful && n >= many_doubts)
      add(Grade::failed, format("%zu figures are out of the usual at once, as if the two breasts "
                                "did not belong together: see below.",
                                n));
  }

  Verdict verdict() {
    verdict_.reasons = failed_;
    verdict_.reasons.insert(verdict_.reasons.end(), doubtful_.begin(), doubtful_.end());
    return verdict_;
  }

private:
  Verdict verdict_;
  std::vector<std::string> failed_, doubtful_;
};

double percent(double part) {
  return 100. * part;
}

void judge_scene(const Quality& quality, const Agreement& end, Findings& findings) {
  findings.judge(quality.chest.median, chest_median,
                 format("The chest walls of the two images are %.1f mm apart (median; usual: below "
                        "%.0f mm): check the coordinates of the supine image, or set "
                        "'Pre-alignment/Method'.",
                        quality.chest.median, chest_median.doubtful));
  findings.judge(1. - quality.chest.shared, not_shared,
                 format("Only %.0f %% of the chest walls are seen in both images: check the "
                        "coordinates of both images and their fields of view.",
                        percent(quality.chest.shared)));
  findings.judge(1. - end.compared_share, not_shared,
                 format("Only %.0f %% of a breast could be compared with the other one, since the "
                        "chest or the border of an image lies there: check the coordinates and "
                        "label images of both positions.",
                        percent(end.compared_share)));
}

void judge_motion(const Quality& quality, Findings& findings) {
  const Motion& motion = quality.motion;
  findings.judge(1. / std::max(motion.mean, 1e-9), at_rest,
                 format("The breast moves by only %.2f mm from prone to supine (usual: 5 to 50 "
                        "mm): check whether both images are of the same position.",
                        motion.mean));
  if (motion.along_gravity < 0.)
    findings.add(Grade::failed,
                 format("From prone to supine the breast moves by %.1f mm against gravity: check "
                        "whether prone and supine are exchanged, and '--prone-gravity' and "
                        "'--supine-gravity' (LPS).",
                        -motion.along_gravity));
}

/// The value of one of MaterialUpdateResult::at_bound.
std::string value_of(const std::string& name, const MechanicalProperties& properties) {
  if (name == "shear modulus")
    return format("%.0f Pa", properties.tissue.shear_modulus);
  if (name == "Poisson ratio")
    return format("%.3f", properties.tissue.poisson_ratio);
  if (name == "gland ratio")
    return format("%.2f", properties.tissue.gland_ratio);
  if (name == "lateral chest ratio")
    return format("%.3f", properties.lateral_chest_ratio);
  if (name == "skin stiffness")
    return format("%.0f Pa mm", properties.tissue.skin_stiffness);
  if (name == "gravity") {
    const auto [left, superior] = properties.tilt.degrees();
    return format("supine tilted by %.0f degrees to the left and %.0f to the head", left, superior);
  }
  if (name == "chest stiffness")
    return format("%.1f Pa/mm", properties.chest_stiffness);
  return format("%.1f Pa/mm in prone and %.1f Pa/mm in supine",
                properties.cut_plane_stiffness.prone, properties.cut_plane_stiffness.supine);
}

void judge_properties(const Quality& quality, Findings& findings) {
  const bool several = quality.at_bound.size() > 1;
  for (const std::string& name : quality.at_bound)
    findings.add(
        several ? Grade::failed : Grade::doubtful,
        "The " + name + " found from the images, " + value_of(name, quality.properties) +
            ", is at an end of its range, as if no plausible tissue explained both shapes: check "
            "positions, gravity, labels and '--chest'.");
}

void judge_cells(const Quality& quality, Findings& findings) {
  for (const Position position : both_positions) {
    const auto [min, max] = quality.jacobian[position];
    findings.judge(
        max, largest_jacobian,
        format("A cell of the %s breast is %.3g times as large as without gravity (usual: "
               "below 2): look at the mesh in ParaView, and check gravity and labels.",
               name_of(position), max));
    findings.judge(
        1. / std::max(min, 1e-9), smallest_jacobian,
        format("A cell of the %s breast is squeezed to %.3g of its volume without gravity "
               "(usual: above 0.5): look at the mesh in ParaView, and check gravity and "
               "labels.",
               name_of(position), min));
  }
  findings.judge(quality.inverse_p95, inverse,
                 format("Points mapped to the other position and back miss by %.2f mm (95th "
                        "percentile; usual: below 0.01): the field is folded; do not use it there.",
                        quality.inverse_p95));
}

/// What the mechanics alone have explained, before image forces can hide the rest.
void judge_mechanics(const Agreement& found, Findings& findings) {
  findings.judge(1. - found.breast_dice, found_outlines,
                 format("Before image forces the unloaded outlines overlap by %.1f %% only "
                        "(usual: above %.0f %%; %.1f mm apart): check that both images are of the "
                        "same breast and position, and both label images.",
                        percent(found.breast_dice), percent(1. - found_outlines.doubtful),
                        found.skin_distance));
  findings.judge(found.volume_ratio, volumes,
                 format("The volumes of the unloaded breasts differ by a factor of %.2f (usual: "
                        "below %.2f): check that both label images mark the same breast.",
                        found.volume_ratio, volumes.doubtful));
}

void judge_end(const Quality& quality, const Agreement& end, Findings& findings) {
  findings.judge(
      1. - end.breast_dice, outlines,
      format("The registered outlines overlap by %.1f %% only (usual: above %.0f %%; 95th "
             "percentile of their distance %.1f mm): compare the label images.",
             percent(end.breast_dice), percent(1. - outlines.doubtful), end.skin_p95));
  findings.judge(
      1. - end.gland_dice, gland,
      format("The registered glands overlap by %.0f %% only (usual: above %.0f %%): check "
             "that both images are of the same breast, and the gland labels.",
             percent(end.gland_dice), percent(1. - gland.doubtful)));
  findings.judge(end.outside_share, outside,
                 format("%.1f %% of a breast is more than %.0f mm outside of the other one (usual: "
                        "0): compare the label images.",
                        percent(end.outside_share), far_outside));
  if (quality.same_contrast && end.intensities)
    findings.judge(1. - end.intensities->correlation, uncorrelated,
                   format("The registered images correlate by %.2f (usual with this metric: above "
                          "%.2f): use '--similarity lncc' if they differ in contrast, else look at "
                          "the pictures.",
                          end.intensities->correlation, 1. - uncorrelated.doubtful));
}

void judge_stage(const char* stage, const std::optional<Agreement>& before,
                 const std::optional<Agreement>& after, Findings& findings) {
  if (before && after && after->breast_dice < before->breast_dice - worse_outline)
    findings.add(
        Grade::doubtful,
        format("%s made the outlines agree less: they overlap by %.1f %% after it, %.1f %% "
               "before; look at the pictures, and try without it.",
               stage, percent(after->breast_dice), percent(before->breast_dice)));
}

} // namespace

const char* name_of(Grade grade) {
  return grade == Grade::good ? "good" : grade == Grade::doubtful ? "doubtful" : "failed";
}

Verdict judge(const Quality& quality) {
  Findings findings;
  if (!quality.converged)
    findings.add(Grade::failed, "A simulation did not settle within 'Unloading/Maximum steps': "
                                "look at the log for the stage, and raise the number.");
  const auto& end = quality.image_forces ? quality.image_forces
                    : quality.material   ? quality.material
                                         : quality.unloaded;
  if (end) {
    judge_scene(quality, *end, findings);
    judge_end(quality, *end, findings);
  }
  if (quality.material)
    judge_mechanics(*quality.material, findings);
  judge_motion(quality, findings);
  judge_properties(quality, findings);
  judge_cells(quality, findings);
  findings.fail_if_many();
  for (const std::string& finding : quality.scene_findings)
    findings.add(Grade::doubtful, finding);
  judge_stage("The material update", quality.unloaded, quality.material, findings);
  judge_stage("The stage of image forces", quality.material, quality.image_forces, findings);
  return findings.verdict();
}

} // namespace prosup::registration
