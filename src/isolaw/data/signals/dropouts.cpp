#include "isolaw/data/signals/dropouts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "isolaw/data/cycles/cycles.hpp"

namespace isolaw::data {
namespace {

// A dropout has at least this many samples. A shorter one is left to the search for spikes.
constexpr std::size_t fewest_gone = 3;
// The channel jumps into a dropout and out of it. Each of the two jumps exceeds all of the next four limits. The half
// range of a channel is half the difference between its largest and smallest value.
constexpr double least_gone = 0.1;        // this fraction of the channel's half range
constexpr double gone_deviations = 10.0;  // this many standard deviations of the channel's noise
constexpr double gone_quanta = 4.0;       // this many steps of the channel's digitiser
constexpr double gone_steps = 4.0;        // this many times the largest step just before or after the dropout
// During a dropout the other channel of the device moves by more than this fraction of its own half range.
constexpr double other_goes_on = 0.002;
// If both channels jump, the device itself has moved, and there is no dropout. So at a dropout, the other channel jumps
// by a smaller part of its half range: at most this fraction of jump / half range in the channel with the dropout.
constexpr double other_jumps = 0.3;
// If more than this fraction of all samples lies in dropouts, none is reported: they seem to belong to the signal.
constexpr double most_gone = 0.15;

struct Size {
  double half_range = 0.0, noise = 0.0, quantum = 0.0;
};

Size size_of(std::span<double const> x) {
  auto const [least, largest] = std::ranges::minmax(x);
  double const half = largest / 2.0 - least / 2.0;
  return {.half_range = half, .noise = noise_deviation(x), .quantum = smallest_step(x, 2.0 * half)};
}

double largest_step(std::span<double const> x, std::size_t begin, std::size_t end) {
  double largest = 0.0;
  for (auto i = begin; i + 1 < std::min(end, x.size()); ++i) largest = std::max(largest, std::abs(x[i + 1] - x[i]));
  return largest;
}

class DropoutSearch {
 public:
  DropoutSearch(std::span<double const> x, std::span<double const> other, OtherChannel does)
      : x_(x), other_(other), own_(size_of(x)), other_size_(size_of(other)), does_(does) {}

  std::vector<Dropout> find() const {
    std::vector<Dropout> found;
    if (!(own_.half_range > 0.0) || !(other_size_.half_range > 0.0) ||
        !std::isfinite(own_.half_range + other_size_.half_range))
      return found;
    double const width = same_value * 2.0 * own_.half_range;
    std::size_t gone = 0;
    for (std::size_t first = 0, i = 1; i <= x_.size(); ++i) {
      if (i < x_.size() && std::abs(x_[i] - x_[first]) <= width) continue;
      SampleRange const run{.first = first, .last = i - 1};
      first = i;
      if (run.size() < fewest_gone || !is_dropout(run)) continue;
      gone += run.size();
      found.push_back({.samples = run, .level = x_[run.first], .before = x_[run.first - 1], .after = x_[run.last + 1]});
    }
    if (static_cast<double>(gone) > most_gone * static_cast<double>(x_.size())) found.clear();
    return found;
  }

 private:
  bool is_dropout(SampleRange const& run) const {
    auto const count = run.size();
    if (run.first < 2 || run.last + 2 >= x_.size()) return false;
    double const off_before = x_[run.first] - x_[run.first - 1], off_after = x_[run.last] - x_[run.last + 1];
    if (!(off_before * off_after > 0.0)) return false;
    double const jump = std::min(std::abs(off_before), std::abs(off_after));
    if (!(jump > std::max({least_gone * own_.half_range, gone_deviations * own_.noise, gone_quanta * own_.quantum})))
      return false;
    auto const reach = std::max<std::size_t>(6, count);
    double const step = std::max(largest_step(x_, run.first > reach ? run.first - reach : 0, run.first),
                                 largest_step(x_, run.last + 1, run.last + 1 + reach));
    if (!(jump > gone_steps * step)) return false;
    // After a dropout, the channel must have a value that it could reach at its usual speed during the dropout.
    double const way = std::abs(x_[run.last + 1] - x_[run.first - 1]);
    if (way > 2.0 * step * static_cast<double>(count + 1) + gone_deviations * own_.noise) return false;
    for (auto const i : {run.first, run.last + 1})
      if (std::abs(other_[i] - other_[i - 1]) / other_size_.half_range > other_jumps * jump / own_.half_range)
        return false;
    return does_ == OtherChannel::may_stand || (goes_on(run) && !turns_at_both_ends(run));
  }

  bool goes_on(SampleRange const& run) const {
    auto const [least, largest] = std::ranges::minmax(other_.subspan(run.first - 1, run.size() + 2));
    return largest - least >
           std::max({other_goes_on * other_size_.half_range, 4.0 * other_size_.noise, 2.0 * other_size_.quantum});
  }

  // A force with friction jumps at a turn of the motion and jumps back at the next turn. This is no dropout.
  bool turns_at_both_ends(SampleRange const& run) const {
    auto const lag = std::max<std::size_t>(4, run.size());
    auto const begin = run.first - 1 - std::min(run.first - 1, lag);
    auto const end = std::min(run.last + 1 + lag, other_.size() - 1);
    double const within = other_[run.last] - other_[run.first];
    return within * (other_[run.first - 1] - other_[begin]) < 0.0 &&
           within * (other_[end] - other_[run.last + 1]) < 0.0;
  }

  std::span<double const> x_, other_;
  Size own_, other_size_;
  OtherChannel does_;
};

}  // namespace

std::vector<Dropout> dropouts(std::span<double const> values, std::span<double const> other, OtherChannel does) {
  constexpr std::size_t fewest = 16;
  if (values.size() < fewest || values.size() != other.size()) return {};
  return DropoutSearch(values, other, does).find();
}

std::vector<double> bridged(std::span<double const> values, std::vector<Dropout> const& gone) {
  std::vector<double> filled(values.begin(), values.end());
  for (auto const& one : gone) {
    auto const [first, last] = one.samples;
    auto const intervals = static_cast<double>(one.samples.size() + 1);
    for (auto i = first; i <= last; ++i)
      filled[i] = one.before + (one.after - one.before) * static_cast<double>(i + 1 - first) / intervals;
  }
  return filled;
}

}  // namespace isolaw::data
