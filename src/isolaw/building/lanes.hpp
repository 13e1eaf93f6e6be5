// Integrates many drawn buildings at once by explicit_run() of stepping.hpp, one per SIMD lane (lane_kernels.cpp). The
// result of a draw depends neither on the other draws nor on the number of threads.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "isolaw/building/integrate.hpp"
#include "isolaw/building/lane_run.hpp"
#include "isolaw/num/instruction_set.hpp"

namespace isolaw::building {

// Finds the function that integrates buildings with this law in SIMD lanes. Returns nullptr if `set` is `scalar`, and
// for a law without a two-dimensional form.
LaneKernel const* lane_kernel(num::InstructionSet set, std::string_view law);
// Returns the measures [draw][measure] of `draws` [draw][bearing][parameter], with parameters in the law's order and
// units. A draw that failed has measures that are not finite. If `coupling` is not `coupled`, each draw is integrated
// implicitly, since its law may depend on the velocity too steeply for an explicit step. The explicit integration uses
// only longest_step_s, rest_s and interrupted of the options.
std::vector<double> respond(Model const& model, std::string_view law, std::span<double const> draws,
                            Motion const& motion, Options const& options, Coupling coupling = Coupling::coupled,
                            num::InstructionSet set = num::instruction_set());

// The longest step dt [s] of the explicit integration on bearings with this stiffness at rest ([bearing], 2 x 2 by
// rows). It follows from dt^2 K = m / 2, with the stiffness K of the bearings and the mass m of the base slab. Steps
// are stable for dt^2 K < 4 m, so there is a margin for draws that are stiffer.
double longest_explicit_step(Model const& model, std::span<std::array<double, 4> const> first_stiffness);

}  // namespace isolaw::building
