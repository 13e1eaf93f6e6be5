// Writes the law as a Tcl script for OpenSees. The script only defines procedures; its self-check makes a separate
// model.
#include <fmt/format.h>

#include <ranges>

#include "isolaw/base/words.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/script_addition.hpp"
#include "isolaw/programs/self_check.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {
namespace {

std::string body(CheckedForm const& form, CheckedVariant const& variant) {
  std::string text;
  for (std::size_t i = 0; i < variant.commands.size(); ++i) {
    auto const& command = variant.commands[i];
    if (form.is_element) {
      text += fmt::format("        element {} $tag $i $j{} {{*}}$args{}\n", command.name, argument_values(command, " "),
                          element_options(command, " ", ""));
      continue;
    }
    auto const tag = [](std::size_t above) {
      return above == 0 ? std::string("$tag") : fmt::format("[expr {{$tag + {}}}]", above);
    };
    text += fmt::format("        uniaxialMaterial {} {}", command.name, tag(variant.tags[i].own));
    for (auto const inner : variant.tags[i].inner) text += " " + tag(inner);
    text += argument_values(command, " ") + "\n";
  }
  return text;
}

std::string procedure(CheckedForm const& form) {
  std::string text = fmt::format("  # {}: {}\n", form.form->title, argument_names(*form.form));
  if (form.is_element)
    text +=
        "  # args: the rest of the command, such as -P 1 -Mz 2, or -P 1 -T 2 -My 3 -Mz 4, -orient ...\n"
        "  proc bearing {tag i j variant args} {\n";
  else {
    if (auto const tags = tags_text(*form.form); !tags.empty()) text += "  # " + tags + "\n";
    text += fmt::format("  proc {} {{tag {{variant nominal}}}} {{\n", form.function);
  }
  text += "    switch -- $variant {\n";
  for (auto const& variant : form.variants)
    text += fmt::format("      {} {{\n{}      }}\n", variant.name, body(form, variant));
  return text + fmt::format("      default {{ error \"no variant $variant; there is: {}\" }}\n    }}\n  }}\n\n",
                            joined(form.variants | std::views::transform(&CheckedVariant::name)));
}

std::string check_procedure(SelfCheck const& check) {
  std::size_t checks = 0;
  for (auto const& form : check.forms) checks += form.variants.size();
  std::string text = fmt::format(
      "  # Displacements of the self-check, and the force of the law itself along them.\n"
      "  variable disp {{\n{}\n  }}\n  variable law {{\n{}\n  }}\n"
      "  # Forces that OpenSees must give along these displacements. isolaw computed them by the same algorithm.\n"
      "  variable expected\n  array set expected {{}}\n",
      number_lines(check.disp, " ", "    "), number_lines(check.law, " ", "    "));
  text += fmt::format("  variable checks {}\n  variable allowed {}\n", checks, exact_text(check_tolerance));
  for (auto const& form : check.forms)
    for (auto const& variant : form.variants)
      text += fmt::format("  set expected({},{}) {{\n{}\n  }}\n", form.function, variant.name,
                          number_lines(variant.force, " ", "    "));
  text += R"tcl(
  # Moves one end of the material or the bearing along the displacements, in a separate model, and returns the forces.
  # If the analysis fails at a displacement, the list ends before it.
  proc forces {function variant} {
    variable disp
    wipe
    namespace eval :: { model basic -ndm 2 -ndf 3 }
    node 1 0.0 0.0
    node 2 0.0 0.0
    fix 1 1 1 1
    fix 2 1 0 1
    if {$function eq "bearing"} {
      uniaxialMaterial Elastic 1 1.0
      bearing 1 1 2 $variant -P 1 -Mz 1 -orient 1 0 0 0 1 0
    } else {
      $function 1 $variant
      element zeroLength 1 1 2 -mat 1 -dir 2
    }
    # The extra 0.0 is the value at time 0, so that step k ends at displacement k of the list.
    timeSeries Path 1 -dt 1.0 -values [concat 0.0 $disp]
    pattern Plain 1 1 { sp 2 2 1.0 }
    constraints Lagrange
    numberer Plain
    system FullGeneral
    algorithm Linear
    integrator LoadControl 1.0
    analysis Static
    set got {}
    foreach x $disp {
      if {[analyze 1] != 0} break
      lappend got [lindex [eleForce 1] 4]
    }
    wipe
    return $got
  }

  # Moves every material and the bearing in separate models, and wipes any model that is loaded. Prints the largest
  # differences as shares of the peak force. Returns 1 if all forces agree and none is missing.
  proc self_check {} {
    variable disp
    variable law
    variable expected
    variable checks
    variable allowed
    set all [expr {[array size expected] == $checks}]
    if {!$all} { puts "isolaw: [array size expected] of $checks checks are in this file: FAIL" }
    foreach key [lsort [array names expected]] {
      lassign [split $key ,] function variant
      set forces [forces $function $variant]
      set peak 0.0
      set worst 0.0
      set from_law 0.0
      set numbers [expr {[llength $forces] == [llength $disp]}]
      foreach got $forces force $expected($key) of_law $law {
        if {$got eq "" || $got != $got} { set numbers 0; break }
        if {abs($force) > $peak} { set peak [expr {abs($force)}] }
        if {abs($got - $force) > $worst} { set worst [expr {abs($got - $force)}] }
        if {abs($got - $of_law) > $from_law} { set from_law [expr {abs($got - $of_law)}] }
      }
      set pass [expr {$numbers && $peak > 0.0 && $worst <= $allowed * $peak}]
      if {$numbers && $peak > 0.0} {
        set line "isolaw $function $variant: largest difference from the expected force [format %.3g [expr {$worst / $peak}]] of its peak (allowed $allowed)"
        if {$variant eq "nominal"} {
          append line ", from the law [format %.3g [expr {$from_law / $peak}]]"
        }
      } else {
        set line "isolaw $function $variant: no force at [llength $forces] of [llength $disp] displacements or after"
      }
      puts "$line: [expr {$pass ? "PASS" : "FAIL"}]"
      if {!$pass} { set all 0 }
    }
    return $all
  }
)tcl";
  return text;
}

}  // namespace

std::string opensees_script(Subject const& subject, Realisation const& realisation, UnitSystem const& units,
                            ScriptAddition const& addition) {
  auto const check = self_check(subject, realisation, units);
  auto const space = identifier(subject, units);
  std::string text;
  for (auto const& line : fact_lines(facts(subject, realisation, units, "OpenSees (Tcl)"))) text += "# " + line + "\n";
  for (auto const& line : fact_lines(addition.facts)) text += "# " + line + "\n";
  text += fmt::format(
      "#\n# To use:   source this file; {0}::{1} 1        (or: 1 lower, 1 upper)\n"
      "# To check: OpenSees this-file check              (exit code 0 where all agree, 1 where not)\n"
      "#           or, in a program that holds no model: source this file; {0}::self_check\n"
      "{2}\n"
      "if {{[namespace exists {0}] && !([info exists {0}::own_number] && ${0}::own_number eq \"{3}\")}} {{\n"
      "  error \"the name {0} is taken: choose another for [info script] by --name of isolaw export\"\n}}\n"
      "namespace eval {0} {{\n  variable own_number {3}\n",
      space, check.forms.front().function, addition.usage, own_number_mark);
  for (auto const& form : check.forms) text += procedure(form);
  text += check_procedure(check) + addition.procedures + "}\n\n";
  // OpenSees exits with 0 even after an error in a script. The script therefore calls exit with a code of its own.
  text += fmt::format(
      "if {{[info exists argv0] && [info script] eq $argv0 && [info exists argv] && [lindex $argv 0] eq \"check\"}} {{\n"
      "  if {{[catch {{ {}::self_check }} all]}} {{\n    puts stderr $::errorInfo\n    exit 1\n  }}\n"
      "  exit [expr {{$all ? 0 : 1}}]\n}}\n",
      space);
  return with_own_number(text + addition.dispatch);
}

}  // namespace isolaw::programs
