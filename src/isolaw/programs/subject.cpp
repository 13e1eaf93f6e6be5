#include "isolaw/programs/subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/maker.hpp"
#include "isolaw/campaign/named_device.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/programs/untested_motions.hpp"
#include "isolaw/study/design_bounds.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::programs {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Returns the motion of one of a device's tests: first a point at zero displacement if the test begins elsewhere, then
// the samples, with the turning points between them if `turning_points` is `interpolated`.
History history_of(std::string const& device, data::FitRecord const& record, laws::TurningPoints turning_points) {
  auto const path = turning_points == laws::TurningPoints::interpolated
                        ? laws::make_path_with_turning_points(record.disp_mm, record.vel_mm_s, record.time_s)
                        : laws::make_path(record.disp_mm, record.vel_mm_s);
  History history;
  history.device = device;
  history.timed = record.has_time();
  history.dead_band_mm = record.dead_band_mm;
  auto const add = [&](double t, double x, double v, double force) {
    history.time_s.push_back(t);
    history.disp_mm.push_back(x);
    history.vel_mm_s.push_back(v);
    history.measured_kN.push_back(force);
  };
  if (record.disp_mm.front() != 0.0)
    add(record.time_s.front(), 0.0, record.has_time() ? record.vel_mm_s.front() : 0.0, nan);
  std::size_t sample = 0;
  for (auto const& step : path.steps) {
    double const t = step.sample ? record.time_s[sample] : 0.5 * (record.time_s[sample - 1] + record.time_s[sample]);
    add(t, step.x1, step.v1, step.sample ? record.force_kN[sample] : nan);
    if (step.sample) ++sample;
  }
  return history;
}

// Adds the histories of a device's tests and puts the one of largest amplitude first.
void add_histories(Subject& subject, campaign::Device const& device, laws::TurningPoints turning_points) {
  for (auto const& test : data::tests_of(device.record))
    subject.histories.push_back(history_of(device.name, test, turning_points));
  auto const reach = [](History const& history) {
    auto const [low, high] = std::ranges::minmax(history.disp_mm);
    return std::max(-low, high);
  };
  std::ranges::stable_sort(subject.histories, std::ranges::greater{}, reach);
}

void widen(std::optional<double>& least, std::optional<double>& most, std::optional<double> low,
           std::optional<double> high) {
  if (low) least = std::min(least.value_or(*low), *low);
  if (high) most = std::max(most.value_or(*high), *high);
}

void add_tested(TestedRange& tested, study::DeviceResult const& device) {
  study::Ranges own;
  own.add(device.record);
  if (device.rubber_thickness_mm)
    tested.strain_percent =
        std::max(tested.strain_percent.value_or(0.0), 100.0 * own.tested.disp_mm / *device.rubber_thickness_mm);
  for (auto const& block : device.properties.blocks)
    widen(tested.lowest_Hz, tested.highest_Hz, block.frequency_Hz, block.frequency_Hz);
  if (!device.raw.load_kN.empty()) {
    auto const [low, high] = std::ranges::minmax(device.raw.load_kN);
    widen(tested.load_min_kN, tested.load_max_kN, low, high);
  }
  widen(tested.temperature_min_C, tested.temperature_max_C, device.temperature_C, device.temperature_C);
}

rules::LotQuantity const* quantity_of(study::Summary const& summary, rules::Quantity quantity) {
  for (auto const& view : summary.acceptance.lot.quantities)
    if (view.quantity == quantity) return &view;
  return nullptr;
}

// Returns the value that the factors of a bound multiply. For the lot this is the mean, and for a device the value of
// the cycle that study::counting_cycle() chooses, usually the third.
std::optional<double> own_value(study::Summary const& summary, Subject const& subject, rules::LotQuantity const& view) {
  if (subject.lot) return view.mean;
  auto const device = std::ranges::find(summary.devices, subject.device, &study::DeviceResult::name);
  auto const* cycle = study::counting_cycle(device->properties, device->acceptance.block);
  if (cycle == nullptr) return std::nullopt;
  switch (view.quantity) {
    case rules::Quantity::K_d:
      return cycle->K_d_kN_per_mm;
    case rules::Quantity::Q_d:
      return cycle->Q_d_kN;
    default:
      return cycle->K_eff_kN_per_mm;
  }
}

rules::Bound const* chosen_bound(rules::LotQuantity const& view) {
  rules::Bound const* chosen = nullptr;
  for (auto const& bound : view.bounds) {
    if (bound.scope == rules::BoundScope::contract) return &bound;
    if (bound.is_tolerance) chosen = &bound;
  }
  return chosen;
}

struct PropertyBounds {
  double own = 0.0;                    // own_value(): the lot's mean, or the value in the device's counting cycle
  std::optional<double> lower, upper;  // the bounds divided by `own`
  std::optional<double> tolerance_factor;
  std::string text;
};

std::string number(double value) {
  return fmt::format("{:.4g}", value);
}

std::optional<PropertyBounds> ruled_bounds(study::Summary const& summary, Subject const& subject,
                                           rules::Quantity quantity, UnitSystem const& units) {
  auto const* view = quantity_of(summary, quantity);
  if (view == nullptr) return std::nullopt;
  auto const* bound = chosen_bound(*view);
  auto const own = own_value(summary, subject, *view);
  if (bound == nullptr || !own || !(*own > 0.0)) return std::nullopt;
  PropertyBounds bounds;
  bounds.own = *own;
  if (bound->is_tolerance) bounds.tolerance_factor = view->tolerance_factor;
  if (std::isfinite(bound->lower) && bound->lower > 0.0) bounds.lower = bound->lower / *own;
  if (std::isfinite(bound->upper)) bounds.upper = bound->upper / *own;
  bool const stiffness = quantity != rules::Quantity::Q_d;
  auto const text = [&](double value) { return number(units.convert(value, 1, stiffness ? -1 : 0)); };
  auto const unit = std::string(units.force.symbol) + (stiffness ? "/" + std::string(units.length.symbol) : "");
  bounds.text = fmt::format(
      "{} {}: lower {}, upper {} {} (lambda {} and {} on {} {}, {}{}), this one's {}", bound->source,
      rules::name(quantity), bounds.lower ? text(bound->lower) : "none", bounds.upper ? text(bound->upper) : "none",
      unit, bounds.lower ? number(bound->combined.min) : "none", number(bound->combined.max),
      view->nominal ? "the design value" : "the lot's mean", text(view->nominal ? *view->nominal : *view->mean),
      bound->note,
      bound->combined.max_is_default || bound->combined.min_is_default ? ", the set's own limits of lambda taken" : "",
      text(*own));
  return bounds;
}

BoundFactors whole(double factor) {
  return {.stiffness = factor, .strength = factor, .overall = factor, .separate = false};
}

Bounds spread_of_the_lot(study::Summary const& summary, Subject const& subject, UnitSystem const& units,
                         std::string_view why) {
  auto const* view = quantity_of(summary, rules::Quantity::K_eff);
  auto const own = view == nullptr ? std::nullopt : own_value(summary, subject, *view);
  if (view == nullptr || !view->tolerance_factor || !own || !(*own > 0.0))
    return {.lower = {}, .upper = {}, .source = "none: " + std::string(why) + ", and one device has no spread"};
  auto const text = [&](double stiffness) { return number(units.convert(stiffness, 1, -1)); };
  auto const below = view->tolerance_low;
  return {
      .lower = below ? std::optional(whole(*below / *own)) : std::nullopt,
      .upper = whole(*view->tolerance_high / *own),
      .source = fmt::format(
          "{}: the spread of the {} devices tested, whose K_eff has the mean {} and the standard deviation {} {}/{}; mean +- {} standard deviations, {} to {}, holds 95 % of the devices with confidence 95 %{}; over this one's {}; ageing, temperature and rate are not in it",
          why, view->count, text(*view->mean), text(*view->std), units.force.symbol, units.length.symbol,
          number(*view->tolerance_factor), below ? text(*below) : "none", text(*view->tolerance_high),
          below ? "" : " (" + view->no_lower + ")", text(*own)),
      .tolerance_factor = view->tolerance_factor};
}

Bounds bounds_of_the_lot(study::Summary const& summary, Subject const& subject, UnitSystem const& units) {
  if (!summary.acceptance.has_rules()) return spread_of_the_lot(summary, subject, units, "no rule set was given");
  auto const& rules = summary.acceptance.rules;
  auto const K_d = ruled_bounds(summary, subject, rules::Quantity::K_d, units);
  auto const Q_d = ruled_bounds(summary, subject, rules::Quantity::Q_d, units);
  if (!K_d || !Q_d)
    return spread_of_the_lot(summary, subject, units,
                             "rule set " + rules.id + " has no factors of K_d and Q_d for this lot");
  Bounds bounds;
  // At the design displacement d the force has the parts K_d d and Q_d. The factor on the whole force is the mean of
  // the factors on stiffness and strength, weighted by these two parts.
  double const spring = K_d->own * subject.design_disp_mm, both = spring + Q_d->own;
  auto const factors = [&](std::optional<double> stiffness, std::optional<double> strength) {
    return stiffness && strength
               ? std::optional(BoundFactors{.stiffness = *stiffness,
                                            .strength = *strength,
                                            .overall = (*stiffness * spring + *strength * Q_d->own) / both,
                                            .separate = true})
               : std::nullopt;
  };
  bounds.lower = factors(K_d->lower, Q_d->lower);
  bounds.upper = factors(K_d->upper, Q_d->upper);
  if (K_d->tolerance_factor == Q_d->tolerance_factor) bounds.tolerance_factor = K_d->tolerance_factor;
  bounds.source = fmt::format("rule set {} ({}): {}; {}", rules.id, rules.verified() ? "verified" : "not verified",
                              K_d->text, Q_d->text);
  return bounds;
}

// Returns the bounds over the design conditions. If the lot has no design conditions, returns the bounds from the
// scatter between devices. If there are design conditions but the tests give no bounds for them, there are no bounds:
// those from the scatter would be too narrow.
Bounds bounds_of(study::Summary const& summary, Subject const& subject, UnitSystem const& units) {
  auto const design = study::design_bounds(summary, *subject.law, subject.parameters);
  if (design.obstacle) {
    bool const asked = summary.conditions && !summary.conditions->bounds.empty();
    if (asked || !summary.no_conditions.empty()) return {.source = wording::remark(*design.obstacle, units)};
    return bounds_of_the_lot(summary, subject, units);
  }
  auto const factors = [](study::DesignBound const& bound) {
    return BoundFactors{.stiffness = bound.law.factors.a,
                        .strength = bound.law.factors.b,
                        .overall = bound.C_K,
                        .energy = bound.C_E,
                        .separate = !bound.law.one_factor,
                        .parameters = bound.law.parameters};
  };
  return {.lower = factors(*design.lower),
          .upper = factors(*design.upper),
          .source = wording::remark(study::about_bound("lower", *design.lower), units) + "; " +
                    wording::remark(study::about_bound("upper", *design.upper), units)};
}

void add_device_parameters(Subject& subject, campaign::Contents const& contents, std::size_t device,
                           std::string const& where) {
  auto const& named = contents.devices[device];
  if (!named.usable())
    throw Error(
        {.where = where, .found = "the device was refused: " + named.refusal, .allowed = "a device that was not"});
  auto const* run = contents.best_run(device, subject.law->info.id);
  if (run == nullptr) {
    std::string why = "no run has finished";
    for (auto const& search : contents.searches)
      if (search.device == device && search.law == subject.law->info.id && !search.refusal.empty())
        why = search.refusal;
    for (auto const& other : contents.runs)
      if (other.device == device && other.law == subject.law->info.id && !other.failure.empty()) why = other.failure;
    throw Error(
        {.where = where, .found = "the law has no result there: " + why, .allowed = "a law that was identified"});
  }
  subject.parameters = run->parameters;
  if (auto const* analysis = contents.analysis_of(device, subject.law->info.id); analysis && analysis->springs)
    subject.springs = analysis->springs->parameters;
  subject.refinement = run->refinement;
  subject.objective = run->objective;
  add_histories(subject, named, contents.settings.turning_points);
}

void add_lot_parameters(Subject& subject, campaign::Contents const& contents, std::string const& where) {
  auto const lot = std::ranges::find(contents.lot_analyses, subject.law->info.id, &campaign::LotAnalysis::law);
  if (lot == contents.lot_analyses.end())
    throw Error(
        {.where = where,
         .found = contents.settings.analysis
                      ? "the one law of the lot is not there: it needs two devices on which the law was analysed"
                      : "no analysis was made, and with it no one law of the lot",
         .allowed = contents.devices.size() > 1
                        ? std::string("a law that was analysed on two devices or more, or the name of a device")
                        : "the name of the one device: " + campaign::devices_to_name(contents),
         .advice = contents.devices.size() > 1 ? "isolaw calibrate ... --analysis full" : ""});
  subject.parameters = lot->mean.parameters;
  if (lot->springs) subject.springs = lot->springs->parameters;
  subject.refinement = lot->refinement;
  subject.objective = lot->mean.mean;
  for (auto const device : lot->devices)
    add_histories(subject, contents.devices[device], contents.settings.turning_points);
}

// Throws Error if a force is not finite. This may happen if a record begins away from zero: the exported law starts at
// zero, and may have no finite force on the way to the first sample.
void require_finite(Subject const& subject, std::string const& where) {
  auto const finite = [](History const& history) {
    return std::ranges::all_of(history.law_kN, [](double f) { return std::isfinite(f); });
  };
  if (std::ranges::all_of(subject.histories, finite) && finite(subject.protocol)) return;
  throw Error(
      {.where = where,
       .found =
           "from zero displacement the law has no finite force on the calibration record, or on the path of the check",
       .allowed = "a law with a finite force there"});
}

void add_measured(Subject& subject, study::Summary const& summary) {
  std::vector<double> stiffness, damping, load;
  study::Ranges ranges;
  for (auto const& device : summary.devices) {
    if (std::ranges::find(subject.histories, device.name, &History::device) == subject.histories.end()) continue;
    add_tested(subject.tested, device);
    ranges.add(device.record);
    if (auto const& cycle = device.properties.reported) {
      stiffness.push_back(cycle->K_eff_kN_per_mm);
      damping.push_back(cycle->damping_percent);
      if (cycle->N_mean_kN) load.push_back(*cycle->N_mean_kN);
      subject.design_disp_mm = std::max(subject.design_disp_mm, cycle->amplitude_mm);
    }
  }
  static_cast<study::Range&>(subject.tested) = ranges.tested;
  static_cast<study::Range&>(subject.fitted) = ranges.fitted;
  auto const mean = [](std::vector<double> const& values) {
    double sum = 0.0;
    for (double const v : values) sum += v;
    return sum / static_cast<double>(values.size());
  };
  if (!load.empty()) subject.tested.load_mean_kN = mean(load);
  if (!stiffness.empty()) {
    subject.K_eff_kN_per_mm = mean(stiffness);
    subject.damping_percent = mean(damping);
  }
  if (subject.design_disp_mm == 0.0) subject.design_disp_mm = subject.tested.disp_mm;
}

}  // namespace

History two_cycles(double first_mm, double second_mm, double frequency_Hz, int steps_per_cycle) {
  History history;
  auto const omega = 2.0 * std::numbers::pi * frequency_Hz;
  for (int i = 0; i <= 2 * steps_per_cycle; ++i) {
    double const phase = 2.0 * std::numbers::pi * i / steps_per_cycle;
    double const size = i <= steps_per_cycle ? first_mm : second_mm;
    history.time_s.push_back(i / (steps_per_cycle * frequency_Hz));
    // std::sin gives no exact zero at multiples of pi.
    history.disp_mm.push_back(i % (steps_per_cycle / 2) == 0 ? 0.0 : size * std::sin(phase));
    history.vel_mm_s.push_back(i == 0 ? 0.0 : size * omega * std::cos(phase));
  }
  return history;
}

History tested_cycles(Subject const& subject) {
  auto cycles = two_cycles(0.5 * subject.tested.disp_mm, subject.tested.disp_mm, subject.frequency_Hz);
  cycles.refinement = subject.refinement;
  cycles.dead_band_mm = subject.dead_band_mm;
  cycles.law_kN = law_force(*subject.law, subject.parameters, cycles);
  return cycles;
}

History check_path(double tested_mm, double frequency_Hz, double dead_band_mm) {
  constexpr double pi = std::numbers::pi;
  // A law with a dead band computes its force from a motion that follows the real one (laws/memory/followed.hpp). After
  // a turn, this follower rests until the real motion has gone back by two bands, and it has caught up with the real
  // motion after six. The small loop from 0.4 to 0.4 - tremor goes back by four bands, so that its force depends on the
  // width of the band.
  double const tremor = 4.0 * dead_band_mm / tested_mm, step_s = 1.0 / (protocol_steps * frequency_Hz);
  History history{.device = {}, .time_s = {0.0}, .disp_mm = {0.0}, .vel_mm_s = {0.0}, .measured_kN = {}, .law_kN = {}};
  double from = 0.0;
  for (double const to : {0.5, -0.5, 1.0, -1.0, 0.4, 0.4 - tremor, 0.4, -0.2, 0.6, 0.1, 1.0, 0.0}) {
    double const half_way = 0.5 * (to - from) * tested_mm;
    int const steps = static_cast<int>(std::ceil(0.25 * protocol_steps * std::abs(to - from) - 1e-9));
    for (int i = 1; i <= steps; ++i) {
      double const phase = pi * i / steps, x = from * tested_mm + half_way * (1.0 - std::cos(phase));
      history.time_s.push_back(static_cast<double>(history.time_s.size()) * step_s);
      // Rounding must not decide on which side of zero a sample lies.
      history.disp_mm.push_back(std::abs(x) < 1e-9 * tested_mm ? 0.0 : x);
      history.vel_mm_s.push_back(i == steps ? 0.0 : half_way * std::sin(phase) * pi / (steps * step_s));
    }
    from = to;
  }
  return history;
}

std::string plain_name(std::string_view name, std::size_t longest) {
  std::string plain;
  for (char const c : name) {
    bool const kept = static_cast<unsigned char>(c) < 128 && std::isalnum(static_cast<unsigned char>(c)) != 0;
    // Names with two underscores in a row are reserved in C++.
    if (kept || (!plain.empty() && !plain.ends_with('_'))) plain += kept ? c : '_';
    if (plain.size() == longest) break;
  }
  while (plain.ends_with('_')) plain.pop_back();
  return plain;
}

std::vector<double> law_force(laws::LawEntry const& law, std::span<double const> parameters, History const& history) {
  data::FitRecord const motion{.time_s = history.time_s,
                               .disp_mm = history.disp_mm,
                               .vel_mm_s = history.vel_mm_s,
                               .dead_band_mm = history.dead_band_mm};
  return fit::LawOnMotion(law, motion, laws::Integration::converged, laws::TurningPoints::as_sampled,
                          history.refinement)
      .force_kN(parameters);
}

Subject make_subject(campaign::Contents const& contents, study::Summary const& summary, std::string_view law,
                     std::string_view device, UnitSystem const& units) {
  Subject subject;
  subject.law = &laws::find_law(law);
  if (std::ranges::find(contents.settings.laws, law) == contents.settings.laws.end())
    throw Error({.where = "law " + std::string(law),
                 .found = "the law is not in this campaign",
                 .allowed = joined(contents.settings.laws)});
  subject.version = summary.version;
  subject.makers = campaign::text(std::span(summary.makers));
  subject.title = contents.title;
  subject.seed = contents.settings.seed;
  auto const chosen = campaign::named_device(contents, device);
  subject.lot = !chosen;
  subject.device = std::string(device);
  for (auto const& other : contents.devices)
    if (other.name != subject.device && plain_name(other.name) == plain_name(subject.device))
      subject.number_among_alike = chosen.value_or(contents.devices.size()) + 1;
  auto const one = subject.lot ? std::nullopt : std::optional<std::string_view>(device);
  auto const where = study::law_and_device_text(law, one);
  if (chosen)
    add_device_parameters(subject, contents, *chosen, where);
  else
    add_lot_parameters(subject, contents, where);
  if (contents.settings.integration == laws::Integration::paper)
    subject.notes.emplace_back(
        "The campaign integrated with one Runge-Kutta step per sample; the export is of the law itself, integrated to convergence with the same parameters.");
  // The setting alone does not tell whether samples had weights, because a record without swings has none. So the
  // records are inspected.
  if (std::ranges::any_of(contents.devices, [&](campaign::Device const& d) {
        return !d.record.weights.empty() &&
               std::ranges::find(subject.histories, d.name, &History::device) != subject.histories.end();
      })) {
    auto const weights = contents.settings.clean.weights.value_or(data::Weighting::swing);
    subject.notes.push_back(fmt::format(
        "The law was fitted with samples that count by {}{}, so its objective is no mean over time (Eq. (27) of Cucuzza et al. 2025).",
        name(weights), weights == data::Weighting::swing ? " where a test has swings" : ""));
  }
  subject.fitted.part = contents.settings.clean.scored.text();
  subject.doubts = study::doubts(summary, law, one);
  add_measured(subject, summary);
  subject.frequency_Hz = subject.tested.highest_Hz.value_or(0.5);
  for (auto const& history : subject.histories)
    subject.dead_band_mm = std::max(subject.dead_band_mm, history.dead_band_mm);
  subject.protocol = check_path(subject.tested.disp_mm, subject.frequency_Hz, subject.dead_band_mm);
  auto const as_fitted = [&](History& history) {
    history.refinement = subject.refinement;
    history.dead_band_mm = subject.dead_band_mm;
  };
  std::ranges::for_each(subject.histories, as_fitted);
  as_fitted(subject.protocol);
  for (auto& history : subject.histories) history.law_kN = law_force(*subject.law, subject.parameters, history);
  subject.protocol.law_kN = law_force(*subject.law, subject.parameters, subject.protocol);
  require_finite(subject, where);
  subject.bounds = bounds_of(summary, subject, units);
  subject.beyond_tests = beyond_the_tests(subject, units);
  return subject;
}

}  // namespace isolaw::programs
