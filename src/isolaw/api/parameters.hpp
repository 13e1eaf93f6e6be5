// Parameters of a law by name, from a file, an option or a program's own table, checked against the law.
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
  std::string where = {};  // "parameters.toml:3", "--set"; if empty, messages use the caller's `where`
};

// Reads "Ke=2.5", in the law's units. Throws Error for a text of another form.
NamedValue parse_named_value(std::string_view text, std::string const& where);
// Reads a file of TOML or JSON with `name = value` for each parameter, in the law's units, at the top or in a table
// with the law's id. Throws one Error with every value that is not a number; parameters_in_order() checks the names.
std::vector<NamedValue> read_parameter_file(std::filesystem::path const& file, laws::LawEntry const& law);

// Whether values must also meet the law's joint limits. A search may break them, with a poor or infinite objective.
enum class Together { checked, left };

// The values of all parameters in the law's order and units; parameters fixed by default may be missing. Throws one
// Error with everything wrong: unknown or repeated names, missing parameters, values outside their physical limits,
// else a joint limit that is not met. `where` is the place in messages about values without a place of their own.
std::vector<double> parameters_in_order(laws::LawEntry const& law, std::vector<NamedValue> const& values,
                                        std::string const& where, Together together = Together::checked);

}  // namespace isolaw
