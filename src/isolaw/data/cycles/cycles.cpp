#include "isolaw/data/cycles/cycles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "isolaw/data/channels/record.hpp"
#include "isolaw/data/channels/time_gaps.hpp"
#include "isolaw/data/cycles/cycle_blocks.hpp"
#include "isolaw/data/cycles/excursions.hpp"
#include "isolaw/data/cycles/holds.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::data {
namespace {

constexpr double least_floor = 0.01;      // the noise band is at least this fraction of the half range
constexpr double largest_floor = 0.05;    // the noise band is at most this fraction of the half range
constexpr double noise_deviations = 5.0;  // noise band in standard deviations; one sample in a million lies beyond it
constexpr double interruption = 0.04;     // a swing below this fraction of both neighbouring swings is an interruption
constexpr double off_centre = 0.05;       // a middle closer to zero than this fraction of the amplitude counts as zero
constexpr double uneven = 0.25;    // a start off the middle by up to this part of the amplitude may be the centre
constexpr double resting = 0.05;   // an end within this part of the amplitude from the start is a return to the start
constexpr double as_large = 0.05;  // amplitudes that differ by at most this fraction count as equal
// In a cyclic record, cycles that repeat an amplitude or are symmetric make up at least this fraction of the travel
// (the way that the device moves in all). Cyclic tests reach 0.9. Among 1000 irregular responses of linear oscillators,
// ten reach 0.64 and one reaches 0.80.
constexpr double least_regular_share = 0.8;
// A test may consist of growing half cycles: each is larger than the one before by a factor from least_growth to
// largest_growth. A ground motion does not grow like this over fewest_growing half cycles.
constexpr std::size_t fewest_growing = 6;
constexpr double least_growth = 1.02, largest_growth = 1.5;
constexpr double at_start = 0.05;  // a one-sided test returns to its start within this part of its smallest peak
constexpr double one_stage = 1.1;  // in a one-sided test in stages, largest peak / smallest peak exceeds this
constexpr auto not_cyclic_cycle = "the record is not cyclic";

// Returns the first sample and then the turning points between swings of `least` mm or more.
std::vector<std::size_t> extremes(std::span<double const> x, double least) {
  std::vector<std::size_t> found;
  std::size_t low = 0, high = 0;
  int direction = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (direction >= 0 && x[i] > x[high]) high = i;
    if (direction <= 0 && x[i] < x[low]) low = i;
    if (direction == 0 && x[high] - x[low] >= least) {
      direction = high > low ? 1 : -1;
      found.push_back(0);
    } else if (direction > 0 && x[high] - x[i] >= least) {
      found.push_back(high);
      direction = -1;
      low = i;
    } else if (direction < 0 && x[i] - x[low] >= least) {
      found.push_back(low);
      direction = 1;
      high = i;
    }
  }
  if (direction != 0) found.push_back(direction > 0 ? high : low);
  return found;
}

std::vector<std::size_t> without_interruptions(std::span<double const> x, std::vector<std::size_t> const& found) {
  std::vector<std::size_t> kept;
  auto const swing = [&](std::size_t from_end) {
    return std::abs(x[kept[kept.size() - from_end]] - x[kept[kept.size() - from_end - 1]]);
  };
  for (auto const at : found) {
    kept.push_back(at);
    while (kept.size() >= 4 && swing(2) <= interruption * std::min(swing(1), swing(3)))
      kept.erase(kept.end() - 3, kept.end() - 1);
  }
  return kept;
}

struct Swings {
  std::vector<double> half;
  std::vector<double> middle;
  std::size_t begin = 0;  // swings [begin, end) are used: all, but not the first and last of three or more
  std::size_t end = 0;

  double largest() const { return std::ranges::max(std::span(half).subspan(begin, end - begin)); }
};

Swings swings_of(std::span<double const> x, std::vector<std::size_t> const& at) {
  Swings swings;
  for (std::size_t k = 1; k < at.size(); ++k) {
    swings.half.push_back(std::abs(x[at[k]] - x[at[k - 1]]) / 2.0);
    swings.middle.push_back(x[at[k]] / 2.0 + x[at[k - 1]] / 2.0);
  }
  swings.end = swings.half.size();
  if (swings.end >= 3) {
    ++swings.begin;
    --swings.end;
  }
  return swings;
}

// The median of the swings' middles, weighted by the eighth power of their size, so that small swings hardly count.
double middle_of(Swings const& swings) {
  double const largest = swings.largest();
  std::vector<std::pair<double, double>> weighted;
  double total = 0.0;
  for (auto k = swings.begin; k < swings.end; ++k) {
    double const weight = std::pow(swings.half[k] / largest, 8.0);
    weighted.emplace_back(swings.middle[k], weight);
    total += weight;
  }
  std::ranges::sort(weighted);
  double sum = 0.0;
  for (auto const& [middle, weight] : weighted)
    if ((sum += weight) >= total / 2.0) return middle;
  return 0.0;
}

std::size_t swings_across(Swings const& swings, double level, double margin) {
  std::size_t count = 0;
  for (auto k = swings.begin; k < swings.end; ++k)
    if (std::abs(swings.middle[k] - level) <= swings.half[k] - margin) ++count;
  return count;
}

// The displacement at which cycles are cut. It is zero if the motion's middle is close to zero and at least as many
// swings cross zero as cross the middle, because noise makes the middle less certain than the zero of the test.
// Otherwise it is the first displacement, if the record also ends there and the first displacement is off the middle by
// at most a quarter of the amplitude. In all other cases it is the middle.
double centre_of(std::span<double const> x, Swings const& swings, double band) {
  double const middle = middle_of(swings);
  double const amplitude = swings.largest();
  bool const zero_serves = swings_across(swings, 0.0, band) >= swings_across(swings, middle, band);
  if (std::abs(middle) <= off_centre * amplitude && zero_serves) return 0.0;
  bool const ends_where_it_starts = std::abs(x.back() - x.front()) <= resting * amplitude;
  bool const starts_elsewhere = std::abs(x.front() - middle) > off_centre * amplitude;
  if (ends_where_it_starts && starts_elsewhere && std::abs(x.front() - middle) <= uneven * amplitude)
    return std::abs(x.front()) <= off_centre * amplitude ? 0.0 : x.front();
  return middle;
}

// Replaces a displacement below any transducer's resolution by zero, so that messages show no "-0".
double or_zero(double disp_mm) {
  return std::abs(disp_mm) < 1e-6 ? 0.0 : disp_mm;
}

bool is_within(Gap const& gap, double first, double last) {
  auto const after = static_cast<double>(gap.last_before);
  return after >= first && after < last;
}
bool has_gap(std::vector<Gap> const& gaps, double first, double last) {
  return std::ranges::any_of(gaps, [&](Gap const& gap) { return is_within(gap, first, last); });
}

struct Motion {
  std::span<double const> x, time;
  FurtherChannels further;
  std::vector<Gap> gaps;
  std::vector<std::size_t> turns;
  double centre = 0.0;
  double noise = 0.0;
  std::vector<Excursion> excursions;
  std::vector<Group> groups;

  double first(Group const& group) const { return excursions[group.begin].first; }
  double last(Group const& group) const { return excursions[group.end - 1].last; }
  std::size_t count(Part part) const {
    return static_cast<std::size_t>(std::ranges::count(groups, part, &Group::part));
  }
  bool turns_after(Group const& group) const { return group.end == excursions.size() || excursions[group.end].turns; }
  double at(double index) const { return time.empty() ? index : value_at(time, index); }
  Shape shape(Group const& group) const;
  Shape shape(double first, double last) const;
  // Whether the logger left out cycles in the gap. A loop across the gap would then be made of two cycles.
  bool skips_cycles(Gap const& gap) const {
    auto const& logged = further.logged_cycle;
    return !logged.empty() && logged[gap.last_before + 1] - logged[gap.last_before] > 1.0;
  }
};

// Computes the measures of a cycle that do not depend on where the motion turns within the cycle.
Shape Motion::shape(double first, double last) const {
  Shape shape;
  shape.first = first;
  shape.last = last;
  double const start = value_at(x, shape.first), end = value_at(x, shape.last);
  shape.least = std::min(start, end);
  shape.largest = std::max(start, end);
  auto const stop = std::min(static_cast<std::size_t>(std::ceil(shape.last)), x.size());
  for (auto i = static_cast<std::size_t>(shape.first) + 1; i < stop; ++i) {
    shape.least = std::min(shape.least, x[i]);
    shape.largest = std::max(shape.largest, x[i]);
  }
  shape.unevenness = std::abs((shape.largest - centre) + (shape.least - centre)) / (shape.largest - shape.least);
  auto const still = still_time(x, time,
                                {.first = shape.first,
                                 .last = shape.last,
                                 .amplitude = shape.amplitude(),
                                 .middle = shape.largest / 2.0 + shape.least / 2.0},
                                noise);
  shape.still_samples = still.samples;
  shape.still_time = still.time;
  shape.period = at(shape.last) - at(shape.first) - shape.still_time;
  shape.rise_and_fall = shape.period + shape.still_time;
  shape.has_gap = has_gap(gaps, shape.first, shape.last);
  shape.jumps = std::ranges::any_of(
      gaps, [&](Gap const& gap) { return is_within(gap, shape.first, shape.last) && skips_cycles(gap); });
  if (!further.logged_cycle.empty())
    shape.logged = static_cast<int>(further.logged_cycle[static_cast<std::size_t>((first + last) / 2.0)]);
  return shape;
}

Shape Motion::shape(Group const& group) const {
  auto shape = this->shape(first(group), last(group));
  auto const& one = excursions[group.begin];
  auto const& other = excursions[group.begin + 1];
  shape.rise_and_fall = 2.0 * (at(static_cast<double>(other.tip)) - at(static_cast<double>(one.tip)));
  if (!further.load_kN.empty()) {
    auto const load = num::moments(further.load_kN.subspan(one.tip, other.tip - one.tip + 1));
    shape.load_kN = load.mean;
    shape.load_scatter_kN = load.std;
  }
  shape.rest_before = one.rest;
  shape.turns_at_start = one.turns;
  shape.turns_at_end = turns_after(group);
  return shape;
}

std::string why_partial(Motion const& motion, Group const& group) {
  double const tip = motion.x[motion.excursions[group.begin].tip];
  switch (group.part) {
    case Part::pre_load:
      return fmt::format("pre-load: to {:.4g} mm and back, no part of the cycles after it", tip);
    case Part::half:
      return fmt::format("half a cycle: to {:.4g} mm and back, then the motion starts anew", tip);
    case Part::open_start:
      return fmt::format("partial: the record starts at {:.4g} mm, within a cycle", or_zero(motion.x.front()));
    default:
      return fmt::format("partial: the record ends at {:.4g} mm, before the cycle is closed", or_zero(motion.x.back()));
  }
}

std::vector<CycleCut> with_parts(std::vector<CycleCut> cycles, Motion const& motion, bool cyclic = true) {
  std::vector<CycleCut> all;
  std::size_t next = 0;
  for (auto const& group : motion.groups) {
    if (group.part == Part::cycle) {
      all.push_back(std::move(cycles[next++]));
      continue;
    }
    bool const leads = group.part == Part::pre_load || group.part == Part::open_start || all.empty();
    CycleCut part;
    part.block = leads && next < cycles.size() ? cycles[next].block : all.empty() ? 1 : all.back().block;
    part.partial = true;
    part.first = motion.first(group);
    part.last = motion.last(group);
    bool const one_side = group.part == Part::pre_load || group.part == Part::half;
    part.not_counted = !cyclic && one_side ? not_cyclic_cycle : why_partial(motion, group);
    auto const after = [&](double index) {
      return std::ranges::upper_bound(motion.turns, index, {}, [](std::size_t i) { return static_cast<double>(i); });
    };
    auto const inside = after(part.last) - after(part.first);
    constexpr auto usual = 2;  // a partial cycle rarely holds more turns of the motion
    if (inside > usual) part.not_counted += fmt::format("; {} turns of the motion lie within it", inside);
    all.push_back(std::move(part));
  }
  return all;
}

Finding too_short(std::span<double const> x, Motion const& motion, Segmentation const& segmentation) {
  auto const [least, largest] = std::ranges::minmax(x);
  // Counts the crossings of the centre in the direction in which the test starts, by the excursions to that side.
  auto const first = std::ranges::find(motion.excursions, false, &Excursion::starts_open);
  auto const crossings = std::count_if(first, motion.excursions.end(), [&](Excursion const& excursion) {
    return excursion.positive == first->positive;
  });
  return {.kind = FindingKind::no_complete_cycle,
          .numbers = {{"least_mm", least},
                      {"largest_mm", largest},
                      {"crossings", static_cast<double>(crossings)},
                      {"centre_mm", segmentation.centre_mm},
                      {"noise_mm", 2.0 * segmentation.band_mm}}};
}

// The travel of the swings before the first and after the last complete cycle, if they repeat the amplitude of the
// regular cycle beside them.
double regular_ends(std::vector<Shape> const& shapes, Swings const& swings, std::vector<std::size_t> const& at) {
  double travel = 0.0;
  for (auto k = swings.begin; k < swings.end; ++k) {
    auto const from = static_cast<double>(at[k]), to = static_cast<double>(at[k + 1]);
    bool const before = from < shapes.front().first;
    if (!before && to <= shapes.back().last) continue;
    auto const& neighbour = before ? shapes.front() : shapes.back();
    if (!neighbour.regular || std::abs(swings.half[k] - neighbour.amplitude()) > as_large * neighbour.amplitude())
      continue;
    bool const crosses = before ? to > neighbour.first : from < neighbour.last;  // half the swing is within the cycle
    travel += (crosses ? 1.0 : 2.0) * swings.half[k];
  }
  return travel;
}

// The travel of regular cycles as a share of the whole travel. The whole travel leaves out pre-loads, the cycles with
// which a test builds up or fades (tapers), regular_ends(), and the first and the last swing.
double regular_share(std::vector<Shape> const& shapes, Swings const& swings, Motion const& motion,
                     std::vector<std::size_t> const& at) {
  double regular = 0.0, in_cycles = 0.0, in_tapers = 0.0, travel = 0.0;
  for (auto const& shape : shapes) {
    double const travelled = 2.0 * (shape.largest - shape.least);
    in_cycles += travelled;
    if (shape.regular)
      regular += travelled;
    else if (shape.taper)
      in_tapers += travelled;
  }
  for (auto k = swings.begin; k < swings.end; ++k) travel += 2.0 * swings.half[k];
  for (auto const& group : motion.groups)
    if (group.part == Part::pre_load) travel -= 2.0 * motion.excursions[group.begin].reach_mm;
  double const all = std::max(in_cycles, travel - regular_ends(shapes, swings, at)) - in_tapers;
  return all > 0.0 ? regular / all : 0.0;
}

Finding not_cyclic(std::vector<Shape> const& shapes, double share) {
  auto const [least, largest] =
      std::ranges::minmax(shapes, {}, [](Shape const& shape) { return shape.largest - shape.least; });
  return {.kind = FindingKind::not_cyclic,
          .numbers = {{"regular_swings", static_cast<double>(std::ranges::count_if(shapes, &Shape::regular))},
                      {"swings", static_cast<double>(shapes.size())},
                      {"travel_percent", 100.0 * share},
                      {"needed_percent", 100.0 * least_regular_share},
                      {"least_mm", (least.largest - least.least) / 2.0},
                      {"largest_mm", (largest.largest - largest.least) / 2.0}}};
}

// Whether the test has growing amplitudes: each half cycle, except at most one, is larger than the one before.
bool grows(Motion const& motion) {
  std::size_t growing = 0;
  for (std::size_t i = 1; i < motion.excursions.size(); ++i) {
    double const growth = motion.excursions[i].reach_mm / motion.excursions[i - 1].reach_mm;
    if (growth >= least_growth && growth <= largest_growth) ++growing;
  }
  return growing + 1 >= fewest_growing && growing + 2 >= motion.excursions.size();
}

// Whether a test in stages always goes to the same side and comes back to its start: 0, peak, 0, peak, 0.
bool is_one_sided(std::span<double const> x, Reversals const& found) {
  constexpr std::size_t fewest = 6;  // start, turns and end of three loops, if the last loop lacks its way back
  if (found.at.size() < fewest) return false;
  double const start = x[found.at[0]];
  bool const positive = x[found.at[1]] > start;
  double least = std::numeric_limits<double>::infinity(), largest = 0.0, off = 0.0;
  for (std::size_t k = 1; k < found.at.size(); ++k) {
    double const out = (positive ? 1.0 : -1.0) * (x[found.at[k]] - start);
    if (k % 2 == 0) {
      off = std::max(off, std::abs(out));
    } else {
      least = std::min(least, out);
      largest = std::max(largest, out);
    }
  }
  return least > 0.0 && largest > one_stage * least && off <= std::max(at_start * least, found.band_mm / 2.0);
}

// Cuts a one-sided test into loops, each from one return to the start to the next. The motion after the last return is
// a partial cycle.
Segmentation cut_one_sided(Motion const& motion, Segmentation segmentation) {
  auto const& turns = motion.turns;
  std::vector<Shape> shapes;
  for (std::size_t k = 0; k + 2 < turns.size(); k += 2) {
    auto shape = motion.shape(static_cast<double>(turns[k]), static_cast<double>(turns[k + 2]));
    if (!motion.further.load_kN.empty())
      shape.load_kN = num::moments(motion.further.load_kN.subspan(turns[k], turns[k + 2] - turns[k] + 1)).mean;
    shape.unevenness = 0.0;
    shape.one_sided = shape.turns_at_start = shape.turns_at_end = true;
    shapes.push_back(std::move(shape));
  }
  segmentation.cyclic = true;
  segmentation.regular_share = 1.0;
  segmentation.centre_mm = 0.0;
  segmentation.cycles = number_cycles(shapes, motion.time.empty() ? "samples" : "s");
  auto const end = turns.size() % 2 == 0 ? turns[turns.size() - 2] : turns.back();
  auto const last = motion.x.size() - 1;
  if (turns.size() % 2 == 0 && end < last)
    segmentation.cycles.push_back(
        {.block = segmentation.cycles.back().block,
         .not_counted =
             fmt::format("partial: the record ends at {:.4g} mm, before the cycle is closed", or_zero(motion.x.back())),
         .partial = true,
         .first = static_cast<double>(end),
         .last = static_cast<double>(last)});
  return segmentation;
}

// Finds the swings that belong to no full cycle (see the top of cycles.hpp). Each group holds swings that follow one
// another; full cycles lie between the groups.
std::vector<std::vector<Shape>> half_cycles(Motion const& motion, std::span<CycleCut const> full) {
  auto const& x = motion.x;
  auto const& turns = motion.turns;
  std::vector<std::vector<Shape>> groups;
  bool joins = false;
  for (std::size_t k = 0; k + 1 < turns.size(); ++k) {
    auto const first = static_cast<double>(turns[k]), last = static_cast<double>(turns[k + 1]);
    double const way = std::abs(x[turns[k + 1]] - x[turns[k]]);
    auto const is_no_turn = [&](std::size_t i) {
      return std::min(std::abs(x[i]), std::abs(x[i] - motion.centre)) > resting * way;
    };
    double in_full = 0.0;
    for (auto cut = std::ranges::lower_bound(full, first, {}, &CycleCut::last); cut != full.end() && cut->first < last;
         ++cut)
      in_full += std::abs(value_at(x, std::min(cut->last, last)) - value_at(x, std::max(cut->first, first)));
    // A swing belongs to the full cycles if more than this part of its way lies in full cycles. 1e-6 allows for
    // rounding errors of the interpolated cuts.
    constexpr double half = 0.5 + 1e-6;
    bool const belongs = in_full > half * way || has_gap(motion.gaps, first, last) ||
                         (k == 0 && is_no_turn(turns[0])) || (k + 2 == turns.size() && is_no_turn(turns[k + 1]));
    if (!belongs) {
      auto shape = motion.shape(first, last);
      shape.half = shape.turns_at_start = shape.turns_at_end = true;
      shape.unevenness = 0.0;
      shape.period *= 2.0;
      shape.rise_and_fall = shape.period + shape.still_time;
      if (!motion.further.load_kN.empty())
        shape.load_kN = num::moments(motion.further.load_kN.subspan(turns[k], turns[k + 1] - turns[k] + 1)).mean;
      if (!joins) groups.emplace_back();
      groups.back().push_back(std::move(shape));
    }
    joins = !belongs;
  }
  return groups;
}

Segmentation with_half_cycles(Segmentation segmentation, Motion const& motion) {
  std::vector<std::vector<CycleCut>> blocks;
  auto const add = [&](std::vector<CycleCut> const& cuts) {
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      if (i == 0 || cuts[i].block != cuts[i - 1].block) blocks.emplace_back();
      blocks.back().push_back(cuts[i]);
    }
  };
  std::vector<CycleCut> full;
  for (auto const& cut : segmentation.cycles)
    if (segmentation.cyclic && !cut.partial) full.push_back(cut);
  auto groups = half_cycles(motion, full);
  if (groups.empty()) return segmentation;
  auto const is_replaced = [&](CycleCut const& cut) {
    return (cut.partial || !segmentation.cyclic) && std::ranges::any_of(groups, [&](auto const& group) {
             return cut.first < group.back().last && group.front().first < cut.last;
           });
  };
  std::erase_if(segmentation.cycles, is_replaced);
  add(segmentation.cycles);
  for (auto& group : groups) add(number_cycles(group, motion.time.empty() ? "samples" : "s"));
  std::ranges::stable_sort(blocks, {}, [](auto const& block) { return block.front().first; });
  segmentation.cycles.clear();
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (auto& cut : blocks[b]) {
      cut.block = static_cast<int>(b) + 1;
      segmentation.cycles.push_back(std::move(cut));
    }
  segmentation.cyclic = true;
  segmentation.refusal.reset();
  return segmentation;
}

// If the time jumps where one excursion ends and the next begins, ends the first one before the jump and begins the
// next one after it, because nobody knows the motion in between.
void part_at_gaps(Motion& motion) {
  for (auto const& gap : motion.gaps) {
    if (gap.taken_s >= gap.length_s) continue;  // the logger only skipped a rest
    auto const after = static_cast<double>(gap.last_before);
    constexpr double rounding = 0.5;  // the boundary of two excursions may lie up to this many samples after the gap
    auto const excursion = std::ranges::lower_bound(motion.excursions, after, {}, &Excursion::last);
    if (excursion == motion.excursions.end() || excursion + 1 == motion.excursions.end() ||
        excursion->last > after + 1.0 + rounding)
      continue;
    excursion->last = after;
    (excursion + 1)->first = after + 1.0;
  }
}

// Cuts a test into full cycles and parts of cycles. Also fills `motion`, because with_half_cycles() needs it.
Segmentation cut_full(std::span<double const> disp_mm, std::span<double const> time_s, FurtherChannels const& further,
                      Motion& motion) {
  auto gaps = time_gaps(disp_mm, time_s);
  auto const moving = without_gaps(time_s, gaps);
  if (!moving.empty()) time_s = moving;
  Segmentation segmentation;
  if (disp_mm.empty()) {
    segmentation.refusal = Finding{.kind = FindingKind::no_complete_cycle};
    return segmentation;
  }
  auto const found = reversals(disp_mm);
  motion.x = disp_mm;
  motion.time = time_s;
  motion.further = further;
  motion.gaps = std::move(gaps);
  segmentation.band_mm = found.band_mm;
  if (found.at.size() < 2) {
    segmentation.refusal = too_short(disp_mm, motion, segmentation);
    return segmentation;
  }
  motion.turns = found.at;
  auto const swings = swings_of(disp_mm, found.at);
  motion.noise = noise_deviation(disp_mm);
  if (is_one_sided(disp_mm, found)) return cut_one_sided(motion, std::move(segmentation));
  segmentation.centre_mm = centre_of(disp_mm, swings, found.band_mm);
  motion.centre = segmentation.centre_mm;
  motion.excursions = excursions(disp_mm, time_s, found, segmentation.centre_mm);
  part_at_gaps(motion);
  for (auto& excursion : motion.excursions) excursion.has_gap = has_gap(motion.gaps, excursion.first, excursion.last);
  motion.groups = group_excursions(motion.excursions);
  if (motion.count(Part::cycle) == 0) {
    segmentation.refusal = too_short(disp_mm, motion, segmentation);
    segmentation.cycles = with_parts({}, motion);
    return segmentation;
  }
  std::vector<Shape> shapes;
  for (auto const& group : motion.groups)
    if (group.part == Part::cycle) shapes.push_back(motion.shape(group));
  bool const growing = grows(motion);
  if (growing)
    for (auto& shape : shapes) shape.unevenness = 0.0;
  segmentation.cycles = number_cycles(shapes, time_s.empty() ? "samples" : "s");
  segmentation.regular_share = growing ? 1.0 : regular_share(shapes, swings, motion, found.at);
  segmentation.cyclic = segmentation.regular_share >= least_regular_share;
  if (!segmentation.cyclic) {
    segmentation.refusal = not_cyclic(shapes, segmentation.regular_share);
    for (auto& cut : segmentation.cycles) {
      cut.block = 1;
      cut.number = 0;
      cut.not_counted = not_cyclic_cycle;
    }
  }
  segmentation.cycles = with_parts(std::move(segmentation.cycles), motion, segmentation.cyclic);
  return segmentation;
}

Segmentation cut_test(std::span<double const> disp_mm, std::span<double const> time_s, FurtherChannels const& further) {
  Motion motion;
  auto segmentation = cut_full(disp_mm, time_s, further, motion);
  return further.half_cycles ? with_half_cycles(std::move(segmentation), motion) : segmentation;
}

}  // namespace

// Uses fourth differences: they magnify white noise by sqrt(70), and shrink a sine of 20 samples per cycle to a
// hundredth, so that hardly anything but noise is left. The median size of normally distributed noise is 0.6745
// standard deviations. A missing value counts as large, because nth_element cannot sort NaN.
double noise_deviation(std::span<double const> x) {
  if (x.size() < 16) return 0.0;
  std::vector<double> sizes(x.size() - 4);
  for (std::size_t i = 0; i < sizes.size(); ++i)
    sizes[i] = std::abs((x[i] + x[i + 4]) - 4.0 * (x[i + 1] + x[i + 3]) + 6.0 * x[i + 2]);
  for (double& size : sizes)
    if (std::isnan(size)) size = std::numeric_limits<double>::infinity();
  auto const middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::ranges::nth_element(sizes, middle);
  return *middle / (0.6745 * std::sqrt(70.0));
}

double half_range(std::span<double const> values) {
  if (values.empty()) return 0.0;
  auto const [least, largest] = std::ranges::minmax(values);
  return largest / 2.0 - least / 2.0;
}

double value_at(std::span<double const> values, double index) {
  auto const i = std::min(static_cast<std::size_t>(index), values.size() - 1);
  double const part = index - static_cast<double>(i);
  return part > 0.0 && i + 1 < values.size() ? values[i] + part * (values[i + 1] - values[i]) : values[i];
}

PeakPositions peak_positions(std::span<double const> disp_mm, double first, double last) {
  auto const begin = static_cast<std::size_t>(std::ceil(first));
  auto const end = std::min(static_cast<std::size_t>(std::floor(last)) + 1, disp_mm.size());
  if (begin >= end) return {first, last};
  auto const samples = disp_mm.subspan(begin, end - begin);
  auto const [least, largest] = std::ranges::minmax(samples);
  double const beyond = 0.45 * (largest - least);
  double const middle = largest / 2.0 + least / 2.0;
  auto const position = [&](double sign) {
    double enters = -1.0, leaves = -1.0;
    auto const y = [&](std::size_t i) { return sign * (samples[i] - middle) - beyond; };
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (!(y(i) >= 0.0)) continue;
      if (enters < 0.0) enters = static_cast<double>(i) - (i > 0 && y(i - 1) < 0.0 ? y(i) / (y(i) - y(i - 1)) : 0.0);
      leaves = static_cast<double>(i) + (i + 1 < samples.size() && y(i + 1) < 0.0 ? y(i) / (y(i) - y(i + 1)) : 0.0);
    }
    return static_cast<double>(begin) + (enters < 0.0 ? 0.0 : (enters + leaves) / 2.0);
  };
  return {.largest = position(1.0), .smallest = position(-1.0)};
}

Reversals reversals(std::span<double const> disp_mm) {
  Reversals found;
  double const half = half_range(disp_mm);
  if (disp_mm.size() < 3 || !(half > 0.0) || !std::isfinite(2.0 * half)) return found;
  found.band_mm = std::clamp(noise_deviations * noise_deviation(disp_mm), least_floor * half, largest_floor * half);
  found.at = without_interruptions(disp_mm, extremes(disp_mm, 2.0 * found.band_mm));
  return found;
}

Segmentation segment(std::span<double const> disp_mm, std::span<double const> time_s,
                     std::span<std::size_t const> starts, FurtherChannels const& further) {
  if (starts.empty()) return cut_test(disp_mm, time_s, further);
  Segmentation all;
  int blocks = 0;
  for (auto const& range : test_ranges(starts, disp_mm.size())) {
    auto test = cut_test(range.slice(disp_mm), range.slice(time_s),
                         {.load_kN = range.slice(further.load_kN),
                          .logged_cycle = range.slice(further.logged_cycle),
                          .half_cycles = further.half_cycles});
    if (test.cyclic == all.cyclic ? test.band_mm > all.band_mm : test.cyclic) {
      all.band_mm = test.band_mm;
      all.centre_mm = test.centre_mm;
      all.regular_share = test.regular_share;
    }
    all.cyclic = all.cyclic || test.cyclic;
    if (!all.refusal) all.refusal = std::move(test.refusal);
    int const before = blocks;
    for (auto& cut : test.cycles) {
      if (cut.first == 0.0) cut.turns_at_start = true;  // a test starts and ends at rest
      if (cut.last == static_cast<double>(range.size() - 1)) cut.turns_at_end = true;
      cut.first += static_cast<double>(range.first);
      cut.last += static_cast<double>(range.first);
      cut.block += before;
      blocks = std::max(blocks, cut.block);
      all.cycles.push_back(std::move(cut));
    }
  }
  if (all.cyclic) all.refusal.reset();
  return all;
}

}  // namespace isolaw::data
