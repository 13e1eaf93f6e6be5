// C++17: a header that needs the standard library alone, with the law itself as a material of trial, commit and revert.
#include <fmt/format.h>

#include <cctype>

#include "isolaw/base/error.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/header_parts.hpp"
#include "isolaw/programs/self_check.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {
namespace {

// "Kb+" is Kb_p.
std::string member(std::string_view name) {
  std::string made;
  for (char const c : name) made += c == '+' ? std::string("_p") : c == '-' ? std::string("_m") : std::string(1, c);
  return made;
}

std::string parameters_struct(Subject const& subject) {
  std::string text = fmt::format("// In the law's own units: {}, {}, s.\nstruct Parameters {{\n",
                                 subject.law->info.force.symbol, subject.law->info.length.symbol);
  for (std::size_t i = 0; i < subject.parameters.size(); ++i) {
    auto const& p = subject.law->parameters[i];
    text += fmt::format("  double {} = {};  // {}: {}\n", member(p.name), exactly(subject.parameters[i]), p.unit,
                        p.meaning);
  }
  return text + "};\n";
}

std::string constants(Subject const& subject, UnitSystem const& units) {
  auto const& law = subject.law->info;
  std::string text = fmt::format(
      "inline constexpr double length_to_law = {};  // {} per {} of the program\n"
      "inline constexpr double force_from_law = {};  // {} of the program per {}\n"
      "inline constexpr int substeps = {};  // of a step, as the law was integrated when it was identified\n"
      "inline constexpr double nominal = 1.0;  // factors on the force\n",
      exactly(units.length.in_record_units / law.length.in_record_units), law.length.symbol, units.length.symbol,
      exactly(law.force.in_record_units / units.force.in_record_units), units.force.symbol, law.force.symbol,
      subject.refinement);
  if (law.traits.remembers)
    text += fmt::format("inline constexpr double dead_band = {};  // {}: motion within it to both sides is none\n",
                        exactly(subject.dead_band_mm / law.length.in_record_units), law.length.symbol);
  if (subject.bounds.lower)
    text += fmt::format("inline constexpr double lower = {};\n", exactly(subject.bounds.lower->overall));
  if (subject.bounds.upper)
    text += fmt::format("inline constexpr double upper = {};\n", exactly(subject.bounds.upper->overall));
  return text;
}

std::string check(Subject const& subject, UnitSystem const& units) {
  std::vector<double> disp, velocity, force;
  for (double const x : subject.protocol.disp_mm) disp.push_back(units.from_mm(x));
  for (double const v : subject.protocol.vel_mm_s) velocity.push_back(units.from_mm(v));
  for (double const f : subject.protocol.law_kN) force.push_back(units.from_kN(f));
  return fmt::format(
      R"text(
#ifdef ISOLAW_SELF_CHECK
#include <cstdio>

int main() {{
  // Two cycles at {:.4g} Hz, at half and at the whole tested amplitude, and the force of the law.
  double const disp[] = {{
{}
  }};
  double const velocity[] = {{
{}
  }};
  double const expected[] = {{
{}
  }};
  {}::Material material;
  double largest = 0.0, peak = 0.0;
  bool numbers = true;
  for (std::size_t i = 0; i < sizeof(disp) / sizeof(disp[0]); ++i) {{
    material.trial(1.1 * disp[i], velocity[i]);  // a trial that is not kept must leave nothing behind
    double const force = material.trial(disp[i], velocity[i]);
    material.commit();
    numbers = numbers && force == force;
    peak = std::max(peak, std::abs(expected[i]));
    largest = std::max(largest, std::abs(force - expected[i]));
  }}
  bool const pass = numbers && peak > 0.0 && largest <= 1e-6 * peak;
  std::printf("isolaw {}: largest difference %.3g of the peak force (allowed 1e-06): %s\n", largest / peak,
              pass ? "PASS" : "FAIL");
  return pass ? 0 : 1;
}}
#endif
)text",
      subject.frequency_Hz, number_lines(disp, ", ", "      "), number_lines(velocity, ", ", "      "),
      number_lines(force, ", ", "      "), identifier(subject), subject.law->info.id);
}

}  // namespace

std::string cpp_header(Subject const& subject, UnitSystem const& units) {
  auto const parts = header_parts(subject.law->info.id);
  if (parts.empty())
    throw Error({.where = "law " + std::string(subject.law->info.id),
                 .found = "no C++ form of it",
                 .allowed = "another target"});
  auto const space = identifier(subject);
  auto const all =
      facts_of_the_law(subject, units, "C++17",
                       "the law itself, computed as isolaw computes it, one step for each step of the analysis");

  std::string text;
  for (auto const& line : fact_lines(all)) text += "// " + line + "\n";
  text += fmt::format(
      "//\n// To use, in a user material: {0}::Material m(nominal, or lower or upper);\n"
      "//   setTrialStrain(u, v): m.trial(u, v)   getStress: m.force()   getTangent: m.tangent()   getDampTangent: m.damping()\n"
      "//   commitState: m.commit()   revertToLastCommit: m.revert()   revertToStart: m.revert_to_start()   copy: by value\n"
      "//   {1}\n"
      "// To check: c++ -std=c++17 -DISOLAW_SELF_CHECK -x c++ this-file -o check && ./check\n"
      "#ifndef {2}_HPP\n#define {2}_HPP\n\n#include <algorithm>\n#include <cmath>\n#include <cstddef>\n#include <vector>\n\n"
      "namespace {0} {{\n\n",
      space,
      subject.law->info.traits.rate_independent ? "The law does not depend on the velocity."
                                                : "The law depends on the velocity: the element must pass it on.",
      [&] {
        auto guard = space;
        for (char& c : guard) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        return guard;
      }());
  text += parameters_struct(subject) + "\n" + constants(subject, units) + "\n";
  text += std::string(header_numbers()) + "\n";
  for (auto const part : parts) text += std::string(part) + "\n";
  text += std::string(header_material()) + fmt::format("\n}}  // namespace {}\n\n#endif\n", space);
  return text + check(subject, units);
}

}  // namespace isolaw::programs
