#include "isolaw/programs/self_check.hpp"

#include <fmt/format.h>

#include "isolaw/laws/online/online.hpp"

namespace isolaw::programs {
namespace {

std::vector<double> as_written(std::vector<double> const& values_mm, UnitSystem const& units) {
  std::vector<double> values;
  for (double const v : values_mm) values.push_back(std::stod(fmt::format("{:.10g}", units.from_mm(v))));
  return values;
}

}  // namespace

std::string tags_text(Form const& form) {
  auto const inner = form.commands.size() - 1;
  if (inner == 0) return {};
  return inner == 1 ? "uses the tag after the given one too"
                    : fmt::format("uses the {} tags after the given one too", inner);
}

LawCheck law_check(Subject const& subject, UnitSystem const& units) {
  LawCheck check{as_written(subject.protocol.disp_mm, units), as_written(subject.protocol.vel_mm_s, units), {}};
  auto const& law = subject.law->info;
  double const to_law = units.length.in_record_units / law.length.in_record_units;
  laws::Online device(law.id, subject.parameters, subject.dead_band_mm / law.length.in_record_units,
                      subject.refinement);
  for (std::size_t i = 0; i < check.disp.size(); ++i) {
    check.force.push_back(units.from_kN(device.trial(check.disp[i] * to_law, check.velocity[i] * to_law).force *
                                        law.force.in_record_units));
    device.commit();
  }
  return check;
}

SelfCheck self_check(Subject const& subject, Realisation const& realisation, UnitSystem const& units) {
  SelfCheck check;
  check.disp = as_written(subject.protocol.disp_mm, units);
  for (double const f : subject.protocol.law_kN) check.law.push_back(units.from_kN(f));
  for (auto const& realised : realisation.forms) {
    CheckedForm form{.form = &realised.nominal, .function = realised.nominal.id, .is_element = false, .variants = {}};
    form.is_element = form.function == "bearing";
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
