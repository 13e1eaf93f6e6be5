// Writes a Python module that adds the law itself to OpenSeesPy by isolaw.opensees. Running the module does its
// self-check in OpenSees.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <ranges>
#include <utility>

#include "isolaw/base/words.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/model_text.hpp"
#include "isolaw/programs/self_check.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {
namespace {

// Returns the items of a Python dict: for each variant (nominal, lower and upper bound) the largest force along the
// motion of the self-check.
std::string peaks(Subject const& subject, LawCheck const& check) {
  double nominal = 0.0;
  for (double const force : check.force) nominal = std::max(nominal, std::abs(force));
  auto text = fmt::format("\"nominal\": {}", exact_text(nominal));
  for (auto const& [name, bound] : {std::pair("lower", &subject.bounds.lower), {"upper", &subject.bounds.upper}})
    if (*bound) text += fmt::format(", \"{}\": {}", name, exact_text((*bound)->overall * nominal));
  return text;
}

}  // namespace

std::string law_in_python(Subject const& subject, UnitSystem const& units, std::string_view prefix) {
  auto const check = law_check(subject, units);
  std::string capitals(prefix);
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  auto text = capitals + "PARAMETERS = {\n";
  for (std::size_t i = 0; i < subject.parameters.size(); ++i) {
    auto const& p = subject.law->parameters[i];
    text += fmt::format("    \"{}\": {},  # {}: {}\n", p.name, exact_text(subject.parameters[i]), p.unit, p.meaning);
  }
  text += fmt::format("}}\n# Factors on the force.\n{}BOUNDS = {{\"nominal\": 1.0", capitals);
  if (subject.bounds.lower) text += fmt::format(", \"lower\": {}", exact_text(subject.bounds.lower->overall));
  if (subject.bounds.upper) text += fmt::format(", \"upper\": {}", exact_text(subject.bounds.upper->overall));
  text += "}\n";
  bool const drawn = subject.model && !subject.model->draws.empty();
  if (drawn) {
    text += fmt::format("# Parameters of the drawn laws, in the order of {0}PARAMETERS.\n{0}DRAWN = {{\n", capitals);
    auto const& draws = subject.model->draws;
    for (std::size_t d = 0; d < draws.size(); ++d)
      for (std::size_t b = 0; b < draws[d].size(); ++b)
        text += fmt::format("    \"{}\": ({},),\n", drawn_variant(d + 1, b + 1),
                            joined(draws[d][b] | std::views::transform(exact_text)));
    text += "}\n";
  }
  return text +
         fmt::format(
             R"python(

def {prefix}arguments(variant="nominal"):
    """Returns the arguments of isolaw.opensees.material and section for a variant: nominal, lower, upper{or_draw}."""
    return {{
        "law": "{id}", "source": {source}, "bound": {bound},
        "units": ("{force}", "{length}"), "dead_band_mm": {dead_band}, "refinement": {refinement},
    }}


def {prefix}material(tag, variant="nominal"):
    """Makes a uniaxial material of the law: force over displacement."""
    isolaw.opensees.material(tag, **{prefix}arguments(variant))


# The motion of the self-check, the nominal force of the law along it, and the peak force of each variant.
{capitals}DISP = [
{disp}
]
{capitals}VELOCITY = [
{velocity}
]
{capitals}EXPECTED = [
{expected}
]
{capitals}PEAKS = {{{peaks}}}


def {prefix}self_check():
    """Wipes the model and moves a material of each variant along the motion. Returns whether all forces agree."""
    allowed = {tolerance}  # of the peak force
    everything = True
    for variant in {capitals}BOUNDS:
        ops.wipe()
        {prefix}material(1, variant)
        ops.testUniaxialMaterial(1)
        got = []
        for disp, velocity in zip({capitals}DISP, {capitals}VELOCITY):
            ops.setStrain(disp, velocity)
            got.append(ops.getStress())
        peak = {capitals}PEAKS[variant]
        factor = peak / max(abs(force) for force in {capitals}EXPECTED)
        worst = max(abs(force - factor * expected) for force, expected in zip(got, {capitals}EXPECTED))
        passed = all(force == force for force in got) and worst <= allowed * peak
        print(
            f"isolaw {id} {{variant}}: largest difference {{worst / peak:.3g}} of the peak force (allowed {{allowed:g}}): "
            + ("PASS" if passed else "FAIL")
        )
        everything = everything and passed
    ops.wipe()
    return everything


)python",
             fmt::arg("prefix", prefix), fmt::arg("capitals", capitals), fmt::arg("or_draw", drawn ? " or a draw" : ""),
             fmt::arg("source",
                      !drawn
                          ? capitals + "PARAMETERS"
                          : fmt::format(
                                "dict(zip({0}PARAMETERS, {0}DRAWN[variant])) if variant in {0}DRAWN else {0}PARAMETERS",
                                capitals)),
             fmt::arg("bound", capitals + (drawn ? "BOUNDS.get(variant, 1.0)" : "BOUNDS[variant]")),
             fmt::arg("id", subject.law->info.id), fmt::arg("force", units.force.symbol),
             fmt::arg("length", units.length.symbol), fmt::arg("dead_band", exact_text(subject.dead_band_mm)),
             fmt::arg("refinement", subject.refinement), fmt::arg("disp", number_lines(check.disp, ", ", "    ")),
             fmt::arg("velocity", number_lines(check.velocity, ", ", "    ")),
             fmt::arg("expected", number_lines(check.force, ", ", "    ")), fmt::arg("peaks", peaks(subject, check)),
             fmt::arg("tolerance", exact_text(check_tolerance)));
}

std::string openseespy_law(Subject const& subject, UnitSystem const& units) {
  std::string text;
  for (auto const& line : fact_lines(
           facts_of_the_law(subject, units, "OpenSeesPy with isolaw",
                            "the law itself, computed as isolaw computes it, one step for each step of the analysis")))
    text += "# " + line + "\n";
  return text +
         "#\n# To use:   with isolaw's Python package and openseespy: import this module; material(1) or material(1, \"upper\").\n"
         "#           isolaw.opensees.section makes the law in two directions, for one element.\n"
         "# To check: python3 this-file (exit code 0 where all agree)\n\n"
         "import openseespy.opensees as ops\nimport isolaw.opensees\n\n" +
         law_in_python(subject, units, "") +
         "if __name__ == \"__main__\":\n    import sys\n\n    sys.exit(0 if self_check() else 1)\n";
}

}  // namespace isolaw::programs
