// Writes the law as a UniaxialMaterial in C++ that OpenSees 3.8.0 loads from a library.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "isolaw/laws/online/online.hpp"
#include "isolaw/programs/cpp_form.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/interface_parts.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {
namespace {

// The names of force factors that an OpenSees script may give, as rows of a C++ table and as a list for a comment.
struct Variants {
  std::string table = "{\"nominal\", nominal}", names = "nominal";
};

Variants variants_of(Subject const& subject) {
  Variants variants;
  auto const add = [&](std::string const& name) {
    variants.table += fmt::format(", {{\"{0}\", {0}}}", name);
    variants.names += ", " + name;
  };
  if (subject.bounds.lower) add("lower");
  if (subject.bounds.upper) add("upper");
  return variants;
}

// True if the slope of the force at zero displacement is infinite. The chord from zero then becomes steeper as it
// becomes shorter. The law's tangent cannot tell this, because the code of such laws limits it.
bool starts_steeply(Subject const& subject) {
  double const amplitude = subject.design_disp_mm / subject.law->info.length.in_record_units;
  auto const chord = [&](double share) {
    laws::Online law(subject.law->info.id, subject.parameters);
    return std::abs(law.trial(share * amplitude, 0.0).force - law.trial(0.0, 0.0).force) / share;
  };
  return chord(1e-9) > 1.5 * chord(1e-6);
}

}  // namespace

std::string opensees_material(Subject const& subject, UnitSystem const& units) {
  auto const name = identifier(subject, units);
  auto const variants = variants_of(subject);
  std::array<std::pair<std::string_view, std::string>, 4> const marks{{{"name", name},
                                                                       {"law", std::string(subject.law->info.id)},
                                                                       {"variants", variants.table},
                                                                       {"names", variants.names}}};
  auto const& traits = subject.law->info.traits;
  return with_own_number(
      cpp_facts(subject, units, "OpenSees, a UniaxialMaterial in C++") +
      fmt::format(
          "// To build, with the compiler that built your OpenSees and against the source of the same version:\n"
          "//   s=OpenSees/SRC; c++ -std=c++17 -O2 -fPIC -shared -I$s -I$s/api -I$s/tagged -I$s/handler -I$s/matrix\n"
          "//     -I$s/material -I$s/material/uniaxial -I$s/actor/actor -I$s/actor/channel -I$s/domain/component\n"
          "//     this-file -o {0}.so\n"
          "// To use in the Tcl program of OpenSees, with the library in a folder of LD_LIBRARY_PATH. After the tag you\n"
          "//   may give one of {1}, or a factor on the force:\n"
          "//   uniaxialMaterial {0} $tag\n"
          "// For Python, which loads no libraries, for Windows, parallel runs and databases, compile the file into\n"
          "//   OpenSees: add a line for OPS_{0} to uniaxialMaterialsMap in\n"
          "//   SRC/interpreter/OpenSeesUniaxialMaterialCommands.cpp, choose a class number ISOLAW_CLASS_TAG that no\n"
          "//   other material has, and let FEM_ObjectBrokerAllClasses::getNewUniaxialMaterial make\n"
          "//   {0}::UserMaterial for it.\n"
          "// The strain is a displacement, so use the material in zeroLength and twoNodeLink elements. {2}\n"
          "// If a step does not converge: the tangent jumps where the motion turns, and Newton's method may oscillate\n"
          "//   in the first step after a turn, most of all under load control. Take algorithm KrylovNewton from the start,\n"
          "//   then NewtonLineSearch, then smaller steps.\n"
          "{3}"
          "// To check the law: c++ -std=c++17 -DISOLAW_SELF_CHECK -x c++ this-file -o check && ./check\n\n",
          name, variants.names,
          traits.rate_independent ? "The law does not depend on the velocity."
                                  : "The law depends on the velocity, which both pass to it.",
          starts_steeply(subject)
              ? "//   When the motion first enters a side of zero, the slope of the force has no bound. Under load\n"
                "//   control that step may fail with every algorithm. Displacement control and short time steps work.\n"
              : "") +
      guarded(name, cpp_law(subject, units) + interface_part("opensees.inc", marks)) +
      cpp_check(subject, units, "Material"));
}

}  // namespace isolaw::programs
