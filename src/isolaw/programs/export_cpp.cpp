// Writes the law as a C++17 header that needs only the standard library.
#include <fmt/format.h>

#include "isolaw/programs/cpp_form.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {

std::string cpp_header(Subject const& subject, UnitSystem const& units) {
  auto const space = identifier(subject, units);
  return with_own_number(
      cpp_facts(subject, units, "C++17") +
      fmt::format(
          "// To use, in a user material: {0}::Material m(nominal, or lower or upper);\n"
          "//   setTrialStrain(u, v): m.trial(u, v)   getStress: m.force()   getTangent: m.tangent()   getDampTangent: m.damping()\n"
          "//   commitState: m.commit()   revertToLastCommit: m.revert()   revertToStart: m.revert_to_start()   copy: by value\n"
          "//   to send or store the state: m.state_size(), m.save(numbers), m.load(numbers, size)\n"
          "//   {1}\n"
          "// To check: c++ -std=c++17 -DISOLAW_SELF_CHECK -x c++ this-file -o check && ./check\n",
          space,
          subject.law->info.traits.rate_independent ? "The law does not depend on the velocity."
                                                    : "The law depends on the velocity: the element must pass it on.") +
      guarded(space, cpp_law(subject, units)) + cpp_check(subject, units, "Material"));
}

}  // namespace isolaw::programs
