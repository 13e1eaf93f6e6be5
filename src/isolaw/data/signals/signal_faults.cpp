#include "isolaw/data/signals/signal_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "isolaw/data/cycles/cycles.hpp"
#include "isolaw/data/signals/clipping.hpp"
#include "isolaw/data/signals/signal_pair.hpp"
#include "isolaw/data/signals/spikes.hpp"
#include "isolaw/data/signals/sticking.hpp"

namespace isolaw::data {
namespace {

// A channel that lost its sign crosses zero by at most this fraction of its range (largest minus smallest value).
constexpr double one_signed = 0.02;
// At a peak of displacement, the sign of a force counts only if the force exceeds this fraction of the largest force.
constexpr double clear_force = 0.3;
// A stage (a part of the test with one amplitude) is also searched for faults by itself if the half range of its
// displacement is below this fraction of the whole record's half range.
constexpr double small_stage = 0.5;

SignalFault without_sign(std::string channel, std::string_view unit, std::vector<std::size_t> samples,
                         SignalPair const& pair) {
  auto finding = finding_at(FindingKind::signal_without_sign, channel, unit, samples, pair.time);
  return {.kind = FaultKind::rectified,
          .channel = std::move(channel),
          .samples = std::move(samples),
          .finding = std::move(finding)};
}

// Finds a channel that lost its sign. A displacement lost it if all peaks are on one side of zero while the force at
// these peaks has both signs. A force lost it if it has one sign at the peaks of displacement on both sides of zero.
std::vector<SignalFault> rectified_channels(SignalPair const& pair) {
  auto const& turns = pair.turns;
  if (turns.size() < 4) return {};
  auto const [least, largest] = std::ranges::minmax(pair.disp.x);
  auto const [least_F, largest_F] = std::ranges::minmax(pair.force.x);
  double const size_F = std::max(std::abs(least_F), std::abs(largest_F));
  double const margin = one_signed * (largest - least);
  bool const positive = least >= -margin, negative = largest <= margin;
  std::vector<std::size_t> const inner(turns.begin() + 1, turns.end() - 1);
  std::vector<std::size_t> peaks;
  std::size_t pushed = 0, pulled = 0, alike = 0;
  for (std::size_t k = 1; k + 1 < turns.size(); ++k) {
    auto const i = turns[k];
    bool const is_high = pair.disp.x[i] > pair.disp.x[turns[k - 1]];
    // The force is read a little before the turn, at which it may jump.
    auto const before = std::min(i, std::max<std::size_t>(2, pair.half_cycle / 12));
    double const F = pair.force.x[i - before];
    if (std::abs(F) > clear_force * size_F && F * (largest_F + least_F) > 0.0) ++alike;
    if (is_high == negative) continue;
    peaks.push_back(i);
    if (F > clear_force * size_F) ++pushed;
    if (F < -clear_force * size_F) ++pulled;
  }
  if ((positive || negative) && std::min(pushed, pulled) * 4 >= peaks.size() && std::min(pushed, pulled) > 0)
    return {without_sign("displacement", "mm", peaks, pair)};
  bool const one_sign_F = std::min(std::abs(least_F), std::abs(largest_F)) <= one_signed * (largest_F - least_F);
  if (one_sign_F && !positive && !negative && alike == inner.size() && largest * -least > 0.0 &&
      std::min(largest, -least) > 0.5 * pair.disp.half_range)
    return {without_sign("force", "kN", inner, pair)};
  return {};
}

// Finds a force that leaves its range at one end and comes in at the other. While the motion goes on, it jumps by most
// of its range, at least twice and both ways. A friction force jumps only where the motion turns or starts.
std::vector<SignalFault> wrapped_force(SignalPair const& pair) {
  // A force that wraps jumps by more than least_jump times its range (largest minus smallest force). Its steps just
  // before and after the jump are below most_step times its range.
  constexpr double least_jump = 0.8, most_step = 0.1;
  // The motion goes on: within `lag` samples before the jump, and after it, displacement moves by more than this
  // fraction of its range.
  constexpr double least_way = 0.005;
  // The force has a trend, and jumps against it. The trend is the change of force over `lag` samples before the jump
  // and `lag` samples after it; it exceeds this fraction of the force's range.
  constexpr double least_trend = 0.005;
  constexpr std::size_t lag = 3;
  auto const &x = pair.disp.x, &F = pair.force.x;
  double const range = 2.0 * pair.force.half_range, way = 2.0 * least_way * pair.disp.half_range;
  std::vector<std::size_t> samples;
  std::size_t up = 0, down = 0;
  double largest = 0.0;
  for (std::size_t i = lag; i + lag + 1 < pair.size(); ++i) {
    double const jump = F[i + 1] - F[i], before = x[i] - x[i - lag], after = x[i + 1 + lag] - x[i + 1];
    if (!(std::abs(jump) > least_jump * range)) continue;
    ++(jump > 0.0 ? up : down);
    // A force that wraps jumps against its own trend. The force of friction, recorded a little late, jumps along it.
    double const trend = (F[i] - F[i - lag]) + (F[i + 1 + lag] - F[i + 1]);
    bool const against = jump * trend < 0.0 && std::abs(trend) > least_trend * range + 4.0 * pair.force.noise;
    if (against && before * after > 0.0 && std::min(std::abs(before), std::abs(after)) > way &&
        std::max(std::abs(F[i] - F[i - 1]), std::abs(F[i + 2] - F[i + 1])) < most_step * range) {
      samples.push_back(i + 1);
      largest = std::max(largest, std::abs(jump));
    }
  }
  if (samples.size() < 2 || std::min(up, down) == 0) return {};
  auto finding = finding_at(FindingKind::signal_wraps, "force", "kN", samples, pair.time);
  finding.numbers.push_back({"jump_kN", largest});
  return {
      {.kind = FaultKind::wrapped, .channel = "force", .samples = std::move(samples), .finding = std::move(finding)}};
}

// Converts the sample numbers of a fault that was found in a stage: afterwards they count from the start of the record.
void shift(SignalFault& fault, std::size_t by) {
  for (auto& sample : fault.samples) sample += by;
  for (auto& number : fault.finding.numbers)
    if (number.name.starts_with("sample")) number.value += static_cast<double>(by);
}

bool is_known(SignalFault const& fault, std::vector<SignalFault> const& known, TestRange const& stage) {
  return std::ranges::any_of(known, [&](SignalFault const& other) {
    return other.kind == fault.kind && other.channel == fault.channel &&
           std::ranges::any_of(other.samples, [&](auto i) { return i >= stage.first && i < stage.end; });
  });
}

}  // namespace

std::string_view said_of(FaultKind kind) {
  constexpr std::string_view names[]{"clipped",          "stuck",       "disturbed by spikes",
                                     "without its sign", "interrupted", "wrapped around"};
  return names[static_cast<std::size_t>(kind)];
}

std::optional<FaultKind> fault_kind(FindingKind kind) {
  switch (kind) {
    case FindingKind::signal_clipped:
      return FaultKind::clipped;
    case FindingKind::signal_stuck:
      return FaultKind::stuck;
    case FindingKind::signal_spike:
      return FaultKind::spike;
    case FindingKind::signal_without_sign:
      return FaultKind::rectified;
    case FindingKind::signal_interrupted:
      return FaultKind::dropout;
    case FindingKind::signal_wraps:
      return FaultKind::wrapped;
    default:
      return std::nullopt;
  }
}

Finding finding_at(FindingKind kind, std::string const& channel, std::string_view unit,
                   std::span<std::size_t const> samples, std::span<double const> time_s) {
  constexpr std::size_t most = 5;
  Finding finding{.kind = kind,
                  .numbers = {{"count", static_cast<double>(samples.size())}},
                  .words = {{"channel", channel}, {"unit", std::string(unit)}}};
  for (std::size_t k = 0; k < std::min(most, samples.size()); ++k) {
    auto const which = k == 0 ? std::string() : fmt::format("_{}", k + 1);
    finding.numbers.push_back({"sample" + which, static_cast<double>(samples[k] + 1)});
    if (!time_s.empty()) finding.numbers.push_back({"time_s" + which, time_s[samples[k]]});
  }
  return finding;
}

std::string sample_text(std::span<std::size_t const> samples, std::span<double const> time_s) {
  constexpr std::size_t most = 5;
  auto const one = [&](std::size_t i) {
    return time_s.empty() ? fmt::format("{}", i + 1) : fmt::format("{} ({:.6g} s)", i + 1, time_s[i]);
  };
  std::string text = samples.size() == 1 ? "sample " : "samples ";
  auto const shown = std::min(most, samples.size());
  for (std::size_t k = 0; k < shown; ++k)
    text += (k == 0 ? "" : k + 1 == samples.size() ? " and " : ", ") + one(samples[k]);
  if (samples.size() > shown) text += fmt::format(" and {} more", samples.size() - shown);
  return text;
}

SignalFault standing_fault(FaultKind kind, std::string const& channel, std::string_view unit,
                           std::vector<std::size_t> samples, std::span<double const> time_s, double level,
                           std::size_t longest) {
  auto finding = finding_at(kind == FaultKind::clipped ? FindingKind::signal_clipped : FindingKind::signal_stuck,
                            channel, unit, samples, time_s);
  finding.numbers.push_back({fmt::format("level_{}", unit), level});
  finding.numbers.push_back({"longest_samples", static_cast<double>(longest)});
  return {.kind = kind, .channel = channel, .samples = std::move(samples), .finding = std::move(finding)};
}

std::vector<SignalFault> spike_faults(std::string const& channel, std::string_view unit, std::vector<Spike> const& off,
                                      std::span<double const> time_s) {
  if (off.empty()) return {};
  std::vector<std::size_t> samples;
  auto const* largest = &off.front();
  for (auto const& spike : off) {
    samples.push_back(spike.at);
    if (std::abs(spike.value - spike.expected) > std::abs(largest->value - largest->expected)) largest = &spike;
  }
  auto finding = finding_at(FindingKind::signal_spike, channel, unit, samples, time_s);
  finding.numbers.push_back({fmt::format("value_{}", unit), largest->value});
  finding.numbers.push_back({fmt::format("expected_{}", unit), largest->expected});
  return {{.kind = FaultKind::spike, .channel = channel, .samples = std::move(samples), .finding = std::move(finding)}};
}

std::vector<SignalFault> dropout_faults(std::string const& channel, std::string_view unit,
                                        std::vector<Dropout> const& gone, std::span<double const> time_s) {
  if (gone.empty()) return {};
  std::vector<std::size_t> samples;
  auto const* longest = &gone.front();
  for (auto const& one : gone) {
    samples.push_back(one.samples.first);
    if (one.samples.size() > longest->samples.size()) longest = &one;
  }
  auto finding = finding_at(FindingKind::signal_interrupted, channel, unit, samples, time_s);
  finding.numbers.push_back({fmt::format("level_{}", unit), longest->level});
  finding.numbers.push_back({"longest_samples", static_cast<double>(longest->samples.size())});
  finding.numbers.push_back({fmt::format("before_{}", unit), longest->before});
  finding.numbers.push_back({fmt::format("after_{}", unit), longest->after});
  return {
      {.kind = FaultKind::dropout, .channel = channel, .samples = std::move(samples), .finding = std::move(finding)}};
}

std::vector<TestRange> small_stages(std::span<double const> disp_mm, std::span<double const> time_s) {
  auto const cut = segment(disp_mm, time_s);
  if (!cut.cyclic) return {};
  std::vector<TestRange> stages;
  for (int block = 0; auto const& cycle : cut.cycles) {
    TestRange const samples{.first = static_cast<std::size_t>(cycle.first),
                            .end = std::min(disp_mm.size(), static_cast<std::size_t>(cycle.last) + 1)};
    if (std::exchange(block, cycle.block) == cycle.block)
      stages.back().end = samples.end;
    else
      stages.push_back(samples);
  }
  double const whole = half_range(disp_mm);
  std::erase_if(stages, [&](TestRange const& stage) { return half_range(stage.slice(disp_mm)) > small_stage * whole; });
  return stages;
}

std::vector<Spike> spikes_in(std::span<double const> values, std::span<TestRange const> stages) {
  auto found = spikes(values);
  auto const known = found.size();
  for (auto const& stage : stages)
    for (auto spike : spikes(stage.slice(values))) {
      spike.at += stage.first;
      auto const end = found.begin() + static_cast<std::ptrdiff_t>(known);
      if (std::find_if(found.begin(), end, [&](Spike const& other) { return other.at == spike.at; }) == end)
        found.push_back(spike);
    }
  std::ranges::sort(found, {}, &Spike::at);
  return found;
}

namespace {

std::vector<SignalFault> faults_within(std::span<double const> disp_mm, std::span<double const> force_kN,
                                       std::span<double const> time_s, std::vector<double>* mended_disp) {
  std::size_t constexpr fewest = 16;
  if (disp_mm.size() < fewest) return {};
  auto const gone_disp = dropouts(disp_mm, force_kN, OtherChannel::may_stand),
             gone_force = dropouts(force_kN, disp_mm, OtherChannel::moves);
  auto const whole_disp = bridged(disp_mm, gone_disp), whole_force = bridged(force_kN, gone_force);
  disp_mm = whole_disp;
  force_kN = whole_force;
  auto const of_disp = spikes(disp_mm);
  auto const of_force = spikes(force_kN);
  SignalPair const pair(disp_mm, force_kN, time_s, of_disp, of_force);
  if (mended_disp != nullptr) *mended_disp = pair.disp.x;
  if (!pair.moves()) return {};
  std::vector<SignalFault> found;
  auto const add = [&](std::vector<SignalFault> more) {
    found.insert(found.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  auto const is_clipped = [&](std::string_view channel) {
    return std::ranges::any_of(
        found, [&](SignalFault const& fault) { return fault.channel == channel && fault.kind == FaultKind::clipped; });
  };
  add(rectified_channels(pair));
  add(wrapped_force(pair));
  add(clipped_channels(pair));
  add(stuck_channels(pair, is_clipped("displacement"), is_clipped("force")));
  add(dropout_faults("displacement", "mm", gone_disp, time_s));
  add(dropout_faults("force", "kN", gone_force, time_s));
  add(spike_faults("displacement", "mm", of_disp, time_s));
  auto single = of_force;
  std::erase_if(single, [&](Spike const& spike) { return is_of_every_turn(spike, of_force, force_kN, pair.turns); });
  add(spike_faults("force", "kN", single, time_s));
  return found;
}

}  // namespace

std::vector<SignalFault> signal_faults(std::span<double const> disp_mm, std::span<double const> force_kN,
                                       std::span<double const> time_s) {
  std::vector<double> mended;
  auto found = faults_within(disp_mm, force_kN, time_s, &mended);
  for (auto const& stage : small_stages(mended, time_s)) {
    std::vector<SignalFault> more;
    for (auto& fault : faults_within(stage.slice(disp_mm), stage.slice(force_kN), stage.slice(time_s), nullptr)) {
      shift(fault, stage.first);
      // Only the whole record shows whether a channel lacks its sign.
      if (fault.kind != FaultKind::rectified && !is_known(fault, found, stage)) more.push_back(std::move(fault));
    }
    found.insert(found.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }
  return found;
}

}  // namespace isolaw::data
