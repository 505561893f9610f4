#include "element_kernel.h"

namespace prosup::mechanics::kernel {

namespace {

#ifdef PROSUP_X86_KERNELS
bool has_avx2() {
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
}
bool has_avx512() {
  return has_avx2() && __builtin_cpu_supports("avx512f") != 0 &&
         __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
         __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512cd") != 0;
}
#endif

/// Kernels that this processor can run, the plainest first.
template <typename Real>
struct List {
  const Kernels<Real>* kernels[3];
  int n = 0;

  void add(const Kernels<Real>& set) { kernels[n++] = &set; }
};

List<double> list(double) {
  List<double> list;
  list.add(baseline::double_kernels);
#ifdef PROSUP_X86_KERNELS
  if (has_avx2())
    list.add(avx2::double_kernels);
  if (has_avx512())
    list.add(avx512::double_kernels);
#endif
  return list;
}

List<float> list(float) {
  List<float> list;
  list.add(baseline::float_kernels);
#ifdef PROSUP_X86_KERNELS
  if (has_avx2())
    list.add(avx2::float_kernels);
  if (has_avx512())
    list.add(avx512::float_kernels);
#endif
  return list;
}

} // namespace

template <typename Real>
const Kernels<Real>* const* all_kernels(int& n) {
  static const List<Real> all = list(Real());
  n = all.n;
  return all.kernels;
}

template const Kernels<double>* const* all_kernels<double>(int&);
template const Kernels<float>* const* all_kernels<float>(int&);

} // namespace prosup::mechanics::kernel
