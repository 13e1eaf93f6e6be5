// The robustness index beta: how little a law's parameters differ between the devices of a lot (Cucuzza et al. 2025,
// sections 5 and 6, Eqs. 28-31).
// The input is, for each device, the mean of a parameter over the runs of the search. Differences are relative to the
// mean over all devices. They are undefined if that mean is only a rounding error (|mean| <= 1e-9 times the largest
// |value|) or if the value of a device is not finite. The caller chooses the devices.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isolaw::lot {

// Difference of each device's value mu_d from the mean over devices in percent, 100 (mu_d - mean) / mean, Eq. (30).
// Positive if mu_d is farther from zero than the mean. Empty if differences are undefined.
std::vector<double> percent_differences(std::span<double const> device_means);
// Delta_n of one parameter, Eqs. (29)-(30): the largest |mu_d - mean| / |mean|. nullopt for one device or if undefined.
std::optional<double> largest_relative_difference(std::span<double const> device_means);

struct Robustness {
  // Eq. (31): the mean of Delta_n over the parameters. With a smaller beta, the parameters differ less between devices.
  std::optional<double> beta;
  std::string note;  // why beta is undefined: no or one device, or the parameters whose mean is near zero; else empty
};

// names[n] and device_means[n][d] belong to free parameter n and device d. beta is undefined if Delta_n is undefined
// for one parameter, since a mean over the remaining parameters could not be compared between laws.
Robustness robustness_index(std::vector<std::string> const& names,
                            std::vector<std::vector<double>> const& device_means);

}  // namespace isolaw::lot
