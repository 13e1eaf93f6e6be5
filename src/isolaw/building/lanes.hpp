// Many draws of a building at once: one motion, every bearing of every draw with parameters of its own, one draw in a
// lane. The explicit path of stepping.hpp, compiled once per instruction set (lane_kernels.cpp). No draw notices
// another, so that a result depends neither on what stands beside it nor on threads.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "isolaw/building/integrate.hpp"
#include "isolaw/building/lane_run.hpp"
#include "isolaw/num/instruction_set.hpp"

namespace isolaw::building {

// nullptr: no kernel, as for `scalar` or a law without a coupled form.
LaneKernel const* lane_kernel(num::InstructionSet set, std::string_view law);

// The measures of `draws` [draw][bearing][parameter], [draw][measure]. Draws that are not finite come out so.
// Parameters in the law's order; longest_step_s and rest_s of `options` alone count. Springs, whose laws may depend on
// the rate as steeply as they like, go one by one by the implicit path; one that does not converge comes out as not a
// number.
std::vector<double> respond(Model const& model, std::string_view law, std::span<double const> draws,
                            Motion const& motion, Options const& options, Coupling coupling = Coupling::coupled,
                            num::InstructionSet set = num::instruction_set());

// The longest step of the explicit path on bearings as stiff as these at first, with margin for draws that are twice as
// stiff: dt^2 K <= m / 2, eight times below where it grows.
double longest_explicit_step(Model const& model, std::span<std::array<double, 4> const> first_stiffness);

}  // namespace isolaw::building
