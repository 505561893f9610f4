#ifndef PROSUP_PIPELINE_MACHINE_H
#define PROSUP_PIPELINE_MACHINE_H

#include <string>
#include <utility>
#include <vector>

namespace prosup::pipeline {

/// What figures of speed depend on: processor, cores, memory, versions of the
/// libraries, and the day.
std::vector<std::pair<std::string, std::string>> describe_machine();

} // namespace prosup::pipeline

#endif
