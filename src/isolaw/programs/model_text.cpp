#include "isolaw/programs/model_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/laws/plane/in_plane.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::programs {
namespace {

constexpr std::string_view coupled_form = "bearing";

// Longest time step of an analysis. It is short enough for the frequencies of ground motions.
constexpr double longest_model_step_s = 0.005;
// Time step of an analysis if steps_needed() found no number of steps per cycle that is accurate enough.
constexpr double careful_model_step_s = 0.001;

Form const* with_id(Mapping const& mapping, std::string_view id) {
  auto const found = std::ranges::find(mapping.forms, id, &Form::id);
  return found == mapping.forms.end() ? nullptr : &*found;
}

double step_asked_s(Subject const& subject, Realised const& form) {
  if (form.nominal.exactness == Exactness::every_step) return longest_model_step_s;
  if (!form.steps) return careful_model_step_s;
  return std::min(longest_model_step_s, 1.0 / (form.steps->per_cycle * subject.frequency_Hz));
}

std::size_t place_of_model_form(Realisation const& realisation) {
  auto const& forms = realisation.forms;
  auto const found = std::ranges::find_if(forms, [](Realised const& form) { return form.nominal.id == coupled_form; });
  return found == forms.end() ? 0 : static_cast<std::size_t>(found - forms.begin());
}

std::string range_text(double low, double high) {
  return low == high ? fmt::format("{:.4g}", low) : fmt::format("{:.4g} to {:.4g}", low, high);
}

std::string shown_name(std::string const& name) {
  auto shown = harmless(name);
  // The names go into CSV files, where commas separate cells.
  std::ranges::replace(shown, ',', '_');
  return shown;
}

}  // namespace

Realised const& form_of_model(Realisation const& realisation) {
  return realisation.forms[place_of_model_form(realisation)];
}
Realised& form_of_model(Realisation& realisation) {
  return realisation.forms[place_of_model_form(realisation)];
}

std::string drawn_variant(std::size_t draw, std::size_t bearing) {
  return fmt::format("draw_{}_{}", draw, bearing);
}

Deviation add_draws(Realisation& realisation, Subject const& subject) {
  auto const& model = *subject.model;
  Deviation worst;
  if (model.draws.empty()) return worst;
  auto& model_form = form_of_model(realisation);
  auto one = subject;
  one.model.reset();
  one.histories.resize(1);
  one.histories[0].measured_kN.clear();
  auto const fails = [&](std::size_t draw, std::size_t bearing, std::string why) {
    return Error({.where = fmt::format("--draws, draw {}, bearing {}", draw + 1, model.bearings[bearing].name),
                  .found = fmt::format("{} cannot be had with {}: {}", model_form.nominal.title,
                                       parameter_text(*subject.law, model.draws[draw][bearing]), why),
                  .allowed = "draws that the program's materials can give",
                  .advice = "another --seed, or the bounds: without --draws"});
  };
  for (std::size_t draw = 0; draw < model.draws.size(); ++draw)
    for (std::size_t bearing = 0; bearing < model.draws[draw].size(); ++bearing) {
      one.parameters = model.draws[draw][bearing];
      for (auto* history : {&one.histories[0], &one.protocol})
        history->law_kN = law_force(*one.law, one.parameters, *history);
      auto const* law = one.law;
      auto parameters = one.parameters;
      if (!realisation.substitute.empty()) {
        auto fitted = fit_substitute(one, realisation.substitute);
        if (fitted.law == nullptr) throw fails(draw, bearing, "no " + realisation.substitute + " law could be fitted");
        law = fitted.law;
        parameters = std::move(fitted.parameters);
      }
      auto const mapping = map_law(*law, parameters);
      auto const* form = with_id(mapping, model_form.nominal.id);
      if (form == nullptr) throw fails(draw, bearing, mapping.reason.empty() ? "it has another form" : mapping.reason);
      Realised realised;
      auto const failure = failure_of(*form, one, realised);
      // A substitute that differs from the law is accepted and its deviation is reported, but its force must be finite.
      bool const has_force = std::isfinite(realised.from_law.largest);
      if (!failure.empty() && (realisation.substitute.empty() || !has_force)) throw fails(draw, bearing, failure);
      keep_worst(worst, realised.from_law);
      model_form.draws.emplace_back(drawn_variant(draw + 1, bearing + 1), *form);
    }
  realisation.draws_from_law = worst;
  return worst;
}

ModelNumbers model_numbers(Subject const& subject, Realisation const& realisation, UnitSystem const& units) {
  auto const& model = *subject.model;
  auto const& form = form_of_model(realisation);
  ModelNumbers numbers;
  numbers.function = form.nominal.id;
  numbers.coupled = numbers.function == coupled_form;
  numbers.gravity = units.from_mm(data::gravity_mm_s2);
  numbers.weight = units.from_kN(model.weight_kN);
  numbers.mass = numbers.weight / numbers.gravity;
  auto const gyration = units.from_mm(model.gyration_mm);
  numbers.inertia = numbers.mass * gyration * gyration;
  numbers.x = units.from_mm(model.x_mm);
  numbers.y = units.from_mm(model.y_mm);
  for (auto const& b : model.bearings) {
    auto const load = units.from_kN(b.load_kN);
    numbers.bearings.push_back({.name = shown_name(b.name),
                                .x = units.from_mm(b.x_mm),
                                .y = units.from_mm(b.y_mm),
                                .angle_rad = b.angle_deg * std::numbers::pi / 180.0,
                                .load = load,
                                .K_v = units.convert(b.K_v_kN_per_mm, 1, -1),
                                .mass = load / numbers.gravity});
  }
  numbers.motion_step_s = model.motions.front().step_s;
  numbers.pieces = static_cast<int>(std::ceil(numbers.motion_step_s / step_asked_s(subject, form) - 1e-9));
  for (auto const& motion : model.motions) {
    auto& values = numbers.motions.emplace_back();
    for (double const a : motion.acceleration_mm_s2) values.push_back(units.from_mm(model.scale * a));
  }
  numbers.tolerance = units.from_mm(1e-8);
  numbers.tested = units.from_mm(subject.tested.disp_mm);
  if (!model.draws.empty()) {
    numbers.cases = {"nominal"};
    for (std::size_t i = 1; i <= model.draws.size(); ++i) numbers.cases.push_back(fmt::format("draw_{}", i));
  } else {
    if (form.lower) numbers.cases.emplace_back("lower");
    numbers.cases.emplace_back("nominal");
    if (form.upper) numbers.cases.emplace_back("upper");
  }
  numbers.held = model.bearings.size() == 1;
  return numbers;
}

std::vector<std::string> model_cautions(Subject const& subject, UnitSystem const& units) {
  std::vector<std::string> cautions;
  if (auto const id = std::string(subject.law->info.id);
      !laws::springs_follow(id) && laws::no_coupled_form(id, subject.parameters))
    cautions.push_back(
        wording::sentence({.kind = FindingKind::unequal_sides, .law = id, .words = {{"how", "in a model"}}}, units));
  // Loads that lie outside the tested loads by up to 20 % need no caution, because laboratories hold the load of a test
  // no more closely than that.
  constexpr double held_within = 0.2;
  auto const &low = subject.tested.load_min_kN, &high = subject.tested.load_max_kN;
  if (!low || !high) return cautions;
  auto const [least, most] = std::ranges::minmax(subject.model->bearings, {}, &ModelBearing::load_kN);
  if (least.load_kN >= (1.0 - held_within) * *low && most.load_kN <= (1.0 + held_within) * *high) return cautions;
  auto const text = [&](double a, double b) { return range_text(units.from_kN(a), units.from_kN(b)); };
  cautions.push_back(fmt::format("the isolators carry {} {} and were tested under {}: their law is fitted to the tests",
                                 text(least.load_kN, most.load_kN), units.force.symbol, text(*low, *high)));
  return cautions;
}

std::vector<Fact> model_facts(Subject const& subject, Realisation const& realisation, UnitSystem const& units) {
  auto const& model = *subject.model;
  auto const numbers = model_numbers(subject, realisation, units);
  auto const length = units.length.symbol, force = units.force.symbol;
  auto const extent = [&](auto place) {
    auto const [low, high] = std::ranges::minmax(numbers.bearings, {}, place);
    return fmt::format("{:.5g} to {:.5g}", low.*place, high.*place);
  };
  std::vector<Fact> facts;
  facts.push_back(
      {"Model", fmt::format("{} under a slab that is rigid in its plane, above fixed ground; x and y in plan, z up",
                            counted(numbers.bearings.size(), "isolator"))});
  facts.push_back({"Layout", fmt::format("{}: x {}, y {} {}", model.layout, extent(&ModelNumbers::One::x),
                                         extent(&ModelNumbers::One::y), length)});
  facts.push_back(
      {"Weight carried", fmt::format("{:.6g} {} ({}), a mass of {:.6g} {} s2/{} with g = {:.6g} {}/s2", numbers.weight,
                                     force, model.weight_from, numbers.mass, force, length, numbers.gravity, length)});
  facts.push_back({"Its centre", fmt::format("x = {:.5g}, y = {:.5g} {}, {}; no accidental eccentricity", numbers.x,
                                             numbers.y, length, model.centre_from)});
  facts.push_back(
      {"Turning in plan", numbers.held ? std::string("held, as one isolator gives no stiffness against it")
                                       : fmt::format("radius of gyration {:.5g} {}, {}",
                                                     units.from_mm(model.gyration_mm), length, model.gyration_from)});
  auto const [least, most] = std::ranges::minmax(numbers.bearings, {}, &ModelNumbers::One::load);
  facts.push_back({"Load on an isolator", fmt::format("{} {}", range_text(least.load, most.load), force)});
  for (auto const& caution : model_cautions(subject, units)) facts.push_back({"Warning", caution});
  auto const [softest, stiffest] = std::ranges::minmax(numbers.bearings, {}, &ModelNumbers::One::K_v);
  facts.push_back(
      {"Vertical springs", fmt::format("{} {}/{}, {}; elastic, the same in tension and compression",
                                       range_text(softest.K_v, stiffest.K_v), force, length, model.K_v_from)});
  facts.push_back(
      {"Isolators", numbers.coupled
                        ? std::string("an element that couples the two directions in plan")
                        : std::string("two independent springs at right angles, along the isolator's own axes")});
  facts.push_back(
      {"Rotations",
       "the slab and the ground hold both ends of an isolator level; its own stiffness against twist is 0"});
  facts.push_back(
      {"Not in the model",
       "the structure above; damping beside that of the law; what the vertical load does to the law, P-delta, uplift, tilting and vertical motion of the slab"});
  if (subject.K_eff_kN_per_mm) {
    auto const total = *subject.K_eff_kN_per_mm * static_cast<double>(numbers.bearings.size());
    facts.push_back(
        {"Period", fmt::format("{:.3g} s with the measured K_eff at {:.4g} {}",
                               2.0 * std::numbers::pi * std::sqrt(model.weight_kN / data::gravity_mm_s2 / total),
                               units.from_mm(subject.design_disp_mm), length)});
  }
  for (std::size_t i = 0; i < model.motions.size(); ++i) {
    auto const& motion = model.motions[i];
    double peak = 0.0;
    for (double const a : motion.acceleration_mm_s2) peak = std::max(peak, std::abs(a));
    facts.push_back(
        {i == 0 ? "Ground motion along x" : "Ground motion along y",
         fmt::format("{}: {}; peak {:.4g} g{}", motion.file, motion.recognised,
                     model.scale * peak / data::gravity_mm_s2,
                     model.scale == 1.0 ? std::string()
                                        : fmt::format(" (scaled by {:g}, as are the numbers below)", model.scale))});
  }
  facts.push_back(
      {"Step of the analysis", fmt::format("{:.4g} s, {} to a sample of the motion; Newmark (0.5, 0.25), Newton",
                                           numbers.motion_step_s / numbers.pieces, numbers.pieces)});
  facts.push_back({"Analyses", model.draws.empty()
                                   ? joined(numbers.cases)
                                   : fmt::format("nominal, and {} draws, seed {}, each isolator with a law of its own",
                                                 model.draws.size(), model.seed)});
  for (auto const& sentence : model.draws_said) facts.push_back({"  draws", sentence});
  if (auto const& worst = realisation.draws_from_law)
    facts.push_back(
        {"  draws against their own laws",
         fmt::format("the worst, on the record of {}: {}", subject.histories.front().device, deviation_text(*worst))});
  return facts;
}

std::string run_usage(std::string_view command, std::string const& folder, ModelNumbers const& numbers) {
  constexpr std::size_t few = 4;
  auto const cases = numbers.cases.size() > few
                         ? std::vector<std::string>{numbers.cases[0], numbers.cases[1], "...", numbers.cases.back()}
                         : numbers.cases;
  return fmt::format(
      "# To run:   {} run [FOLDER [CASES]]    (exit code 0 where every analysis came to its end, 1 where not)\n"
      "#           writes peaks.csv and a folder for each case to FOLDER ({}); cases: {}\n",
      command, folder, joined(cases));
}

std::string slab_header(UnitSystem const& units) {
  auto const l = units.length.symbol, f = units.force.symbol;
  return fmt::format("time [s],ux [{0}],uy [{0}],turning [rad],Vx [{1}],Vy [{1}]", l, f);
}

std::string peaks_header(UnitSystem const& units) {
  auto const l = units.length.symbol, f = units.force.symbol;
  return fmt::format(
      "case,bearing,largest displacement [{0}],largest force [{1}],vertical load [{1}],left at the end [{0}]", l, f);
}

}  // namespace isolaw::programs
