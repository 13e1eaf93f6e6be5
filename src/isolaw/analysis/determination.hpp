// What a test determines of a law's parameters: how far each may go before the loop gets visibly worse, and which of
// them trade off.
//
// A parameter is judged by the profile of the objective: it is held at a value, all others are fitted again. The range
// in which the objective stays within `rise` of its least value is what the test leaves open. Directions along which
// several parameters change together and the forces do not are the right singular vectors of the scaled Jacobian (Golub
// and Van Loan, Matrix Computations, sec. 5.5; for parameters, Raue et al. 2009, Bioinformatics 25, 1923, on profiles).
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

// A rise of the objective that nobody sees in the loops: this share of the least value, or this much where that is
// zero.
inline constexpr double visible_rise = 0.01, least_visible_rise = 1e-4;
// Half of the open range, relative to the parameter (to no less than a hundredth of a box that spans zero), up to which
// it is determined, and weakly determined.
inline constexpr double determined_within = 0.05, weakly_determined_within = 0.5;

// The least objective with the parameter held at each of these values, all others fitted again; rising values.
struct Profile {
  std::vector<double> value;
  std::vector<double> objective;
};

struct ParameterDetermination {
  std::size_t parameter = 0;  // index among the law's
  Verdict verdict = Verdict::determined;
  double lower = 0.0, upper = 0.0;              // the open range
  bool open_below = false, open_above = false;  // it ends at the box, not where the objective has risen
  Profile profile;
};

// Parameters that can change together without the loop showing it; or one alone, which does not act.
struct TradeOff {
  std::vector<std::size_t> parameters;  // indices among the law's
  std::vector<double> change;           // of each, relative; the largest is 1
  double force_change = 0.0;            // root mean square, of the force's standard deviation, for such a change
  std::string sentence;
};

struct Determination {
  // All of the law's parameters; a little lower than what was given where a profile found it.
  std::vector<double> optimum;
  double objective = 0.0;
  double rise = 0.0;  // of the objective, by which the ranges are judged
  // Of the Jacobian by relative changes, falling; without those at a bound or without effect.
  std::vector<double> singular_values;
  std::vector<ParameterDetermination> parameters;  // the free ones, in order
  std::vector<TradeOff> trade_offs;
  int evaluations = 0;
};

// `optimum`: all of the law's parameters. nullopt when interrupted.
std::optional<Determination> determine(fit::LawOnRecord const& model, fit::SearchBox const& box,
                                       std::span<double const> optimum, Interrupted const& interrupted = {});

// The sentence of a trade-off: names and relative changes of the parameters that take part, the largest change 1.
std::string trade_off_sentence(std::vector<std::string> const& names, std::span<double const> change);

}  // namespace isolaw::analysis
