#ifdef __AVX2__
#define PROSUP_INSTRUCTION_SET avx2
#define PROSUP_INSTRUCTION_SET_NAME "AVX2"
#define PROSUP_DOUBLES FourDoubles
#include "element_kernel_loops.h"
#endif
