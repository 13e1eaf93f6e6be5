// The laws with their parameters, units, limits and search boxes, and the list of rule sets, as JSON text.
#pragma once

#include <string>

#include "isolaw/laws/catalogue.hpp"

namespace isolaw {

std::string law_json(laws::LawEntry const& law);
std::string catalogue_json();  // a JSON list with one object for each law
std::string rule_sets_json();  // a JSON list with one object for each built-in rule set
// The text of a built-in rule set, of the commented "template", or of a rule file. Throws Error for a faulty file.
std::string rule_text(std::string const& name);

}  // namespace isolaw
