#define PROSUP_INSTRUCTION_SET baseline
#define PROSUP_INSTRUCTION_SET_NAME "baseline"
#define PROSUP_DOUBLES FourDoubles
#include "element_kernel_loops.h"
