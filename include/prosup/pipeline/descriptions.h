#ifndef PROSUP_PIPELINE_DESCRIPTIONS_H
#define PROSUP_PIPELINE_DESCRIPTIONS_H

#include <string>

#include "prosup/mechanics/static/quasi_static.h"
#include "prosup/settling/settling_result.h"

namespace prosup::pipeline {

/// One line on the simulation of `name`, with the explanation on a second one if it has not
/// settled.
std::string describe(const std::string& name, const settling::SettlingResult& result);
/// One line on the quasi-static solution of `name`.
std::string describe(const std::string& name, const mechanics::QuasiStaticResult& result);

} // namespace prosup::pipeline

#endif
