#ifndef PROSUP_SRC_OUTPUT_COLOURS_H
#define PROSUP_SRC_OUTPUT_COLOURS_H

#include "canvas.h"

namespace prosup::output {

/// Blue at -1 and below, white at 0, red at +1 and above.
Colour blue_white_red(double value);

/// Dark blue at 0 and below, over green to yellow at 1 and above; its lightness grows steadily.
Colour dark_to_bright(double value);

} // namespace prosup::output

#endif
