// Writes the law for Abaqus/Standard as a user element (UEL) in C++. The element keeps its whole state in SVARS,
// because Abaqus may repeat an increment from an earlier state.
#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>

#include "isolaw/laws/memory/open_branches.hpp"
#include "isolaw/programs/cpp_form.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/header_parts.hpp"
#include "isolaw/programs/interface_parts.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {
namespace {

// The number of state variables (SVARS) that the element asks for. The number fixed_variables is enough for every law
// that stores no turning points. A law that stores turning points gets turning_variables in addition: up to five
// numbers for each turning point that it can keep.
constexpr int fixed_variables = 64, turning_variables = 5 * static_cast<int>(laws::OpenBranches::most);

}  // namespace

std::string abaqus_element(Subject const& subject, UnitSystem const& units) {
  auto const name = identifier(subject, units);
  bool const steady = subject.law->info.traits.rate_independent;
  bool const turns = remembers_turning_points(subject.law->info.id);
  int const variables = fixed_variables + (turns ? turning_variables : 0);
  std::array<std::pair<std::string_view, std::string>, 3> const marks{
      {{"name", name}, {"law", std::string(subject.law->info.id)}, {"variables", std::to_string(variables)}}};
  std::string factors = "1.0 as fitted";
  if (subject.bounds.lower) factors += fmt::format(", {} lower", exact_text(subject.bounds.lower->overall));
  if (subject.bounds.upper) factors += fmt::format(", {} upper bound", exact_text(subject.bounds.upper->overall));
  return with_own_number(
      cpp_facts(subject, units, "Abaqus/Standard, user subroutine UEL in C++") +
      fmt::format(
          "// In the input file, for a spring along the first axis between nodes 10 and 20 (element 1):\n"
          "//   *USER ELEMENT, TYPE=U1, NODES=2, COORDINATES=3, PROPERTIES=1, VARIABLES={1}\n"
          "//   1\n"
          "//   *ELEMENT, TYPE=U1, ELSET=ISOLATORS\n"
          "//   1, 10, 20\n"
          "//   *UEL PROPERTY, ELSET=ISOLATORS\n"
          "//   1.0\n"
          "// The property is the factor on the force: {2}. For a spring along any other line, give\n"
          "// the data line 1, 2, 3 and PROPERTIES=4, and the components of its direction after the factor.\n"
          "// Displacements count from rest. The line keeps its direction, and the element has no mass.\n"
          "// To run: c++ -std=c++17 -O2 -fPIC -c this-file -o {0}.o; abaqus job=model user={0}.o\n"
          "// Or user=this-file, if compile_cpp in Abaqus' environment file selects C++17.\n"
          "// The element works in static steps (general and perturbation) and in direct integration in time with its\n"
          "// half-increment residual. It gives the matrices of frequency steps. ENERGY(4) is all work done on it.\n"
          "// It was not run in Abaqus: a Fortran program made the calls that Abaqus makes.\n"
          "// {3}\n"
          "// To check: c++ -std=c++17 -DISOLAW_SELF_CHECK -x c++ this-file -o check && ./check\n\n",
          name, variables, factors,
          steady
              ? "The law does not depend on the velocity."
              : "The law depends on the velocity: in dynamic steps that of the nodes, in static steps that of the increment.") +
      guarded(name, cpp_law(subject, units) + interface_part("abaqus.inc", marks)) +
      cpp_check(subject, units, "DrivenElement"));
}

}  // namespace isolaw::programs
