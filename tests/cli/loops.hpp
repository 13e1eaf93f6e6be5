// Computes the expected properties of a cycle from the samples alone, and reads isolaw's tables and JSON.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/records.hpp"
#include "cli/run.hpp"
#include "page_data.hpp"

namespace isolaw::cli_test {

struct Loop {
  double d_plus = 0.0, d_minus = 0.0, F_plus = 0.0, F_minus = 0.0, K_eff = 0.0, energy = 0.0, damping = 0.0;
};

// Returns the properties of the cycle from sample `first` to sample `last`, both included: K_eff from peak to peak,
// energy by trapezoids, and damping E/(2 pi K_eff D^2).
inline Loop loop_of(std::span<Sample const> samples, std::size_t first, std::size_t last) {
  auto const cycle = samples.subspan(first, last - first + 1);
  auto const [lowest, highest] = std::ranges::minmax(cycle, {}, &Sample::disp_mm);
  Loop loop{.d_plus = highest.disp_mm,
            .d_minus = lowest.disp_mm,
            .F_plus = highest.force_kN,
            .F_minus = lowest.force_kN,
            .K_eff = (highest.force_kN - lowest.force_kN) / (highest.disp_mm - lowest.disp_mm)};
  for (std::size_t i = 1; i < cycle.size(); ++i)
    loop.energy += (cycle[i].force_kN + cycle[i - 1].force_kN) / 2.0 * (cycle[i].disp_mm - cycle[i - 1].disp_mm);
  double const D = (loop.d_plus - loop.d_minus) / 2.0;
  loop.damping = 100.0 * loop.energy / (2.0 * std::numbers::pi * loop.K_eff * D * D);
  return loop;
}

inline void expect_loop(Json const& cycle, Loop const& loop, double share = 1e-6) {
  auto const near = [&](char const* key, double value) {
    EXPECT_NEAR(cycle[key].get<double>(), value, share * std::abs(value)) << key << " of " << cycle;
  };
  near("d_plus_mm", loop.d_plus);
  near("d_minus_mm", loop.d_minus);
  near("amplitude_mm", (loop.d_plus - loop.d_minus) / 2.0);
  near("F_plus_kN", loop.F_plus);
  near("F_minus_kN", loop.F_minus);
  near("K_plus_kN_per_mm", loop.F_plus / loop.d_plus);
  near("K_minus_kN_per_mm", loop.F_minus / loop.d_minus);
  near("K_eff_kN_per_mm", loop.K_eff);
  near("energy_kN_mm", loop.energy);
  near("damping_percent", loop.damping);
}

// Returns the cycle with this number in this block of a device. Only counted cycles are looked at: isolaw counts the
// complete cycles near the amplitude of their block (docs/glossary.md).
inline Json const& cycle_of(Json const& device, int block, int number) {
  for (auto const& one : device["blocks"])
    for (auto const& cycle : one["cycles"])
      if (one["number"] == block && cycle["counts"] == true && cycle["number"] == number) return cycle;
  throw std::runtime_error(fmt::format("no cycle {} of block {} in {}", number, block, device.dump().substr(0, 1000)));
}

// Splits a CSV table into rows of cells, without quotes. The first row has the names of the columns.
inline std::vector<Words> cells_of(std::string_view csv) {
  std::vector<Words> rows(1, Words(1));
  bool quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    char const c = csv[i];
    if (c == '"' && quoted && i + 1 < csv.size() && csv[i + 1] == '"')
      rows.back().back() += csv[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      rows.back().emplace_back();
    else if (c == '\n' && !quoted)
      rows.emplace_back(1);
    else if (c != '\r')
      rows.back().back() += c;
  }
  if (rows.back() == Words(1)) rows.pop_back();
  return rows;
}

inline std::string cell(std::vector<Words> const& rows, std::size_t row, std::string_view name) {
  auto const found = std::ranges::find(rows.at(0), name);
  if (found == rows[0].end()) throw std::runtime_error("no column " + std::string(name));
  return rows.at(row).at(static_cast<std::size_t>(found - rows[0].begin()));
}
inline double number(std::vector<Words> const& rows, std::size_t row, std::string_view name) {
  return std::stod(cell(rows, row, name));
}

// Collects all values of the key `verdict`, at any depth.
inline void collect_verdicts(Json const& json, std::vector<std::string>& found) {
  if (json.is_object())
    for (auto const& [key, value] : json.items())
      if (key == "verdict" && value.is_string()) found.push_back(value);
  for (auto const& value : json)
    if (value.is_structured()) collect_verdicts(value, found);
}
inline std::vector<std::string> verdicts_of(Json const& json) {
  std::vector<std::string> found;
  collect_verdicts(json, found);
  return found;
}

}  // namespace isolaw::cli_test
