// Explicit integration of a batch of draws, one per SIMD lane. This file is compiled once per instruction set, each
// time with another name for ISOLAW_LANE_KERNELS. Other files may use only that name: where functions in two object
// files have equal names, the linker keeps one, and that one may need instructions that the processor lacks.
#include <tuple>

#include "isolaw/building/lane_run.hpp"
#include "isolaw/laws/plane/plane.hpp"
#include "isolaw/num/batch.hpp"

namespace isolaw::building {
namespace {

// in.memory holds the states of all bearings, then the parameters of all bearings, then the scalars of the run.
template <class Law, class T = num::Batch<lane_width>>
void run_lanes(LaneRun const& in) {
  using Params = typename Law::template Params<T>;
  using State = typename Law::template State<T>;
  using Point = laws::plane::Vector<T>;
  constexpr auto& members = laws::members<typename Law::OneDirection, T>;
  constexpr auto count = laws::parameter_count<typename Law::OneDirection>;
  auto* const states = static_cast<State*>(in.memory);
  auto* const params = reinterpret_cast<Params*>(states + in.arrays.bearings);
  auto* const scalars = reinterpret_cast<T*>(params + in.arrays.bearings);
  for (std::size_t j = 0; j < in.arrays.bearings; ++j) {
    for (std::size_t i = 0; i < count; ++i)
      params[j].*members[i] = T::load(in.parameters + (j * count + i) * lane_width);
    states[j] = Law::template start<T>(params[j]);
  }
  Run<T> run;
  start_run(run, in.arrays, scalars);
  T const per_length(1.0 / in.length), per_force(in.force);
  double const dt = in.step.dt;
  explicit_run(run, in.arrays, in.step, in.inverse, in.ground,
               [&](std::size_t j, T const& x, T const& y, T const&, T const&, T& fx, T& fy) ISOLAW_LAMBDA {
                 Point const from{per_length * run.d[2 * j], per_length * run.d[2 * j + 1]};
                 Point const to{per_length * x, per_length * y};
                 Point const force = Law::template step<T>(params[j], states[j], from, to, dt);
                 fx = per_force * force.x, fy = per_force * force.y;
               });
  Layout const layout{in.arrays.floors, in.arrays.bearings};
  for (std::size_t i = 0; i < layout.count(); ++i) run.measured[i].store(in.measured + i * lane_width);
}

template <class Law, class T = num::Batch<lane_width>>
constexpr LaneKernel kernel_of() {
  return {Law::info.id, run_lanes<Law>, sizeof(T),
          sizeof(typename Law::template State<T>) + sizeof(typename Law::template Params<T>)};
}

}  // namespace

using LaneKernels = std::array<LaneKernel, std::tuple_size_v<laws::plane::AllLaws>>;
extern LaneKernels const ISOLAW_LANE_KERNELS;
constinit LaneKernels const ISOLAW_LANE_KERNELS = []<class... Law>(std::tuple<Law...>*) {
  return LaneKernels{kernel_of<Law>()...};
}(static_cast<laws::plane::AllLaws*>(nullptr));

}  // namespace isolaw::building
