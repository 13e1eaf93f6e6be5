#include "isolaw/programs/cpp_form.hpp"

#include <fmt/format.h>

#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/programs/header_parts.hpp"
#include "isolaw/programs/self_check.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {
namespace {

// Makes a C++ name from a parameter's name: "Kb+" becomes Kb_p.
std::string member(std::string_view name) {
  std::string plain;
  for (char const c : name) plain += c == '+' ? std::string("_p") : c == '-' ? std::string("_m") : std::string(1, c);
  return plain;
}

std::string parameters_struct(Subject const& subject) {
  std::string text = fmt::format("// In the law's own units: {}, {}, s.\nstruct Parameters {{\n",
                                 subject.law->info.force.symbol, subject.law->info.length.symbol);
  for (std::size_t i = 0; i < subject.parameters.size(); ++i) {
    auto const& p = subject.law->parameters[i];
    text += fmt::format("  double {} = {};  // {}: {}\n", member(p.name), exact_text(subject.parameters[i]), p.unit,
                        p.meaning);
  }
  if (subject.law->info.traits.remembers)
    text += fmt::format("  double dead_band = {};  // {}: the law ignores movements within plus or minus this value\n",
                        exact_text(subject.dead_band_mm / subject.law->info.length.in_record_units),
                        subject.law->info.length.symbol);
  return text + "};\n";
}

std::string constants(Subject const& subject, UnitSystem const& units) {
  auto const& law = subject.law->info;
  std::string text = fmt::format(
      "inline constexpr double length_to_law = {};  // {} of the law per {} of the program\n"
      "inline constexpr double force_from_law = {};  // {} of the program per {} of the law\n"
      "inline constexpr int substeps = {};  // parts into which the law divides each step, as in the fit\n"
      "inline constexpr double nominal = 1.0;  // a factor on the force, as are the bounds\n",
      exact_text(units.length.in_record_units / law.length.in_record_units), law.length.symbol, units.length.symbol,
      exact_text(law.force.in_record_units / units.force.in_record_units), units.force.symbol, law.force.symbol,
      subject.refinement);
  if (subject.bounds.lower)
    text += fmt::format("inline constexpr double lower = {};\n", exact_text(subject.bounds.lower->overall));
  if (subject.bounds.upper)
    text += fmt::format("inline constexpr double upper = {};\n", exact_text(subject.bounds.upper->overall));
  return text;
}

// Returns lines of the self-check that compare the factors in the file with those that isolaw wrote, in case a user
// edited them.
std::string bounds_check(Subject const& subject, UnitSystem const& units) {
  auto const space = identifier(subject, units);
  std::string rows;
  for (auto const& [name, bound] : {std::pair("lower", &subject.bounds.lower), {"upper", &subject.bounds.upper}})
    if (*bound) rows += fmt::format(", {{{}::{}, {}}}", space, name, exact_text((*bound)->overall));
  return fmt::format(R"text(  // Each factor of this file, and its value as isolaw wrote it.
  double const factors[][2] = {{{{{0}::nominal, 1.0}}{1}}};
  for (auto const& factor : factors)
    if (!(std::abs(factor[0] - factor[1]) <= {2} * factor[1])) {{
      std::printf("the factor of a bound was changed: %.10g in place of %.10g\n", factor[0], factor[1]);
      numbers = false;
    }}
)text",
                     space, rows, exact_text(check_tolerance));
}

}  // namespace

std::string cpp_law(Subject const& subject, UnitSystem const& units) {
  auto const code = law_in_cpp(subject.law->info.id);
  if (code.empty())
    throw Error({.where = "law " + std::string(subject.law->info.id),
                 .found = "no C++ form of it",
                 .allowed = "another target"});
  // The name of the inline namespace is unique to the file (own_number_mark). Two exports of the same name that are
  // compiled separately therefore share no symbols.
  auto const space = identifier(subject, units);
  std::string text = fmt::format(
      "#include <algorithm>\n#include <cmath>\n#include <cstddef>\n#include <vector>\n\nnamespace {} {{\ninline namespace of_{} {{\n\n",
      space, own_number_mark);
  text += parameters_struct(subject) + "\n" + constants(subject, units) + "\n" + code;
  return text + fmt::format("}}  // inline namespace\n}}  // namespace {}\n", space);
}

std::string guarded(std::string_view name, std::string_view code) {
  return fmt::format(
      "#ifndef {0}_FILE\n#define {0}_FILE {1}\n\n{2}\n#elif {0}_FILE != {1}\n"
      "#error \"Another export of the name {0} is included already: choose a name for one of them by --name of isolaw export\"\n"
      "#endif\n",
      name, own_number_mark, code);
}

std::string cpp_check(Subject const& subject, UnitSystem const& units, std::string_view material) {
  auto const check = law_check(subject, units);
  return fmt::format(
      R"text(
#ifdef ISOLAW_SELF_CHECK
#include <cstdio>

int main() {{
  // The motion of the check, and the force that the law must give along it.
  double const disp[] = {{
{0}
  }};
  double const velocity[] = {{
{1}
  }};
  double const expected[] = {{
{2}
  }};
  {3}::{4} material;
  double largest = 0.0, peak = 0.0;
  bool numbers = true;
  for (std::size_t i = 0; i < sizeof(disp) / sizeof(disp[0]); ++i) {{
    material.trial(1.1 * disp[i], velocity[i]);  // a trial without commit() must not change the state
    double const force = material.trial(disp[i], velocity[i]);
    material.commit();
    numbers = numbers && force == force;
    peak = std::max(peak, std::abs(expected[i]));
    largest = std::max(largest, std::abs(force - expected[i]));
  }}
{7}  bool const pass = numbers && peak > 0.0 && largest <= {5} * peak;
  std::printf("isolaw {6}: largest difference %.3g of the peak force (allowed {5}): %s\n", largest / peak,
              pass ? "PASS" : "FAIL");
  return pass ? 0 : 1;
}}
#endif
)text",
      number_lines(check.disp, ", ", "      "), number_lines(check.velocity, ", ", "      "),
      number_lines(check.force, ", ", "      "), identifier(subject, units), material, exact_text(check_tolerance),
      subject.law->info.id, bounds_check(subject, units));
}

std::string cpp_facts(Subject const& subject, UnitSystem const& units, std::string_view program) {
  std::string text;
  for (auto const& line : fact_lines(
           facts_of_the_law(subject, units, program,
                            "the law itself, computed as isolaw computes it, one step for each step of the analysis")))
    text += "// " + line + "\n";
  return text + "//\n";
}

}  // namespace isolaw::programs
