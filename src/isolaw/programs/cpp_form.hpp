// What the exports in C++ share: the law in a namespace, in C++17 that needs the standard library alone, and its check.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/programs/subject.hpp"
#include "isolaw/programs/unit_system.hpp"

namespace isolaw::programs {

// What every export states, as comments.
std::string cpp_facts(Subject const& subject, UnitSystem const& units, std::string_view program);
// What it includes, then namespace identifier(subject), with Parameters and Material. Throws Error for a law that has
// no such form.
std::string cpp_law(Subject const& subject, UnitSystem const& units);
// With ISOLAW_SELF_CHECK: a program that drives `material`, a type of that namespace with trial(disp, velocity) and
// commit(), along the protocol.
std::string cpp_check(Subject const& subject, UnitSystem const& units, std::string_view material);

}  // namespace isolaw::programs
