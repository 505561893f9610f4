#include "report_verdict.h"

#include <vector>

#include "html.h"
#include "prosup/core/log.h"
#include "prosup/core/text.h"

namespace prosup::output {

namespace {

using Json = nlohmann::json;

std::string meaning(const std::string& grade) {
  if (grade == "good")
    return ": nothing speaks against the result.";
  if (grade == "doubtful")
    return ": look at the reasons and the pictures before you use the result.";
  if (grade == "failed")
    return ": do not use the result. The reasons say what to check.";
  return "";
}

/// The figures of the last stage that was judged.
std::string figures(const Json& summary) {
  const Json& quality = summary["quality"];
  std::vector<std::string> parts;
  for (const char* stage : {"image_forces", "material", "unloaded"})
    if (const auto end = quality.find(stage); end != quality.end() && end->is_object()) {
      const auto percent = [&](const char* name) { return 100. * end->value(name, 0.); };
      parts.push_back(format("The outlines overlap by %.1f %%, the glands by %.0f %%, and the "
                             "volumes differ by a factor of %.2f",
                             percent("breast_dice"), percent("gland_dice"),
                             end->value("volume_ratio", 0.)));
      break;
    }
  if (const auto tre = summary.find("tre"); tre != summary.end() && tre->contains("image_forces"))
    parts.push_back(format("the landmarks are %.2f mm apart on average, %.2f mm at most",
                           (*tre)["image_forces"].value("mean", 0.),
                           (*tre)["image_forces"].value("max", 0.)));
  return parts.empty() ? "" : "<p>" + joined(parts, "; ") + ".</p>\n";
}

} // namespace

std::string report_verdict(const Json& summary) {
  const std::string grade = summary["quality"].value("verdict", "unknown");
  std::string text = "<div class=\"verdict " + html::escaped(grade) +
                     "\">\n<p><strong>Verdict: " + html::escaped(grade) + "</strong>" +
                     meaning(grade) + "</p>\n";
  if (const Json reasons = summary["quality"].value("reasons", Json::array()); !reasons.empty()) {
    text += "<ul>\n";
    for (const Json& reason : reasons)
      text += "<li>" + html::escaped(reason.get<std::string>()) + "</li>\n";
    text += "</ul>\n";
  }
  return text + figures(summary) + "</div>\n";
}

} // namespace prosup::output
