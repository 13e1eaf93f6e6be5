// Writes a Python module that adds the law itself to OpenSeesPy by isolaw.opensees. Running the module does its
// self-check in OpenSees.
#include <fmt/format.h>

#include "isolaw/laws/online/online.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/self_check.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {
namespace {

// The force along the self-check's motion, as the library of isolaw.opensees computes it, in the units of the file.
std::vector<double> online_force(Subject const& subject, std::vector<double> const& disp,
                                 std::vector<double> const& velocity, UnitSystem const& units) {
  auto const& law = subject.law->info;
  double const to_law = units.length.in_record_units / law.length.in_record_units;
  laws::Online device(law.id, subject.parameters, subject.dead_band_mm / law.length.in_record_units,
                      subject.refinement);
  std::vector<double> force;
  for (std::size_t i = 0; i < disp.size(); ++i) {
    force.push_back(
        units.from_kN(device.trial(disp[i] * to_law, velocity[i] * to_law).force * law.force.in_record_units));
    device.commit();
  }
  return force;
}

}  // namespace

std::string openseespy_law(Subject const& subject, UnitSystem const& units) {
  auto const written = [&](std::vector<double> const& values_mm) {
    std::vector<double> values;
    for (double const x : values_mm) values.push_back(std::stod(fmt::format("{:.10g}", units.from_mm(x))));
    return values;
  };
  auto const disp = written(subject.protocol.disp_mm), velocity = written(subject.protocol.vel_mm_s);
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
    allowed = 1e-8  # of the peak force
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
                      subject.refinement, number_lines(disp, ", ", "    "), number_lines(velocity, ", ", "    "),
                      number_lines(online_force(subject, disp, velocity, units), ", ", "    "));
  return text;
}

}  // namespace isolaw::programs
