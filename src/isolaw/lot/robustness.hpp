// The robustness index: how far a law's parameters hold for the whole lot (Cucuzza et al. 2025, sections 5 and 6,
// Eqs. 28-31).
// The input is a parameter's mean over the runs, one for each device. Differences are relative to the mean over the
// devices. They are undefined if that mean is only rounding error (|mean| <= 1e-9 times the largest |value|) or if a
// device's mean is not finite: the caller decides which devices take part.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isolaw::lot {

// The difference of each device's mean from the mean over devices in percent, 100 (mu_d - mean) / mean as in Eq. (30);
// positive if it is larger in magnitude. Empty if undefined.
std::vector<double> percent_differences(std::span<double const> device_means);
// Delta_n of one parameter, Eqs. (29)-(30): the largest |mu_d - mean| / |mean|. nullopt if undefined or for one device.
std::optional<double> largest_relative_difference(std::span<double const> device_means);

struct Robustness {
  std::optional<double> beta;  // Eq. (31); smaller is more robust
  std::string note;            // why beta is undefined, for instance which parameters have a mean near zero
};

// names[n] and device_means[n][d] for the law's free parameters n and devices d. A single parameter without a Delta_n
// leaves beta undefined: a mean over the others could not be compared between laws.
Robustness robustness_index(std::vector<std::string> const& names,
                            std::vector<std::vector<double>> const& device_means);

}  // namespace isolaw::lot
