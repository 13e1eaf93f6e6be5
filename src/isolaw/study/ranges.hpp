// How far the tests of a law went and how far it was fitted, over the samples of the records that laws are fitted to:
// what exports state and `simulate` holds a motion to.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "isolaw/data/record.hpp"

namespace isolaw::study {

// Largest magnitudes.
struct Range {
  double disp_mm = 0.0;
  std::optional<double> vel_mm_s;  // empty: no record has time
};

struct Ranges {
  Range tested, fitted;

  void add(data::FitRecord const& record) {
    auto const widen = [&](Range& range, auto const& largest) {
      range.disp_mm = std::max(range.disp_mm, largest(record.disp_mm));
      if (record.has_time()) range.vel_mm_s = std::max(range.vel_mm_s.value_or(0.0), largest(record.vel_mm_s));
    };
    widen(tested, [](std::vector<double> const& values) {
      double found = 0.0;
      for (double const value : values) found = std::max(found, std::abs(value));
      return found;
    });
    widen(fitted, [&](std::vector<double> const& values) { return record.largest_scored(values); });
  }
};

}  // namespace isolaw::study
