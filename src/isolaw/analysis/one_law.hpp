// Fits one parameter vector of a law to all devices of a lot, and computes how well it fits each of them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "isolaw/analysis/problems.hpp"
#include "isolaw/fit/objective.hpp"

namespace isolaw::analysis {

// The smallest box that contains the boxes of all devices. A scale that differs between devices becomes linear. Throws
// Error unless all devices have the same parameters free and the others fixed or tied alike.
fit::SearchBox common_box(std::span<fit::SearchBox const* const> boxes);

struct OneLaw {
  std::vector<double> parameters;  // all of the law's
  std::vector<double> objectives;  // one for each device
  double mean = 0.0, worst = 0.0;  // over the objectives
  int evaluations = 0;             // counted for each device's record
};

// The law with the least mean objective, by descents from the devices' own optima (at most a dozen, evenly chosen) and
// their median. optima[device] holds all parameters. nullopt if interrupted or no start has finite forces everywhere.
std::optional<OneLaw> least_mean(std::span<fit::LawOnRecord const* const> models, fit::SearchBox const& box,
                                 std::span<std::vector<double> const> optima, Interrupted const& interrupted = {});

// The parameters that make the worst device as good as possible. The search starts from the parameters of least mean
// and moves weight towards the worst device, until the weighted mean comes close to that device's objective. The least
// weighted mean is a lower bound: no parameters bring the worst device below it, if it is the global minimum.
struct LeastWorst {
  OneLaw law;
  double bound = 0.0;  // the largest weighted mean found, hence a lower bound for the worst device
};
std::optional<LeastWorst> least_worst(std::span<fit::LawOnRecord const* const> models, fit::SearchBox const& box,
                                      OneLaw const& mean, Interrupted const& interrupted = {});

// The law of least mean over all devices but one, judged on the device left out, as if that had not been tested.
// Descents start from the law of all devices and from the optima of other devices that suit those devices best.
struct LeftOut {
  std::vector<double> parameters;
  double objective = 0.0;  // on the device left out
  int evaluations = 0;
};
std::optional<LeftOut> leave_out(std::span<fit::LawOnRecord const* const> models, fit::SearchBox const& box,
                                 std::span<double const> parameters_of_all, std::span<std::vector<double> const> optima,
                                 std::size_t device);

}  // namespace isolaw::analysis
