// Finds out which parameters of a law are determined by a test: how far each can change before the loop gets visibly
// worse, and which parameters can compensate each other. Each parameter is judged by a profile of the objective: the
// parameter is held at several values, and at each value all others are fitted again. In the open range of the
// parameter, the objective stays within `rise` of its least value (Raue et al. 2009, Bioinformatics 25, 1923).
// Trade-offs are changes of several parameters that leave the forces as they are. They are right singular vectors of
// the scaled Jacobian (Golub and Van Loan, Matrix Computations, sec. 5.5).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/analysis/problems.hpp"
#include "isolaw/fit/objective.hpp"

namespace isolaw::analysis {

enum class Verdict { determined, weakly_determined, undetermined, at_bound };
std::string_view name(Verdict verdict);  // "determined", "weakly determined", "undetermined", "at its bound"
// A loop looks as good as the best one if its objective is at most max(visible_rise * least objective,
// least_visible_rise) above the least objective.
inline constexpr double visible_rise = 0.01, least_visible_rise = 1e-4;
// A parameter is determined if both ends of its open range lie within the first of these distances of its value, and
// weakly determined if they lie within the second. Distances are divided by |value|; if the box spans zero, the divisor
// is at least a hundredth of the box's width.
inline constexpr double determined_within = 0.05, weakly_determined_within = 0.5;

// The profile of one parameter. If the parameter is held at value[i], objective[i] is the least objective that a fit of
// all other parameters reaches. `value` is in rising order.
struct Profile {
  std::vector<double> value;
  std::vector<double> objective;
};

struct ParameterDetermination {
  std::size_t parameter = 0;  // index among the law's parameters
  Verdict verdict = Verdict::determined;
  double lower = 0.0, upper = 0.0;  // the open range (see the top of this file), in the law's units
  // True if this end of the range is the edge of the search box: up to there the objective has not risen visibly.
  bool open_below = false, open_above = false;
  Profile profile;
};

// Parameters that can change together without a visible change of the loop, or a single parameter without effect.
struct TradeOff {
  std::vector<std::size_t> parameters;  // indices among the law's parameters
  std::vector<double> change;           // how much each changes, relative to its value; scaled so that the largest is 1
  // How much `change` alters the force: root mean square of the difference / standard deviation of the force.
  double force_change = 0.0;
  std::string sentence;
};

struct Determination {
  // Values of all parameters. They differ from the given optimum if a profile found a lower objective.
  std::vector<double> optimum;
  double objective = 0.0;
  double rise = 0.0;  // by how much the objective at the ends of the open ranges exceeds its least value
  // Singular values, the largest first, of the force's derivatives with respect to relative changes of the parameters.
  // Parameters at a bound or without effect are left out.
  std::vector<double> singular_values;
  std::vector<ParameterDetermination> parameters;  // the free parameters, in the law's order
  std::vector<TradeOff> trade_offs;
  int evaluations = 0;
};

// `optimum` holds all of the law's parameters. Returns nullopt if interrupted.
std::optional<Determination> determine(fit::LawOnRecord const& model, fit::SearchBox const& box,
                                       std::span<double const> optimum, Interrupted const& interrupted = {});

// A sentence about a trade-off between the named parameters. `change` are their relative changes; the largest is 1.
std::string trade_off_sentence(std::vector<std::string> const& names, std::span<double const> change);

}  // namespace isolaw::analysis
