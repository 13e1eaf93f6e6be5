// Texts for all exports in C++: the law in a namespace (C++17, standard library only) and its self-check.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/base/unit_system.hpp"
#include "isolaw/programs/subject.hpp"

namespace isolaw::programs {
std::string cpp_facts(Subject const& subject, UnitSystem const& units, std::string_view program);
// Returns the includes and the law in namespace identifier(subject, units). Throws Error if the law has no C++ form.
std::string cpp_law(Subject const& subject, UnitSystem const& units);
// Puts an include guard around `code`. Including another file that defines the same name is then a compile error.
std::string guarded(std::string_view name, std::string_view code);
// Returns a main() that is compiled only if ISOLAW_SELF_CHECK is defined. It drives `material` over the self-check's
// motion by trial() and commit(), and compares its force with the law's.
std::string cpp_check(Subject const& subject, UnitSystem const& units, std::string_view material);

}  // namespace isolaw::programs
