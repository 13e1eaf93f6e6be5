// OpenSees, Tcl: a namespace of procedures that make the material or the bearing, and check it. Sourcing the file makes
// nothing; the check adds materials of its own and leaves the model as it is.
#include <fmt/format.h>

#include <ranges>

#include "isolaw/base/words.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/self_check.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {
namespace {

std::string body(CheckedForm const& form, CheckedVariant const& variant) {
  if (form.is_element) {
    auto const& c = variant.commands.back();
    return fmt::format("      element {} $tag $i $j{} {{*}}$args\n", c.name, argument_values(c, " "));
  }
  if (variant.commands.size() == 1)
    return fmt::format("      uniaxialMaterial {} $tag{}\n", variant.commands[0].name,
                       argument_values(variant.commands[0], " "));
  return fmt::format("      uniaxialMaterial {} $inner{}\n      uniaxialMaterial {} $tag $inner{}\n",
                     variant.commands[0].name, argument_values(variant.commands[0], " "), variant.commands[1].name,
                     argument_values(variant.commands[1], " "));
}

std::string procedure(CheckedForm const& form) {
  bool const inner = form.form->commands.size() > 1;
  std::string text = fmt::format("  # {}: {}\n", form.form->title, argument_names(*form.form));
  if (form.is_element)
    text +=
        "  # args: the rest of the command, such as -P 1 -Mz 2, or -P 1 -T 2 -My 3 -Mz 4, -orient ...\n"
        "  proc bearing {tag i j variant args} {\n";
  else if (inner)
    text += fmt::format(
        "  # uses the tag after the given one too\n  proc {} {{tag {{variant nominal}}}} {{\n    set inner [expr {{$tag + 1}}]\n",
        form.function);
  else
    text += fmt::format("  proc {} {{tag {{variant nominal}}}} {{\n", form.function);
  text += "    switch -- $variant {\n";
  for (auto const& variant : form.variants)
    text += fmt::format("      {} {{\n  {}      }}\n", variant.name, body(form, variant));
  return text + fmt::format("      default {{ error \"no variant $variant; there is: {}\" }}\n    }}\n  }}\n\n",
                            joined(form.variants | std::views::transform(&CheckedVariant::name)));
}

std::string check_procedure(SelfCheck const& check) {
  std::string text = fmt::format(
      "  # Displacements of the self-check, and the force of the law itself along them.\n"
      "  variable disp {{\n{}\n  }}\n  variable law {{\n{}\n  }}\n"
      "  # Force that the program must give: its algorithm along these displacements, computed by isolaw.\n"
      "  variable expected\n  array set expected {{}}\n",
      number_lines(check.disp, " ", "    "), number_lines(check.law, " ", "    "));
  for (auto const& form : check.forms) {
    if (form.is_element) continue;
    for (auto const& variant : form.variants)
      text += fmt::format("  set expected({},{}) {{\n{}\n  }}\n", form.function, variant.name,
                          number_lines(variant.force, " ", "    "));
    text += fmt::format("  variable tolerance_{} {}\n", form.function, exactly(form.tolerance));
  }
  text += R"tcl(
  # Drives every material and prints the largest differences in parts of the peak force. The first free tag is given;
  # needs a model (model basic -ndm 1 -ndf 1). Returns 1 where all agree.
  proc self_check {{tag 990001}} {
    variable disp
    variable law
    variable expected
    set all 1
    foreach key [lsort [array names expected]] {
      lassign [split $key ,] function variant
      variable tolerance_$function
      set tolerance [set tolerance_$function]
      $function $tag $variant
      testUniaxialMaterial $tag
      set peak 0.0
      set worst 0.0
      set from_law 0.0
      set numbers 1
      foreach x $disp force $expected($key) of_law $law {
        setStrain $x
        set got [getStress]
        if {$got != $got} { set numbers 0 }
        if {abs($force) > $peak} { set peak [expr {abs($force)}] }
        if {abs($got - $force) > $worst} { set worst [expr {abs($got - $force)}] }
        if {abs($got - $of_law) > $from_law} { set from_law [expr {abs($got - $of_law)}] }
      }
      set pass [expr {$numbers && $peak > 0.0 && $worst <= $tolerance * $peak}]
      set line "isolaw $function $variant: largest difference from the expected force [format %.3g [expr {$worst / $peak}]] of its peak (allowed $tolerance)"
      if {$variant eq "nominal"} {
        append line ", from the law [format %.3g [expr {$from_law / $peak}]]"
      }
      puts "$line: [expr {$pass ? "PASS" : "FAIL"}]"
      if {!$pass} { set all 0 }
      incr tag 2
    }
    return $all
  }
)tcl";
  return text;
}

}  // namespace

std::string opensees_script(Subject const& subject, Realisation const& realisation, UnitSystem const& units) {
  auto const check = self_check(subject, realisation, units);
  auto const space = identifier(subject);
  std::string text;
  for (auto const& line : fact_lines(facts(subject, realisation, units, "OpenSees (Tcl)"))) text += "# " + line + "\n";
  text += fmt::format(
      "#\n# To use:   source this file; {0}::{1} 1        (or: 1 lower, 1 upper)\n"
      "# To check: OpenSees, then: model basic -ndm 1 -ndf 1; source this file; {0}::self_check\n"
      "#           or, where the program passes arguments on: OpenSees this-file check\n\n"
      "namespace eval {0} {{\n",
      space, check.forms.front().function);
  for (auto const& form : check.forms) text += procedure(form);
  text += check_procedure(check) + "}\n\n";
  text += fmt::format(
      "if {{[info exists argv] && [lindex $argv 0] eq \"check\"}} {{\n  model basic -ndm 1 -ndf 1\n  {}::self_check\n}}\n",
      space);
  return text;
}

}  // namespace isolaw::programs
