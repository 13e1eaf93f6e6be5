#include "isolaw/data/signals/sticking.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "isolaw/num/statistics.hpp"

namespace isolaw::data {
namespace {

// A stretch is a run of samples in which a channel keeps one value. The channel may be stuck there, or the device may
// rest. The half range of a channel is half the difference between its largest and smallest value.
constexpr std::size_t least_stretch = 4;  // fewest samples of a stretch
// The missed motion is the way that displacement would have gone in the stretch at its speed before or after it. If
// displacement is stuck, this way exceeds least_missed times its half range and missed_quanta steps of its digitiser.
constexpr double least_missed = 0.02;
constexpr double missed_quanta = 4.0;
// At the end of a stretch a stuck channel jumps by more than this many times its step from sample to sample.
constexpr double least_jump = 2.0;
// If displacement is stuck, the force changes during the stretch by more than this fraction of the stiffness times the
// missed motion.
constexpr double least_advance = 0.1;
// If more than this fraction of the samples lies in stretches, the channel is not stuck: it only repeats values.
constexpr double most_stretches = 0.3;
// If the force is stuck, displacement moves during the stretch by more than this fraction of its half range.
constexpr double force_stands = 0.05;

class Sticking {
 public:
  explicit Sticking(SignalPair const& pair) : pair_(pair) {}

  std::vector<SignalFault> find(bool clipped_disp, bool clipped_force) {
    if (!clipped_disp) stuck_displacement();
    if (!clipped_force) stuck_force();
    return std::move(found_);
  }

 private:
  void add(std::string const& channel, std::string_view unit, std::vector<std::size_t> const& first, double level,
           std::size_t longest) {
    found_.push_back(standing_fault(FaultKind::stuck, channel, unit, first, pair_.time, level, longest));
  }

  std::vector<SampleRange> stretches(Signal const& signal) const {
    std::vector<SampleRange> runs;
    double const width = same_value * 2.0 * signal.half_range;
    for (std::size_t first = 0, i = 1; i <= signal.x.size(); ++i) {
      if (i < signal.x.size() && std::abs(signal.x[i] - signal.x[first]) <= width) continue;
      if (i - first >= least_stretch) runs.push_back({.first = first, .last = i - 1});
      first = i;
    }
    return runs;
  }

  std::pair<double, double> speeds(Signal const& signal, SampleRange const& run) const {
    auto const reach = std::clamp<std::size_t>(run.size(), 3, std::max<std::size_t>(3, pair_.half_cycle / 4));
    auto const back = std::min(reach, run.first);
    auto const after = run.last + 1;
    auto const ahead = after < pair_.size() ? std::min(reach, pair_.size() - 1 - after) : 0;
    double const before =
        back > 0 ? (signal.x[run.first] - signal.x[run.first - back]) / static_cast<double>(back) : 0.0;
    double const next = ahead > 0 ? (signal.x[after + ahead] - signal.x[after]) / static_cast<double>(ahead) : 0.0;
    return {before, next};
  }

  bool is_stuck(SampleRange const& run) const {
    auto const [before, after] = speeds(pair_.disp, run);
    double const speed = std::max(std::abs(before), std::abs(after));
    double const missed = speed * static_cast<double>(run.size() - 1);
    if (!(missed > std::max(least_missed * pair_.disp.half_range, missed_quanta * pair_.disp.quantum))) return false;
    auto const begin = pair_.force.x.begin() + static_cast<std::ptrdiff_t>(run.first);
    auto const [least, largest] = std::minmax_element(begin, begin + static_cast<std::ptrdiff_t>(run.size()));
    double const floor = std::max({0.01 * pair_.force.half_range, 6.0 * pair_.force.noise, 3.0 * pair_.force.quantum});
    if (!(*largest - *least > floor)) return false;
    double advance = 0.0;
    // When the device comes to rest at the record's end, displacement may stop a little before the force. So the force
    // at the stretch's first `late` samples is not used.
    auto const late =
        run.last + 1 == pair_.size() ? std::min(run.size() - 1, std::max<std::size_t>(2, pair_.half_cycle / 12)) : 0;
    auto const way = std::min(run.first, std::clamp<std::size_t>(pair_.half_cycle / 16, 2, 8));
    double const going = pair_.disp.x[run.first] - pair_.disp.x[run.first - way];
    auto const from = begin + static_cast<std::ptrdiff_t>(late);
    for (auto i = from; i != begin + static_cast<std::ptrdiff_t>(run.size()); ++i)
      advance = std::max(advance, std::copysign(1.0, going) * (*i - *from));
    auto const [lower, upper] = std::minmax_element(from, begin + static_cast<std::ptrdiff_t>(run.size()));
    if (*upper - *lower > most_of_force * 2.0 * pair_.force.half_range) return true;
    double const missed_before =
        std::abs(going) / static_cast<double>(std::max<std::size_t>(1, way)) * static_cast<double>(run.size() - 1);
    bool const went =
        missed_before > std::max(least_missed * pair_.disp.half_range, missed_quanta * pair_.disp.quantum);
    if (went && run.size() > least_stretch &&
        advance > std::max(2.0 * floor,
                           least_advance * pair_.stiffness() * std::min(missed_before, pair_.disp.half_range / 2.0)))
      return true;
    if (run.last + 1 >= pair_.size() || pair_.gap_after(run.last)) return false;
    double const jump = std::abs(pair_.disp.x[run.last + 1] - pair_.disp.x[run.last]);
    return jump > std::max({least_missed * pair_.disp.half_range,
                            least_jump * speed + missed_quanta * pair_.disp.quantum, 6.0 * pair_.disp.noise}) &&
           *largest - *least > 2.0 * floor;
  }

  static std::vector<SampleRange> quiet_stretches(Signal const& signal, double band, std::size_t least) {
    std::vector<SampleRange> runs;
    double sum = 0.0;
    std::size_t first = 0;
    for (std::size_t i = 0; i <= signal.x.size(); ++i) {
      auto const count = static_cast<double>(i - first);
      if (i < signal.x.size() && (i == first || std::abs(signal.x[i] - sum / count) <= band)) {
        sum += signal.x[i];
        continue;
      }
      if (i - first >= least) runs.push_back({.first = first, .last = i - 1});
      if (i == signal.x.size()) break;
      first = i;
      sum = signal.x[i];
    }
    return runs;
  }

  // Finds stretches in which the channel `stands` shows only noise while `other` moves on. At the end of such a stretch
  // `stands` jumps and `other` does not. In a true jump both channels move.
  std::vector<SampleRange> stuck_in_noise(Signal const& stands, Signal const& other, double least_part) const {
    double const noise = std::hypot(stands.noise, 0.3 * stands.quantum);
    if (!(noise > same_value * stands.half_range)) return {};
    constexpr std::size_t fewest = 8;
    std::vector<SampleRange> found;
    for (auto const& run : quiet_stretches(stands, 5.0 * noise, std::max<std::size_t>(fewest, pair_.half_cycle / 10))) {
      auto const lag = std::max<std::size_t>(2, pair_.half_cycle / 48);
      if (run.first == 0 || run.last + 1 + lag >= pair_.size() || pair_.gap_after(run.last)) continue;
      auto const middle = run.first + run.size() / 2;
      double const level = mean_of(stands.x, run.first, run.last + 1);
      double const trend = mean_of(stands.x, middle, run.last + 1) - mean_of(stands.x, run.first, middle);
      if (std::abs(trend) > 8.0 * noise / std::sqrt(static_cast<double>(run.size()))) continue;
      double const jump = std::abs(stands.x[run.last + 1] - level) / stands.half_range;
      double const next = std::abs(stands.x[run.last + 2] - stands.x[run.last + 1]) / stands.half_range;
      if (!(jump > std::max(least_part, 12.0 * noise / stands.half_range) && jump > 3.0 * next)) continue;
      double const other_jump = std::abs(other.x[run.last + 1] - other.x[run.last]) / other.half_range;
      if (other_jump > 0.3 * jump) continue;
      double const way = other.x[run.last] - other.x[run.last - lag],
                   after = other.x[run.last + lag] - other.x[run.last];
      double const clear = std::max(0.005 * other.half_range, 6.0 * other.noise);
      bool const went = std::abs(other.x[run.last] - other.x[run.first]) > least_part * other.half_range;
      if (went && way * after > 0.0 && std::min(std::abs(way), std::abs(after)) > clear) found.push_back(run);
    }
    return found;
  }

  // Whether the force in this stretch differs clearly from the force at other times when the motion passes the same
  // displacement in the same direction. In a device with play, or one that yields and stiffens again, the force repeats
  // in every cycle and is not stuck.
  bool is_elsewhere(SampleRange const& run) const {
    auto const lag = std::max<std::size_t>(2, pair_.half_cycle / 48);
    double const at = pair_.disp.x[run.last - lag], way = pair_.disp.x[run.last] - at;
    double const level = mean_of(pair_.force.x, run.first, run.last + 1), next = pair_.force.x[run.last + 1];
    std::vector<double> there;
    for (std::size_t i = lag; i + lag < pair_.size(); ++i) {
      if (i + lag >= run.first && i <= run.last + lag) continue;
      if ((pair_.disp.x[i] - at) * (pair_.disp.x[i + 1] - at) <= 0.0 &&
          (pair_.disp.x[i + lag] - pair_.disp.x[i - lag]) * way > 0.0)
        there.push_back((pair_.force.x[i] - level) / (next - level));
    }
    return !there.empty() && num::median(std::move(there)) > 0.5;
  }

  void stuck_displacement() {
    std::size_t covered = 0;
    std::vector<std::size_t> first;
    std::size_t longest = 0;
    auto const keep = [&](SampleRange const& run) {
      // A channel with a slow sampling rate repeats its values, which makes many stretches shorter than half a cycle.
      // `covered` counts the samples in such stretches. If they are too many, the channel is slow and not stuck.
      if (run.size() < pair_.half_cycle) covered += run.size();
      first.push_back(run.first);
      longest = std::max(longest, run.size());
    };
    for (auto const& run : stretches(pair_.disp))
      if (is_stuck(run)) keep(run);
    if (first.empty()) std::ranges::for_each(stuck_in_noise(pair_.disp, pair_.force, 0.1), keep);
    if (first.empty() || static_cast<double>(covered) > most_stretches * static_cast<double>(pair_.size())) return;
    add("displacement", "mm", first, pair_.disp.x[first.front()], longest);
  }

  // Whether the stretch is play (backlash) of the device. During play the force is zero, and play begins near a
  // reversal or without a jump of force.
  bool is_backlash(SampleRange const& run, std::size_t lag) const {
    double const noise = 5.0 * pair_.force.noise + pair_.force.quantum;
    if (std::abs(mean_of(pair_.force.x, run.first, run.last + 1)) > noise) return false;
    if (run.first < 2) return true;
    auto const turn = std::ranges::upper_bound(pair_.turns, run.first + 1);
    if (turn != pair_.turns.begin()) {
      if (run.first <= *(turn - 1) + lag) return true;
      if (std::abs(pair_.disp.x[run.first] - pair_.disp.x[*(turn - 1)]) < force_stands * pair_.disp.half_range)
        return true;
    }
    double const jump = std::abs(pair_.force.x[run.first] - pair_.force.x[run.first - 1]);
    return jump <= least_jump * std::abs(pair_.force.x[run.first - 1] - pair_.force.x[run.first - 2]) + 3.0 * noise;
  }

  void stuck_force() {
    std::vector<std::size_t> first;
    std::size_t longest = 0, covered = 0;
    auto const keep = [&](SampleRange const& run) {
      if (run.size() < pair_.half_cycle) covered += run.size();
      first.push_back(run.first);
      longest = std::max(longest, run.size());
    };
    double const least = std::max(
        {force_stands * pair_.disp.half_range, 10.0 * pair_.force.quantum / pair_.stiffness(), 8.0 * pair_.disp.noise});
    bool const noisy = pair_.has_noise(pair_.force);
    for (auto const& run : stretches(pair_.force)) {
      auto const begin = pair_.disp.x.begin() + static_cast<std::ptrdiff_t>(run.first);
      auto const end = begin + static_cast<std::ptrdiff_t>(run.size());
      auto const [low, high] = std::minmax_element(begin, end);
      if (!(*high - *low > least)) continue;
      // How far the motion goes out and comes back within the stretch. In a yielding device, the force would change
      // where the motion turns, and the stretch would end there.
      double const there_and_back =
          std::max(std::min(*high - *begin, *high - *(end - 1)), std::min(*begin - *low, *(end - 1) - *low));
      auto const lag = std::max<std::size_t>(2, pair_.half_cycle / 48);
      if (is_backlash(run, lag)) continue;
      bool stuck = there_and_back > least || (noisy && run.size() >= 2 * least_stretch);
      if (!stuck && run.last + 1 + lag < pair_.size() && run.size() > lag && !pair_.gap_after(run.last)) {
        auto const [before, after] = speeds(pair_.force, run);
        double const jump = std::abs(pair_.force.x[run.last + 1] - pair_.force.x[run.last]);
        double const way = pair_.disp.x[run.last] - pair_.disp.x[run.last - lag];
        double const next = pair_.disp.x[run.last + 1 + lag] - pair_.disp.x[run.last + 1];
        double const clear = std::max(0.005 * pair_.disp.half_range, 6.0 * pair_.disp.noise);
        bool const same_way = way * next > 0.0 && std::min(std::abs(way), std::abs(next)) > clear;
        stuck = same_way && jump > std::max({0.03 * pair_.force.half_range, 6.0 * pair_.force.noise,
                                             missed_quanta * pair_.force.quantum,
                                             least_jump * std::max(std::abs(before), std::abs(after))});
      }
      // When the device rests at an end of the record, one channel may stand still a little longer than the other. So a
      // stretch there is kept only if displacement moves by its half range or more.
      bool const at_an_end = run.first == 0 || run.last + 1 == pair_.size();
      if (stuck && !(at_an_end && *high - *low < pair_.disp.half_range)) keep(run);
    }
    if (first.empty())
      for (auto const& run : stuck_in_noise(pair_.force, pair_.disp, 0.15))
        if (is_elsewhere(run) && !is_backlash(run, std::max<std::size_t>(2, pair_.half_cycle / 48))) keep(run);
    if (first.empty() || static_cast<double>(covered) > most_stretches * static_cast<double>(pair_.size())) return;
    add("force", "kN", first, pair_.force.x[first.front()], longest);
  }

  SignalPair const& pair_;
  std::vector<SignalFault> found_;
};

}  // namespace

std::vector<SignalFault> stuck_channels(SignalPair const& pair, bool clipped_disp, bool clipped_force) {
  return Sticking(pair).find(clipped_disp, clipped_force);
}

}  // namespace isolaw::data
