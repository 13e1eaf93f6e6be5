#include "isolaw/study/typical_device.hpp"

#include <cmath>
#include <vector>

#include "isolaw/num/statistics.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::study {
namespace {

using Values = std::vector<std::optional<double>>;  // one for each device

void add_distances(Values const& values, std::vector<double>& sums, std::vector<int>& counts) {
  std::vector<double> known;
  for (auto const& value : values)
    if (value && std::isfinite(*value)) known.push_back(*value);
  if (known.empty()) return;
  double const mean = num::moments(known).mean;
  if (mean == 0.0) return;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i] || !std::isfinite(*values[i])) continue;
    sums[i] += std::abs(*values[i] / mean - 1.0);
    ++counts[i];
  }
}

}  // namespace

std::optional<std::size_t> typical_device(Summary const& summary) {
  auto const& devices = summary.devices;
  std::vector<double> stiffness(devices.size()), objectives(devices.size());
  std::vector<int> stiffnesses(devices.size()), laws(devices.size());
  Values values;
  for (auto const& device : devices)
    values.push_back(device.counts() && device.properties.reported
                         ? std::optional(device.properties.reported->K_eff_kN_per_mm)
                         : std::nullopt);
  add_distances(values, stiffness, stiffnesses);
  for (auto const& law : summary.laws) {
    values.clear();
    for (auto const& device : devices) {
      auto const* fit = fit_of(law, device.name);
      values.push_back(fit != nullptr && fit->counts ? fit->objective.mean : std::nullopt);
    }
    add_distances(values, objectives, laws);
  }
  std::optional<std::size_t> nearest;
  double least = 0.0;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    if (devices[i].status != "ok" || !devices[i].counts() || devices[i].record.size() + devices[i].raw.size() == 0)
      continue;
    double const distance = stiffness[i] + (laws[i] > 0 ? objectives[i] / laws[i] : 0.0);
    bool const is_known = stiffnesses[i] + laws[i] > 0;
    if (nearest && (!is_known || distance >= least)) continue;
    nearest = i;
    least = is_known ? distance : HUGE_VAL;
  }
  return nearest;
}

}  // namespace isolaw::study
