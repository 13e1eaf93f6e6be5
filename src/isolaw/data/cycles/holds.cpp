#include "isolaw/data/cycles/holds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "isolaw/data/cycles/cycles.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::data {
namespace {

constexpr double band = 0.005;       // in a hold, displacement varies by at most this fraction of the amplitude
constexpr double edge = 0.0005;      // a hold starts and ends at most this fraction of the amplitude off its median
constexpr double noise_band = 8.0;   // the extremes of a hold may be this many standard deviations of the noise apart
constexpr double too_noisy = 0.3;    // no holds are sought if noise_band * noise exceeds this fraction of the amplitude
constexpr double least_hold = 0.15;  // a hold lasts longer than this fraction of the period
constexpr double least_stretch = 0.02;  // a hold has more than this fraction of the cycle's samples
constexpr double clear_edges = 0.9;     // unclear ends of a hold are cut off only if this fraction of it remains
constexpr std::size_t most_holds = 16;  // in one cycle
constexpr std::size_t least_in_piece = 8;

// Fraction of a period that a sine spends between two levels on its way up or, near a peak, on its way up and down.
double lingering(double least, double largest) {
  auto const angle = [](double level) { return std::acos(std::clamp(level, -1.0, 1.0)); };
  double const once = (angle(least) - angle(largest)) / (2.0 * std::numbers::pi);
  bool const at_a_peak = largest > 0.98 || least < -0.98;
  return at_a_peak ? 2.0 * once : once;
}

Stretch sharpened(std::span<double const> x, Stretch const& stretch, double level, double half_width) {
  auto const within = [&](std::size_t i) { return std::abs(x[i] - level) <= half_width; };
  auto sharp = stretch;
  while (sharp.first < sharp.last && !within(sharp.first)) ++sharp.first;
  while (sharp.first < sharp.last && !within(sharp.last)) --sharp.last;
  return static_cast<double>(sharp.intervals()) >= clear_edges * static_cast<double>(stretch.intervals()) ? sharp
                                                                                                          : stretch;
}

}  // namespace

std::vector<Stretch> stretches_within(std::span<double const> x, std::size_t begin, std::size_t end, double width,
                                      std::size_t least) {
  std::vector<Stretch> found;
  std::vector<std::size_t> low, high;  // queues of candidates for the window's least and largest value
  std::size_t low_front = 0, high_front = 0, left = begin;
  for (auto i = begin; i <= end; ++i) {
    bool const over = i == end;
    if (!over) {
      while (low.size() > low_front && x[low.back()] >= x[i]) low.pop_back();
      while (high.size() > high_front && x[high.back()] <= x[i]) high.pop_back();
      low.push_back(i), high.push_back(i);
    }
    bool const leaves = over || x[high[high_front]] - x[low[low_front]] > width;
    if (leaves && i > left && i - 1 - left >= least) found.push_back({.first = left, .last = i - 1});
    while (!over && left < i && x[high[high_front]] - x[low[low_front]] > width) {
      ++left;
      while (low[low_front] < left) ++low_front;
      while (high[high_front] < left) ++high_front;
    }
  }
  return found;
}

StillTime still_time(std::span<double const> disp_mm, std::span<double const> time_s, Piece const& piece,
                     double noise) {
  StillTime still;
  auto const begin = static_cast<std::size_t>(std::ceil(piece.first));
  auto const end = std::min(static_cast<std::size_t>(std::floor(piece.last)) + 1, disp_mm.size());
  if (end < begin + least_in_piece || !(piece.amplitude > 0.0) || noise_band * noise > too_noisy * piece.amplitude)
    return still;
  double const width = std::max(band * piece.amplitude, noise_band * noise);
  double const half_edge = std::max(edge * piece.amplitude, noise_band / 2.0 * noise);
  auto const time_at = [&](double index) { return time_s.empty() ? index : value_at(time_s, index); };
  auto const duration = [&](Stretch const& s) {
    return time_at(static_cast<double>(s.last)) - time_at(static_cast<double>(s.first));
  };
  auto const least =
      std::max<std::size_t>(2, static_cast<std::size_t>(least_stretch * static_cast<double>(end - begin)));
  auto stretches = stretches_within(disp_mm, begin, end, width, least);
  std::ranges::sort(stretches, [&](auto const& a, auto const& b) { return a.intervals() > b.intervals(); });
  double moving = time_at(piece.last) - time_at(piece.first);
  std::vector<Stretch> holds;
  for (auto const& stretch : stretches) {
    auto const overlaps = [&](Stretch const& hold) { return stretch.first <= hold.last && hold.first <= stretch.last; };
    if (holds.size() == most_holds) break;
    if (std::ranges::any_of(holds, overlaps)) continue;
    std::vector<double> values(disp_mm.begin() + static_cast<std::ptrdiff_t>(stretch.first),
                               disp_mm.begin() + static_cast<std::ptrdiff_t>(stretch.last) + 1);
    auto const half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, half);
    double const level = *half;  // the median, since a mean may fall between two steps of the digitiser
    auto const hold = sharpened(disp_mm, stretch, level, half_edge);
    double const reach = (hold.intervals() == stretch.intervals() ? width / 2.0 : half_edge) / piece.amplitude;
    double const centred = (level - piece.middle) / piece.amplitude;
    double const share = lingering(centred - reach, centred + reach);
    double const without = (moving - duration(hold)) / (1.0 - share);
    double const stands = moving - without;
    if (!(stands > least_hold * without)) break;
    still.samples += static_cast<double>(hold.intervals()) * stands / duration(hold);
    still.time += stands;
    moving = without;
    holds.push_back(stretch);
  }
  return still;
}

}  // namespace isolaw::data
