// The laws with their parameters, units, limits and search boxes as JSON text.
#pragma once

#include <string>

#include "isolaw/laws/catalogue.hpp"

namespace isolaw {

std::string law_json(laws::LawEntry const& law);
std::string catalogue_json();  // a JSON list with one object for each law

}  // namespace isolaw
