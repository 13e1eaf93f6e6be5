// Shared by the exports in C++: the law in a namespace, as C++17 that needs only the standard library, and its check.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/programs/subject.hpp"
#include "isolaw/programs/unit_system.hpp"

namespace isolaw::programs {
std::string cpp_facts(Subject const& subject, UnitSystem const& units, std::string_view program);
// Returns the includes and the namespace identifier(subject). Throws Error for a law without a C++ form.
std::string cpp_law(Subject const& subject, UnitSystem const& units);
// A main() under ISOLAW_SELF_CHECK. It moves `material` along the protocol with trial(disp, velocity) and commit().
std::string cpp_check(Subject const& subject, UnitSystem const& units, std::string_view material);

}  // namespace isolaw::programs
