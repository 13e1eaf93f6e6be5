// Makes the record that laws are fitted to from the raw record (Cucuzza et al. 2025, section 3) and notes every step.
#pragma once

#include <optional>

#include "isolaw/data/cycles/selection.hpp"
#include "isolaw/data/cycles/swings.hpp"
#include "isolaw/data/properties/properties.hpp"
#include "isolaw/data/signals/smoothing.hpp"

namespace isolaw::data {

// campaign::setting_table() has the allowed values.
struct CleanOptions {
  int smooth = 1;                              // window of the centred moving average, odd; 1 = none
  std::optional<int> samples_per_cycle = 200;  // keep at least this many samples per cycle (20 or more); nullopt: all
  bool center = false;                         // subtract the mean of the extremes of displacement and force
  std::optional<double> dead_band_mm = {};     // see FitRecord::dead_band_mm; nullopt = three sigma of the noise
  // How much each sample counts in the objective (see swings.hpp). nullopt: by swing, or by time if all swings are
  // alike.
  std::optional<Weighting> weights = {};
  Selection scored = {};  // blocks and cycles that the objective counts
};

// The steps of cleaning are:
// 1. If `center`: subtract (max + min) / 2 of the reported cycle (Properties::reported) in the raw record.
// 2. Take the moving average over `smooth` samples.
// 3. Divide the record's samples per cycle by samples_per_cycle and round down to k. If k > 1, take the moving average
//    over k samples (k + 1 if k is even).
// 4. Compute the velocity before step 5 drops samples, because all samples make it more exact.
// 5. Keep every k-th sample. A record without a complete cycle keeps all samples.
// If the record holds several tests, each is cleaned by itself. The largest dead band of the tests holds for all, and
// the swings of all tests together decide how samples are weighted. Throws Error for a record without samples.
FitRecord clean(TestRecord const& raw, CleanOptions const& options);
FitRecord clean(TestRecord const& raw, Properties const& properties, CleanOptions const& options);

// The dead band for a displacement: three standard deviations of its noise. Normally distributed noise exceeds this in
// one of about 400 samples. 0 if there is no noise beyond rounding errors.
double dead_band_of(std::vector<double> const& disp_mm);

// Makes a record from which a law computes its force: all samples of the displacement, and the velocity if there is
// time, but no measured force.
FitRecord motion_of(TestRecord const& record);

}  // namespace isolaw::data
