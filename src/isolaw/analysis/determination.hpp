// Finds which parameters of a law a test determines: how far each may change before the loop gets visibly worse, and
// which of them trade off against each other.
// A parameter is judged by the profile of the objective: it is held at a value and all others are fitted again. The
// test leaves open the range in which the objective stays within `rise` of its least value (profiles: Raue et al. 2009,
// Bioinformatics 25, 1923). Directions in which several parameters change together while the forces stay the same are
// right singular vectors of the scaled Jacobian (Golub and Van Loan, Matrix Computations, sec. 5.5).
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
// A rise of the objective is invisible in the loops up to visible_rise times its least value, or least_visible_rise.
inline constexpr double visible_rise = 0.01, least_visible_rise = 1e-4;
// A parameter is determined, or weakly determined, if its open range reaches no farther than this from its value,
// relative to the value (or to a hundredth of the box, if the box spans zero and this is larger).
inline constexpr double determined_within = 0.05, weakly_determined_within = 0.5;

struct Profile {  // the least objective with the parameter held at each of these values, in rising order
  std::vector<double> value;
  std::vector<double> objective;
};

struct ParameterDetermination {
  std::size_t parameter = 0;  // index among the law's parameters
  Verdict verdict = Verdict::determined;
  double lower = 0.0, upper = 0.0;              // the open range, in the law's units
  bool open_below = false, open_above = false;  // the range ends at the edge of the box, before the objective has risen
  Profile profile;
};

// Parameters that can change together without a visible change of the loop; or a single one that has no effect.
struct TradeOff {
  std::vector<std::size_t> parameters;  // indices among the law's parameters
  std::vector<double> change;           // the relative change of each; the largest is 1
  double force_change = 0.0;            // resulting root mean square change of the force / its standard deviation
  std::string sentence;
};

struct Determination {
  // All of the law's parameters. Differs from the given optimum if a profile found a lower objective.
  std::vector<double> optimum;
  double objective = 0.0;
  double rise = 0.0;  // the rise of the objective that ends the open ranges
  // Singular values of the Jacobian for relative changes, falling; without parameters at a bound or without effect.
  std::vector<double> singular_values;
  std::vector<ParameterDetermination> parameters;  // the free ones, in order
  std::vector<TradeOff> trade_offs;
  int evaluations = 0;
};

// `optimum` holds all of the law's parameters. nullopt if interrupted.
std::optional<Determination> determine(fit::LawOnRecord const& model, fit::SearchBox const& box,
                                       std::span<double const> optimum, Interrupted const& interrupted = {});

// The sentence for a trade-off, from the names and relative changes of its parameters; the largest change is 1.
std::string trade_off_sentence(std::vector<std::string> const& names, std::span<double const> change);

}  // namespace isolaw::analysis
