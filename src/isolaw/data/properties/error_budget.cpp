#include "isolaw/data/properties/error_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <ranges>
#include <utility>

#include "isolaw/data/properties/channel_changes.hpp"
#include "isolaw/data/properties/skew.hpp"

namespace isolaw::data {
namespace {

constexpr double wanted_samples = 100.0;
constexpr double most_jitter = 1.0;         // percent of the mean interval
constexpr double most_disp_offset = 5.0;    // percent of the amplitude
constexpr double most_force_offset = 10.0;  // percent of the amplitude; sound elastomers have slightly asymmetric loops
constexpr double most_closure = 1.0;        // percent of twice the amplitude
constexpr double most_drift = 1.0;          // percent of twice the amplitude
constexpr double most_v_max_error = 5.0;    // percent
constexpr double assumed_friction = 0.005;  // times the vertical load; typical of well kept sliding or rolling guides
constexpr double least_jump = 0.04;         // times the force's amplitude; a smaller jump may be part of a loop's shape
constexpr double most_friction_points = 1.0;
constexpr double most_average_loss = 1.0;  // percent of the amplitude, at the test's frequency

constexpr double most_hum = 1.0;         // percent of the amplitude
constexpr double most_noise_bias = 1.0;  // percent of the amplitude
// Limit for the difference between a peak force and the mean of the peaks in the two neighbouring cycles (a fraction).
constexpr double unlike_between = 0.15;
// As unlike_between, for the first and the last cycle, which have only one neighbour.
constexpr double unlike_beside = 0.2;
constexpr double most_noise_scatter = 2.0;  // percent of the effective stiffness

struct Jump {
  double force_kN = 0.0;
  bool said = false;  // large enough to be reported
};

double percent(double part, double whole) {
  return 100.0 * part / whole;
}
class Assessment {
 public:
  Assessment(CycleView const& view, Properties const& properties) : view_(view), properties_(properties) {
    if (properties.reported)
      for (auto const& block : properties.blocks)
        if (block.number == properties.reported->block) block_ = &block;
  }

  Budget of_all(int smooth) {
    uneven_time();
    if (block_ != nullptr) {
      stages();
      sweep();
      sampling();
      rests();
      kind_of_device();
      // The following checks use the force at the peaks, where a viscous device has none.
      if (!properties_.viscous) {
        unlike_their_neighbours();
        stiffness_rises();
        noise();
        hum_of(view_.disp_mm, "displacement", "mm");
        hum_of(view_.force_kN, "force", "kN");
        auto const jump = jump_at_reversals();
        skew(jump);
        rig_friction();
        moving_mass();
      }
      drift();
      closure();
      offsets();
      halves();
      velocity();
      smoothing(smooth);
    }
    return std::move(budget_);
  }

 private:
  Cycle const& cycle() const { return *properties_.reported; }

  bool add(std::string effect, double value, std::string unit, std::optional<double> limit = {}) {
    bool const exceeds = limit && std::abs(value) > *limit;
    budget_.effects.push_back({std::move(effect), value, std::move(unit), limit, exceeds});
    return exceeds;
  }
  void warn(FindingKind kind, std::vector<FindingNumber> numbers, std::vector<FindingWord> words = {}) {
    budget_.warnings.push_back({.kind = kind, .numbers = std::move(numbers), .words = std::move(words)});
  }
  void note(FindingKind kind, std::vector<FindingNumber> numbers, std::vector<FindingWord> words = {}) {
    budget_.notes.push_back({.kind = kind, .numbers = std::move(numbers), .words = std::move(words)});
  }
  static void locate(std::vector<Finding>& findings, Cycle const& at) {
    findings.back().blocks = {at.block};
    findings.back().numbers.push_back({"cycle", static_cast<double>(at.number)});
  }

  void uneven_time() {
    auto const& time = view_.time_s;
    if (time.size() < 3) return;
    double const mean = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    double least = mean;
    double largest = mean;
    for (std::size_t i = 1; i < time.size(); ++i) {
      least = std::min(least, time[i] - time[i - 1]);
      largest = std::max(largest, time[i] - time[i - 1]);
    }
    if (add("uneven time", percent(std::max(largest - mean, mean - least), mean), "%", most_jitter))
      warn(FindingKind::time_uneven, {{"least_s", least}, {"largest_s", largest}, {"mean_s", mean}});
  }

  void kind_of_device() {
    if (auto const& viscous = properties_.viscous) {
      auto const at_v_max = [&](ViscousSide const& side, double sign) {
        return viscous->F_0_kN + sign * side.C * std::pow(viscous->v_max_mm_s, side.alpha);
      };
      note(FindingKind::viscous_device, {{"v_max_mm_s", viscous->v_max_mm_s},
                                         {"C_out", viscous->rising.C},
                                         {"alpha_out", viscous->rising.alpha},
                                         {"out_kN", at_v_max(viscous->rising, 1.0)},
                                         {"C_back", viscous->falling.C},
                                         {"alpha_back", viscous->falling.alpha},
                                         {"back_kN", at_v_max(viscous->falling, -1.0)},
                                         {"F_0_kN", viscous->F_0_kN}});
    }
    if (auto const& slider = properties_.slider) {
      note(FindingKind::sliding_device, {{"mu_percent", 100.0 * slider->mu}, {"load_kN", slider->N_kN}});
      if (slider->R_mm) budget_.notes.back().numbers.push_back({"R_mm", *slider->R_mm});
    }
  }

  // Warns if a test has several amplitudes, because the reported cycle describes only one of them.
  void stages() {
    auto const counted = properties_.counted();
    auto const by_amplitude = [](Cycle const* c) { return c->amplitude_mm; };
    auto const [least, largest] = std::ranges::minmax(counted, {}, by_amplitude);
    if (largest->amplitude_mm < 1.1 * least->amplitude_mm) return;
    warn(FindingKind::several_amplitudes, {{"least_mm", least->amplitude_mm},
                                           {"largest_mm", largest->amplitude_mm},
                                           {"amplitude_mm", cycle().amplitude_mm}});
    locate(budget_.warnings, cycle());
  }

  // Warns if the force of one cycle differs from the force of its neighbours with the same amplitude: the force channel
  // may have dropped out, or the device may have slipped.
  void unlike_their_neighbours() {
    for (auto const& block : properties_.blocks) {
      auto cycles = block.counted();
      bool const fails = properties_.failure && properties_.failure->blocks.front() == block.number;
      // A loss of force has a warning of its own. In a one-sided loop, one of the two peak forces is near zero, so the
      // ratio of two such forces means nothing.
      if (cycles.size() < 3 || fails || cycles.front()->one_sided) continue;
      cycles.erase(cycles.begin());  // leaves out the first cycle, in which rubber softens (scragging)
      Cycle const* oddest = nullptr;
      double share = 1.0;  // peak force over the mean of the peaks in the neighbouring cycles
      auto const distance = [](double of) {
        return of > 0.0 ? std::abs(std::log(of)) : std::numeric_limits<double>::infinity();
      };
      for (std::size_t k = 0; k < cycles.size(); ++k)
        for (auto const of : {&Cycle::F_plus_kN, &Cycle::F_minus_kN}) {
          double neighbours = 0.0, count = 0.0;
          for (auto const i : {k - 1, k + 1})
            if (i < cycles.size()) neighbours += cycles[i]->*of, count += 1.0;
          if (neighbours == 0.0) continue;
          double const found = cycles[k]->*of / (neighbours / count);
          if (!(std::abs(found - 1.0) > (count > 1.0 ? unlike_between : unlike_beside)) ||
              distance(found) < distance(share))
            continue;
          oddest = cycles[k];
          share = found;
        }
      if (oddest == nullptr) continue;
      warn(FindingKind::cycle_unlike_neighbours, {{"percent", 100.0 * share}});
      locate(budget_.warnings, *oddest);
    }
  }

  void sweep() {
    if (!block_->sweep_Hz) return;
    auto const [first, last] = *block_->sweep_Hz;
    warn(FindingKind::frequency_sweeps, {{"first_Hz", first}, {"last_Hz", last}});
  }

  void stiffness_rises() {
    for (auto const& block : properties_.blocks) {
      auto const found = stiffness_rise(view_, block);
      if (!found) continue;
      if (&block == block_) add("rise of stiffness", 100.0 * found->share, "%");
      warn(FindingKind::stiffness_rises, {{"percent", 100.0 * found->share},
                                          {"from_cycle", static_cast<double>(found->from_cycle)},
                                          {"cycle", static_cast<double>(found->cycle)}});
      if (found->sample) add_time(*found->sample);
      budget_.warnings.back().blocks = {block.number};
    }
  }

  // Adds the time of a sample index to the last warning.
  void add_time(double index) {
    if (!view_.time_s.empty()) budget_.warnings.back().numbers.push_back({"time_s", value_at(view_.time_s, index)});
  }

  // Adds the effects of an oscillation of a channel. The oscillation may move the forces at both peaks, or the peaks of
  // displacement, by its amplitude. Over a cycle it does not change the energy.
  void hum_of(std::span<double const> values, std::string const& what, std::string const& unit) {
    auto const found = hum(values, view_, *block_);
    if (!found) return;
    auto const [least, largest] = range(values, cycle());
    double const share = percent(found->amplitude, (largest - least) / 2.0);
    bool const exceeds = add("oscillation of " + what, share, "%", most_hum);
    add("damping by the oscillation of " + what, cycle().damping_percent * share / 100.0, "points");
    if (!exceeds) return;
    warn(FindingKind::hum,
         {{"amplitude_" + unit, found->amplitude}, {"frequency_Hz", found->frequency_Hz}, {"percent", share}},
         {{"channel", what}, {"unit", unit}});
    if (!found->mains_Hz) return;
    budget_.warnings.back().numbers.push_back({"mains_Hz", *found->mains_Hz});
    if (*found->mains_Hz > found->rate_Hz / 2.0) budget_.warnings.back().numbers.push_back({"rate_Hz", found->rate_Hz});
  }

  void halves() {
    auto const found = asymmetry(view_, *block_);
    if (!found) return;
    add("difference of the forces of the two directions", 100.0 * (found->ratio - 1.0), "%");
    if (!found->is_of_gain) return;
    warn(FindingKind::gain_of_one_side, {{"ratio", found->ratio},
                                         {"K_plus_kN_per_mm", cycle().K_plus_kN_per_mm},
                                         {"K_minus_kN_per_mm", cycle().K_minus_kN_per_mm}});
    locate(budget_.warnings, cycle());
  }

  void sampling() {
    double const samples = *properties_.samples_per_cycle;
    bool const few = std::round(10.0 * samples) / 10.0 < wanted_samples;  // rounded as in the report
    budget_.effects.push_back({"samples per cycle", samples, "", wanted_samples, few});
    bool const corners = block_->waveform == "triangle";
    double const energy = corners ? corner_loss_percent(samples) : energy_loss_percent(samples);
    double const peak = corners ? corner_loss_percent(samples) : peak_loss_percent(samples);
    add("energy lost between samples", energy, "%");
    add("peak missed between samples", peak, "%");
    std::vector<FindingNumber> numbers{
        {"samples", samples}, {"energy_percent", energy}, {"peak_percent", peak}, {"wanted", wanted_samples}};
    std::vector<FindingWord> words;
    if (corners) words.push_back({"up_to", "yes"});
    few ? warn(FindingKind::samples_few, std::move(numbers), std::move(words))
        : note(FindingKind::samples_per_cycle, std::move(numbers), std::move(words));
  }

  // Adds the effects of noise, which moves the extreme samples beyond the true extremes of the motion. The properties
  // are computed from the raw values nevertheless.
  void noise() {
    double const disp = noise_deviation(view_.disp_mm);
    double const force = noise_deviation(view_.force_kN);
    double const amplitude = cycle().amplitude_mm;
    double const force_amplitude = std::abs(cycle().F_plus_kN - cycle().F_minus_kN) / 2.0;
    if (!(amplitude > 0.0 && force_amplitude > 0.0)) return;
    double const beyond = percent(peak_gain_mm(disp, amplitude, *properties_.samples_per_cycle), amplitude);
    // K_eff is a difference of two forces over a difference of two displacements, with four independent errors.
    double const scatter = std::hypot(percent(force, force_amplitude), percent(disp, amplitude)) / std::numbers::sqrt2;
    add("noise of displacement", percent(disp, amplitude), "%");
    add("noise of force", percent(force, force_amplitude), "%");
    bool const biased = add("extremes moved by noise", beyond, "%", most_noise_bias);
    bool const scattered = add("scatter of stiffness by noise", scatter, "%", most_noise_scatter);
    if (biased || scattered)
      warn(FindingKind::noise, {{"disp_mm", disp},
                                {"disp_percent", percent(disp, amplitude)},
                                {"force_kN", force},
                                {"force_percent", percent(force, force_amplitude)},
                                {"beyond_percent", beyond},
                                {"scatter_percent", scatter}});
  }

  // Notes rests and holds that last longer than the period of their cycle, except a rest before a test's first motion.
  void rests() {
    Cycle const* longest = nullptr;
    int count = 0;
    for (auto const* counted : properties_.counted()) {
      bool const starts_test = counted->first == 0.0 || std::ranges::any_of(view_.starts, [&](std::size_t start) {
                                 return static_cast<double>(start) == counted->first;
                               });
      bool const is_long = !starts_test && counted->still_s && *counted->still_s > *counted->period_s;
      if (!is_long) continue;
      ++count;
      if (longest == nullptr || *counted->still_s > *longest->still_s) longest = counted;
    }
    if (longest == nullptr) return;
    add("longest rest or hold", *longest->still_s, "s");
    note(FindingKind::stands_still, {{"still_s", *longest->still_s}, {"others", count - 1.0}});
    locate(budget_.notes, *longest);
  }

  void skew(Jump const& jump) {
    auto const found = estimate_skew(view_, properties_, jump.said ? jump.force_kN / 2.0 : 0.0);
    if (!found) return;
    bool const timed = !view_.time_s.empty();
    if (timed && found->grows()) return growing_skew(*found);
    double const scale = timed ? 1000.0 : 1.0;
    std::string const unit = timed ? "ms" : "samples";
    double const late = scale * found->force_late;
    double const points = 50.0 * std::abs(found->phase);
    bool const is_late = found->significant() && late > 0.0;
    budget_.effects.push_back({"skew", late, unit, scale * found->uncertainty, is_late});
    budget_.effects.push_back(
        {damping_by_skew, found->significant() ? -std::copysign(points, late) : 0.0, "points", std::nullopt, is_late});
    if (!found->significant()) return;
    std::vector<FindingNumber> numbers{{"by_" + unit, std::abs(late)},
                                       {"uncertainty_" + unit, scale * found->uncertainty},
                                       {"reversals", static_cast<double>(found->reversals)},
                                       {"damping_points", points}};
    std::vector<FindingWord> words{{"unit", unit}, {"without_jump", jump.said ? "yes" : "no"}};
    is_late ? warn(FindingKind::force_late, std::move(numbers), std::move(words))
            : note(FindingKind::force_early, std::move(numbers), std::move(words));
  }

  void growing_skew(Skew const& found) {
    constexpr double ms_per_s = 1000.0;
    double reported = found.force_late;
    for (auto const& [number, late] : found.cycle_delays) {
      budget_.effects.push_back({fmt::format("skew in cycle {}", number), ms_per_s * late, "ms", std::nullopt, false});
      if (number == cycle().number) reported = late;
    }
    double const points = 50.0 * reported * found.growth_phase / found.growth;
    budget_.effects.push_back({"skew", ms_per_s * reported, "ms", ms_per_s * found.growth_uncertainty, true});
    budget_.effects.push_back({damping_by_skew, -points, "points", std::nullopt, true});
    auto const &first = found.cycle_delays.front(), &last = found.cycle_delays.back();
    warn(FindingKind::lag_grows, {{"first_ms", ms_per_s * first.delay},
                                  {"last_ms", ms_per_s * last.delay},
                                  {"from_cycle", static_cast<double>(first.number)},
                                  {"to_cycle", static_cast<double>(last.number)},
                                  {"uncertainty_ms", ms_per_s * found.growth_uncertainty},
                                  {"reversals", static_cast<double>(found.growth_reversals)},
                                  {"reported_ms", ms_per_s * reported},
                                  {"damping_points", -points}});
    locate(budget_.warnings, cycle());
  }

  void rig_friction() {
    if (!cycle().N_mean_kN) return;
    double const friction = assumed_friction * std::abs(*cycle().N_mean_kN);
    double const points = friction_damping_points(friction, cycle().K_eff_kN_per_mm, cycle().amplitude_mm);
    add(damping_by_rig_friction, points, "points");
    note(FindingKind::rig_friction,
         {{"load_kN", *cycle().N_mean_kN}, {"friction_kN", friction}, {"damping_points", points}});
  }

  // The drop of force within 0.2 % of the amplitude around a reversal, minus the drop that follows from the slope of
  // the force after the reversal.
  std::optional<double> jump(Cycle const& at, bool upper) const {
    auto const peaks = peak_positions(view_.disp_mm, at.first, at.last);
    double const sign = upper ? 1.0 : -1.0;
    double const tip = upper ? at.d_plus_mm : at.d_minus_mm;
    auto const middle = static_cast<std::ptrdiff_t>(std::lround(upper ? peaks.largest : peaks.smallest));
    auto const size = static_cast<std::ptrdiff_t>(view_.disp_mm.size());
    auto const below = [&](std::ptrdiff_t i) { return sign * (tip - view_.disp_mm[static_cast<std::size_t>(i)]); };
    auto const force_at = [&](double depth, std::ptrdiff_t step) -> std::optional<double> {
      auto i = middle;
      while (i + step >= 0 && i + step < size && below(i) < depth) i += step;
      if (below(i) < depth || i == middle) return std::nullopt;
      auto const beyond = static_cast<std::size_t>(i);
      auto const inner = static_cast<std::size_t>(i - step);
      double const part = (depth - below(i - step)) / (below(i) - below(i - step));
      return view_.force_kN[inner] + part * (view_.force_kN[beyond] - view_.force_kN[inner]);
    };
    double const depth = 0.002 * at.amplitude_mm;
    auto const before = force_at(depth, -1);
    auto const after = force_at(depth, 1);
    auto const later = force_at(3.0 * depth, 1);
    if (!before || !after || !later) return std::nullopt;
    return sign * ((*before - *after) - (*after - *later) / 2.0);
  }

  Jump jump_at_reversals() {
    std::vector<double> jumps;
    double const noise = noise_deviation(view_.disp_mm);
    for (auto const* counted : block_->counted())
      for (bool const upper : {true, false}) {
        if (held_at_extreme(view_.disp_mm, *counted, upper, noise)) continue;  // the force relaxes during a hold
        if (auto const found = jump(*counted, upper)) jumps.push_back(*found);
      }
    if (jumps.size() < 4) return {};
    std::ranges::sort(jumps);
    double const typical = jumps[jumps.size() / 2];
    double const force = (cycle().F_plus_kN - cycle().F_minus_kN) / 2.0;
    add("jump of force at reversals", typical, "kN");
    // The jump must reach half its median at three quarters of the reversals, which noise alone does not achieve.
    Jump const found{.force_kN = typical,
                     .said = typical > least_jump * std::abs(force) && jumps[jumps.size() / 4] >= 0.5 * typical};
    // In a slider, the friction of the device itself makes the force jump.
    if (!found.said || properties_.slider) return found;
    double const points = friction_damping_points(typical / 2.0, cycle().K_eff_kN_per_mm, cycle().amplitude_mm);
    bool const exceeds = add(damping_by_jump, points, "points", most_friction_points);
    std::vector<FindingNumber> numbers{
        {"jump_kN", typical}, {"friction_kN", typical / 2.0}, {"damping_points", points}};
    exceeds ? warn(FindingKind::friction_in_force, std::move(numbers))
            : note(FindingKind::jump_of_force, std::move(numbers));
    return found;
  }

  void moving_mass() {
    if (!block_->frequency_Hz) return;
    double const stiffness = mass_stiffness_kN_per_mm(1000.0, *block_->frequency_Hz);
    add("stiffness taken by a tonne of moving mass", stiffness, "kN/mm");
    note(FindingKind::moving_mass, {{"stiffness_kN_per_mm", stiffness},
                                    {"frequency_Hz", *block_->frequency_Hz},
                                    {"percent", std::abs(percent(stiffness, cycle().K_eff_kN_per_mm))}});
  }

  // Adds the drift of a channel's zero, from the midpoints between the extremes of the block's cycles. Leaves out the
  // first cycle, because the force of a device that softens is not symmetric there.
  void drift_of(std::string const& what, std::string const& unit, double amplitude, LoopChannel channel, auto middle) {
    auto const counted = block_->counted();
    if (counted.size() < 3) return;
    std::vector<double> middles;
    for (auto const* cycle : counted | std::views::drop(1)) middles.push_back(middle(*cycle));
    auto const [least, largest] = std::ranges::minmax(middles);
    double const share = percent(largest - least, 2.0 * amplitude);
    if (!add("drift of " + what, share, "%", most_drift)) return;
    if (auto const step = offset_step(view_, *block_, channel)) {
      warn(FindingKind::offset_steps,
           {{"step_" + unit, step->jump},
            {"percent", percent(std::abs(step->jump), 2.0 * amplitude)},
            {"limit_percent", most_drift}},
           {{"channel", what}, {"unit", unit}});
      add_time(step->sample);
      budget_.warnings.back().blocks = {block_->number};
      return;
    }
    warn(FindingKind::drift, {{"drift_" + unit, largest - least}, {"percent", share}, {"limit_percent", most_drift}},
         {{"channel", what}, {"unit", unit}});
    budget_.warnings.back().blocks = {block_->number};
  }

  void drift() {
    drift_of("displacement", "mm", cycle().amplitude_mm, LoopChannel::displacement,
             [](Cycle const& c) { return (c.d_plus_mm + c.d_minus_mm) / 2.0; });
    auto const [least, largest] = force_range(cycle());
    drift_of("force", "kN", (largest - least) / 2.0, LoopChannel::force, [this](Cycle const& c) {
      auto const [low, high] = force_range(c);
      return (low + high) / 2.0;
    });
  }

  void closure() {
    double const open = percent(cycle().closure_mm, 2.0 * cycle().amplitude_mm);
    if (!add("closure of the loop", open, "%", most_closure)) return;
    double const energy = std::abs(cycle().closure_mm * value_at(view_.force_kN, cycle().first));
    warn(FindingKind::loop_open, {{"closure_mm", cycle().closure_mm},
                                  {"percent", std::abs(open)},
                                  {"limit_percent", most_closure},
                                  {"energy_kN_mm", energy}});
    locate(budget_.warnings, cycle());
  }

  std::pair<double, double> range(std::span<double const> values, Cycle const& of) const {
    auto const first = static_cast<std::size_t>(of.first);
    auto const end = std::min(values.size(), static_cast<std::size_t>(of.last) + 1);
    auto const [least, largest] = std::ranges::minmax(values.subspan(first, end - first));
    return {least, largest};
  }
  std::pair<double, double> force_range(Cycle const& of) const { return range(view_.force_kN, of); }

  void offset_of(std::span<double const> values, std::string const& what, std::string const& unit, double limit) {
    auto const [least, largest] = range(values, cycle());
    double const offset = (largest + least) / 2.0;
    double const share = percent(offset, (largest - least) / 2.0);
    if (!add("offset of " + what, share, "%", limit)) return;
    warn(FindingKind::off_centre, {{"offset_" + unit, offset}, {"percent", std::abs(share)}},
         {{"channel", what}, {"unit", unit}});
    locate(budget_.warnings, cycle());
  }

  void offsets() {
    if (cycle().one_sided) return;
    offset_of(view_.disp_mm, "displacement", "mm", most_disp_offset);
    offset_of(view_.force_kN, "force", "kN", most_force_offset);
    if (properties_.centre_mm != 0.0) note(FindingKind::cut_off_zero, {{"centre_mm", properties_.centre_mm}});
  }

  void velocity() {
    if (!block_->v_max_mm_s || !block_->frequency_Hz) return;
    bool const triangle = block_->waveform == "triangle";
    double const expected = (triangle ? 4.0 : 2.0 * std::numbers::pi) * *block_->frequency_Hz * block_->amplitude_mm;
    double const deviation = percent(*block_->v_max_mm_s - expected, expected);
    bool const known = block_->waveform != "other";
    bool const exceeds =
        add("v_max beside its closed form", deviation, "%", known ? std::optional(most_v_max_error) : std::nullopt);
    std::vector<FindingNumber> numbers{
        {"v_max_mm_s", *block_->v_max_mm_s}, {"percent", deviation}, {"expected_mm_s", expected}};
    std::vector<FindingWord> words{{"of", triangle ? "triangle" : "sine"}, {"waveform", block_->waveform}};
    exceeds ? warn(FindingKind::speed_off, std::move(numbers), std::move(words))
            : note(FindingKind::largest_speed, std::move(numbers), std::move(words));
    (exceeds ? budget_.warnings : budget_.notes).back().blocks = {block_->number};
  }

  void smoothing(int window) {
    if (window <= 1) return;
    double const samples = *properties_.samples_per_cycle;
    double const first = average_loss_percent(window, samples);
    double const third = average_loss_percent(window, samples / 3.0);
    bool const exceeds = add("taken by the moving average", first, "%", most_average_loss);
    add("taken by the moving average from the third harmonic", third, "%");
    std::vector<FindingNumber> numbers{{"window_samples", static_cast<double>(window)},
                                       {"samples_per_cycle", samples},
                                       {"percent", first},
                                       {"third_harmonic_percent", third}};
    exceeds ? warn(FindingKind::average_too_wide, std::move(numbers))
            : note(FindingKind::average_over_samples, std::move(numbers));
  }

  CycleView const& view_;
  Properties const& properties_;
  Block const* block_ = nullptr;  // the block of the reported cycle
  Budget budget_;
};

}  // namespace

double energy_loss_percent(double samples_per_cycle) {
  double const angle = 2.0 * std::numbers::pi / samples_per_cycle;
  return 100.0 * (1.0 - std::sin(angle) / angle);
}

double corner_loss_percent(double samples_per_cycle) {
  return 100.0 * 2.0 / samples_per_cycle;
}

double peak_loss_percent(double samples_per_cycle) {
  return 100.0 * (1.0 - std::cos(std::numbers::pi / samples_per_cycle));
}

// Returns the mean of the largest noisy sample near a peak, minus the true peak. The largest of independent samples x_k
// + noise exceeds v with probability 1 - product of Phi((v - x_k) / s), where s is the standard deviation of the noise.
// Integration over v gives the mean. If samples are many, only every `weight`-th one is computed and counts `weight`
// times.
double peak_gain_mm(double noise_mm, double amplitude_mm, double samples_per_cycle) {
  if (!(noise_mm > 0.0) || !(amplitude_mm > noise_mm)) return 0.0;
  double const angle = 2.0 * std::numbers::pi / samples_per_cycle;
  double const deepest = std::min(12.0 * noise_mm / amplitude_mm, 1.0);
  double const reach = std::acos(1.0 - deepest) / angle;  // samples on each side of the peak that may be the largest
  double const weight = std::max(1.0, reach / 200.0);
  constexpr double step = 0.05;
  double mean = -6.0;
  for (double v = -6.0 + step / 2.0; v < 8.0; v += step) {
    double log_below = 0.0;
    for (double k = -std::floor(reach / weight); k <= reach / weight; ++k) {
      double const depth = amplitude_mm * (1.0 - std::cos(angle * weight * k)) / noise_mm;
      log_below += weight * std::log(std::max(0.5 * std::erfc(-(v + depth) / std::numbers::sqrt2), 1e-300));
      if (log_below < -50.0) break;
    }
    mean += step * (1.0 - std::exp(log_below));
  }
  return mean * noise_mm;
}

double average_loss_percent(int window, double samples_per_cycle) {
  double const half_angle = std::numbers::pi / samples_per_cycle;
  return 100.0 * (1.0 - std::sin(window * half_angle) / (window * std::sin(half_angle)));
}

double friction_damping_points(double friction_kN, double K_eff_kN_per_mm, double amplitude_mm) {
  return 200.0 * friction_kN / (std::numbers::pi * K_eff_kN_per_mm * amplitude_mm);
}

double mass_stiffness_kN_per_mm(double mass_kg, double frequency_Hz) {
  constexpr double kN_per_mm_of_N_per_m = 1e-6;
  double const omega = 2.0 * std::numbers::pi * frequency_Hz;
  return mass_kg * omega * omega * kN_per_mm_of_N_per_m;
}

// Leaves half cycles out, because the errors are estimated from full loops.
Budget error_budget(CycleView const& view, Properties const& properties, int smooth) {
  if (!view.half_cycles) return Assessment(view, properties).of_all(smooth);
  auto full = properties;
  for (auto& block : full.blocks) std::erase_if(block.cycles, [](Cycle const& cycle) { return cycle.half; });
  std::erase_if(full.blocks, [](Block const& block) { return block.cycles.empty(); });
  if (full.reported && full.reported->half) full.reported.reset();
  return Assessment(view, full).of_all(smooth);
}

Budget error_budget(TestRecord const& record, Properties const& properties, int smooth) {
  return error_budget(view_of(record), properties, smooth);
}

}  // namespace isolaw::data
