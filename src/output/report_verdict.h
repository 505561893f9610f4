#ifndef PROSUP_SRC_OUTPUT_REPORT_VERDICT_H
#define PROSUP_SRC_OUTPUT_REPORT_VERDICT_H

#include <nlohmann/json.hpp>
#include <string>

namespace prosup::output {

/// The verdict of summary.json with what it means, its reasons, and the figures that say most of
/// the result. HTML.
std::string report_verdict(const nlohmann::json& summary);

} // namespace prosup::output

#endif
