// The contract of a law: what its file says about it, the record as it sees it, and how one is run over a record.
//
// A law is a struct with
//   info                       LawInfo: id, name, title, source, units, traits, notes on how the source was read
//   Params<T>                  its parameters, in the paper's symbols
//   rows<T>                    one Row per parameter, in the order of reports: member, name, unit, meaning, limits,
//                              boxes
//   State<T>                   what it remembers from sample to sample, with constants derived from the parameters
//   start(params, first, how)  the virgin state at the first sample
//   step(params, state, step)  advances the state over one step of the path, returns the force at its end
//   or, for a law that reads what the path remembers (traits.remembers), start(params, path) and step(params, state,
//   step, memory)
// and, where it has them,
//   step_paper(...)            the same by one classical Runge-Kutta step, where that differs
//   crowded                    true: so much in flight that kernels take fewer lanes at once
//   joint_limits               what parameters must meet together: a JointLimit each
//   reduced(params)            parameters of the same forces in which `redundant`, which trades off with
//                              `redundant_with`, has the value `redundant_value`: where one can be fixed without loss
//   canonical(params)          the law as analysis programs know it (canonical.hpp)
// T is double, a derivative number or a batch of candidates. No allocation, exception or container in a step;
// branching on what the record determines (Step) is free, on a candidate's values it is a select.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
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
using num::max;
using num::min;
using num::power;
using num::rounded;
using num::sech_squared;
using num::select;
using num::sqrt;

struct Interval {
  double lower = 0.0;
  double upper = 0.0;
};

// logarithmic: in log|value|; where the interval holds 0, down to a millionth of its larger end, linear in between.
enum class Scale { linear, logarithmic };

// The size of a record, in the units of the law that asks; boxes of unknown devices are scaled from it.
struct RecordScales {
  double disp = 0.0;       // largest |displacement|
  double force = 0.0;      // largest |force|
  double stiffness = 0.0;  // effective, peak to peak
  double strength = 0.0;   // half the force span at zero displacement (characteristic strength)
  double velocity = 0.0;   // largest |velocity|; 0 without a time channel
  double work = 0.0;       // energy dissipated by the whole record
};

// A search interval in multiples of a size of the record (limits.hpp names the sizes).
struct ScaledInterval {
  double lower, upper;
  double (*size)(RecordScales const&);

  Interval operator()(RecordScales const& scales) const { return {lower * size(scales), upper * size(scales)}; }
};

struct ParameterInfo {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  Interval physical;                            // outside: refused
  std::optional<Interval> published;            // the paper's search box (Table 4), always searched linearly
  ScaledInterval scaled;                        // the search box of a device of any size
  Scale scaled_search = Scale::linear;          // how the scaled box is searched
  std::optional<double> fixed_by_default = {};  // the value of a parameter that is not calibrated unless freed
  std::string_view paper_name = {};             // in its tables 4 and A.5, where that is another one

  constexpr ParameterInfo in_paper(std::string_view other_name) const {
    ParameterInfo made = *this;
    made.paper_name = other_name;
    return made;
  }
};

// The same as a line of a law's table.
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

// What the limits of single parameters cannot say. `statement` names the parameters as words of their own. Moving one
// of them one way always helps or always harms: a box is outside where its corners are.
template <class Params>
struct JointLimit {
  std::string_view statement;  // "K1 >= K2"
  bool (*holds)(Params const&);
};

struct Traits {
  bool rate_independent = false;  // the velocity does not matter
  bool odd = false;               // F(-x) = -F(x) for the mirrored history
  bool path_integrated = false;   // a differential law: the integration method matters
  bool remembers = false;         // its step reads what the path remembers (Memory)
  bool masing = false;            // branches close where they began, small loops leave nothing behind
  bool exact_flow = false;        // follows the curve of saturating_flow.hpp; its online form a table of it
};

// paper: of Cucuzza et al. 2025. usual: runs besides where nothing is said. further: runs where it is asked for.
enum class LawSet { paper, usual, further };

struct LawInfo {
  std::string_view id;     // what is typed, and what files hold
  std::string_view name;   // what people say: a sentence, a figure
  std::string_view title;  // what a catalogue says
  std::string_view source;
  Unit force, length;  // time is always in seconds
  Traits traits;
  std::string_view formula;    // lines of plain text with the parameters' names; x, v and F in the units above
  std::string_view note = "";  // how the source was read where it is incomplete, what the law was made for
  LawSet set = LawSet::further;
  // One step of one candidate [0.01 ns], as `isolaw bench` measured it once with 512-bit lanes: puts runs in the order of
  // what they cost where no clock may (campaign/deal.hpp), so that it need not follow the law's code.
  unsigned step_cost = 500;
};

enum class Integration { converged, paper };
enum class TurningPoints { as_sampled, interpolated };  // whether the path turns at samples only, or between them too

// One step of the path, from the sample before to this one, in the law's units. Depends on the record alone.
struct Step {
  double x0, x1;                    // displacement before and after
  double v0, v1;                    // velocity before and after; 0 for a record without time
  double dx;                        // x1 - x0
  double length;                    // |dx|
  double direction;                 // +1, -1; the last one where dx = 0; 0 before the first motion
  bool reversal;                    // the direction differs from that of the step before
  bool sample;                      // the end is a sample of the record, where a force is wanted
  double peak0, peak1;              // largest |x| up to the start and the end of the step
  double log2_abs_x0, log2_abs_x1;  // of |x| clamped to num::smallest_power_base
};

// What the displacement alone decides for a law that remembers turning points and the travel of each side, at the end
// of a step (memory.cpp). The side of x is that of its sign. A first sample away from 0 is a motion from 0.
struct Memory {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t kept = none;    // the step began at a turning point: the force there goes to this place of the stack
  std::size_t branch = none;  // the turning point that the branch began at; none: on the skeleton
  double branch_x = 0.0;      // its displacement
  double direction = 0.0;     // +1, -1; 0 before the first motion
  double peak0 = 0.0;         // largest |x| before the step
  double peak = 0.0;          // and after it
  double inside = 0.0;        // length of the step within peak0
  double side_peak = 0.0;     // the same on the side of x
  double travel = 0.0;        // N of that side: relative to its peak inside it, forgotten as the peak grows
  double virgin = 1.0;        // (1 + N)^(-1/3)
  double log2_worn = 0.0;     // log2(1 + N) of both sides together, relative to the largest |x|
  double pushed = 0.0;        // how far the largest |x| has grown at x > 0, less how far at x < 0
  double softening = 0.0;  // G of that side: half its way outwards and four times its way back, never beyond side_peak
  double way_back = 0.0;   // C of that side: its way towards 0
  double log2_softening = 0.0, log2_way_back = 0.0;  // of the two, clamped to num::smallest_power_base
  std::size_t side = 0;                              // 0: x >= 0, 1: x < 0
  bool softens = false, returns = false;             // G or C are not what they were at the last step that ended there
  bool peak_grows = false, side_peak_grows = false;  // in this step
};

// The record as a piecewise linear path. The first step has no length: its force is that of the first sample.
struct Path {
  std::vector<Step> steps;
  std::size_t sample_count = 0;
  std::vector<Memory> memory = {};  // of every step; empty where it was not asked for
  std::size_t deepest = 0;          // turning points remembered at once

  std::size_t samples() const { return sample_count; }
};

// x and v in the law's units; v empty for a record without time. Needs at least one sample and refinement >= 1.
// With `refinement` > 1 every interval is cut into that many equal steps, displacement and velocity interpolated.
Path make_path(std::span<double const> x, std::span<double const> v, int refinement = 1, bool with_memory = true);

// The same through the turning points as well, which lie between the samples: at each reversal the vertex of the
// parabola through its three samples is inserted, at rest. For smooth records; on a noisy one it follows the noise.
// `time` of the samples, increasing.
Path make_path_with_turning_points(std::span<double const> x, std::span<double const> v, std::span<double const> time,
                                   int refinement = 1, bool with_memory = true);

// Fills in what the path remembers.
void remember(Path& path);

// The motion without what stays within `dead_band` to both sides, in the unit of x: after a turn it rests for twice the
// band and catches up over the next four; elsewhere it is x.
std::vector<double> followed(std::span<double const> x, double dead_band);

template <class Law, class T>
using ParamsOf = typename Law::template Params<T>;

template <class Law>
inline constexpr std::size_t parameter_count = Law::template rows<double>.size();

// The members of rows<T> alone: code for batches that held on to the rest would bring along a copy of the functions
// named there, compiled for its instruction set.
template <class Law, class T>
inline constexpr auto members = [] {
  std::array<T ParamsOf<Law, T>::*, parameter_count<Law>> made{};
  for (std::size_t i = 0; i < made.size(); ++i) made[i] = Law::template rows<T>[i].member;
  return made;
}();

template <class Law>
concept HasPaperStep = requires(ParamsOf<Law, double> const& p, typename Law::template State<double>& s,
                                Step const& k) {
  Law::step_paper(p, s, k);
};

template <class Law, class T>
auto first_state(ParamsOf<Law, T> const& params, Path const& path, Integration integration) {
  if constexpr (Law::info.traits.remembers)
    return Law::template start<T>(params, path);
  else
    return Law::template start<T>(params, path.steps.front(), integration);
}

// Force at every sample of the path: force(i) is called with the sample's index and the force there.
template <class Law, class T, class Sink>
void run(ParamsOf<Law, T> const& params, Path const& path, Integration integration, Sink&& sink) {
  if (path.steps.empty()) return;
  auto state = first_state<Law, T>(params, path, integration);
  auto const walk = [&](auto&& advance) {
    std::size_t sample = 0;
    for (Step const& step : path.steps) {
      T const force = advance(step);
      if (step.sample) sink(sample++, force);
    }
  };
  if constexpr (HasPaperStep<Law>) {
    if (integration == Integration::paper) {
      walk([&](Step const& step) { return Law::template step_paper<T>(params, state, step); });
      return;
    }
  }
  if constexpr (Law::info.traits.remembers) {
    auto memory = path.memory.begin();
    walk([&](Step const& step) { return Law::template step<T>(params, state, step, *memory++); });
  } else {
    walk([&](Step const& step) { return Law::template step<T>(params, state, step); });
  }
}

template <class Law, class T>
ParamsOf<Law, T> unpack(std::span<T const> values) {
  ParamsOf<Law, T> params{};
  for (std::size_t i = 0; i < parameter_count<Law>; ++i) params.*members<Law, T>[i] = values[i];
  return params;
}

}  // namespace isolaw::laws
