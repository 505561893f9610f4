#ifndef PROSUP_SRC_EVALUATION_JSON_TEXT_H
#define PROSUP_SRC_EVALUATION_JSON_TEXT_H

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace prosup::evaluation {

/// The text at `key`, or `otherwise` if there is none.
inline std::string text_at(const nlohmann::json& json, const char* key,
                           const std::string& otherwise) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

/// What `markup` calls its coordinate system, if it says.
inline std::optional<std::string> system_name(const nlohmann::json& markup) {
  const auto system = markup.find("coordinateSystem");
  if (system == markup.end())
    return {};
  return system->is_string() ? system->get<std::string>() : system->dump();
}

} // namespace prosup::evaluation

#endif
