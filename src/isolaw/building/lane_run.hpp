// What the kernels of lanes.hpp take and are; without what cannot be compiled beside them.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "isolaw/building/stepping.hpp"

namespace isolaw::building {

inline constexpr std::size_t lane_width = 8;

// What a kernel needs; `parameters` [bearing][parameter][lane], `memory` of 64-byte alignment.
struct LaneRun {
  StructureArrays skeleton;
  ModeStep step;
  double const* inverse = nullptr;
  Ground ground;
  double const* parameters = nullptr;
  double length = 1.0, force = 1.0;  // mm and kN in one of the law's units
  void* memory = nullptr;
  double* measured = nullptr;  // [measure][lane]
};
struct LaneKernel {
  std::string_view law;
  void (*run)(LaneRun const&) = nullptr;
  std::size_t memory_bytes_a_scalar = 0, state_bytes = 0;
};

}  // namespace isolaw::building
