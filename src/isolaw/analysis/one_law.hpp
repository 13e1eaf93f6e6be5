// One parameter vector of a law for all devices of a lot, and what it costs each of them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "isolaw/analysis/problems.hpp"
#include "isolaw/fit/objective.hpp"

namespace isolaw::analysis {

// The box that holds those of all devices; what is fixed or tied must be the same. Throws Error otherwise. A scale that
// differs becomes linear.
fit::SearchBox common_box(std::span<fit::SearchBox const* const> boxes);

struct OneLaw {
  std::vector<double> parameters;  // all of the law's
  std::vector<double> objectives;  // of each device with them
  double mean = 0.0, worst = 0.0;  // of these
  int evaluations = 0;             // of one device's record each
};

// The least mean over the devices: descents from each device's own optimum (evenly chosen ones where there are more
// than a dozen) and from their median. `optima`: all of the law's parameters, per device. nullopt when interrupted or
// where no start has a finite force on every device.
std::optional<OneLaw> least_mean(std::span<fit::LawOnRecord const* const> models, fit::SearchBox const& box,
                                 std::span<std::vector<double> const> optima, Interrupted const& interrupted = {});

// The least objective of the worst device, from the law of least mean: shares of the devices are moved towards the
// worst until the weighted mean, which no law undercuts where its descent is global, is close to the worst.
struct LeastWorst {
  OneLaw law;
  double bound = 0.0;  // the largest weighted mean met: the worst device cannot be brought below it
};
std::optional<LeastWorst> least_worst(std::span<fit::LawOnRecord const* const> models, fit::SearchBox const& box,
                                      OneLaw const& mean, Interrupted const& interrupted = {});

// The law of least mean of all devices but one, judged by the one: what an engineer meets who has not tested the
// device. Descents start from the law of all and from those of the others' own optima that suit the others best.
struct LeftOut {
  std::vector<double> parameters;
  double objective = 0.0;  // of the device left out
  int evaluations = 0;
};
std::optional<LeftOut> leave_out(std::span<fit::LawOnRecord const* const> models, fit::SearchBox const& box,
                                 std::span<double const> parameters_of_all, std::span<std::vector<double> const> optima,
                                 std::size_t device);

}  // namespace isolaw::analysis
