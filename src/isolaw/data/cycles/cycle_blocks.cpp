#include "isolaw/data/cycles/cycle_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>

#include "isolaw/num/statistics.hpp"

namespace isolaw::data {
namespace {

constexpr double nominal = 0.05;       // the amplitude of a counted cycle is at most this fraction off its block's
constexpr double least_change = 0.05;  // a change of the period by more than this fraction splits a block
constexpr double clear_change = 0.20;  // replaces least_change if only one cycle precedes the change
constexpr double agreement = 0.25;     // periods on each side of a change scatter by at most this part of the change
constexpr std::size_t compared = 3;    // at most this many cycles before a change are compared
constexpr double far_period = 1.4;     // two periods are alike if they differ by at most this factor
constexpr double other_load = 0.1;     // a change of the vertical load by more than this fraction splits a block
constexpr double build_up = 0.15;      // a lone cycle joins a run if their amplitudes differ by at most this fraction
constexpr double symmetric = 0.05;     // a lone cycle with at most this Shape::unevenness is a block of its own
constexpr double lopsided = 0.25;      // the middles of regular neighbours differ by at most this part of the amplitude
constexpr std::size_t sure_run = 3;    // the amplitudes of fewer cycles may agree by chance
constexpr std::size_t longest_taper = 2;  // a test builds up or fades within at most this many cycles

struct Run {
  std::size_t begin = 0;
  std::size_t end = 0;
  double amplitude = 0.0;  // amplitude, period and load are medians of the cycles
  double period = 0.0;
  double load = 0.0;
  std::size_t size() const { return end - begin; }
};

bool close(double value, double reference, double share) {
  return std::abs(value - reference) <= share * reference;
}

std::vector<Run> runs_of_amplitude(std::vector<Shape> const& shapes) {
  std::vector<Run> runs;
  // A cycle joins a run if its amplitude is close to the run's mean, which is quicker to update than a median.
  double sum = 0.0;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    bool const joins =
        !runs.empty() && close(shapes[i].amplitude(), sum / static_cast<double>(runs.back().size()), nominal);
    if (!joins) {
      runs.push_back({.begin = i, .end = i});
      sum = 0.0;
    }
    sum += shapes[i].amplitude();
    runs.back().end = i + 1;
  }
  return runs;
}

bool same_pace(double period, double other, double factor) {
  return period <= factor * other && other <= factor * period;
}

// False if the device moves slowly at the start or end of the cycle.
bool is_even(Shape const& shape) {
  return same_pace(shape.rise_and_fall, shape.period + shape.still_time, far_period);
}

// Whether the period changes between the cycles [begin, at) and the two cycles from `after` on: by more than 5 %, or by
// more than 20 % if [begin, at) is a single cycle. The periods within each group must agree.
bool changes(std::vector<Shape> const& shapes, std::size_t begin, std::size_t at, std::size_t after) {
  if (begin >= at) return false;
  auto const period = [](Shape const& shape) { return shape.period; };
  auto const before = std::span(shapes).subspan(begin, at - begin);
  auto const [least, largest] = std::ranges::minmax(before, {}, period);
  auto const [least_new, largest_new] = std::ranges::minmax(std::span(shapes).subspan(after, 2), {}, period);
  double const old_period = least.period / 2.0 + largest.period / 2.0;
  double const new_period = least_new.period / 2.0 + largest_new.period / 2.0;
  double const change = std::abs(new_period - old_period);
  double const limit = before.size() > 1 ? least_change : clear_change;
  return change > limit * std::min(old_period, new_period) && largest.period - least.period <= agreement * change &&
         largest_new.period - least_new.period <= agreement * change;
}

// Splits a run where its frequency changes. A new part starts at cycle i if the periods of cycles i and i + 1 agree,
// the periods of the cycles before agree, and the two groups differ. Cycle i - 1 may lead from one frequency to the
// other; then it is not compared. The first cycle of a part may start slowly, so it is not compared if two or more
// cycles follow it before cycle i. A run of just two cycles is split if neither starts or ends slowly and one period is
// more than 1.4 times the other.
std::vector<Run> split_by_frequency(std::vector<Shape> const& shapes, Run const& run) {
  std::vector<Run> parts{{.begin = run.begin, .end = run.end}};
  auto const split_at = [&](std::size_t i) {
    parts.back().end = i;
    parts.push_back({.begin = i, .end = run.end});
  };
  bool const pair_of_stages = run.size() == 2 && is_even(shapes[run.begin]) && is_even(shapes[run.begin + 1]) &&
                              !same_pace(shapes[run.begin].period, shapes[run.begin + 1].period, far_period);
  if (pair_of_stages) split_at(run.begin + 1);
  for (auto i = run.begin + 2; i + 1 < run.end; ++i) {
    auto const begin = parts.back().begin;
    auto const count = i - begin;
    if (count < 2) continue;
    auto const recent = std::max(i - std::min(count, compared), begin + (count > 2 ? 1 : 0));
    bool const clear = changes(shapes, recent, i, i) || (count > 2 && changes(shapes, recent, i - 1, i)) ||
                       (count == 2 && changes(shapes, i - 1, i, i));
    if (clear) split_at(i);
  }
  for (auto& part : parts) {
    auto const cycles = std::span(shapes).subspan(part.begin, part.size());
    part.amplitude = num::median_over(cycles, &Shape::amplitude);
    part.period = num::median_over(cycles, &Shape::period);
    part.load = num::median_over(cycles, &Shape::load_kN);
  }
  return parts;
}

// Splits runs where the vertical load changes. The load of the next cycle in the run, if there is one, must have
// changed too, so that one odd load does not split a run.
std::vector<Run> split_by_load(std::vector<Shape> const& shapes, std::vector<Run> const& runs) {
  double largest = 0.0;
  for (auto const& shape : shapes) largest = std::max(largest, std::abs(shape.load_kN));
  if (largest == 0.0) return runs;
  std::vector<Run> parts;
  for (auto const& run : runs) {
    parts.push_back(run);
    double sum = 0.0;
    for (auto i = run.begin; i < run.end; ++i) {
      auto const count = static_cast<double>(i - parts.back().begin);
      double const load = shapes[i].load_kN;
      bool const changes = count > 0.0 && !same_load(load, sum / count, largest) &&
                           (i + 1 == run.end || !same_load(shapes[i + 1].load_kN, sum / count, largest));
      if (changes) {
        parts.back().end = i;
        parts.push_back({.begin = i, .end = run.end});
        sum = 0.0;
      }
      sum += load;
    }
  }
  return parts;
}

// Splits runs at long rests. Rests that recur after every cycle or two belong to the test's protocol and split nothing.
std::vector<Run> split_by_rest(std::vector<Shape> const& shapes, std::vector<Run> const& runs) {
  std::vector<Run> parts;
  for (auto const& run : runs) {
    auto const rests = [&](std::size_t i) { return i == run.end || shapes[i].rest_before > shapes[i].period; };
    parts.push_back(run);
    for (auto i = run.begin + sure_run; i + sure_run <= run.end; ++i) {
      if (!rests(i)) continue;
      auto next = i + 1, last = i - 1;
      while (!rests(next)) ++next;
      while (last > parts.back().begin && !rests(last)) --last;
      if (next - i < sure_run || i - last < sure_run) continue;
      parts.back().end = i;
      parts.push_back({.begin = i, .end = run.end});
    }
  }
  return parts;
}

std::vector<Run> runs_of(std::vector<Shape> const& shapes) {
  std::vector<Run> runs;
  for (auto const& run : split_by_rest(shapes, split_by_load(shapes, runs_of_amplitude(shapes))))
    for (auto const& part : split_by_frequency(shapes, run)) runs.push_back(part);
  return runs;
}

double middle(Shape const& shape) {
  return shape.largest / 2.0 + shape.least / 2.0;
}

// Whether the middle between a cycle's extremes is close to the neighbouring cycle's middle. The middles of regular
// cycles may drift slowly, but not jump.
bool stays(std::vector<Shape> const& shapes, Run const& run, std::size_t i) {
  auto const neighbour = i > run.begin ? i - 1 : i + 1;
  return std::abs(middle(shapes[i]) - middle(shapes[neighbour])) <= lopsided * shapes[i].amplitude();
}

// Marks cycles that grow into a run of cycles or fade out of it, as at the start and end of a shaking table's signal.
void mark_tapers(std::vector<Shape>& shapes, Run const& run) {
  if (run.size() < sure_run) return;
  for (std::size_t k = 0; k < longest_taper && run.begin > k; ++k) {
    auto& shape = shapes[run.begin - k - 1];
    if (shape.amplitude() >= shapes[run.begin - k].amplitude()) break;
    shape.taper = true;
  }
  for (std::size_t k = 0; k < longest_taper && run.end + k < shapes.size(); ++k) {
    auto& shape = shapes[run.end + k];
    if (shape.amplitude() >= shapes[run.end + k - 1].amplitude()) break;
    shape.taper = true;
  }
}

void mark_regular(std::vector<Shape>& shapes, std::vector<Run> const& runs) {
  for (auto const& run : runs) {
    for (auto i = run.begin; i < run.end; ++i)
      shapes[i].regular = run.size() > 1 ? stays(shapes, run, i) : shapes[i].unevenness <= symmetric;
    mark_tapers(shapes, run);
  }
}

struct Draft {
  std::size_t begin = 0;
  std::size_t end = 0;
  Run core;
};

bool is_build_up(Run const& lone, Run const& run) {
  return run.size() >= sure_run && close(lone.amplitude, run.amplitude, build_up) &&
         same_pace(lone.period, run.period, far_period) &&
         same_load(lone.load, run.load, std::max(std::abs(lone.load), std::abs(run.load)));
}

// A lone cycle is a run of one cycle. It joins a neighbouring run if it is asymmetric, if it builds up to that run or
// fades out of it, or if it lies between two similar runs.
std::vector<Draft> drafts_of(std::vector<Shape> const& shapes, std::vector<Run> const& runs) {
  std::vector<Draft> drafts;
  std::size_t pending = 0;  // first of the lone cycles that lead to the next block
  bool waiting = false;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    auto const& run = runs[r];
    bool const lone = run.size() == 1;
    // A cycle with a jump of the clock may lack its peak. It joins the cycles beside it, even if these are lone cycles.
    bool const has_gap = lone && shapes[run.begin].has_gap;
    bool const between = lone && !drafts.empty() && !waiting && r + 1 < runs.size() &&
                         (has_gap || (drafts.back().core.size() > 1 && runs[r + 1].size() > 1)) &&
                         close(runs[r + 1].amplitude, drafts.back().core.amplitude, nominal) &&
                         close(runs[r + 1].period, drafts.back().core.period, least_change);
    if (between) {
      auto& draft = drafts.back();
      draft.end = runs[r + 1].end;
      if (runs[r + 1].size() > draft.core.size()) draft.core = runs[r + 1];
      ++r;
      continue;
    }
    bool const leads = lone && r + 1 < runs.size() && is_build_up(run, runs[r + 1]);
    bool const fades = lone && !drafts.empty() && !waiting && is_build_up(run, drafts.back().core);
    if (lone && (leads || fades || shapes[run.begin].unevenness > symmetric)) {
      double const before = drafts.empty() || waiting ? 0.0 : drafts.back().core.amplitude;
      double const after = r + 1 < runs.size() ? runs[r + 1].amplitude : 0.0;
      bool const joins_before =
          before > 0.0 && (after == 0.0 || std::abs(run.amplitude - before) <= std::abs(run.amplitude - after));
      if (joins_before) {
        drafts.back().end = run.end;
      } else if (!waiting) {
        waiting = true;
        pending = run.begin;
      }
      continue;
    }
    drafts.push_back({.begin = waiting ? pending : run.begin, .end = run.end, .core = run});
    waiting = false;
  }
  if (waiting && !drafts.empty()) drafts.back().end = runs.back().end;
  // If all cycles are lone and asymmetric, they form one block, with the cycle of largest amplitude as its core.
  if (drafts.empty() && !runs.empty())
    drafts.push_back({.begin = runs.front().begin,
                      .end = runs.back().end,
                      .core = *std::ranges::max_element(runs, {}, &Run::amplitude)});
  return drafts;
}

std::string of_amplitude(Shape const& shape, double amplitude) {
  double const deviation = 100.0 * (shape.amplitude() / amplitude - 1.0);
  return fmt::format("its amplitude of {:.4g} mm is {:.1f} % {} the block's {:.4g} mm, more than {:.0f} %",
                     shape.amplitude(), std::abs(deviation), deviation > 0.0 ? "above" : "below", amplitude,
                     100.0 * nominal);
}

std::string of_period(Shape const& shape, double period, std::string_view unit) {
  bool const slow = shape.period > period;
  return fmt::format("its period of {:.4g} {} is {:.2f} times {} the block's {:.4g} {}, more than {}", shape.period,
                     unit, slow ? shape.period / period : period / shape.period, slow ? "as long as" : "shorter than",
                     period, unit, far_period);
}

// The median period of cycles that neither start nor end slowly, or of all if there are no such cycles. 0 if no period
// is close to the median.
double period_of(std::vector<Shape> const& shapes, std::vector<std::size_t> const& nominal_cycles) {
  std::vector<double> even, all;
  for (auto const i : nominal_cycles) {
    all.push_back(shapes[i].period);
    if (is_even(shapes[i])) even.push_back(shapes[i].period);
  }
  if (all.empty()) return 0.0;
  double const period = num::median(even.empty() ? all : even);
  bool const any = std::ranges::any_of(all, [&](double other) { return same_pace(other, period, far_period); });
  return any ? period : 0.0;
}

// Numbers a block's counted cycles as the logger did, if the logger's numbers rise. `before` is the logger's number of
// the last counted cycle in the previous block. If the logger did not start anew in this block, the numbers are shifted
// so that the block's first cycle, counted or not, has number 1. Returns the logger's number of the last counted cycle,
// or 0 if the logger's numbers are not used.
int take_logged_numbers(std::vector<CycleCut>& cuts, std::size_t begin, std::vector<Shape> const& shapes, int before) {
  std::vector<std::size_t> counted;
  for (auto i = begin; i < cuts.size(); ++i)
    if (cuts[i].number > 0) counted.push_back(i);
  auto const logged = [&](std::size_t i) { return shapes[i].logged; };
  bool const rise = std::ranges::is_sorted(counted, std::less_equal<>(), logged);
  if (counted.empty() || logged(counted.front()) <= 0 || !rise) return 0;
  bool const goes_on = before > 0 && logged(counted.front()) > before;
  int const base = goes_on ? std::max(before, logged(begin) - 1) : 0;
  for (auto const i : counted) cuts[i].number = logged(i) - base;
  return logged(counted.back());
}

}  // namespace

bool same_load(double load, double other, double largest) {
  return std::abs(load - other) <= other_load * std::max({std::abs(load), std::abs(other), other_load * largest});
}

std::vector<CycleCut> number_cycles(std::vector<Shape>& shapes, std::string_view unit) {
  auto const is_noise = [](Shape const& shape) { return std::abs(shape.load_kN) <= shape.load_scatter_kN; };
  if (std::ranges::all_of(shapes, is_noise))  // the load channel only holds noise about zero
    for (auto& shape : shapes) shape.load_kN = 0.0;
  auto const runs = runs_of(shapes);
  mark_regular(shapes, runs);
  std::vector<CycleCut> cuts;
  int block = 0, logged = 0;
  for (auto const& draft : drafts_of(shapes, runs)) {
    ++block;
    int number = 0;
    auto const begin = cuts.size();
    std::vector<std::size_t> nominal_cycles;
    for (auto i = draft.begin; i < draft.end; ++i)
      if (close(shapes[i].amplitude(), draft.core.amplitude, nominal)) nominal_cycles.push_back(i);
    double const period = period_of(shapes, nominal_cycles);
    for (auto i = draft.begin; i < draft.end; ++i) {
      auto const& shape = shapes[i];
      CycleCut cut = shape;
      cut.block = block;
      bool const builds_up = i < draft.core.begin && shape.amplitude() < draft.core.amplitude;
      if (!close(shape.amplitude(), draft.core.amplitude, nominal))
        cut.not_counted =
            (shape.has_gap ? "the time jumps within it, its peak may be missing; those after it are numbered "
                             "without it: "
             : builds_up   ? "build-up: "
                           : "") +
            of_amplitude(shape, draft.core.amplitude);
      else if (period > 0.0 && !same_pace(shape.period, period, far_period))
        cut.not_counted = of_period(shape, period, unit);
      else if (shape.jumps)
        cut.not_counted = "the logger left out cycles within it, and no loop is closed across them";
      else
        cut.number = ++number;
      cuts.push_back(std::move(cut));
    }
    logged = take_logged_numbers(cuts, begin, shapes, logged);
  }
  return cuts;
}

}  // namespace isolaw::data
