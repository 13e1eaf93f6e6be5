// Fits one set of parameters of a law to all devices of a lot and computes its objective on each device.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "isolaw/analysis/problems.hpp"
#include "isolaw/fit/objective.hpp"

namespace isolaw::analysis {

// The smallest box that contains all given boxes. A parameter gets a linear scale unless its scale is logarithmic in
// all boxes. Throws Error unless a parameter is free in all boxes, fixed at the same value in all, or tied to the same
// parameter in all.
fit::SearchBox common_box(std::span<fit::SearchBox const* const> boxes);

struct OneLaw {
  std::vector<double> parameters;  // all parameters of the law
  std::vector<double> objectives;  // the law's objective on each device
  double mean = 0.0, worst = 0.0;  // mean and largest value of `objectives`
  int evaluations = 0;             // how often the law was computed for one device
};

// Finds the parameters with the smallest mean objective over the devices. Descents start from the median of the
// devices' own optima and from up to twelve of these optima. optima[device] holds all parameters of the law. nullopt if
// interrupted or if no start has finite forces.
std::optional<OneLaw> least_mean(std::span<fit::LawOnRecord const* const> models, fit::SearchBox const& box,
                                 std::span<std::vector<double> const> optima, Interrupted const& interrupted = {});

// Finds the parameters with the smallest objective on the worst device. The search starts from `mean`. In each round it
// gives devices with a large objective more weight and minimises the weighted mean. Whatever the parameters, the worst
// device cannot have a smaller objective than this minimum, so it is a lower bound (if the descent found the global
// minimum). The search ends when the worst device is within 0.1 % of the largest bound, and at the latest after 40
// rounds.
struct LeastWorst {
  OneLaw law;
  double bound = 0.0;  // lower bound for the worst device's objective with any parameters
};
std::optional<LeastWorst> least_worst(std::span<fit::LawOnRecord const* const> models, fit::SearchBox const& box,
                                      OneLaw const& mean, Interrupted const& interrupted = {});

// Finds the parameters with the smallest mean objective over all devices except `device`, and computes their objective
// on this device, as if it had not been tested. Descents start from the parameters for all devices and from three
// optima of other devices, those with the smallest mean objective.
struct LeftOutFit {
  std::vector<double> parameters;
  double objective = 0.0;  // objective of these parameters on the device that was left out
  int evaluations = 0;
};
std::optional<LeftOutFit> leave_out(std::span<fit::LawOnRecord const* const> models, fit::SearchBox const& box,
                                    std::span<double const> parameters_of_all,
                                    std::span<std::vector<double> const> optima, std::size_t device);

}  // namespace isolaw::analysis
