// OpenSeesPy: a module with the same functions as the Tcl export; run as a program it checks itself.
#include <fmt/format.h>

#include <ranges>

#include "isolaw/base/words.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/self_check.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {
namespace {

std::string function(CheckedForm const& form) {
  std::string text = form.is_element ? std::string("def bearing(tag, i, j, variant, *rest):\n")
                                     : fmt::format("def {}(tag, variant=\"nominal\"):\n", form.function);
  text += fmt::format("    \"\"\"{}: {}{}\"\"\"\n", form.form->title, argument_names(*form.form),
                      form.is_element                  ? "; rest: '-P', 1, '-Mz', 2 and so on"
                      : form.form->commands.size() > 1 ? "; uses tag + 1 too"
                                                       : "");
  for (auto const& variant : form.variants) {
    auto const& c = variant.commands;
    text += fmt::format("    if variant == \"{}\":\n", variant.name);
    if (form.is_element)
      text += fmt::format("        ops.element(\"{}\", tag, i, j{}, *rest)\n", c.back().name,
                          argument_values(c.back(), ", "));
    else if (c.size() == 1)
      text += fmt::format("        ops.uniaxialMaterial(\"{}\", tag{})\n", c[0].name, argument_values(c[0], ", "));
    else
      text += fmt::format(
          "        ops.uniaxialMaterial(\"{}\", tag + 1{})\n        ops.uniaxialMaterial(\"{}\", tag, tag + 1{})\n",
          c[0].name, argument_values(c[0], ", "), c[1].name, argument_values(c[1], ", "));
    text += "        return\n";
  }
  return text + fmt::format("    raise ValueError(f\"no variant {{variant!r}}; there is: {}\")\n\n\n",
                            joined(form.variants | std::views::transform(&CheckedVariant::name)));
}

}  // namespace

std::string openseespy_script(Subject const& subject, Realisation const& realisation, UnitSystem const& units) {
  auto const check = self_check(subject, realisation, units);
  std::string text;
  for (auto const& line : fact_lines(facts(subject, realisation, units, "OpenSeesPy"))) text += "# " + line + "\n";
  text += fmt::format(
      "#\n# To use:   import this module; {0}(1) or {0}(1, \"upper\")\n"
      "# To check: python3 this-file (exit code 0 where all agree)\n\n"
      "import openseespy.opensees as ops\n\n\n",
      check.forms.front().function);
  for (auto const& form : check.forms) text += function(form);
  text += fmt::format(
      "# Displacements of the self-check, and the force of the law itself along them.\nDISP = [\n{}\n]\nLAW = [\n{}\n]\n",
      number_lines(check.disp, ", ", "    "), number_lines(check.law, ", ", "    "));
  text +=
      "# Force that the program must give, computed by isolaw from its algorithm: function, variant, tolerance, force.\n"
      "EXPECTED = [\n";
  for (auto const& form : check.forms) {
    if (form.is_element) continue;
    for (auto const& variant : form.variants)
      text += fmt::format("    ({}, \"{}\", {}, [\n{}\n    ]),\n", form.function, variant.name, exactly(form.tolerance),
                          number_lines(variant.force, ", ", "        "));
  }
  text += R"python(]


def self_check(tag=990001):
    """Drives every material; prints the largest differences in parts of the peak force; True where all agree."""
    everything = True
    for function, variant, tolerance, expected in EXPECTED:
        function(tag, variant)
        ops.testUniaxialMaterial(tag)
        got = []
        for x in DISP:
            ops.setStrain(float(x))
            got.append(ops.getStress())
        peak = max(abs(f) for f in expected)
        # A force that is no number is larger than any difference.
        worst = max(abs(a - b) if a == a else float("inf") for a, b in zip(got, expected))
        from_law = max(abs(a - b) if a == a else float("inf") for a, b in zip(got, LAW))
        passed = worst <= tolerance * peak
        line = (f"isolaw {function.__name__} {variant}: largest difference from the expected force "
                f"{worst / peak:.3g} of its peak (allowed {tolerance:g})")
        if variant == "nominal":
            line += f", from the law {from_law / peak:.3g}"
        print(line + (": PASS" if passed else ": FAIL"))
        everything = everything and passed
        tag += 2
    return everything


if __name__ == "__main__":
    import sys

    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    sys.exit(0 if self_check() else 1)
)python";
  return text;
}

}  // namespace isolaw::programs
