#define PROSUP_INSTRUCTION_SET baseline
#define PROSUP_INSTRUCTION_SET_NAME "baseline"
#include "stencil_kernel_loops.h"
