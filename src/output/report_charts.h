#ifndef PROSUP_SRC_OUTPUT_REPORT_CHARTS_H
#define PROSUP_SRC_OUTPUT_REPORT_CHARTS_H

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace prosup::output {

/// The similarity over all stages and levels as one curve: each begins where the one before has
/// ended, since values are comparable within a level only. `entries` are those of summary.json.
std::string similarity_chart(const nlohmann::json& entries);

/// How many landmarks have which error, and which have the largest, from the text of landmarks.csv;
/// empty without.
std::string error_histogram(const std::filesystem::path& landmarks);

} // namespace prosup::output

#endif
