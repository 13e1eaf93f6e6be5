#include "isolaw/num/row_kernels.hpp"

namespace isolaw::num {

extern RowKernels const row_kernels_portable;
#if defined(ISOLAW_X86_KERNELS)
extern RowKernels const row_kernels_avx2, row_kernels_avx512;
#endif

RowKernels const& row_kernels() {
#if defined(ISOLAW_X86_KERNELS)
  auto const set = instruction_set();
  if (set == InstructionSet::avx512) return row_kernels_avx512;
  if (set == InstructionSet::avx2) return row_kernels_avx2;
#endif
  return row_kernels_portable;
}

}  // namespace isolaw::num
