#include <array>
#include <tuple>

#include "isolaw/fit/kernels.hpp"
#include "isolaw/laws/all_laws.hpp"

namespace isolaw::fit {

using Kernels = std::array<Kernel, std::tuple_size_v<laws::AllLaws>>;
extern Kernels const kernels_portable;
#if defined(ISOLAW_X86_KERNELS)
extern Kernels const kernels_avx2, kernels_avx512;
#endif

Kernel kernel(InstructionSet set, std::size_t law) {
#if defined(ISOLAW_X86_KERNELS)
  if (set == InstructionSet::avx512) return kernels_avx512.at(law);
  if (set == InstructionSet::avx2) return kernels_avx2.at(law);
#else
  static_cast<void>(set);
#endif
  return kernels_portable.at(law);
}

}  // namespace isolaw::fit
