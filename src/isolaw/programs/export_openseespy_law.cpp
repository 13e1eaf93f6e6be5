// Writes a Python module that adds the law itself to OpenSeesPy by isolaw.opensees. Running the module does its
// self-check in OpenSees.
#include <fmt/format.h>

#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/self_check.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {
std::string openseespy_law(Subject const& subject, UnitSystem const& units) {
  auto const check = law_check(subject, units);
  std::string text;
  for (auto const& line : fact_lines(
           facts_of_the_law(subject, units, "OpenSeesPy with isolaw",
                            "the law itself, computed as isolaw computes it, one step for each step of the analysis")))
    text += "# " + line + "\n";
  text +=
      "#\n# To use:   with isolaw's Python package and openseespy: import this module; material(1) or material(1, \"upper\").\n"
      "#           isolaw.opensees.section is the law in two directions, in one element.\n"
      "# To check: python3 this-file (exit code 0 where all agree)\n\n"
      "import openseespy.opensees as ops\nimport isolaw.opensees\n\nPARAMETERS = {\n";
  for (std::size_t i = 0; i < subject.parameters.size(); ++i) {
    auto const& p = subject.law->parameters[i];
    text += fmt::format("    \"{}\": {},  # {}: {}\n", p.name, exactly(subject.parameters[i]), p.unit, p.meaning);
  }
  text += "}\n# Factors on the force.\nBOUNDS = {\"nominal\": 1.0";
  if (subject.bounds.lower) text += fmt::format(", \"lower\": {}", exactly(subject.bounds.lower->overall));
  if (subject.bounds.upper) text += fmt::format(", \"upper\": {}", exactly(subject.bounds.upper->overall));
  text += fmt::format(R"python(}}


def material(tag, variant="nominal"):
    """The law as a uniaxial material: force over displacement."""
    isolaw.opensees.material(
        tag, "{0}", PARAMETERS, bound=BOUNDS[variant], units=("{1}", "{2}"), dead_band_mm={3}, refinement={4}
    )


# The motion of the self-check, and the force of the law along it.
DISP = [
{5}
]
VELOCITY = [
{6}
]
EXPECTED = [
{7}
]


def self_check():
    """Moves a material of each variant along the motion. What there was is wiped. True where all forces agree."""
    allowed = {8}  # of the peak force
    everything = True
    for variant, factor in BOUNDS.items():
        ops.wipe()
        material(1, variant)
        ops.testUniaxialMaterial(1)
        got = []
        for disp, velocity in zip(DISP, VELOCITY):
            ops.setStrain(disp, velocity)
            got.append(ops.getStress())
        peak = factor * max(abs(force) for force in EXPECTED)
        worst = max(abs(force - factor * expected) for force, expected in zip(got, EXPECTED))
        passed = all(force == force for force in got) and worst <= allowed * peak
        print(
            f"isolaw {0} {{variant}}: largest difference {{worst / peak:.3g}} of the peak force (allowed {{allowed:g}}): "
            + ("PASS" if passed else "FAIL")
        )
        everything = everything and passed
    ops.wipe()
    return everything


if __name__ == "__main__":
    import sys

    sys.exit(0 if self_check() else 1)
)python",
                      subject.law->info.id, units.force.symbol, units.length.symbol, exactly(subject.dead_band_mm),
                      subject.refinement, number_lines(check.disp, ", ", "    "), number_lines(check.velocity, ", ", "    "),
                      number_lines(check.force, ", ", "    "), exactly(check_tolerance));
  return text;
}

}  // namespace isolaw::programs
