// Makes the record that laws are fitted to from the raw record (Cucuzza et al. 2025, section 3) and notes every step.
#pragma once

#include <optional>

#include "isolaw/data/record.hpp"
#include "isolaw/data/selection.hpp"

namespace isolaw::data {

// campaign::setting_table() has the allowed values.
struct CleanOptions {
  int smooth = 1;                              // window of the centred moving average, odd; 1 = none
  std::optional<int> samples_per_cycle = 200;  // thinning to at least this many, 20 or more; nullopt = all samples
  bool center = false;                         // remove the mean of the extremes of displacement and force
  std::optional<double> dead_band_mm = {};     // FitRecord::dead_band_mm; nullopt = from the record's noise
  Selection scored = {};                       // blocks and cycles that laws are judged by
};

// The window (odd) shrinks symmetrically at the ends. The cost does not grow with the window.
std::vector<double> moving_average(std::vector<double> const& values, int window);

// Derivative of the parabola through three neighbouring samples at true time stamps: exact for quadratics on uneven
// spacing, also at the ends, where the parabola is one-sided. Units of x per s. time_s must increase.
std::vector<double> central_difference(std::vector<double> const& time_s, std::vector<double> const& values);

// The steps, in this order: centring by (max + min) / 2 of the raw reported cycle; moving average of `smooth`; if a
// cycle has at least twice the samples asked for, k = floor(ratio), a moving average of the odd window k or k + 1;
// velocity; every k-th sample. Velocity is computed before samples are dropped, so that thinning does not make it less
// exact. A record without a complete cycle keeps all samples. Throws Error for a record without samples.
FitRecord clean(TestRecord const& raw, CleanOptions const& options);

// Three standard deviations of the displacement's noise: one sample in 400 exceeds them. 0 for a record without noise.
double dead_band_of(std::vector<double> const& disp_mm);

// The record of a motion, for running a law on it: all samples, no force, velocity by central_difference().
FitRecord motion_of(TestRecord const& record);

}  // namespace isolaw::data
