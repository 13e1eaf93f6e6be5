// Parameters of a law as users name them, from a file, an option or a program's own table, checked against the law.
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
  std::string where = {};  // "parameters.toml:3", "--set"; empty: as the caller says
};

// "Ke=2.5", in the law's units. Throws Error.
NamedValue parse_named_value(std::string_view text, std::string const& where);

// A file of TOML or JSON: `name = value` for each parameter, in the law's units, at the top or in a table of the law's
// id. Throws one Error with every line that is neither; the names are checked by parameters_in_order().
std::vector<NamedValue> read_parameter_file(std::filesystem::path const& file, laws::LawEntry const& law);

// Whether values that are each within their limits must also be those of a device together. A search may come by
// others:
// they have no objective, or a poor one.
enum class Together { checked, left };

// The values of all of the law's parameters in its order; those fixed by default may be missing. Throws one Error with
// everything wrong: unknown names, a name twice, missing parameters, values outside the physical limits; or, where each
// is right, what they come to together. `where` is said of what has no place of its own.
std::vector<double> parameters_in_order(laws::LawEntry const& law, std::vector<NamedValue> const& values,
                                        std::string const& where, Together together = Together::checked);

}  // namespace isolaw
