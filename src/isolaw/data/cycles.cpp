#include "isolaw/data/cycles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "isolaw/data/cycle_blocks.hpp"

namespace isolaw::data {
namespace {

constexpr double least_floor = 0.01;      // of the half range
constexpr double largest_floor = 0.05;    // of the half range: more is no noise of a rig
constexpr double noise_deviations = 5.0;  // beyond these among a million samples there is hardly one
constexpr double interruption = 0.04;     // of the smaller neighbouring swing; one of 5 to 200 % strain is a stage
constexpr double first_motion = 0.2;      // of the next swing: less is a pre-load, not a first quarter of a cycle
constexpr double off_centre = 0.05;       // of the amplitude: a record this close to zero is cut at zero
constexpr double lopsided = 0.25;         // of the amplitude: a lone cycle this uneven still starts from its centre
constexpr double rest = 0.05;             // of the amplitude: a record that starts or ends this close is at rest
constexpr double as_large = 0.05;         // of the amplitude: a piece of a cycle that repeats its neighbour
// Of the travel. Of 1000 responses of linear oscillators to irregular motion 10 reach 0.64 and one 0.80; cyclic tests
// reach 0.9 and more.
constexpr double least_regular_share = 0.8;

double half_range(std::span<double const> x) {
  if (x.empty()) return 0.0;
  auto const [least, largest] = std::ranges::minmax(x);
  return largest / 2.0 - least / 2.0;
}

// Standard deviation of white noise, from the median of |fourth differences|: a sine of 20 samples in a cycle leaves
// only a thousandth of its amplitude in them, a hundred samples next to nothing. White noise gains sqrt(70).
double noise_of(std::span<double const> x) {
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

// Alternating extremes whose swings are of at least `least` mm, the first sample in front.
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

// Without swings that interrupt two much larger ones.
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

// Swings between reversals: half height and middle.
struct Swings {
  std::vector<double> half;
  std::vector<double> middle;
  std::size_t begin = 0;  // of those whose two ends are reversals, not ends of the record, where there are enough
  std::size_t end = 0;
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

// Weighted median of the swings' middles. The weight makes the largest stage decide, where an offset shows least and
// matters most, and lets no swing from one stage to the next outweigh the stages.
double middle_of(Swings const& swings) {
  double largest = 0.0;
  for (auto k = swings.begin; k < swings.end; ++k) largest = std::max(largest, swings.half[k]);
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

// Zero wherever that serves: the centre of a noisy history is less certain than the zero of a test.
double centre_of(std::span<double const> x, Swings const& swings, double band) {
  double const middle = middle_of(swings);
  double const amplitude = *std::max_element(swings.half.begin() + static_cast<std::ptrdiff_t>(swings.begin),
                                             swings.half.begin() + static_cast<std::ptrdiff_t>(swings.end));
  bool const zero_serves = swings_across(swings, 0.0, band) >= swings_across(swings, middle, band);
  if (std::abs(middle) <= off_centre * amplitude && zero_serves) return 0.0;
  bool const ends_where_it_starts = std::abs(x.back() - x.front()) <= rest * amplitude;
  bool const starts_elsewhere = std::abs(x.front() - middle) > off_centre * amplitude;
  if (ends_where_it_starts && starts_elsewhere && std::abs(x.front() - middle) <= lopsided * amplitude)
    return std::abs(x.front()) <= off_centre * amplitude ? 0.0 : x.front();
  return middle;
}

// +1 or -1: the first swing that is no mere pre-load.
double first_direction(std::span<double const> x, std::vector<std::size_t> const& at, Swings const& swings) {
  std::size_t k = 0;
  while (k + 1 < swings.half.size() && swings.half[k] < first_motion * swings.half[k + 1]) ++k;
  return x[at[k + 1]] > x[at[k]] ? 1.0 : -1.0;
}

struct Cutter {
  std::span<double const> x;
  std::vector<std::size_t> const& at;
  double centre = 0.0;
  double direction = 1.0;
  double band = 0.0;
  double rest_band = 0.0;  // for the start and the end of the record

  double y(std::size_t i) const { return direction * (x[i] - centre); }

  std::optional<double> crossing(std::size_t from, std::size_t to) const {
    for (auto i = from + 1; i <= to; ++i) {
      double const before = y(i - 1);
      double const after = y(i);
      if (!(before < 0.0 && after >= 0.0)) continue;
      double const part = before / (before - after);  // not finite where a damaged store's values are not
      return static_cast<double>(i - 1) + (std::isfinite(part) ? part : 0.0);
    }
    return std::nullopt;
  }

  // The sample nearest to the centre after the last one beyond the band about it: three exact cycles of a sine end at
  // the centre without crossing it.
  std::size_t rest_index() const {
    std::size_t first = x.size();
    while (first > 0 && std::abs(y(first - 1)) <= rest_band) --first;
    std::size_t nearest = first;
    for (auto i = first; i < x.size(); ++i)
      if (std::abs(y(i)) < std::abs(y(nearest))) nearest = i;
    return nearest;
  }

  std::vector<double> cuts() const {
    std::vector<double> found;
    bool const starts_at_rest = std::abs(y(0)) <= rest_band;
    if (starts_at_rest) found.push_back(0.0);
    for (std::size_t k = 1; k < at.size(); ++k) {
      bool const last = k + 1 == at.size();
      if (k == 1 && starts_at_rest && y(at[1]) > 0.0) continue;
      if (!(y(at[k - 1]) < -band || (k == 1 && y(at[0]) < 0.0)) || y(at[k]) < y(at[k - 1])) continue;
      if (auto const here = crossing(at[k - 1], last ? x.size() - 1 : at[k]))
        found.push_back(*here);
      else if (last && std::abs(y(x.size() - 1)) <= rest_band)
        found.push_back(static_cast<double>(rest_index()));
    }
    return found;
  }
};

Shape shape_of(std::span<double const> x, std::span<double const> time, double first, double last, double centre) {
  Shape shape{.first = first, .last = last};
  double const start = value_at(x, first), end = value_at(x, last);
  shape.least = std::min(start, end);
  shape.largest = std::max(start, end);
  auto const stop = std::min(static_cast<std::size_t>(std::ceil(last)), x.size());
  for (auto i = static_cast<std::size_t>(first) + 1; i < stop; ++i) {
    shape.least = std::min(shape.least, x[i]);
    shape.largest = std::max(shape.largest, x[i]);
  }
  shape.unevenness = std::abs((shape.largest - centre) + (shape.least - centre)) / (shape.largest - shape.least);
  auto const peaks = peak_positions(x, first, last);
  shape.period = 2.0 * (time.empty() ? std::abs(peaks.largest - peaks.smallest)
                                     : std::abs(value_at(time, peaks.largest) - value_at(time, peaks.smallest)));
  return shape;
}

CycleCut partial(int block, double first, double last, std::string reason) {
  CycleCut cut;
  cut.block = block;
  cut.partial = true;
  cut.first = first;
  cut.last = last;
  cut.not_counted = std::move(reason);
  return cut;
}

// What no transducer resolves is zero, and zero has no sign.
double or_zero(double disp_mm) {
  return std::abs(disp_mm) < 1e-6 ? 0.0 : disp_mm;
}

// With the pieces before the first cut and after the last, which are no cycles.
std::vector<CycleCut> with_partial_ends(std::vector<CycleCut> cycles, Cutter const& cutter,
                                        std::vector<double> const& cuts) {
  auto const& x = cutter.x;
  std::vector<CycleCut> all;
  if (cuts.front() > 0.0)
    all.push_back(partial(cycles.empty() ? 1 : cycles.front().block, 0.0, cuts.front(),
                          fmt::format("partial: the record starts at {:.4g} mm, within a cycle", or_zero(x.front()))));
  int const last_block = cycles.empty() ? 1 : cycles.back().block;
  std::ranges::move(cycles, std::back_inserter(all));
  double farthest = 0.0;
  for (auto i = static_cast<std::size_t>(std::ceil(cuts.back())); i < x.size(); ++i)
    farthest = std::max(farthest, std::abs(cutter.y(i)));
  if (farthest > cutter.rest_band)
    all.push_back(
        partial(last_block, cuts.back(), static_cast<double>(x.size() - 1),
                fmt::format("partial: the record ends at {:.4g} mm, before the cycle is closed", or_zero(x.back()))));
  return all;
}

std::string too_short(std::span<double const> x, std::size_t cuts, Segmentation const& made) {
  auto const [least, largest] = std::ranges::minmax(x);
  return fmt::format(
      "less than one complete cycle: displacement runs from {:.4g} to {:.4g} mm and {} crossings of {} in the "
      "direction of the first motion were found, 2 are needed (swings of less than {:.3g} mm are taken for noise)",
      least, largest, cuts, made.centre_mm == 0.0 ? "zero" : fmt::format("its centre at {:.4g} mm", made.centre_mm),
      2.0 * made.band_mm);
}

// Travel of the swings before the first cut and after the last that are as large as the regular cycle beside them: where
// a record starts or ends within a cycle, its piece is no irregular motion.
double regular_ends(std::vector<Shape> const& shapes, Swings const& swings, std::vector<std::size_t> const& at) {
  double travel = 0.0;
  for (auto k = swings.begin; k < swings.end; ++k) {
    auto const from = static_cast<double>(at[k]), to = static_cast<double>(at[k + 1]);
    bool const before = from < shapes.front().first;
    if (!before && to <= shapes.back().last) continue;
    auto const& beside = before ? shapes.front() : shapes.back();
    if (!beside.regular || std::abs(swings.half[k] - beside.amplitude()) > as_large * beside.amplitude()) continue;
    bool const crosses = before ? to > beside.first : from < beside.last;  // half of it belongs to the cycle
    travel += (crosses ? 1.0 : 2.0) * swings.half[k];
  }
  return travel;
}

// Travel in regular cycles over all travel, apart from tapers, the record's first and last swing and regular ends.
double regular_share(std::vector<Shape> const& shapes, Swings const& swings, std::vector<std::size_t> const& at) {
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
  double const all = std::max(in_cycles, travel - regular_ends(shapes, swings, at)) - in_tapers;
  return all > 0.0 ? regular / all : 0.0;
}

std::string not_cyclic(std::vector<Shape> const& shapes, double share) {
  auto const [least, largest] =
      std::ranges::minmax(shapes, {}, [](Shape const& shape) { return shape.largest - shape.least; });
  auto const regular = std::ranges::count_if(shapes, &Shape::regular);
  return fmt::format(
      "not cyclic: {} of {} swings to and fro repeat an amplitude or are symmetric within 5 %, {:.0f} % of the travel "
      "where a cyclic test has {:.0f} % or more; amplitudes run from {:.3g} to {:.3g} mm",
      regular, shapes.size(), 100.0 * share, 100.0 * least_regular_share, (least.largest - least.least) / 2.0,
      (largest.largest - largest.least) / 2.0);
}

}  // namespace

double value_at(std::span<double const> values, double index) {
  auto const i = std::min(static_cast<std::size_t>(index), values.size() - 1);
  double const part = index - static_cast<double>(i);
  return part > 0.0 && i + 1 < values.size() ? values[i] + part * (values[i + 1] - values[i]) : values[i];
}

std::size_t Segmentation::complete() const {
  return static_cast<std::size_t>(std::ranges::count_if(cycles, [](CycleCut const& cut) { return !cut.partial; }));
}

PeakPositions peak_positions(std::span<double const> disp_mm, double first, double last) {
  auto const begin = static_cast<std::size_t>(std::ceil(first));
  auto const end = std::min(static_cast<std::size_t>(std::floor(last)) + 1, disp_mm.size());
  if (begin >= end) return {first, last};
  auto const samples = disp_mm.subspan(begin, end - begin);
  auto const [least, largest] = std::ranges::minmax(samples);
  double const beyond = 0.45 * (largest - least);
  double const middle = largest / 2.0 + least / 2.0;
  // From the first to the last sample beyond the level, the ends interpolated.
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
  found.band_mm = std::clamp(noise_deviations * noise_of(disp_mm), least_floor * half, largest_floor * half);
  found.at = without_interruptions(disp_mm, extremes(disp_mm, 2.0 * found.band_mm));
  return found;
}

Segmentation segment(std::span<double const> disp_mm, std::span<double const> time_s) {
  Segmentation made;
  if (disp_mm.empty()) {
    made.refusal = "no samples";
    return made;
  }
  auto const motion = reversals(disp_mm);
  made.band_mm = motion.band_mm;
  if (motion.at.size() < 2) {
    made.refusal = too_short(disp_mm, 0, made);
    return made;
  }
  auto const swings = swings_of(disp_mm, motion.at);
  made.centre_mm = centre_of(disp_mm, swings, motion.band_mm);
  auto const first_swing = std::max(swings.half.front(), swings.half[std::min<std::size_t>(1, swings.half.size() - 1)]);
  Cutter const cutter{.x = disp_mm,
                      .at = motion.at,
                      .centre = made.centre_mm,
                      .direction = first_direction(disp_mm, motion.at, swings),
                      .band = motion.band_mm,
                      .rest_band = std::max(motion.band_mm, rest * first_swing)};
  auto const cuts = cutter.cuts();
  if (cuts.size() < 2) {
    made.refusal = too_short(disp_mm, cuts.size(), made);
    if (!cuts.empty()) made.cycles = with_partial_ends({}, cutter, cuts);
    return made;
  }
  std::vector<Shape> shapes;
  for (std::size_t k = 1; k < cuts.size(); ++k)
    shapes.push_back(shape_of(disp_mm, time_s, cuts[k - 1], cuts[k], made.centre_mm));
  made.cycles = number_cycles(shapes);
  made.regular_share = regular_share(shapes, swings, motion.at);
  made.cyclic = made.regular_share >= least_regular_share;
  if (!made.cyclic) {
    made.refusal = not_cyclic(shapes, made.regular_share);
    for (auto& cut : made.cycles) {
      cut.block = 1;
      cut.number = 0;
      cut.not_counted = "the record is not cyclic";
    }
  }
  made.cycles = with_partial_ends(std::move(made.cycles), cutter, cuts);
  return made;
}

}  // namespace isolaw::data
