// The contract of a law. A law is one file with a struct that describes the law and computes one step of its motion.
// All code that uses the law is generated from this struct. The step is written once, for three kinds of numbers:
//   T   the type of a parameter: double, a number with derivatives (num::Dual), or a batch of several parameter sets
//       (num::Batch), whose places are called lanes
//   X   the type of the motion. In a record the motion is known ahead, and X is double. In a trial it is not, and X is
//       the Dual of online/numbers.hpp; it has two slopes, so that a trial knows its tangent.
//   N   the type of a force: T in a record, Dual in a trial, where T is double
// The struct has
//   info                  LawInfo: id, name, title, source, units, traits, a note on how the source was read
//   Params<T>             the parameters, in the paper's symbols
//   rows<T>               one Row for each parameter, in the order of reports: member, name, unit, meaning, limits, box
//   State<N>              what the law remembers from step to step; members(each) lists all of it, to save and load it
//   step(params, constants, state, step)    advances the state over one step and returns the force at its end
//   with_factors(params, a, b)    parameters with which the elastic part of the force is a times, and the hysteretic or
//                         viscous part b times as large, for a and b above 0
// and, where they apply,
//   Constants<T, X>, constants<T, X>(params)      values that depend on the parameters alone; computed once
//   start(params, constants, state, step)         sets the state at the first sample, if it is not State's own values
//   Memory<X>             for a law with the trait `remembers`: the parts of the path's memory that it reads (memory/).
//                         Its step gets them as a fifth argument. If its State has a stack, make_room resizes it.
//                         Such a law ignores motion within the record's dead band (memory/followed.hpp), and its first
//                         motion goes from 0 to the first sample. Whatever else the law remembers belongs in State,
//                         which is computed for each parameter set.
//   paper_constants(params), step_paper(...)      for Integration::paper: one classical Runge-Kutta step from sample to
//                         sample, as in the paper. A law whose step() is the paper's has neither of the two.
//   crowded               true: a step holds so many values at once that kernels (fit/kernels.cpp) use fewer lanes
//   joint_limits          one JointLimit for each condition between several parameters
//   reduced(params)       for a law with a redundant parameter: returns parameters that give the same forces. In them
//                         the parameter that `redundant` names has the value `redundant_value`, and the parameters in
//                         `redundant_with` make up for the change
//   with_factor(params, factor)   in place of with_factors, for a law in which no parameters tell the parts apart
//   canonical(params)     the law of analysis programs such as OpenSees that equals this one, or NoForm{what their laws
//                         lack} (parts/canonical.hpp)
//
// Four rules keep one step fast and right for all three kinds of numbers:
//   - Branch with a plain `if` on the motion (X), and with `select` on anything that depends on a parameter (T, N).
//   - Write N(step.x1) where a number of the motion meets parameters, and T(2.0) or N(2.0) for a literal.
//   - min and max return their first argument if both are equal: put first the one whose slope the result must have.
//   - Use the functions below (moves, grows, slope_alone, limit_slope, ...) where a plain comparison would lose a slope
//     that a trial needs. For a record they are plain comparisons, or do nothing.
// A step neither throws nor logs, and in a record it allocates nothing: kernels size stacks before the first step.
//
// Exported C++17 files are made from the lines of a law's file between `// [export struct NAME]` and `// [end]`, with
// plain numbers in place of T, X and N (programs/header_parts.hpp). Between these marks there are State, Constants,
// start, step, Memory and their helpers, without designated initialisers, concepts, template lambdas and paper steps.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "isolaw/base/units.hpp"
#include "isolaw/num/scalar.hpp"

namespace isolaw::laws {

using num::abs;
using num::any;
using num::at;
using num::cell_of;
using num::exp;
using num::exp2;
using num::expm1;
using num::fifth_root;
using num::log2;
using num::log2_e;
using num::max;
using num::min;
using num::power;
using num::rounded;
using num::sech_squared;
using num::select;
using num::smallest_power_base;
using num::sqrt;

struct Interval {
  double lower = 0.0;
  double upper = 0.0;
};

// The scale on which an interval is searched. logarithmic: in log|value|, but linearly below 1e-6 of the larger end.
enum class Scale { linear, logarithmic };

// Sizes of a record, in the law's units. The bounds of a search are multiples of them.
struct RecordScales {
  double disp = 0.0;       // largest |displacement|
  double force = 0.0;      // largest |force|
  double stiffness = 0.0;  // effective stiffness: difference of the forces at the two peaks / difference of the peaks
  double strength = 0.0;   // mean |force| where the displacement crosses zero (characteristic strength)
  double velocity = 0.0;   // largest |velocity|; 0 without a time channel
  double work = 0.0;       // energy dissipated in a whole test; of several tests, the largest
};

// A search interval: `lower` and `upper` times a size of the record, which `size` returns (parts/limits.hpp).
struct ScaledInterval {
  double lower, upper;
  double (*size)(RecordScales const&);

  Interval operator()(RecordScales const& scales) const { return {lower * size(scales), upper * size(scales)}; }
};

struct ParameterInfo {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  Interval physical;                            // physically possible values; any other value is refused
  std::optional<Interval> published;            // bounds of Cucuzza et al. 2025, Table 4; always searched linearly
  ScaledInterval scaled;                        // bounds of the search for a device of any size
  Scale scaled_search = Scale::linear;          // whether the search between these bounds is linear or logarithmic
  std::optional<double> fixed_by_default = {};  // the value that the parameter keeps unless the user frees it
  std::string_view paper_name = {};             // the name in Tables 4 and A.5 of that paper, if it differs from `name`

  constexpr ParameterInfo in_paper(std::string_view other_name) const {
    ParameterInfo renamed = *this;
    renamed.paper_name = other_name;
    return renamed;
  }
};

constexpr ParameterInfo parameter(std::string_view name, std::string_view unit, std::string_view meaning,
                                  Interval physical, std::optional<Interval> published, ScaledInterval scaled,
                                  Scale scaled_search = Scale::linear, std::optional<double> fixed_by_default = {}) {
  return {name, unit, meaning, physical, published, scaled, scaled_search, fixed_by_default};
}

template <class T, class Params>
struct Row {
  T Params::*member;
  ParameterInfo info;
};

// A condition between several parameters. `statement` contains their names as whole words. The condition must be
// monotonic in each parameter, so that it can be tested for a whole box of parameters: if no corner of the box meets
// it, no point of the box does.
template <class Params>
struct JointLimit {
  std::string_view statement;  // the condition as text, for example "K1 >= K2"
  bool (*holds)(Params const&);
};

struct Traits {
  bool rate_independent = false;  // the force does not depend on the velocity
  bool odd = false;               // the motion -x(t) gives the force -F(t)
  bool path_integrated = false;   // a differential equation gives the force, so Integration matters
  bool remembers = false;         // the law's step reads the path's Memory
  bool masing = false;            // branches close where they began; a small loop leaves no trace once it has closed
  bool exact_flow = false;        // the law follows the curve of saturating_flow.hpp; a trial uses a table of the curve
};

// paper: a law of Cucuzza et al. 2025. These and the usual laws are computed by default, the further ones on request.
enum class LawSet { paper, usual, further };

struct LawInfo {
  std::string_view id;     // the name that users type and files store, for example "bouc-wen"
  std::string_view name;   // the name in sentences and figures
  std::string_view title;  // one line about the law for the catalogue
  std::string_view source;
  Unit force, length;  // the law's units; its unit of time is always the second
  Traits traits;
  std::string_view formula;    // lines of plain text with the parameters' names; x, v and F in the units above
  std::string_view note = "";  // how the source was read where it is incomplete, what the law was made for
  LawSet set = LawSet::further;
  // Time of one step of one parameter set [0.01 ns], as `isolaw bench` once measured it on a processor with AVX-512. It
  // only serves to estimate the time of runs and to divide a campaign evenly between several machines. Without such a
  // processor, give a new law the value of a law of similar cost.
  unsigned step_cost = 500;
};

enum class Integration { converged, paper };
// Whether the path turns only at samples, or also between them (make_path_with_turning_points()).
enum class TurningPoints { as_sampled, interpolated };

// One step of a motion with numbers of type X, in the law's units.
template <class X>
struct StepOf;
// One step of the path of a record. It depends on the record alone.
template <>
struct StepOf<double> {
  double x0, x1;                    // displacement before and after the step
  double v0, v1;                    // velocity before and after the step; 0 for a record without time
  double dx;                        // change of displacement, x1 - x0
  double length;                    // travel, |dx|
  double direction;                 // the sign of dx; if dx = 0, that of the step before; 0 before the first motion
  bool reversal;                    // whether the direction is opposite to that of the step before
  bool sample;                      // whether the step ends at a sample of the record, whose force is reported
  double peak0, peak1;              // largest |x| up to the start and up to the end of the step
  double log2_abs_x0, log2_abs_x1;  // log2 |x| before and after; |x| counts as at least num::smallest_power_base
};
using Step = StepOf<double>;

// The memory of the displacement after a step. Laws with the trait `remembers` read it. The files in memory/ compute
// its members. A first sample away from 0 counts as a motion from 0. A law's stack has one value for each turning point
// that Masing's rules still need (memory/open_branches.hpp). The skeleton is the force curve of the first loading.
struct Memory {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  bool turns;              // whether the motion turned at the begin of this step
  std::size_t turn_index;  // if it turned: stack index at which a law keeps its force at that turning point
  // If two turning points are dropped from the stack before this step: the stack index of the first; otherwise none.
  std::size_t first_dropped;
  // The turning point at which the present branch began: its stack index (none: the path is on the skeleton), and its
  // displacement.
  std::size_t branch_index;
  double branch_x;
  double direction;          // direction of the step, +1 or -1; 0 before the first motion
  double peak0, peak;        // largest |x| before and after the step
  double length_below_peak;  // the part of the step's length in which |x| is below peak0
  double side_peak;          // largest |x| so far on the side of x (x >= 0 or x < 0) on which the step ends
  double virgin_share;       // (1 + N)^(-1/3); N is the travel on this side / side_peak, and fades as side_peak grows
  double log2_worn;          // log2(1 + NT); NT is the travel on both sides / the largest |x|, and fades as that grows
  double one_sided_growth;   // growth of the largest |x| at x > 0 minus its growth at x < 0
  // log2 of G and log2 of C on this side. C is the travel back towards 0. G is half the travel outwards plus four times
  // the travel back, but at most side_peak.
  double log2_softening, log2_way_back;
  std::size_t side;                  // the side on which the step ends; 0: x >= 0, 1: x < 0
  bool softens, returns;             // whether G, or C, has changed since the last step that ended on this side
  bool peak_grows, side_peak_grows;  // whether `peak`, or side_peak, grows in this step
};

// The record as a piecewise linear path. The first step has no length; its end is the first sample.
struct Path {
  std::vector<Step> steps;
  std::size_t sample_count = 0;
  std::vector<Memory> memory = {};  // the memory after each step; empty if the caller did not ask for it
  std::size_t deepest = 0;          // the largest number of turning points that a law's stack must hold

  std::size_t samples() const { return sample_count; }
};

// x and v [samples] in the law's units; v is empty for a record without time. Needs at least one sample and refinement
// >= 1. Every interval is cut into `refinement` equal steps, with displacement and velocity interpolated linearly.
Path make_path(std::span<double const> x, std::span<double const> v, int refinement = 1, bool with_memory = true);
// Makes a path that also passes through the turning points between the samples: at each reversal it inserts the vertex
// of the parabola through the three nearest samples, with velocity 0. Use it for smooth records only, since on a noisy
// record the path follows the noise. `time` [samples] increases.
Path make_path_with_turning_points(std::span<double const> x, std::span<double const> v, std::span<double const> time,
                                   int refinement = 1, bool with_memory = true);

// Fills in path.memory and path.deepest.
void remember(Path& path);
// Takes movements within `dead_band` [unit of x] out of x (memory/followed.hpp).
std::vector<double> followed(std::span<double const> x, double dead_band);

template <class Law, class T>
using ParamsOf = typename Law::template Params<T>;

template <class Law>
inline constexpr std::size_t parameter_count = Law::template rows<double>.size();

// The member pointers of rows<T>, without the rest of the rows: kernels would otherwise contain the functions in the
// rows once for each instruction set.
template <class Law, class T>
inline constexpr auto members = [] {
  std::array<T ParamsOf<Law, T>::*, parameter_count<Law>> pointers{};
  for (std::size_t i = 0; i < pointers.size(); ++i) pointers[i] = Law::template rows<T>[i].member;
  return pointers;
}();

// Operations that a step calls, here in the form for a record, where the motion has no derivatives. online/numbers.hpp
// has the same operations for a trial and says why a trial needs them.
inline bool moves(Step const& step) {
  return step.length > 0.0;
}
inline bool grows(double growth) {
  return growth > 0.0;
}
inline bool reaches(double size, double peak) {
  return size > peak;
}
inline bool may_move(double way) {
  return way != 0.0;
}
inline bool changes(double before, double after) {
  return before != after;
}
inline double value_of(double x) {
  return x;
}
inline double log2_abs_x1(Step const& step) {
  return step.log2_abs_x1;
}
template <class N>
void limit_slope(N&, auto&&, auto&&) {}
template <class N>
void use_secant_near_zero(N&, double, auto&&) {}
template <class N>
N through(double, N const& value, auto&&) {
  return value;
}
template <class N>
N slope_alone(double, N const&) {
  return N(0.0);
}

// The type of a force: the parameters' type in kernels, the motion's type in a trial.
template <class T, class X>
using NumberOf = std::conditional_t<std::is_same_v<X, double>, T, X>;

struct NoConstants {};

// The argument of make_room() before the first step of a record. It sizes a law's stack for the largest number of
// turning points that the record's path remembers at once.
struct Depth {
  std::size_t depth, first_dropped = Memory::none;
};
// Called by make_room() in each step of a record. If two turning points are dropped, the values behind theirs move up.
// The stack keeps its size.
template <class List>
void hold(List& list, Memory const& memory) {
  if (memory.first_dropped == Memory::none) return;
  auto const first = list.begin() + static_cast<std::ptrdiff_t>(memory.first_dropped);
  std::move(first + 2, list.end(), first);
}

template <class Law, class T, class X>
auto constants_of(auto const& params) {
  if constexpr (requires { Law::template constants<T, X>(params); })
    return Law::template constants<T, X>(params);
  else
    return NoConstants();
}

template <class Law, class T, class X>
auto first_state(auto const& params, auto const& constants, StepOf<X> const& first) {
  typename Law::template State<NumberOf<T, X>> state;
  if constexpr (requires { Law::start(params, constants, state, first); }) Law::start(params, constants, state, first);
  return state;
}

template <class Law>
concept HasPaperStep = requires(ParamsOf<Law, double> const& p) {
  Law::paper_constants(p);
};

// Runs the law over the path and calls sink(i, force) for every sample i with its force, in the law's unit.
template <class Law, class T, class Sink>
void run(ParamsOf<Law, T> const& params, Path const& path, Integration integration, Sink&& sink) {
  if (path.steps.empty()) return;
  auto const walk = [&](auto const& constants, auto&& advance) {
    auto state = first_state<Law, T, double>(params, constants, path.steps.front());
    if constexpr (requires { state.make_room(Depth()); }) state.make_room(Depth{path.deepest});
    std::size_t sample = 0;
    for (Step const& step : path.steps) {
      T const force = advance(constants, state, step);
      if (step.sample) sink(sample++, force);
    }
  };
  if constexpr (HasPaperStep<Law>) {
    if (integration == Integration::paper) {
      walk(Law::paper_constants(params), [&](auto const& constants, auto& state, Step const& step) {
        return Law::step_paper(params, constants, state, step);
      });
      return;
    }
  }
  auto memory = path.memory.begin();
  walk(constants_of<Law, T, double>(params), [&](auto const& constants, auto& state, Step const& step) {
    if constexpr (Law::info.traits.remembers)
      return Law::step(params, constants, state, step, *memory++);
    else
      return Law::step(params, constants, state, step);
  });
}

template <class Law, class T>
ParamsOf<Law, T> unpack(std::span<T const> values) {
  ParamsOf<Law, T> params{};
  for (std::size_t i = 0; i < parameter_count<Law>; ++i) params.*members<Law, T>[i] = values[i];
  return params;
}

}  // namespace isolaw::laws
