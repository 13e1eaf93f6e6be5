#include "isolaw/building/lanes.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <tuple>

#include "isolaw/laws/catalogue.hpp"
#include "isolaw/laws/plane/plane.hpp"

namespace isolaw::building {

using LaneKernels = std::array<LaneKernel, std::tuple_size_v<laws::plane::AllLaws>>;
extern LaneKernels const lane_kernels_portable;
#if defined(ISOLAW_X86_KERNELS)
extern LaneKernels const lane_kernels_avx2, lane_kernels_avx512;
#endif

LaneKernel const* lane_kernel(num::InstructionSet set, std::string_view law) {
  if (set == num::InstructionSet::scalar) return nullptr;
  auto const* kernels = &lane_kernels_portable;
#if defined(ISOLAW_X86_KERNELS)
  if (set == num::InstructionSet::avx512) kernels = &lane_kernels_avx512;
  if (set == num::InstructionSet::avx2) kernels = &lane_kernels_avx2;
#endif
  auto const found = std::ranges::find(*kernels, law, &LaneKernel::law);
  return found == kernels->end() ? nullptr : &*found;
}

namespace {

constexpr std::align_val_t alignment{64};
struct Release {
  void operator()(void* memory) const { ::operator delete(memory, alignment); }
};

}  // namespace

std::vector<double> respond(Model const& model, std::string_view law, std::span<double const> draws,
                            Motion const& motion, Options const& options, Coupling coupling, num::InstructionSet set) {
  auto const& entry = laws::find_law(law);
  auto const layout = model.layout();
  std::size_t const parameters = entry.parameters.size(), bearings = layout.bearings, each = bearings * parameters;
  std::size_t const count = draws.size() / each;
  std::vector<double> out(count * layout.count());
  auto const* const kernel = coupling == Coupling::coupled ? lane_kernel(set, law) : nullptr;
  if (kernel == nullptr) {
    for (std::size_t draw = 0; draw < count; ++draw) {
      std::vector<std::unique_ptr<Bearing>> devices;
      for (std::size_t j = 0; j < bearings; ++j)
        devices.push_back(make_bearing(law, draws.subspan(draw * each + j * parameters, parameters), coupling));
      auto response = coupling == Coupling::coupled ? integrate_explicitly(model, devices, motion, options)
                                                    : integrate(model, devices, motion, options);
      if (response.outcome != Outcome::completed)
        std::ranges::fill(response.measured, std::numeric_limits<double>::quiet_NaN());
      std::ranges::copy(response.measured, out.begin() + static_cast<std::ptrdiff_t>(draw * layout.count()));
    }
    return out;
  }
  auto const steps = steps_of(motion, options.longest_step_s, options.rest_s);
  auto const share = model.shares(steps.dt);
  Matrix3 const inverse = model.condensed_mass(steps.dt).inverse();
  double rows[9];
  for (Eigen::Index i = 0; i < 9; ++i) rows[i] = inverse(i / 3, i % 3);
  std::size_t const bytes =
      bearings * kernel->state_bytes + run_scalars(model.structure().modes(), layout) * kernel->memory_bytes_a_scalar;
  std::unique_ptr<void, Release> const memory(::operator new(bytes, alignment));
  std::vector<double> values(each * lane_width), measured(layout.count() * lane_width);
  LaneRun run{.arrays = model.arrays(),
              .step = {.dt = steps.dt, .share = share.data()},
              .inverse = rows,
              .ground = {.x = motion.x_mm_s2.data(),
                         .y = motion.y_mm_s2.empty() ? nullptr : motion.y_mm_s2.data(),
                         .samples = motion.x_mm_s2.size(),
                         .parts = steps.parts,
                         .steps = steps.count,
                         .asked = options.interrupted ? asks : nullptr,
                         .interruption = &options.interrupted},
              .parameters = values.data(),
              .length = entry.info.length.in_record_units,
              .force = entry.info.force.in_record_units,
              .memory = memory.get(),
              .measured = measured.data()};
  for (std::size_t first = 0; first < count; first += lane_width) {
    for (std::size_t lane = 0; lane < lane_width; ++lane) {
      // If there are fewer draws left than lanes, the last draw fills the other lanes.
      auto const draw = draws.subspan(std::min(first + lane, count - 1) * each, each);
      for (std::size_t i = 0; i < each; ++i) values[i * lane_width + lane] = draw[i];
    }
    kernel->run(run);
    if (options.interrupted && options.interrupted()) throw InterruptedRun();
    for (std::size_t lane = 0; lane < lane_width && first + lane < count; ++lane)
      for (std::size_t i = 0; i < layout.count(); ++i)
        out[(first + lane) * layout.count() + i] = measured[i * lane_width + lane];
  }
  return out;
}

double longest_explicit_step(Model const& model, std::span<std::array<double, 4> const> first_stiffness) {
  Matrix3 const root = model.structure().base_mass().diagonal().cwiseSqrt().cwiseInverse().asDiagonal();
  auto const values = num::symmetric_eigen(root * model.stiffness(first_stiffness) * root).values;
  return std::sqrt(0.5 / std::max(values.maxCoeff(), 1e-12));
}

}  // namespace isolaw::building
