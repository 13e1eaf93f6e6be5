// Finds the largest displacement and speed of the tests, and of the part that a law was fitted to, in the cleaned
// records. Exports state these ranges, and `simulate` compares a motion with them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "isolaw/data/channels/record.hpp"

namespace isolaw::study {

struct Range {
  double disp_mm = 0.0;
  std::optional<double> vel_mm_s;  // empty if no record has time
};

struct Ranges {
  Range tested, fitted;

  void add(data::FitRecord const& record) {
    widen(
        tested, record, [](std::size_t) { return true; }, [](std::size_t) { return true; });
    // A velocity is computed from the two neighbouring samples, so it is used only if both belong to the fitted part.
    auto const last = record.size() - 1;
    auto const scored = [&](std::size_t i) { return record.is_scored(i); };
    widen(fitted, record, scored, [&](std::size_t i) {
      return scored(i) && scored(i - std::min<std::size_t>(i, 1)) && scored(std::min(i + 1, last));
    });
  }

 private:
  static void widen(Range& range, data::FitRecord const& record, auto const& counts, auto const& velocity_counts) {
    for (std::size_t i = 0; i < record.size(); ++i)
      if (counts(i)) range.disp_mm = std::max(range.disp_mm, std::abs(record.disp_mm[i]));
    if (!record.has_time()) return;
    double fastest = range.vel_mm_s.value_or(0.0);
    for (std::size_t i = 0; i < record.size(); ++i)
      if (velocity_counts(i)) fastest = std::max(fastest, std::abs(record.vel_mm_s[i]));
    range.vel_mm_s = fastest;
  }
};

}  // namespace isolaw::study
