// An include between wings that has no arrow.
#include "prosup/mesh/static/newton.h"
