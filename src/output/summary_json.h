#ifndef PROSUP_SRC_OUTPUT_SUMMARY_JSON_H
#define PROSUP_SRC_OUTPUT_SUMMARY_JSON_H

#include <filesystem>
#include <nlohmann/json.hpp>

namespace prosup::output {

/// The summary.json of the finished registration in the folder `result`.
/// @throws Error if it has none, or one that is damaged or of another command.
nlohmann::json read_summary(const std::filesystem::path& result);

} // namespace prosup::output

#endif
