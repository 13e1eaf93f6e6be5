#include "isolaw/data/cycle_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace isolaw::data {
namespace {

constexpr double nominal = 0.05;          // of the block's amplitude
constexpr double same_period = 0.20;      // of the block's period
constexpr double symmetric = 0.05;        // unevenness of a lone cycle that is a stage of its own
constexpr double lopsided = 0.25;         // of the amplitude, that the middle of a regular cycle may move by
constexpr std::size_t tapered_run = 3;    // cycles: shorter runs may come about by chance
constexpr std::size_t longest_taper = 2;  // cycles

// Cycles [begin, end) of one amplitude and frequency.
struct Run {
  std::size_t begin = 0;
  std::size_t end = 0;
  double amplitude = 0.0;  // median
  std::size_t size() const { return end - begin; }
};

bool close(double value, double reference, double share) {
  return std::abs(value - reference) <= share * reference;
}

double median_of(std::vector<double> values) {
  auto const half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, half);
  if (values.size() % 2 == 1) return *half;
  double const upper = *half;
  return (*std::max_element(values.begin(), half) + upper) / 2.0;
}

template <class Property>
double median_over(std::vector<Shape> const& shapes, Run const& run, Property property) {
  std::vector<double> values;
  for (auto i = run.begin; i < run.end; ++i) values.push_back(property(shapes[i]));
  return median_of(std::move(values));
}

// The mean of the run so far stands for its middle: the median of every prefix would cost more than the rest.
class RunningMean {
 public:
  void add(double value) { sum_ += value, ++count_; }
  double value() const { return sum_ / static_cast<double>(count_); }
  std::size_t count() const { return count_; }

 private:
  double sum_ = 0.0;
  std::size_t count_ = 0;
};

std::vector<Run> runs_of_amplitude(std::vector<Shape> const& shapes) {
  std::vector<Run> runs;
  RunningMean mean;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    bool const joins = !runs.empty() && close(shapes[i].amplitude(), mean.value(), nominal);
    if (!joins) {
      runs.push_back({.begin = i, .end = i});
      mean = {};
    }
    mean.add(shapes[i].amplitude());
    runs.back().end = i + 1;
  }
  for (auto& run : runs) run.amplitude = median_over(shapes, run, [](Shape const& s) { return s.amplitude(); });
  return runs;
}

// A new frequency starts at cycle i when it and the next differ from what was, and agree with one another.
std::vector<Run> split_by_frequency(std::vector<Shape> const& shapes, Run const& run) {
  std::vector<Run> parts{{.begin = run.begin, .end = run.end}};
  RunningMean mean;  // of the periods after the part's first cycle, which may start slowly
  for (auto i = run.begin + 1; i < run.end; ++i) {
    bool const changes = mean.count() > 0 && i + 1 < run.end && !close(shapes[i].period, mean.value(), same_period) &&
                         !close(shapes[i + 1].period, mean.value(), same_period) &&
                         close(shapes[i].period, shapes[i + 1].period, same_period);
    if (changes) {
      parts.back().end = i;
      parts.push_back({.begin = i, .end = run.end});
      mean = {};
    } else if (mean.count() == 0 || close(shapes[i].period, mean.value(), same_period)) {
      mean.add(shapes[i].period);
    }
  }
  for (auto& part : parts) part.amplitude = median_over(shapes, part, [](Shape const& s) { return s.amplitude(); });
  return parts;
}

double middle(Shape const& shape) {
  return shape.largest / 2.0 + shape.least / 2.0;
}

// A drift that moves the middle from cycle to cycle leaves a run regular; swings that hop about do not.
bool stays(std::vector<Shape> const& shapes, Run const& run, std::size_t i) {
  auto const neighbour = i > run.begin ? i - 1 : i + 1;
  return std::abs(middle(shapes[i]) - middle(shapes[neighbour])) <= lopsided * shapes[i].amplitude();
}

// Cycles that grow into a run, or fade out of it: the ramps of a shaking table's signal.
void mark_tapers(std::vector<Shape>& shapes, Run const& run) {
  if (run.size() < tapered_run) return;
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

// A block while it grows: the run that gives its amplitude, and the cycles around it.
struct Draft {
  std::size_t begin = 0;
  std::size_t end = 0;
  Run core;
};

// Lone uneven cycles join a neighbour; an odd one out between two runs of one amplitude joins them.
std::vector<Draft> drafts_of(std::vector<Shape> const& shapes, std::vector<Run> const& runs) {
  std::vector<Draft> drafts;
  std::size_t pending = 0;  // begin of lone cycles that wait for the block they lead to
  bool waiting = false;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    auto const& run = runs[r];
    bool const lone = run.size() == 1;
    bool const between = lone && !drafts.empty() && !waiting && r + 1 < runs.size() && drafts.back().core.size() > 1 &&
                         runs[r + 1].size() > 1 && close(runs[r + 1].amplitude, drafts.back().core.amplitude, nominal);
    if (between) {
      auto& draft = drafts.back();
      draft.end = runs[r + 1].end;
      if (runs[r + 1].size() > draft.core.size()) draft.core = runs[r + 1];
      ++r;
      continue;
    }
    if (lone && shapes[run.begin].unevenness > symmetric) {
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
  // Nothing but uneven cycles: the largest run stands for all.
  if (drafts.empty() && !runs.empty())
    drafts.push_back({.begin = runs.front().begin,
                      .end = runs.back().end,
                      .core = *std::ranges::max_element(runs, {}, &Run::amplitude)});
  return drafts;
}

std::string reason(Shape const& shape, double amplitude) {
  double const deviation = 100.0 * (shape.amplitude() / amplitude - 1.0);
  return fmt::format("its amplitude of {:.4g} mm is {:.1f} % {} the block's {:.4g} mm, more than {:.0f} %",
                     shape.amplitude(), std::abs(deviation), deviation > 0.0 ? "above" : "below", amplitude,
                     100.0 * nominal);
}

}  // namespace

std::vector<CycleCut> number_cycles(std::vector<Shape>& shapes) {
  std::vector<Run> runs;
  for (auto const& run : runs_of_amplitude(shapes))
    for (auto const& part : split_by_frequency(shapes, run)) runs.push_back(part);
  mark_regular(shapes, runs);
  std::vector<CycleCut> cuts;
  int block = 0;
  for (auto const& draft : drafts_of(shapes, runs)) {
    ++block;
    int number = 0;
    for (auto i = draft.begin; i < draft.end; ++i) {
      auto const& shape = shapes[i];
      CycleCut cut;
      cut.block = block;
      cut.first = shape.first;
      cut.last = shape.last;
      if (close(shape.amplitude(), draft.core.amplitude, nominal))
        cut.number = ++number;
      else
        cut.not_counted = reason(shape, draft.core.amplitude);
      cuts.push_back(std::move(cut));
    }
  }
  return cuts;
}

}  // namespace isolaw::data
