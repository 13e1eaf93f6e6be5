// How far a law's parameters hold for the whole lot (sections 5 and 6 of Cucuzza et al. 2025, Eqs. 28-31).
//
// Each takes the means of a parameter over the runs, one per device. Differences are relative to the mean over the
// devices, so nothing is defined where that mean is no larger than rounding: |mean| <= 1e-9 times the largest |value|.
// Nor is anything where a device's mean is not finite: who computes it decides which devices take part.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isolaw::lot {

// Percentage difference of each device's mean from the mean over devices, 100 (mu_d - mean) / mean as Eq. (30) has it:
// positive means larger in magnitude. Empty when undefined.
std::vector<double> percent_differences(std::span<double const> device_means);

// Delta_n of one parameter, Eq. (29)-(30): the largest |mu_d - mean| / |mean|. nullopt when undefined, which includes
// fewer than two devices.
std::optional<double> largest_relative_difference(std::span<double const> device_means);

struct Robustness {
  std::optional<double> beta;  // Eq. (31); smaller is more robust
  std::string note;            // why it is null: one device, a mean near zero (which parameters)
};

// names[n] and device_means[n][d] over the law's free parameters n and devices d. One parameter without a Delta_n
// leaves beta undefined: a mean over the others would not be comparable between laws.
Robustness robustness_index(std::vector<std::string> const& names,
                            std::vector<std::vector<double>> const& device_means);

}  // namespace isolaw::lot
