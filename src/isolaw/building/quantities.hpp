// The quantities that a building study evaluates for every run: displacements, forces, accelerations, work.
#pragma once

#include <span>
#include <string_view>
#include "isolaw/building/runs.hpp"

namespace isolaw::building {

struct Quantity {
  std::string_view key, title, unit, meaning;
  double (*value)(Layout const& layout, std::span<double const> measured, double weight_kN);
  std::string_view uncovered = {};  // why bound analyses (coverage.hpp) cannot cover the quantity; empty if they can
};
std::span<Quantity const> quantities();
Quantity const& quantity(std::string_view key);

double measure_of(std::span<double const> measured, Measure which);
// a / b, or 0 if b is not positive.
double ratio(double a, double b);

}  // namespace isolaw::building
