// The exported texts, one function per target. Each throws Error where the target cannot express the law at all.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/programs/realise.hpp"
#include "isolaw/programs/subject.hpp"
#include "isolaw/programs/unit_system.hpp"

namespace isolaw::programs {

enum class Target { opensees, openseespy, cpp, json, sheet };
Target parse_target(std::string_view text);  // throws Error that lists them

std::string opensees_script(Subject const& subject, Realisation const& realisation, UnitSystem const& units);
std::string openseespy_script(Subject const& subject, Realisation const& realisation, UnitSystem const& units);
std::string cpp_header(Subject const& subject, UnitSystem const& units);
std::string export_json(Subject const& subject, Realisation const& realisation, UnitSystem const& units);
std::string value_sheet(Subject const& subject, UnitSystem const& units);

std::string exported(Subject const& subject, Target target, UnitSystem const& units);

}  // namespace isolaw::programs
