// Reads the parameters of a law by name, from a file, an option or a program's table, and checks them against the law.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/laws/catalogue.hpp"

namespace isolaw {

struct NamedValue {
  std::string name;
  double value = 0.0;
  std::string where = {};  // place of the value: "parameters.toml:3", "--set"; if empty, the caller's `where`
};

// Reads a text such as "Ke=2.5", in the law's units. Throws Error for any other form.
NamedValue parse_named_value(std::string_view text, std::string const& where);
// Reads a TOML or JSON file with `name = value` for each parameter, in the law's units, either at the top or in a table
// named after the law. Throws one Error for all values that are not numbers. It does not check the names.
std::vector<NamedValue> read_parameter_file(std::filesystem::path const& file, laws::LawEntry const& law);

// Says whether limits on several parameters together, such as K1 >= K2, are checked. `unchecked` is for parameters from
// a search, because its box may reach beyond such a limit.
enum class JointLimits { checked, unchecked };

// Puts the values in the law's order. Parameters that are fixed by default may be missing. Throws one Error with all
// faults: unknown or repeated names, missing parameters, values outside their physical limits. Without such a fault,
// throws Error for a limit on several parameters together. If the member `where` of a value is empty, messages give the
// argument `where` as its place.
std::vector<double> parameters_in_order(laws::LawEntry const& law, std::vector<NamedValue> const& values,
                                        std::string const& where, JointLimits joint_limits = JointLimits::checked);

}  // namespace isolaw
