#include "summary_json.h"

#include <fstream>

#include "prosup/core/error.h"

namespace prosup::output {

using Json = nlohmann::json;

Json read_summary(const std::filesystem::path& result) {
  std::ifstream stream(result / "summary.json", std::ios::binary);
  Json summary = Json::parse(stream, nullptr, false);
  if (!summary.is_object() || !summary.contains("quality"))
    throw Error("The folder '" + result.string() +
                "' holds no finished registration (summary.json); give the --output folder of "
                "prosup register.");
  return summary;
}

} // namespace prosup::output
