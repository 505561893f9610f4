#include "stencil_kernel.h"

namespace prosup::fdm::kernel {

namespace {

struct List {
  const Kernels* kernels[3];
  int n = 0;

  List() {
    kernels[n++] = &baseline::kernels;
#ifdef PROSUP_X86_KERNELS
    const bool has_avx2 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
    if (has_avx2)
      kernels[n++] = &avx2::kernels;
    if (has_avx2 && __builtin_cpu_supports("avx512f") != 0 &&
        __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
        __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512cd") != 0)
      kernels[n++] = &avx512::kernels;
#endif
  }
};

const List& list() {
  static const List all;
  return all;
}

} // namespace

const Kernels* const* all_kernels(int& n) {
  n = list().n;
  return list().kernels;
}

const Kernels& best_kernels() {
  return *list().kernels[list().n - 1];
}

} // namespace prosup::fdm::kernel
