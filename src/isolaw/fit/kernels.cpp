// Compiles the laws for batches of candidates, once for every instruction set. The variable ISOLAW_KERNELS (for example
// kernels_avx2) is all that other files may use. If two object files define a function of the same mangled name, the
// linker keeps one, perhaps one that this processor cannot run. The name of a function that is not inlined must
// therefore contain the instruction set. It does if num::Batch, whose namespace is named after the instruction set, is
// among its template arguments. tests/kernels checks this.
#include "isolaw/fit/kernels.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "isolaw/laws/all_laws.hpp"
#include "isolaw/num/batch.hpp"

namespace isolaw::fit {
namespace {

// T is a template parameter so that the name of the compiled function contains the instruction set.
template <class Law, std::size_t W, class T>
laws::ParamsOf<Law, T> load(double const* parameters, std::size_t block = W) {
  laws::ParamsOf<Law, T> params;
  for (std::size_t i = 0; i < laws::parameter_count<Law>; ++i)
    params.*laws::members<Law, T>[i] = T::load(parameters + i * block);
  return params;
}

template <class Law, std::size_t W, class T = num::Batch<W>>
void sums(double const* parameters, std::size_t block, KernelRecord const& record, laws::Integration integration,
          double* out) {
  auto const params = load<Law, W, T>(parameters, block);
  T sum(0.0);
  double const *measured = record.measured.data(), *weight = record.weight.data();
  laws::run<Law, T>(params, record.path, integration, [&](std::size_t i, T const& force) ISOLAW_LAMBDA {
    sum += T(weight[i]) * abs(T(measured[i]) - force);
  });
  sum.store(out);
}

// True for laws that need so many registers that eight vectors at once take more than twice as long as four vectors.
template <class Law>
inline constexpr bool crowded = requires {
  Law::crowded;
};

// Computes the objectives of a block of candidates in parts if the whole block would need more registers than the
// processor has.
template <class Law, std::size_t Block, class T = num::Batch<Block>>
void objectives(double const* parameters, KernelRecord const& record, laws::Integration integration, double* out) {
  constexpr auto part = Block > 8 * num::vector_lanes ? narrow_block
                        : crowded<Law>                ? std::min(Block, 4 * num::vector_lanes)
                                                      : Block;
  for (std::size_t i = 0; i < Block; i += part) sums<Law, part>(parameters + i, Block, record, integration, out + i);
}

template <class Law, std::size_t Block, class T = num::Batch<Block>>
void residuals(double const* parameters, laws::Path const& path, laws::Integration integration, double const* measured,
               double scale, double* rows, std::size_t stride) {
  constexpr auto part = Block > 4 * num::vector_lanes ? narrow_block : Block;
  using Part = num::Batch<part>;
  for (std::size_t first = 0; first < Block; first += part) {
    auto const params = load<Law, part, Part>(parameters + first, Block);
    laws::run<Law, Part>(params, path, integration, [&](std::size_t i, Part const& force) ISOLAW_LAMBDA {
      ((Part(measured[i]) - force) * Part(scale)).store(rows + i * stride + first);
    });
  }
}

}  // namespace

using Kernels = std::array<Kernel, std::tuple_size_v<laws::AllLaws>>;
extern Kernels const ISOLAW_KERNELS;
constinit Kernels const ISOLAW_KERNELS = []<class... Law>(std::tuple<Law...>*) {
  return Kernels{Kernel{objectives<Law, wide_block>, objectives<Law, narrow_block>, residuals<Law, residual_block>,
                        residuals<Law, narrow_block>}...};
}(static_cast<laws::AllLaws*>(nullptr));

}  // namespace isolaw::fit
