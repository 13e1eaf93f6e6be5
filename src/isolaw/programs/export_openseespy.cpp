// Writes the law as an OpenSeesPy module with the functions of the Tcl script. Running the module does its self-check.
#include <fmt/format.h>

#include <ranges>

#include "isolaw/base/words.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/script_addition.hpp"
#include "isolaw/programs/self_check.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {
namespace {

std::string function(CheckedForm const& form) {
  auto const tags = tags_text(*form.form);
  std::string text = form.is_element ? std::string("def bearing(tag, i, j, variant, *rest):\n")
                                     : fmt::format("def {}(tag, variant=\"nominal\"):\n", form.function);
  text += fmt::format("    \"\"\"{}: {}{}\"\"\"\n", form.form->title, argument_names(*form.form),
                      form.is_element ? "; rest: '-P', 1, '-Mz', 2 and so on"
                      : tags.empty()  ? ""
                                      : "; " + tags);
  for (auto const& variant : form.variants) {
    text += fmt::format("    if variant == \"{}\":\n", variant.name);
    for (std::size_t i = 0; i < variant.commands.size(); ++i) {
      auto const& command = variant.commands[i];
      if (form.is_element) {
        text += fmt::format("        ops.element(\"{}\", tag, i, j{}, *rest{})\n", command.name,
                            argument_values(command, ", "), element_options(command, ", ", "\""));
        continue;
      }
      auto const tag = [](std::size_t above) {
        return above == 0 ? std::string("tag") : fmt::format("tag + {}", above);
      };
      text += fmt::format("        ops.uniaxialMaterial(\"{}\", {}", command.name, tag(variant.tags[i].own));
      for (auto const inner : variant.tags[i].inner) text += ", " + tag(inner);
      text += argument_values(command, ", ") + ")\n";
    }
    text += "        return\n";
  }
  return text + fmt::format("    raise ValueError(f\"no variant {{variant!r}}; there is: {}\")\n\n\n",
                            joined(form.variants | std::views::transform(&CheckedVariant::name)));
}

}  // namespace

std::string openseespy_script(Subject const& subject, Realisation const& realisation, UnitSystem const& units,
                              ScriptAddition const& addition) {
  auto const check = self_check(subject, realisation, units);
  std::string text;
  for (auto const& line : fact_lines(facts(subject, realisation, units, "OpenSeesPy"))) text += "# " + line + "\n";
  for (auto const& line : fact_lines(addition.facts)) text += "# " + line + "\n";
  text += fmt::format(
      "#\n# To use:   import this module; {0}(1) or {0}(1, \"upper\")\n"
      "# To check: python3 this-file (exit code 0 where all agree)\n{1}\n"
      "try:\n    import openseespy.opensees as ops\nexcept ImportError:  # your own build of OpenSees\n    import opensees as ops\n\n\n",
      check.forms.front().function, addition.usage);
  text += addition.head;
  for (auto const& form : check.forms) text += function(form);
  text += fmt::format(
      "# Displacements of the self-check, and the force of the law itself along them.\nDISP = [\n{}\n]\nLAW = [\n{}\n]\n",
      number_lines(check.disp, ", ", "    "), number_lines(check.law, ", ", "    "));
  text += fmt::format(
      "# Forces that OpenSees must give, which isolaw computed by the same algorithm: function, variant, forces.\n"
      "ALLOWED = {}  # largest difference, as a share of the peak force\nEXPECTED = [\n",
      exact_text(check_tolerance));
  for (auto const& form : check.forms) {
    for (auto const& variant : form.variants)
      text += fmt::format("    ({}, \"{}\", [\n{}\n    ]),\n", form.function, variant.name,
                          number_lines(variant.force, ", ", "        "));
  }
  text += R"python(]


def forces(function, variant):
    """Moves one end of the material or the bearing along the displacements, in a separate model; returns the forces.
    If the analysis fails at a displacement, the list ends before it."""
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.node(1, 0.0, 0.0)
    ops.node(2, 0.0, 0.0)
    ops.fix(1, 1, 1, 1)
    ops.fix(2, 1, 0, 1)
    if function.__name__ == "bearing":
        ops.uniaxialMaterial("Elastic", 1, 1.0)
        function(1, 1, 2, variant, "-P", 1, "-Mz", 1, "-orient", 1, 0, 0, 0, 1, 0)
    else:
        function(1, variant)
        ops.element("zeroLength", 1, 1, 2, "-mat", 1, "-dir", 2)
    # The extra 0.0 is the value at time 0, so that step k ends at displacement k of the list.
    ops.timeSeries("Path", 1, "-dt", 1.0, "-values", 0.0, *(float(x) for x in DISP))
    ops.pattern("Plain", 1, 1)
    ops.sp(2, 2, 1.0)
    ops.constraints("Lagrange")
    ops.numberer("Plain")
    ops.system("FullGeneral")
    ops.algorithm("Linear")
    ops.integrator("LoadControl", 1.0)
    ops.analysis("Static")
    got = []
    for _ in DISP:
        if ops.analyze(1) != 0:
            break
        got.append(ops.eleForce(1)[4])
    ops.wipe()
    return got


def self_check():
    """Moves every material and the bearing in separate models, and wipes any model that is loaded. Prints the largest
    differences as shares of the peak force. Returns whether all forces agree."""
    everything = True
    for function, variant, expected in EXPECTED:
        got = forces(function, variant)
        name = f"isolaw {function.__name__} {variant}"
        # Only a NaN differs from itself.
        if len(got) < len(DISP) or any(f != f for f in got):
            print(f"{name}: no force at {len(got)} of {len(DISP)} displacements or after: FAIL")
            everything = False
            continue
        peak = max(abs(f) for f in expected)
        worst = max(abs(a - b) for a, b in zip(got, expected))
        from_law = max(abs(a - b) for a, b in zip(got, LAW))
        passed = worst <= ALLOWED * peak
        line = f"{name}: largest difference from the expected force {worst / peak:.3g} of its peak (allowed {ALLOWED:g})"
        if variant == "nominal":
            line += f", from the law {from_law / peak:.3g}"
        print(line + (": PASS" if passed else ": FAIL"))
        everything = everything and passed
    return everything


)python";
  text += addition.procedures;
  text += "if __name__ == \"__main__\":\n";
  // If the script has a building, the building's functions have imported sys already.
  return text + (addition.dispatch.empty() ? "    import sys\n\n    sys.exit(0 if self_check() else 1)\n"
                                           : "    " + addition.dispatch);
}

}  // namespace isolaw::programs
