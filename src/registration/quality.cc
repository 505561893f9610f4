#include "prosup/registration/quality.h"

#include <algorithm>

namespace prosup::registration {

namespace {

using Figures = std::vector<std::pair<std::string, double>>;

void add(const std::string& stage, const std::optional<Agreement>& agreement, Figures& figures) {
  if (!agreement)
    return;
  const Agreement& a = *agreement;
  for (const auto& [name, value] :
       {std::pair("compared_share", a.compared_share), std::pair("volume_ratio", a.volume_ratio),
        std::pair("breast_dice", a.breast_dice), std::pair("gland_dice", a.gland_dice),
        std::pair("skin_distance", a.skin_distance), std::pair("skin_p95", a.skin_p95),
        std::pair("outside_share", a.outside_share)})
    figures.emplace_back(stage + "." + name, value);
  if (!a.intensities)
    return;
  for (const auto& [name, value] :
       {std::pair("correlation", a.intensities->correlation),
        std::pair("local_correlation", a.intensities->local_correlation),
        std::pair("mutual_information", a.intensities->mutual_information)})
    figures.emplace_back(stage + "." + name, value);
}

} // namespace

Figures figures_of(const Quality& quality) {
  Figures figures{{"chest.shared", quality.chest.shared},
                  {"chest.median", quality.chest.median},
                  {"chest.p95", quality.chest.p95},
                  {"motion.mean", quality.motion.mean},
                  {"motion.along_gravity", quality.motion.along_gravity},
                  {"unloaded_quality.prone", quality.unloaded_quality.prone},
                  {"unloaded_quality.supine", quality.unloaded_quality.supine}};
  add("unloaded", quality.unloaded, figures);
  add("material", quality.material, figures);
  add("image_forces", quality.image_forces, figures);
  return figures;
}

} // namespace prosup::registration
