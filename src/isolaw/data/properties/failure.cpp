#include "isolaw/data/properties/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "isolaw/data/cycles/cycle_blocks.hpp"

namespace isolaw::data {
namespace {

constexpr double nearly_gone = 0.1;  // a cycle is dead if its force is below this fraction of an earlier cycle's
constexpr double most_lost = 0.35;   // fraction of a peak force that no sound device loses from one cycle to the next
constexpr double most_lost_first = 0.5;  // as most_lost, from the first cycle to the second: virgin rubber softens more
constexpr double clear_force = 0.3;      // a peak force below this fraction of size_of() may change by any amount
constexpr double same_amplitude = 1.05;  // a comparable earlier cycle has at most this many times the cycle's amplitude
constexpr double same_pace = 2.0;        // cycles with periods that differ by more than this factor are not compared

// The size of a cycle's force: half the difference of its peak forces or, if that is larger, half the mean height of
// its loop. Without stiffness, a device's peak forces do not differ.
double size_of(Cycle const& cycle) {
  return std::max(std::abs(cycle.F_plus_kN - cycle.F_minus_kN) / 2.0,
                  std::abs(cycle.energy_kN_mm) / (4.0 * cycle.amplitude_mm));
}

// Whether two cycles have the same vertical load. A difference of up to half the load's range within a cycle may be
// noise.
bool alike_loaded(Cycle const& one, Cycle const& other) {
  if (!one.N_mean_kN) return true;
  double const a = *one.N_mean_kN, b = *other.N_mean_kN;
  double const range = std::max(*one.N_max_kN - *one.N_min_kN, *other.N_max_kN - *other.N_min_kN);
  return same_load(a, b, std::max(std::abs(a), std::abs(b))) || std::abs(a - b) <= range / 2.0;
}

bool comparable(Cycle const& earlier, Cycle const& cycle) {
  bool const paced = !earlier.period_s || (*earlier.period_s <= same_pace * *cycle.period_s &&
                                           *cycle.period_s <= same_pace * *earlier.period_s);
  return earlier.amplitude_mm <= same_amplitude * cycle.amplitude_mm && paced && alike_loaded(earlier, cycle);
}

std::string name_of(Cycle const& cycle, std::span<double const> time_s) {
  if (cycle.counts()) return fmt::format("cycle {} of block {}", cycle.number, cycle.block);
  auto const from = time_s.empty() ? fmt::format("sample {:.0f}", std::floor(cycle.first) + 1.0)
                                   : fmt::format("{:.4g} s", value_at(time_s, cycle.first));
  return fmt::format("the uncounted cycle from {} on in block {}", from, cycle.block);
}

// Divides each of a cycle's two peak forces by the same peak in the cycle before and returns the smaller ratio, at most
// 1. Ignores peaks that were small in the cycle before.
double share_kept(Cycle const& before, Cycle const& cycle) {
  double least = 1.0;
  for (auto const peak : {&Cycle::F_plus_kN, &Cycle::F_minus_kN})
    if (std::abs(before.*peak) > clear_force * size_of(before)) least = std::min(least, cycle.*peak / (before.*peak));
  return least;
}

// Whether the loop keeps its energy, so that only samples at a peak have dropped out. False for a nearly elastic
// device, whose energy is too small to show this.
bool keeps_energy(Cycle const& before, Cycle const& cycle, double share) {
  constexpr double elastic = 0.05;  // half the loop's mean height / size_of(); it is smaller for nearly elastic devices
  bool const dissipates = std::abs(before.energy_kN_mm) > elastic * 4.0 * before.amplitude_mm * size_of(before);
  return dissipates && cycle.energy_kN_mm >= share * before.energy_kN_mm;
}

}  // namespace

void find_failure(Properties& properties, std::span<double const> time_s) {
  std::vector<Cycle*> cycles;  // the complete cycles in order
  for (auto& block : properties.blocks)
    for (auto& cycle : block.cycles)
      if (!cycle.partial && !cycle.half && cycle.amplitude_mm > 0.0) cycles.push_back(&cycle);
  Cycle const* fails = nullptr;
  Cycle const* before = nullptr;
  double kept = 1.0;
  std::string kept_of;
  std::vector<Cycle*> dead;
  Cycle* dying = nullptr;  // the last counted cycle, if it lost a peak force but kept its energy
  double kept_of_dying = 1.0;
  constexpr std::size_t most_blocks = 100;  // a cycle is compared with at most this many earlier blocks
  std::vector<Cycle const*> strongest;      // for each block so far, the cycle with the largest force
  for (auto* each : cycles) {
    auto& cycle = *each;
    auto const earlier = std::span(strongest).last(std::min(most_blocks, strongest.size()));
    double left = 1.0;  // smallest ratio of the cycle's force to the force of an earlier cycle
    Cycle const* stronger = nullptr;
    for (auto const* other : earlier)
      if (double const share = size_of(cycle) / size_of(*other); share < left && comparable(*other, cycle))
        left = share, stronger = other;
    bool const is_dead = left < nearly_gone;
    if (strongest.empty() || strongest.back()->block != cycle.block)
      strongest.push_back(&cycle);
    else if (size_of(cycle) > size_of(*strongest.back()))
      strongest.back() = &cycle;
    bool const follows = before != nullptr && before->block == cycle.block && cycle.counts();
    double const share = follows ? share_kept(*before, cycle) : 1.0;
    double const least = 1.0 - (follows && before->number == 1 ? most_lost_first : most_lost);
    bool const drops = share < least, loses = drops && !keeps_energy(*before, cycle, least);
    // The force may be lost just after a peak. The cycle of this peak then keeps most of its energy, and only the next
    // cycle, which is dead, shows the loss.
    if (fails == nullptr && is_dead && dying != nullptr && dying->block == cycle.block) {
      fails = dying;
      kept = kept_of_dying;
      kept_of = "the peak force in the cycle before it";
      dead.push_back(dying);
    }
    if (is_dead || (loses && share < nearly_gone)) dead.push_back(&cycle);
    if (fails == nullptr && (is_dead || loses)) {
      fails = &cycle;
      kept = loses ? share : left;
      kept_of =
          loses ? "the peak force in the cycle before it" : fmt::format("the force in {}", name_of(*stronger, time_s));
    }
    if (cycle.counts()) {
      before = &cycle;
      dying = drops && !loses ? &cycle : nullptr;
      kept_of_dying = share;
    }
  }
  if (fails == nullptr) return;
  // If the last cycle is dead, or if no cycle is dead, the force is lost from the failing cycle to the end of the
  // record. Otherwise the force came back, and it is lost only in the dead cycles.
  bool const for_good = dead.empty() || dead.back() == cycles.back();
  auto const where = name_of(*fails, time_s);
  auto& failure = properties.failure.emplace(
      Finding{.kind = FindingKind::force_lost,
              .blocks = {fails->block},
              .words = {{"gone", dead.empty() ? "no" : "yes"}, {"where", where}, {"of", kept_of}}});
  if (fails->counts()) failure.numbers.push_back({"cycle", static_cast<double>(fails->number)});
  failure.numbers.push_back({"percent", 100.0 * std::max(0.0, kept)});
  if (for_good)
    properties.samples_without_force = {{fails->first, std::numeric_limits<double>::infinity()}};
  else
    for (auto const* cycle : dead) properties.samples_without_force.emplace_back(cycle->first, cycle->last);
  if (dead.empty()) return;
  auto const why = "the force is lost in " + where;
  auto const end = [&](std::vector<Cycle*> const& lost, auto first) {
    for (; first != lost.end(); ++first) {
      if ((*first)->counts()) (*first)->not_counted = why;
      (*first)->number = 0;
    }
  };
  for_good ? end(cycles, std::ranges::find(cycles, fails)) : end(dead, dead.begin());
}

}  // namespace isolaw::data
