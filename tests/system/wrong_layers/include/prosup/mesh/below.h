#include "prosup/image/looks_up.h"
