// How far a law's parameters hold for the whole lot (sections 5 and 6 of the paper, Eqs. 28-31).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isolaw::lot {

// Percentage difference of each device's mean from the mean over devices; empty when that mean is (nearly) zero.
std::vector<double> percent_differences(std::span<double const> device_means);

// Delta_n of one parameter, Eq. (28)-(30): the largest |mu_d - mean| / |mean|. nullopt when undefined.
std::optional<double> largest_relative_difference(std::span<double const> device_means);

struct Robustness {
  std::optional<double> beta;  // Eq. (31); smaller is more robust
  std::string note;            // why it is null: one device, a mean near zero (which parameter)
};

// names[n] and device_means[n][d] over the law's free parameters n and devices d.
Robustness robustness_index(std::vector<std::string> const& names,
                            std::vector<std::vector<double>> const& device_means);

}  // namespace isolaw::lot
