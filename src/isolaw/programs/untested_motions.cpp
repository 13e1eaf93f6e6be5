#include "isolaw/programs/untested_motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "isolaw/base/words.hpp"
#include "isolaw/programs/realise.hpp"

namespace isolaw::programs {
namespace {

constexpr double infinite_difference = std::numeric_limits<double>::infinity();

double work(std::span<double const> x, std::span<double const> f) {
  double sum = 0.0;
  for (std::size_t i = 1; i < x.size(); ++i) sum += 0.5 * (f[i] + f[i - 1]) * (x[i] - x[i - 1]);
  return sum;
}

double peak(std::span<double const> f) {
  double most = 0.0;
  for (double const v : f) most = std::isfinite(v) ? std::max(most, std::abs(v)) : infinite_difference;
  return most;
}

struct Cycle {
  std::vector<double> x, f;
};
Cycle second_of(History const& history, std::vector<double> const& force) {
  auto const from = static_cast<std::ptrdiff_t>((history.disp_mm.size() - 1) / 2);
  return {{history.disp_mm.begin() + from, history.disp_mm.end()}, {force.begin() + from, force.end()}};
}

History cycles_at(Subject const& subject, double amplitude_share, double rate_share,
                  int steps_per_cycle = protocol_steps) {
  double const amplitude = amplitude_share * subject.tested.disp_mm;
  auto history = two_cycles(amplitude, amplitude, rate_share * subject.frequency_Hz, steps_per_cycle);
  history.refinement = subject.refinement;
  history.dead_band_mm = subject.dead_band_mm;
  return history;
}

std::vector<double> own_force(Subject const& subject, History const& history) {
  return law_force(*subject.law, subject.parameters, history);
}

std::optional<double> percent_of(double value, double truth) {
  if (!(truth > 0.0) || !std::isfinite(truth)) return std::nullopt;
  return std::isfinite(value) ? 100.0 * (value - truth) / truth : infinite_difference;
}

// The steepest fall of the force while the motion goes outwards beyond `beyond_mm`. `slope` is negative, or 0 if the
// force falls nowhere there.
struct Fall {
  double slope = 0.0, at_mm = 0.0;
};
Fall steepest_fall(Cycle const& cycle, double beyond_mm) {
  auto const& [x, f] = cycle;
  Fall fall;
  for (std::size_t i = 1; i < x.size(); ++i) {
    bool const outwards = std::abs(x[i]) > std::abs(x[i - 1]);
    if (!outwards || std::abs(x[i]) <= beyond_mm) continue;
    double const slope = (f[i] - f[i - 1]) / (x[i] - x[i - 1]);
    if (slope < fall.slope) fall = {.slope = slope, .at_mm = x[i]};
  }
  return fall;
}

std::string share_text(double share) {
  return share == 0.25   ? "at a quarter of the tested amplitude"
         : share == 0.5  ? "at half of it"
         : share == 0.75 ? "at three quarters of it"
                         : "at the full amplitude";
}

}  // namespace

double OtherCycle::largest() const {
  return std::max(std::abs(energy.value_or(0.0)), std::abs(peak.value_or(0.0)));
}

std::vector<OtherCycle> other_cycles(Subject const& subject, ForceOf const& stand_in) {
  std::vector<OtherCycle> cycles;
  auto const compare = [&](double amplitude_share, double rate_share) {
    auto const history = cycles_at(subject, amplitude_share, rate_share);
    auto const law = second_of(history, own_force(subject, history)), other = second_of(history, stand_in(history));
    cycles.push_back({.amplitude_share = amplitude_share,
                      .rate_share = rate_share,
                      .energy = percent_of(work(other.x, other.f), work(law.x, law.f)),
                      .peak = percent_of(peak(other.f), peak(law.f))});
  };
  for (double const share : {0.25, 0.5, 0.75, 1.0}) compare(share, 1.0);
  if (!subject.law->info.traits.rate_independent) compare(1.0, 0.5);
  return cycles;
}

std::string text(std::vector<OtherCycle> const& cycles) {
  std::vector<std::string> parts;
  auto const number = [](std::optional<double> const& value) {
    return !value ? std::string("-") : std::isfinite(*value) ? fmt::format("{:+.0f} %", *value) : "no number";
  };
  for (auto const& c : cycles)
    parts.push_back(fmt::format("{}{}: energy {}, peak {}", share_text(c.amplitude_share),
                                c.rate_share == 1.0 ? "" : " and half the rate", number(c.energy), number(c.peak)));
  return joined(parts, "; ");
}

bool needs_warning(std::vector<OtherCycle> const& cycles) {
  return std::ranges::any_of(cycles, [](auto const& c) { return !(c.largest() <= warning_percent); });
}

std::vector<std::string> beyond_the_tests(Subject const& subject, UnitSystem const& units) {
  auto const tested = cycles_at(subject, 1.0, 1.0);
  auto const tested_cycle = second_of(tested, own_force(subject, tested));
  double const tested_peak = peak(tested_cycle.f);
  auto const kN = [&](double force) { return fmt::format("{:.4g} {}", units.from_kN(force), units.force.symbol); };
  std::vector<std::string> sentences;
  for (double const times : beyond_times) {
    auto const history = cycles_at(subject, times, 1.0);
    auto const [x, f] = second_of(history, own_force(subject, history));
    double const most = peak(f);
    auto const at = fmt::format("at {:.4g} times the tested displacement ", times);
    if (!std::isfinite(most)) {
      sentences.push_back(at + "there is no finite force");
      continue;
    }
    auto const fall = steepest_fall({x, f}, subject.tested.disp_mm);
    // A force that depends on the velocity falls before every reversal, also in the tests. Only a fall that is steeper
    // than in the tests is reported.
    auto const in_tests = steepest_fall(tested_cycle, subject.tested.disp_mm / times);
    if (most < 0.999 * tested_peak)
      sentences.push_back(
          fmt::format("{}the peak force is {}, less than the {} at the tested one", at, kN(most), kN(tested_peak)));
    else if (most > times * times * tested_peak)
      sentences.push_back(fmt::format("{}the peak force is {}, {:.3g} times the {} at the tested one", at, kN(most),
                                      most / tested_peak, kN(tested_peak)));
    constexpr double worse = 1.1;
    if (fall.slope < -1e-3 * tested_peak / subject.tested.disp_mm && fall.slope < worse * in_tests.slope)
      sentences.push_back(fmt::format("{}the stiffness is below zero, {:.3g} {}/{} at {:.4g} {}", at,
                                      units.convert(fall.slope, 1, -1), units.force.symbol, units.length.symbol,
                                      units.from_mm(fall.at_mm), units.length.symbol));
    if (work(x, f) < 0.0) sentences.push_back(at + "a cycle gives energy back");
  }
  return sentences;
}

std::optional<StepsNeeded> steps_needed(Subject const& subject, Form const& form) {
  constexpr int finest = 2560;
  auto const replayed = [&](int steps) {
    auto const history = cycles_at(subject, 1.0, 1.0, steps);
    return second_of(history, replay_kN(form, unit_systems[0], history.disp_mm));
  };
  auto const fine = replayed(finest);
  double const energy = work(fine.x, fine.f);
  if (!(energy > 0.0)) return std::nullopt;
  for (int steps = 20; 2 * steps <= finest; steps *= 2) {
    auto const [x, f] = replayed(steps);
    // Both energies are summed at the points of the coarse replay. The error of the summation is then the same in both
    // and does not count as an error of the coarse steps.
    std::vector<double> there;
    for (std::size_t i = 0; i < fine.f.size(); i += static_cast<std::size_t>(finest / steps))
      there.push_back(fine.f[i]);
    double const error = 100.0 * (work(x, f) - work(x, there)) / energy;
    if (std::abs(error) <= step_energy_percent) return StepsNeeded{.per_cycle = steps, .energy = error};
  }
  return std::nullopt;
}

std::optional<TwoSprings> two_springs(Subject const& subject) {
  // Moves two springs at right angles twice around the circle, from rest. Only the second turn is compared.
  double const amplitude = subject.tested.disp_mm;
  constexpr int steps = protocol_steps, quarter = steps / 4;
  auto const along_x = cycles_at(subject, 1.0, 1.0);
  History x, y;
  for (int i = 0; i <= quarter + 2 * steps; ++i) {
    double const phase = 2.0 * std::numbers::pi * (i - quarter) / steps;
    double const omega = 2.0 * std::numbers::pi * subject.frequency_Hz;
    auto const add = [&](History& to, double disp, double vel) {
      to.time_s.push_back(i / (steps * subject.frequency_Hz));
      to.disp_mm.push_back(disp);
      to.vel_mm_s.push_back(vel);
    };
    bool const coming = i <= quarter;
    add(x, i == 0 ? 0.0 : amplitude * std::cos(phase), -amplitude * omega * std::sin(phase));
    add(y, coming ? 0.0 : amplitude * std::sin(phase), coming ? 0.0 : amplitude * omega * std::cos(phase));
  }
  for (auto* history : {&x, &y}) {
    history->refinement = subject.refinement;
    history->dead_band_mm = subject.dead_band_mm;
  }
  auto const fx = own_force(subject, x), fy = own_force(subject, y);
  auto const one = second_of(along_x, own_force(subject, along_x));
  TwoSprings springs;
  std::size_t const from = quarter + steps;
  for (std::size_t i = from; i < fx.size(); ++i) springs.force = std::max(springs.force, std::hypot(fx[i], fy[i]));
  auto const turn = [&](std::vector<double> const& v) { return std::span(v).subspan(from); };
  springs.energy = work(turn(x.disp_mm), turn(fx)) + work(turn(y.disp_mm), turn(fy));
  double const force = peak(one.f), energy = 0.5 * std::numbers::pi * work(one.x, one.f);
  if (!(force > 0.0) || !(energy > 0.0) || !std::isfinite(springs.force)) return std::nullopt;
  springs.force /= force;
  springs.energy /= energy;
  return springs;
}

}  // namespace isolaw::programs
