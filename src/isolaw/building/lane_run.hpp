// The types of the lane kernels and of their arguments. They are not in lanes.hpp, because lanes.hpp includes functions
// that must not be compiled once per instruction set (lane_kernels.cpp).
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "isolaw/building/stepping.hpp"

namespace isolaw::building {

inline constexpr std::size_t lane_width = 8;

struct LaneRun {
  StructureArrays arrays;
  ModeStep step;
  double const* inverse = nullptr;  // [3][3], inverse of Model::condensed_mass()
  Ground ground;
  double const* parameters = nullptr;  // parameters of the law, [bearing][parameter][lane]
  double length = 1.0, force = 1.0;    // the law's unit of length in mm, and its unit of force in kN
  void* memory = nullptr;              // scratch space, aligned to 64 bytes; LaneKernel says how large
  double* measured = nullptr;          // results, [measure in the order of Layout][lane]
};
struct LaneKernel {
  std::string_view law;
  void (*run)(LaneRun const&) = nullptr;
  // LaneRun::memory needs state_bytes for each bearing's state and parameters, and memory_bytes_a_scalar for each of
  // the run_scalars() numbers.
  std::size_t memory_bytes_a_scalar = 0, state_bytes = 0;
};

}  // namespace isolaw::building
