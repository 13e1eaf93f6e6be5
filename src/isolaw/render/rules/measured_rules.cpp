#include "isolaw/render/rules/measured_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "isolaw/base/printable.hpp"
#include "isolaw/base/version.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw::render {
namespace {

using conditions::Effect;
using conditions::Factor;
using conditions::Status;

template <class... Args>
void add_text(std::string& text, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
}

std::string id_of(std::string_view name) {
  std::string id;
  for (char const c : lower(name)) id += is_letter(c) || is_digit(c) ? c : '-';
  constexpr std::size_t longest = 64;
  id.resize(std::min(id.size(), longest));
  return id.find_first_not_of('-') == std::string::npos ? "measured" : id;
}

// Returns the design condition of an effect as text, such as "from -20 to 40 C".
std::string design_of(study::ConditionsResult const& result, Effect effect) {
  auto const& design = result.stated.design;
  auto const range = [](std::optional<campaign::ConditionRange> const& of, std::string_view unit) {
    if (!of) return std::string();
    return of->low == of->high ? fmt::format("at {:g} {}", of->low, unit)
                               : fmt::format("from {:g} to {:g} {}", of->low, of->high, unit);
  };
  switch (effect) {
    case Effect::temperature:
      return range(design.temperature_C, "C");
    case Effect::rate:
      return range(design.frequency_Hz, "Hz");
    case Effect::load:
      return range(design.load_kN, "kN");
    case Effect::ageing:
      if (design.aged) return fmt::format("of {:g} days at {:g} C", design.aged->days, design.aged->at_C);
      if (design.years && design.service_temperature_C)
        return fmt::format("of {:g} years at {:g} C", *design.years, *design.service_temperature_C);
      return {};
    case Effect::scragging:
      return design.rest_h ? fmt::format("after {:g} h of rest", *design.rest_h) : "of a new device";
    case Effect::cycles:
      return design.cycles ? fmt::format("up to cycle {}", *design.cycles) : "";
    case Effect::contamination:
    case Effect::environment:
      break;
  }
  return {};
}

bool rests_on_tests(Factor const& factor) {
  return factor.status != Status::assumed && factor.status != Status::not_covered;
}

std::string status_of(Factor const& factor) {
  if (factor.devices == 0) return "reference";
  return fmt::format("{} on {}", name(factor.status), counted(static_cast<std::size_t>(factor.devices), "device"));
}

// Returns whether the measured factor of an effect depends on this test. This is so if the test was made for the
// effect, or if it is the reference test of a device that also has a test for the effect. Scragging and the effect of
// cycles are measured in reference tests alone.
bool is_behind(study::ConditionsResult const& result, Effect effect, study::ConditionsTest const& test) {
  if (test.role == study::TestRole::effect) return test.effect == effect;
  if (test.role != study::TestRole::reference) return false;
  return std::ranges::any_of(result.levels, [&](study::LevelRow const& row) {
    return row.effect == effect &&
           std::ranges::find(row.ratios, test.device, &conditions::DeviceRatio::device) != row.ratios.end();
  });
}

void add_tests_behind(std::string& text, study::ConditionsResult const& result, Effect effect) {
  constexpr std::size_t short_hash = 12;
  std::vector<std::string> done;  // hashes of records already written: each block of a record is a test of its own here
  for (auto const& test : result.tests) {
    if (!is_behind(result, effect, test) || std::ranges::find(done, test.sha256) != done.end()) continue;
    done.push_back(test.sha256);
    add_text(text, "#   {}, {}: {}\n", printable(test.device), printable(test.test), test.sha256.substr(0, short_hash));
  }
}

}  // namespace

std::string measured_rules(study::ConditionsResult const& result, std::string_view name) {
  auto const& reference = result.stated.reference;
  auto const& at = result.reference;
  auto text = fmt::format(
      "# Factors on properties of devices, measured by isolaw {}: value under the design conditions over value at\n"
      "# reference. They hold for devices of the type that was tested.\n# Lot: {}\n# Reference: {:g} C",
      version(), printable(result.title), reference.temperature_C);
  if (at.frequency_Hz) add_text(text, ", {:.6g} Hz", *at.frequency_Hz);
  if (at.load_kN) add_text(text, ", {:.6g} kN", *at.load_kN);
  if (at.strain_percent)
    add_text(text, ", {} {:.6g} {}", reference.disp_mm ? "amplitude" : "strain", *at.strain_percent,
             reference.disp_mm ? "mm" : "%");
  bool const one = reference.first_cycle == reference.last_cycle;
  add_text(
      text,
      "\n\nid = \"{}\"\ntitle = \"Measured factors\"\nedition = \"isolaw {}\"\nsource = \"the tests that the comments name\"\n"
      "verified_by = \"\"                    # nobody has compared this file with the tests\n\n"
      "[formulas]\nstiffness = \"peak_to_peak\"\ndamping = \"peak_to_peak\"\n\n[cycles]\n",
      id_of(name), version());
  if (one)
    add_text(text, "one = {}\n", reference.first_cycle);
  else
    add_text(text, "mean_of = [{}, {}]\n", reference.first_cycle, reference.last_cycle);
  // The file does not say how factors are combined if the form is "asce", because that form needs numbers from other
  // tables of its rule set, which the new file does not have.
  if (auto const& how = result.combination; how.form != rules::Form::asce) {
    add_text(text, "\n[combination]\nform = \"{}\"\n", rules::name(how.form));
    if (how.form == rules::Form::sum)
      add_text(text, "margin = {:.9g}\n", how.margin);
    else
      add_text(text, "adjust = {:.9g}\n", how.adjust);
    add_text(text, "clause = \"as {}\"\n", how.rules.empty() ? "isolaw's own rule" : "the rule set " + how.rules);
  }
  for (auto const effect : rules::effects()) {
    std::vector<study::DesignRow const*> rows;
    std::vector<std::string> left_out;
    for (auto const& row : result.design) {
      // The factor of damping follows from those of K_eff and energy, so rule files have none.
      if (row.effect != effect || row.quantity == rules::Quantity::damping) continue;
      if (rests_on_tests(row.max) && rests_on_tests(row.min))
        rows.push_back(&row);
      else
        left_out.emplace_back(rules::name(row.quantity));
    }
    if (!left_out.empty())
      add_text(text, "\n# {} {}: no test covers the factors of {}.\n", rules::name(effect), design_of(result, effect),
               joined(left_out));
    if (rows.empty()) continue;
    add_text(text, "\n# {} {}. Device, test, and the first digits of the record's SHA-256:\n", rules::name(effect),
             design_of(result, effect));
    add_tests_behind(text, result, effect);
    for (auto const* row : rows)
      add_text(text,
               "[[effect]]\nname = \"{}\"\nquantity = \"{}\"\ndefault_max = {:.9g}\ndefault_min = {:.9g}\n"
               "clause = \"measured; largest: {}, smallest: {}\"\n\n",
               rules::name(effect), rules::name(row->quantity), row->max.lambda(), row->min.lambda(),
               status_of(row->max), status_of(row->min));
    text.pop_back();
  }
  return text;
}

}  // namespace isolaw::render
