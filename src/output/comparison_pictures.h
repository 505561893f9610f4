#ifndef PROSUP_OUTPUT_COMPARISON_PICTURES_H
#define PROSUP_OUTPUT_COMPARISON_PICTURES_H

#include <string>

#include "prosup/output/comparison.h"

namespace prosup::output {

/// The plot of a comparison as SVG: both axes logarithmic, one colour and sign per group.
std::string comparison_picture(const Comparison& comparison);

} // namespace prosup::output

#endif
