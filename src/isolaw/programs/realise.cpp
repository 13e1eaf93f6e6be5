#include "isolaw/programs/realise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "isolaw/base/hash.hpp"
#include "isolaw/data/properties/properties.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/opt/multistart.hpp"
#include "isolaw/study/adequacy.hpp"

namespace isolaw::programs {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double peak_of(std::span<double const> force) {
  double peak = 0.0;
  for (double const f : force)
    if (std::isfinite(f)) peak = std::max(peak, std::abs(f));
  return peak;
}

std::vector<double> refined(std::span<double const> x, int pieces) {
  std::vector<double> points{x.front()};
  for (std::size_t i = 1; i < x.size(); ++i)
    for (int k = 1; k <= pieces; ++k) points.push_back(k == pieces ? x[i] : x[i - 1] + (x[i] - x[i - 1]) * k / pieces);
  return points;
}

std::vector<double> every(std::span<double const> values, int step) {
  std::vector<double> kept;
  for (std::size_t i = 0; i < values.size(); i += static_cast<std::size_t>(step)) kept.push_back(values[i]);
  return kept;
}

// Whether point i of a history is a sample of the record. A point that was added between samples or before the first
// one is no sample. In the self-check's protocol, which has no measured force, all points count as samples.
bool is_sample(History const& history, std::size_t i) {
  return history.measured_kN.empty() || std::isfinite(history.measured_kN[i]);
}

void compare_properties(Deviation& result, History const& history, std::span<double const> force,
                        std::span<double const> other) {
  std::vector<double> x, f, reference, time;
  for (std::size_t i = 0; i < other.size(); ++i) {
    if (!std::isfinite(other[i])) continue;
    x.push_back(history.disp_mm[i]);
    f.push_back(force[i]);
    reference.push_back(other[i]);
    time.push_back(history.time_s[i]);
  }
  if (x.size() < 2 || (time[0] == time[1])) {
    if (x.size() < 3) return;
    for (auto* values : {&x, &f, &reference, &time}) values->erase(values->begin());
  }
  auto const properties = data::cyclic_properties(data::CycleView{x, reference, time, {}});
  if (!properties.reported) return;
  auto const cycle = data::properties_on(*properties.reported, x, f);
  auto const percent = [](double value, double truth) {
    return truth != 0.0 ? std::optional(100.0 * (value - truth) / truth) : std::nullopt;
  };
  result.K_eff = percent(cycle.K_eff_kN_per_mm, properties.reported->K_eff_kN_per_mm);
  result.energy = percent(cycle.energy_kN_mm, properties.reported->energy_kN_mm);
}

double longest_travel(History const& history) {
  double longest = 0.0, travel = 0.0;
  for (std::size_t i = 1; i < history.disp_mm.size(); ++i) {
    double const dx = history.disp_mm[i] - history.disp_mm[i - 1];
    travel = dx * travel >= 0.0 ? travel + dx : dx;
    longest = std::max(longest, std::abs(travel));
  }
  return longest;
}

double longest_step(History const& history) {
  double longest = 0.0;
  for (std::size_t i = 1; i < history.disp_mm.size(); ++i)
    longest = std::max(longest, std::abs(history.disp_mm[i] - history.disp_mm[i - 1]));
  return longest;
}

// True if the form's commands give a finite force in every unit system. BoucWen starts Newton's rule at z = 0.01
// whatever the unit of length, so it may fail in some unit systems only.
bool has_a_force(Form const& form, Subject const& subject) {
  auto const cycles = two_cycles(0.5 * subject.tested.disp_mm, subject.tested.disp_mm, subject.frequency_Hz);
  return std::ranges::all_of(unit_systems, [&](UnitSystem const& units) {
    return std::ranges::all_of(std::array{&subject.protocol, &cycles}, [&](History const* path) {
      return std::ranges::all_of(replay_kN(form, units, path->disp_mm), [](double f) { return std::isfinite(f); });
    });
  });
}

std::vector<double> replay_in_pieces(Form const& form, std::span<double const> disp_mm, int pieces) {
  return every(replay_kN(form, record_units, refined(disp_mm, pieces)), pieces);
}

// Returns into how many pieces steps of at most `longest_mm` must be cut, so that a cycle of the tested amplitude has
// as many steps as the exported file demands. The result is at most finer_steps.
int pieces_demanded(Form const& form, std::optional<StepsNeeded> const& steps, Subject const& subject,
                    double longest_mm) {
  if (form.exactness != Exactness::small_steps) return 1;
  double const per_cycle = steps ? steps->per_cycle : finer_steps * protocol_steps;
  double const longest_demanded_mm = 2.0 * std::numbers::pi * subject.tested.disp_mm / per_cycle;
  return std::clamp(static_cast<int>(std::ceil(longest_mm / longest_demanded_mm - 1e-9)), 1, finer_steps);
}

// Replays a form's commands on all histories. `as_demanded` is true if the form is of a substitute (another law, fitted
// to the law), which can only approximate the law. The steps of the records are then cut until they are as short as the
// exported file demands. Otherwise the deviation from the law would include integration errors of longer steps.
Realised replayed(Form const& form, Subject const& subject, bool as_demanded = false) {
  Realised realised{.nominal = form};
  if (form.exactness == Exactness::small_steps) realised.steps = steps_needed(subject, form);
  for (auto const& history : subject.histories) {
    double const longest_mm = longest_step(history);
    int const pieces = as_demanded ? pieces_demanded(form, realised.steps, subject, longest_mm) : 1;
    auto const force = replay_in_pieces(form, history.disp_mm, pieces);
    keep_worst(realised.from_law, deviation(history, force, history.law_kN));
    if (!realised.from_measured) realised.from_measured.emplace();
    keep_worst(*realised.from_measured, deviation(history, force, history.measured_kN));
    realised.longest_travel_mm = std::max(realised.longest_travel_mm, longest_travel(history));
    realised.longest_step_mm = std::max(realised.longest_step_mm, longest_mm);
    realised.replayed_step_mm = std::max(realised.replayed_step_mm, longest_mm / pieces);
    if (as_demanded || form.exactness != Exactness::small_steps) continue;
    if (!realised.finer) realised.finer.emplace();
    keep_worst(*realised.finer,
               deviation(history, replay_in_pieces(form, history.disp_mm, finer_steps), history.law_kN));
  }
  return realised;
}

// True if the force may be NaN when the isolator moves `overtravel` times as far as in the tests. If it then travels
// farther than the form's longest swing from side to side, the function returns true without a replay: the force may be
// NaN on another motion even if it is finite on these histories.
bool breaks_beyond_the_test(Form const& form, Subject const& subject, double travel_mm) {
  if (form.longest_swing_mm && *form.longest_swing_mm < overtravel * travel_mm) return true;
  for (auto const& history : subject.histories) {
    auto disp = history.disp_mm;
    for (double& x : disp) x *= overtravel;
    if (!std::ranges::all_of(replay_kN(form, record_units, disp), [](double f) { return std::isfinite(f); }))
      return true;
  }
  return false;
}

// Adds the forms of the lower and the upper bound. The law is mapped with the factors of the bound, and the form with
// the nominal form's id is taken. If no form has this id, the one with the nominal form's index is taken.
void add_bounds(Realised& realised, std::size_t index, laws::LawEntry const& law, std::span<double const> parameters,
                Bounds const& bounds) {
  auto const form = [&](std::optional<BoundFactors> const& factors) -> std::optional<Form> {
    if (!factors) return std::nullopt;
    auto const mapping = map_law(law, parameters, *factors);
    for (auto const& other : mapping.forms)
      if (other.id == realised.nominal.id) return other;
    return index < mapping.forms.size() ? std::optional(mapping.forms[index]) : std::nullopt;
  };
  realised.lower = form(bounds.lower);
  realised.upper = form(bounds.upper);
}

// Fits the bilinear and the Bouc-Wen law to the forces that the exported law computes. The better of the two comes
// first. A law that cannot be fitted is left out.
std::vector<Substitute> stand_ins(Subject const& subject) {
  std::vector<Substitute> fitted;
  for (std::string_view const id : {corner_law, smooth_law})
    if (auto found = fit_substitute(subject, id); found.law != nullptr) fitted.push_back(std::move(found));
  std::ranges::stable_sort(fitted, {}, &Substitute::objective);
  return fitted;
}

Realisation refit(Subject const& subject, Realisation realisation) {
  auto const fitted = stand_ins(subject);
  if (fitted.empty()) {
    realisation.explanation += fmt::format("; neither {} nor {} could be fitted in its place", corner_law, smooth_law);
    return realisation;
  }
  for (auto const& one : fitted) {
    auto const mapping = map_law(*one.law, one.parameters);
    for (std::size_t i = 0; i < mapping.forms.size(); ++i) {
      auto const& form = mapping.forms[i];
      auto realised = replayed(form, subject, true);
      if (!std::isfinite(realised.from_law.largest) || !has_a_force(form, subject)) continue;
      // Every cycle of other_cycles() has protocol_steps steps, whatever its amplitude. The number of pieces that gives
      // a cycle of the tested amplitude the demanded number of steps is therefore right for all of these cycles.
      int const pieces = pieces_demanded(form, realised.steps, subject,
                                         2.0 * std::numbers::pi * subject.tested.disp_mm / protocol_steps);
      realised.other_cycles =
          other_cycles(subject, [&](History const& h) { return replay_in_pieces(form, h.disp_mm, pieces); });
      add_bounds(realised, i, *one.law, one.parameters, subject.bounds);
      realisation.forms.push_back(std::move(realised));
    }
    if (realisation.forms.empty()) continue;
    realisation.fidelity = Fidelity::refitted;
    realisation.substitute = std::string(one.law->info.id);
    realisation.substitute_parameters = one.parameters;
    realisation.response =
        BuildingOnLaw(subject).compare(realisation.forms.front().nominal.title, *one.law, one.parameters);
    realisation.explanation += fmt::format(
        "; in its place the nearest {} law{}, fitted to this law's force on the record of {}", realisation.substitute,
        &one == fitted.data() ? "" : ", the nearest whose force the program finds", subject.histories.front().device);
    if (!subject.law->info.traits.rate_independent)
      realisation.explanation += ", at the rate of that record: other rates are not represented";
    return realisation;
  }
  realisation.explanation +=
      fmt::format("; the force of {} or {} in its place is one that the program does not find", corner_law, smooth_law);
  return realisation;
}

}  // namespace

bool far_off(Deviation const& from_law) {
  auto const beyond = [](std::optional<double> const& percent, double most) {
    return percent && !(std::abs(*percent) <= most);
  };
  return !(from_law.largest <= far_off_percent) || !(from_law.rms <= far_off_rms_percent) ||
         beyond(from_law.K_eff, study::adequate_K_eff_percent) ||
         beyond(from_law.energy, study::adequate_energy_percent);
}

bool far_off(std::vector<OtherCycle> const& cycles) {
  return std::ranges::any_of(cycles, [](auto const& c) { return !(c.largest() <= other_cycle_far_off_percent); });
}

std::string_view name(Fidelity fidelity) {
  static constexpr std::array<std::string_view, 4> names{"exact", "exact as the step goes to zero", "re-fitted",
                                                         "not available"};
  return names.at(static_cast<std::size_t>(fidelity));
}

Deviation deviation(History const& history, std::span<double const> force, std::span<double const> other) {
  double const peak = peak_of(other);
  Deviation result;
  double largest = 0.0, squares = 0.0;
  std::size_t count = 0, sample = 0;
  auto const at = [&](std::size_t i) {
    if (history.timed) result.at_s = history.time_s[i];
    result.at_sample = std::max<std::size_t>(sample, 1);
  };
  for (std::size_t i = 0; i < other.size(); ++i) {
    if (is_sample(history, i)) ++sample;
    if (!std::isfinite(other[i])) continue;
    if (!std::isfinite(force[i])) {
      at(i);
      result.largest = result.rms = infinite;
      return result;
    }
    double const d = force[i] - other[i];
    if (std::abs(d) > largest) at(i);
    largest = std::max(largest, std::abs(d));
    if (!is_sample(history, i)) continue;
    squares += d * d;
    ++count;
  }
  if (count == 0 || peak == 0.0) return result;
  result.largest = 100.0 * largest / peak;
  result.rms = 100.0 * std::sqrt(squares / static_cast<double>(count)) / peak;
  compare_properties(result, history, force, other);
  return result;
}

void keep_worst(Deviation& worst, Deviation const& other) {
  auto const larger = [](std::optional<double>& a, std::optional<double> b) {
    if (b && (!a || std::abs(*b) > std::abs(*a))) a = b;
  };
  if (other.largest > worst.largest) {
    worst.at_s = other.at_s;
    worst.at_sample = other.at_sample;
  }
  worst.largest = std::max(worst.largest, other.largest);
  worst.rms = std::max(worst.rms, other.rms);
  larger(worst.K_eff, other.K_eff);
  larger(worst.energy, other.energy);
}

std::vector<double> replay_kN(Form const& form, UnitSystem const& units, std::span<double const> disp_mm) {
  std::vector<double> disp(disp_mm.begin(), disp_mm.end());
  for (double& x : disp) x = units.from_mm(x);
  auto force = replay(in_units(form, units), disp);
  for (double& f : force) f *= units.force.in_record_units;
  return force;
}

std::string failure_of(Form const& form, Subject const& subject, Realised& realised) {
  if (auto why = refused_by_program(in_units(form, record_units)); !why.empty())
    return "the program refuses it: " + why;
  realised = replayed(form, subject);
  auto const& found = realised.from_law;
  if (!std::isfinite(found.largest) || !has_a_force(form, subject))
    return form.exactness == Exactness::small_steps
               ? "the program's iteration for its force does not end on the calibration record, or on the path of the check"
               : "its force is no number (NaN) on the calibration record";
  if (breaks_beyond_the_test(form, subject, realised.longest_travel_mm))
    return fmt::format(
        "its force may be no number (NaN) where the isolator moves {} times as far as in the tests{}", overtravel,
        form.longest_swing_mm
            ? fmt::format(": it stands no travel beyond about {:.4g} mm in one direction, the tests have {:.4g} mm",
                          *form.longest_swing_mm, realised.longest_travel_mm)
            : std::string());
  if (form.exactness == Exactness::every_step)
    return found.largest <= exact_percent
               ? std::string()
               : fmt::format("its replay differs from the law by {:.3g} % of the peak force", found.largest);
  bool const converges = realised.finer->largest <= std::max(0.25 * found.largest, 1e-3);
  if (converges && realised.finer->largest <= limit_percent) return {};
  return fmt::format(
      "its replay differs from the law by {:.3g} % of the peak force, with steps {} times smaller still by {:.3g} %",
      found.largest, finer_steps, realised.finer->largest);
}

// Fits the substitute to the exported law's force and not to the measured force, because the export represents the law.
Substitute fit_substitute(Subject const& subject, std::string_view id, std::vector<fit::Override> const& asked) {
  auto const& history = subject.histories.front();
  data::FitRecord record;
  for (std::size_t i = 0; i < history.disp_mm.size(); ++i) {
    // A history may go from zero to the first sample in no time, but the times of a record must increase. The point at
    // zero therefore moves 1e-9 s back.
    if (!record.time_s.empty() && history.time_s[i] <= record.time_s.back()) record.time_s.back() -= 1e-9;
    record.time_s.push_back(history.time_s[i]);
    record.disp_mm.push_back(history.disp_mm[i]);
    record.force_kN.push_back(history.law_kN[i]);
  }
  auto const& law = laws::find_law(id);
  fit::LawOnRecord const model(law, record, laws::Integration::converged);
  auto overrides = asked;
  if (!law.redundant.empty())
    overrides.push_back({.law = std::string(id),
                         .parameter = std::string(law.redundant),
                         .interval = laws::Interval{law.redundant_value, law.redundant_value}});
  auto const box = fit::make_box(law, fit::BoxKind::scaled, fit::scales_of(record, law.info), overrides);
  fit::IdentificationProblem const problem(model, box);
  num::Stream const stream = num::Stream(subject.seed).split(stable_hash("export")).split(stable_hash(id));
  auto const found = opt::minimise_multistart(problem, stream);
  if (!found.usable()) return {};
  Substitute fitted{
      .law = &law, .parameters = std::vector<double>(law.parameters.size()), .objective = found.best_value};
  box.expand(found.best, fitted.parameters);
  return fitted;
}

Deviation deviation_of_law(Subject const& subject, laws::LawEntry const& law, std::span<double const> parameters) {
  Deviation worst;
  for (auto const& history : subject.histories)
    keep_worst(worst, deviation(history, law_force(law, parameters, history), history.law_kN));
  return worst;
}

Realisation realise(Subject const& subject) {
  Realisation realisation;
  auto const mapping = map_law(*subject.law, subject.parameters);
  realisation.explanation = mapping.reason;
  for (std::size_t i = 0; i < mapping.forms.size(); ++i) {
    Realised realised;
    auto const failure = failure_of(mapping.forms[i], subject, realised);
    if (!failure.empty()) {
      realisation.refused.push_back(mapping.forms[i].title + ": " + failure);
      continue;
    }
    add_bounds(realised, i, *subject.law, subject.parameters, subject.bounds);
    realisation.forms.push_back(std::move(realised));
  }
  if (realisation.forms.empty()) {
    if (realisation.explanation.empty())
      realisation.explanation = "no exact form is kept: " + realisation.refused.front();
    return refit(subject, std::move(realisation));
  }
  bool const limit = realisation.forms.front().nominal.exactness == Exactness::small_steps;
  realisation.fidelity = limit ? Fidelity::exact_in_limit : Fidelity::exact;
  realisation.explanation =
      limit ? "the program integrates the hysteretic variable by backward Euler, one step per analysis step"
            : "algebraic between reversals: no step is too large";
  return realisation;
}

}  // namespace isolaw::programs
