#ifdef __AVX512F__
#define PROSUP_INSTRUCTION_SET avx512
#define PROSUP_INSTRUCTION_SET_NAME "AVX-512"
#define PROSUP_DOUBLES EightDoubles
#include "element_kernel_loops.h"
#endif
