#include "isolaw/programs/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <ranges>

#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/programs/header_parts.hpp"

namespace isolaw::programs {
namespace {

// Characters that begin a substitution or join lines in Tcl, Python or C++.
constexpr std::string_view acted_on = "\\\"`$[]{}";

std::string replaced(std::string_view text, std::string_view unwanted) {
  auto result = printable(text);
  for (char& c : result)
    if (unwanted.find(c) != std::string_view::npos) c = '_';
  return result;
}

std::string percent(double value) {
  return std::isfinite(value) ? fmt::format("{:.2g} %", std::abs(value) < 5e-11 ? 0.0 : value) : "not a number";
}

std::string range_of(std::optional<double> low, std::optional<double> high, std::string_view unit) {
  if (!low || !high) return "not stated";
  if (*low == *high) return fmt::format("{:.4g} {}", *low, unit);
  return fmt::format("{:.4g} to {:.4g} {}", *low, *high, unit);
}

// True if the materials of two forms deviate equally from the law, apart from rounding, as two materials with the same
// equation do. One sentence then describes both.
bool same(Deviation const& a, Deviation const& b) {
  return std::abs(a.largest - b.largest) <= 1e-6 * a.largest + 1e-9;
}

std::vector<Fact> replay_facts(Subject const& subject, Realisation const& realisation, UnitSystem const& units) {
  auto const& forms = realisation.forms;
  std::vector<Fact> facts;
  for (std::size_t first = 0, next = 0; first < forms.size(); first = next) {
    std::vector<std::string> titles;
    for (next = first; next < forms.size() && same(forms[first].from_law, forms[next].from_law); ++next)
      titles.push_back(forms[next].nominal.title);
    auto const& form = forms[first];
    if (far_off(form.from_law))
      facts.push_back({"Far off", joined(titles) + ": not to be taken for the law without a look at what follows"});
    facts.push_back(
        {joined(titles),
         fmt::format("replayed on the calibration record{}, steps up to {:.3g} {}, against the law: {}",
                     subject.histories.size() > 1 ? "s (the worst of them)" : "", units.from_mm(form.replayed_step_mm),
                     units.length.symbol, deviation_text(form.from_law))});
    if (form.finer)
      facts.push_back({fmt::format("  in steps {} times smaller", finer_steps), deviation_text(*form.finer)});
    if (form.from_measured && first == 0)
      facts.push_back({"  against the measured force", deviation_text(*form.from_measured)});
    if (!form.other_cycles.empty())
      facts.push_back({"  at other amplitudes",
                       text(form.other_cycles) + (needs_warning(form.other_cycles)
                                                      ? fmt::format("; MORE THAN {:.0f} % OFF", warning_percent)
                                                      : std::string())});
    if (form.nominal.exactness == Exactness::small_steps)
      facts.push_back(
          {"  time step",
           form.steps
               ? fmt::format(
                     "{} steps to a cycle ({:.3g} s at the tested {:.3g} Hz) or more: the integration then changes the energy of a cycle by {:+.2g} %",
                     form.steps->per_cycle, 1.0 / (form.steps->per_cycle * subject.frequency_Hz), subject.frequency_Hz,
                     form.steps->energy)
               : fmt::format("no number of steps tried keeps the energy of a cycle within {} %", step_energy_percent)});
    for (std::size_t i = first; i < next; ++i) {
      auto const& one = forms[i].nominal;
      if (!one.since.empty())
        facts.push_back({"  " + one.title.substr(one.title.find(' ') + 1), "in OpenSees from " + one.since + " on"});
      if (one.condition.empty()) continue;
      facts.push_back(
          {"  " + one.title.substr(one.title.find(' ') + 1),
           one.condition + (one.longest_travel_mm
                                ? fmt::format(": {:.4g} {}", units.from_mm(*one.longest_travel_mm), units.length.symbol)
                                : std::string())});
    }
  }
  return facts;
}

std::string factor_text(BoundFactors const& factors, bool one_factor) {
  if (factors.separate && !one_factor && !factors.parameters.empty())
    return fmt::format("elastic part x {:.4g}, hysteretic part x {:.4g}", factors.stiffness, factors.strength);
  if (factors.separate && !one_factor)
    return fmt::format("stiffness (K_d) x {:.4g}, strength (Q_d) x {:.4g}", factors.stiffness, factors.strength);
  return fmt::format("force x {:.4g}", factors.overall);
}

}  // namespace

std::string harmless(std::string_view text) {
  return replaced(text, acted_on);
}

std::string harmless_markdown(std::string_view text) {
  return replaced(text, "\\|<>`[]*#&");
}

std::string identifier(Subject const& subject, UnitSystem const& units) {
  if (!subject.name.empty()) return subject.name;
  constexpr std::size_t longest_title = 20;
  auto name = "isolaw_" + plain_name(subject.law->info.id);
  for (auto const& part : {plain_name(subject.title, longest_title), plain_name(subject.device)})
    if (!part.empty()) name += "_" + part;
  if (subject.number_among_alike > 0) name += fmt::format("_{}", subject.number_among_alike);
  return name + "_" + plain_name(units.id);
}

void require_export_name(std::string_view name) {
  constexpr std::string_view words_of_cpp =
      " alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t char32_t class compl"
      " concept const consteval constexpr constinit const_cast continue co_await co_return co_yield decltype default delete"
      " do double dynamic_cast else enum explicit export extern false float for friend goto if inline int long mutable"
      " namespace new noexcept not not_eq nullptr operator or or_eq private protected public register reinterpret_cast"
      " requires return short signed sizeof static static_assert static_cast struct switch template this thread_local throw"
      " true try typedef typeid typename union unsigned using virtual void volatile wchar_t while xor xor_eq main std ";
  bool const taken = words_of_cpp.find(" " + std::string(name) + " ") != std::string_view::npos;
  if (!taken && !name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) == 0 &&
      name.size() <= longest_name && plain_name(name) == name)
    return;
  throw Error({.where = "--name",
               .found = printable(name) + (taken ? ", a word of C++" : ""),
               .allowed = fmt::format("a letter, then letters, digits and single _ between them, {} characters at most",
                                      longest_name)});
}

std::string with_own_number(std::string text) {
  auto const number = fmt::format("0x{:08x}", static_cast<std::uint32_t>(stable_hash(text)));
  for (auto at = text.find(own_number_mark); at != std::string::npos; at = text.find(own_number_mark, at))
    text.replace(at, own_number_mark.size(), number);
  return text;
}

std::string exact_text(double value) {
  auto text = fmt::format("{}", value);
  // Tcl would read "2" as an integer and use integer division. The text is therefore "2.0".
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string argument_values(Command const& command, std::string_view separator) {
  std::string text;
  for (std::size_t i = 0; i < command.arguments.size(); ++i) {
    // OpenSees reads maxIter as an integer, which has no decimal point.
    bool const count = (i == 10 && command.name == "BoucWen") || (i == 9 && command.name == "BoucWenOriginal");
    text += separator;
    text += count ? fmt::format("{:.0f}", command.arguments[i]) : exact_text(command.arguments[i]);
  }
  return text;
}

std::string element_options(Command const& command, std::string_view separator, std::string_view quote) {
  if (command.name != "elastomericBearingBoucWen") return {};
  return fmt::format("{0}{1}-iter{1}{0}{2}{0}{3}", separator, quote, bearing_iterations, exact_text(bearing_tolerance));
}

std::string argument_names(Form const& form) {
  return joined(form.commands | std::views::transform([](MappedCommand const& command) {
                  return command.name + " " + joined(command.arguments | std::views::transform(&Argument::name), " ");
                }),
                "; ");
}

std::string briefly(double value) {
  return fmt::format("{:.5g}", value);
}

std::string parameter_text(laws::LawEntry const& law, std::span<double const> parameters) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    auto const& p = law.parameters[i];
    texts.push_back(fmt::format("{} = {}{}{}", p.name, exact_text(parameters[i]), p.unit == "1" ? "" : " ",
                                p.unit == "1" ? "" : p.unit));
  }
  return joined(texts);
}

std::string deviation_text(Deviation const& d) {
  // If the largest deviation is 0, it occurs at no particular time or sample.
  auto const place = d.largest > 0.0 ? fmt::format(" (at {})", d.at_s ? fmt::format("{:.4g} s", *d.at_s)
                                                                      : fmt::format("sample {}", d.at_sample))
                                     : std::string();
  auto text =
      fmt::format("largest {} of the peak force{}, root mean square {}", percent(d.largest), place, percent(d.rms));
  if (d.K_eff) text += ", K_eff " + percent(*d.K_eff);
  if (d.energy) text += ", energy of a cycle " + percent(*d.energy);
  return text;
}

std::vector<Fact> response_facts(Subject const& subject, RefitResponse const& response, UnitSystem const& units) {
  std::vector<Fact> facts;
  if (response.finding) facts.push_back({"In a building", wording::remark(*response.finding, units)});
  if (!response.motions.empty()) facts.push_back({"  the building", building_text(subject, response, units)});
  if (!response.why_not.empty()) facts.push_back({"In a building", "not computed: " + response.why_not});
  return facts;
}

std::vector<Fact> validity(Subject const& subject, UnitSystem const& units) {
  auto const& t = subject.tested;
  auto const load = [&](std::optional<double> value) {
    return value ? std::optional(units.from_kN(*value)) : std::nullopt;
  };
  auto const& f = subject.fitted;
  auto const speed = [&](std::optional<double> value) {
    return value ? fmt::format("up to {:.4g} {}/s, at the fastest of all samples", units.from_mm(*value),
                               units.length.symbol)
                 : std::string("not stated");
  };
  return {{"Fitted to", study::part_text(f.part)},
          {"Displacement fitted", fmt::format("up to {:.4g} {}", units.from_mm(f.disp_mm), units.length.symbol)},
          {"Velocity fitted", speed(f.vel_mm_s)},
          {"Displacement tested", fmt::format("up to {:.4g} {}", units.from_mm(t.disp_mm), units.length.symbol)},
          {"Shear strain tested",
           t.strain_percent ? fmt::format("up to {:.4g} %", *t.strain_percent) : std::string("not stated")},
          {"Frequency tested", range_of(t.lowest_Hz, t.highest_Hz, "Hz")},
          {"Velocity tested", speed(t.vel_mm_s)},
          {"Vertical load tested", range_of(load(t.load_min_kN), load(t.load_max_kN), units.force.symbol)},
          {"Temperature", range_of(t.temperature_min_C, t.temperature_max_C, "C")}};
}

std::vector<Fact> measured_facts(Subject const& subject) {
  std::vector<Fact> facts;
  if (subject.objective)
    facts.push_back({"Fitted to the tests with",
                     fmt::format("objective {:.4g}{} (mean deviation over the standard deviation of the force)",
                                 *subject.objective, subject.lot ? ", mean of the devices" : "")});
  Deviation worst;
  std::size_t compared = 0, cyclic = 0;
  for (auto const& history : subject.histories) {
    if (history.measured_kN.empty()) continue;
    auto const found = deviation(history, history.law_kN, history.measured_kN);
    ++compared;
    if (found.K_eff) ++cyclic;
    keep_worst(worst, found);
  }
  if (worst.largest > 0.0)
    facts.push_back({fmt::format("The law against the measured force{}", compared > 1 ? "s (the worst of them)" : ""),
                     deviation_text(worst) +
                         (cyclic > 0 && cyclic < compared
                              ? fmt::format(" (K_eff and energy: of the {} with cycles)", counted(cyclic, "record"))
                              : "")});
  return facts;
}

std::vector<Fact> away_facts(Subject const& subject, Realisation const& realisation) {
  std::vector<Fact> facts;
  for (auto const& sentence : subject.beyond_tests) facts.push_back({"Beyond the tests", sentence});
  bool const coupled =
      std::ranges::any_of(realisation.forms, [](Realised const& form) { return form.nominal.id == "bearing"; });
  if (auto const springs = coupled ? std::nullopt : two_springs(subject))
    facts.push_back(
        {"Two directions",
         fmt::format(
             "no coupled element has this law; two springs at right angles, on a circle of the tested amplitude, give up to {:.3g} times the peak force of one and {:.3g} times the energy that a coupled bearing of constant strength would have",
             springs->force, springs->energy)});
  return facts;
}

double energy_off_percent(BoundFactors const& factors) {
  return 100.0 * (factors.overall / factors.energy.value_or(factors.overall) - 1.0);
}

std::vector<Fact> bound_facts(Subject const& subject, bool one_factor) {
  auto const& bounds = subject.bounds;
  auto const text = [&](std::optional<BoundFactors> const& factors) {
    if (!factors) return std::string("none");
    bool const own = std::abs(factors->stiffness - 1.0) < 1e-9 && std::abs(factors->strength - 1.0) < 1e-9;
    return factor_text(*factors, one_factor) +
           (own ? ", equal to the nominal: this device lies at that end of the lot" : "");
  };
  std::vector<Fact> facts{
      {"Lower bound", text(bounds.lower)}, {"Upper bound", text(bounds.upper)}, {"Bounds from", bounds.source}};
  auto const separate = [](auto const& factors) { return factors && factors->separate; };
  if (one_factor && (separate(bounds.lower) || separate(bounds.upper)))
    facts.push_back(
        {"Bounds act",
         bounds.upper && !bounds.upper->parameters.empty()
             ? fmt::format(
                   "as one factor on the whole force, which is that of K_eff: the damping stays as it is, and the energy is off by {:+.1f} % at the lower bound and {:+.1f} % at the upper one",
                   energy_off_percent(*bounds.lower), energy_off_percent(*bounds.upper))
             : "as one factor on the whole force, which at the amplitude of the reported cycle is that of K_d and Q_d together; the law's parameters do not tell the two apart"});
  return facts;
}

std::string equations(laws::LawInfo const& law) {
  std::vector<std::string_view> lines;
  for (std::string_view text = law.formula; !text.empty();) lines.push_back(trimmed(take_part(text, '\n')));
  return joined(lines, ";  ");
}

std::vector<Fact> prediction_facts(Subject const& subject, UnitSystem const& units) {
  std::vector<Fact> result{{"Prediction", wording::remark(subject.doubts.prediction, units)}};
  auto const& objection = subject.doubts.objection;
  if (objection && *objection != subject.doubts.prediction)
    result.push_back({"Not for use", wording::remark(*objection, units)});
  return result;
}

std::vector<Fact> facts(Subject const& subject, Realisation const& realisation, UnitSystem const& units,
                        std::string_view program, bool one_factor) {
  auto const& law = subject.law->info;
  std::vector<Fact> result{
      {"SPDX-License-Identifier", std::string(export_licence)},
      {"Licence", std::string(export_licence_text)},
      {"Export", fmt::format("isolaw {}, for {}", subject.version, program)},
      {"Calibrated by", "isolaw " + subject.makers},
      {"Law", fmt::format("{}: {} ({})", law.id, law.title, law.source)},
      {"Equations", equations(law)},
      {"Parameters of",
       (subject.lot ? std::string("the lot (one law for all its devices)") : "device " + subject.device) +
           (subject.title.empty() ? "" : ", lot " + subject.title)},
      {"Parameters", fmt::format("{} (units of the law: {}, {}, s)", parameter_text(*subject.law, subject.parameters),
                                 law.force.symbol, law.length.symbol)}};
  for (auto& fact : measured_facts(subject)) result.push_back(std::move(fact));
  for (auto& fact : prediction_facts(subject, units)) result.push_back(std::move(fact));
  for (auto& warning : wording::sentences(subject.doubts.findings, wording::with_law, units))
    result.push_back({"Warning", std::move(warning)});
  result.push_back({"Units of this file", fmt::format("{}, {}, s", units.force.symbol, units.length.symbol)});
  result.push_back({"Fidelity", fmt::format("{}: {}", name(realisation.fidelity), realisation.explanation)});
  if (!realisation.substitute.empty())
    result.push_back({"Fitted in its place", fmt::format("{}: {}", realisation.substitute,
                                                         parameter_text(laws::find_law(realisation.substitute),
                                                                        realisation.substitute_parameters))});
  if (!realisation.substitute.empty() && !law_in_cpp(law.id).empty())
    result.push_back(
        {"The law itself",
         "--to openseespy-law brings it into OpenSeesPy; --to opensees-cpp writes it as a material of OpenSees, to compile"});
  for (auto& fact : replay_facts(subject, realisation, units)) result.push_back(std::move(fact));
  for (auto& fact : response_facts(subject, realisation.response, units)) result.push_back(std::move(fact));
  for (auto const& refused : realisation.refused) result.push_back({"Refused", refused});
  for (auto& fact : validity(subject, units)) result.push_back(std::move(fact));
  result.push_back(
      {"Beyond these",
       subject.fitted.part.empty()
           ? "nothing was tested, and the law is an extrapolation"
           : "where the tests went beyond what the law was fitted to, it is a prediction; beyond the tests it is an extrapolation"});
  for (auto& fact : away_facts(subject, realisation)) result.push_back(std::move(fact));
  for (auto& fact : bound_facts(subject, one_factor)) result.push_back(std::move(fact));
  for (auto const& note : subject.notes) result.push_back({"Note", note});
  return result;
}

std::vector<Fact> facts_of_the_law(Subject const& subject, UnitSystem const& units, std::string_view program,
                                   std::string explanation) {
  Realisation itself;
  itself.fidelity = Fidelity::exact;
  itself.explanation = std::move(explanation);
  return facts(subject, itself, units, program, true);
}

std::vector<std::string> fact_lines(std::vector<Fact> const& facts) {
  constexpr std::size_t width = 110;
  std::vector<std::string> lines;
  for (auto const& fact : facts) {
    auto rest = harmless(fact.label + ": " + fact.text);
    bool first = true;
    while (!rest.empty()) {
      auto const room = first ? width : width - 4;
      auto cut = rest.size();
      if (cut > room) {
        cut = rest.rfind(' ', room);
        if (cut == std::string::npos || cut < room / 2) cut = room;
        // Moves the cut behind the last byte of a UTF-8 character.
        while (cut < rest.size() && continues_character(rest[cut])) ++cut;
      }
      lines.push_back((first ? "" : "    ") + rest.substr(0, cut));
      rest.erase(0, cut);
      rest.erase(0, std::min(rest.find_first_not_of(' '), rest.size()));
      first = false;
    }
  }
  return lines;
}

}  // namespace isolaw::programs
