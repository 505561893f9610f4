#ifdef __AVX2__
#define PROSUP_INSTRUCTION_SET avx2
#define PROSUP_INSTRUCTION_SET_NAME "AVX2"
#include "stencil_kernel_loops.h"
#endif
