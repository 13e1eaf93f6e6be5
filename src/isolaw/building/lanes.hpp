// Computes many draws of a building at once by the explicit path of stepping.hpp, one per lane, compiled once per
// instruction set (lane_kernels.cpp). Lanes never mix: a result depends neither on other draws nor on threads.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "isolaw/building/integrate.hpp"
#include "isolaw/building/lane_run.hpp"
#include "isolaw/num/instruction_set.hpp"

namespace isolaw::building {

// nullptr for `scalar`, and for a law without a coupled form.
LaneKernel const* lane_kernel(num::InstructionSet set, std::string_view law);
// Returns the measures [draw][measure] of `draws` [draw][bearing][parameter], parameters in the law's order and units.
// Failed draws have measures that are not finite. Couplings other than `coupled` use the implicit path, draw by draw,
// since their laws may depend on the velocity too steeply for an explicit step. The explicit path uses only
// longest_step_s and rest_s.
std::vector<double> respond(Model const& model, std::string_view law, std::span<double const> draws,
                            Motion const& motion, Options const& options, Coupling coupling = Coupling::coupled,
                            num::InstructionSet set = num::instruction_set());

// The longest step [s] of the explicit path on bearings with this stiffness at rest ([bearing], 2 x 2 by rows):
// dt^2 K = m / 2, an eighth of the limit of stability, which leaves a margin for draws that are twice as stiff.
double longest_explicit_step(Model const& model, std::span<std::array<double, 4> const> first_stiffness);

}  // namespace isolaw::building
