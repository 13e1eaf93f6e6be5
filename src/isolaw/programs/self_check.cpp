#include "isolaw/programs/self_check.hpp"

#include <fmt/format.h>

namespace isolaw::programs {
namespace {

std::vector<double> as_written(std::vector<double> values) {
  for (double& v : values) v = std::stod(fmt::format("{:.10g}", v));
  return values;
}

}  // namespace

std::string tags_text(Form const& form) {
  auto const inner = form.commands.size() - 1;
  if (inner == 0) return {};
  return inner == 1 ? "uses the tag after the given one too"
                    : fmt::format("uses the {} tags after the given one too", inner);
}

SelfCheck self_check(Subject const& subject, Realisation const& realisation, UnitSystem const& units) {
  SelfCheck check;
  for (double const x : subject.protocol.disp_mm) check.disp.push_back(units.from_mm(x));
  check.disp = as_written(std::move(check.disp));
  for (double const f : subject.protocol.law_kN) check.law.push_back(units.from_kN(f));
  for (auto const& realised : realisation.forms) {
    CheckedForm form{.form = &realised.nominal, .function = realised.nominal.id, .is_element = false, .variants = {}};
    form.is_element = form.function == "bearing";
    // An iteration leaves an error up to its tolerance at every step, and these errors add up.
    if (realised.nominal.exactness == Exactness::small_steps) form.tolerance = 1e-5;
    auto const add = [&](std::string name, Form const& variant) {
      auto commands = in_units(variant, units);
      auto force = replay(commands, check.disp);
      auto tags = tags_of(commands);
      form.variants.push_back({std::move(name), std::move(commands), std::move(tags), std::move(force)});
    };
    add("nominal", realised.nominal);
    if (realised.lower) add("lower", *realised.lower);
    if (realised.upper) add("upper", *realised.upper);
    for (auto const& [name, drawn] : realised.draws) add(name, drawn);
    check.forms.push_back(std::move(form));
  }
  return check;
}

std::string number_lines(std::vector<double> const& values, std::string_view separator, std::string_view indent) {
  constexpr std::size_t per_line = 8;
  std::string text;
  auto const line_end = separator.substr(0, separator.find_last_not_of(' ') + 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    bool const first = i % per_line == 0, last = (i + 1) % per_line == 0;
    if (first) text += fmt::format("{}{}", i == 0 ? "" : "\n", indent);
    text += fmt::format("{:.10g}{}", values[i], i + 1 == values.size() ? "" : last ? line_end : separator);
  }
  return text;
}

}  // namespace isolaw::programs
