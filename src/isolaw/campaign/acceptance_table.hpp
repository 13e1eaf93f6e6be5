// What tests are held to, option by option: command line, lot file, the command in the report and Python are made from
// this table.
#pragma once

#include <span>

#include "isolaw/base/option.hpp"
#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

// The text of the rules is not loaded: a name means what its way in takes it for.
std::span<Option<Acceptance> const> acceptance_table();

}  // namespace isolaw::campaign
