// Messages that merges of campaigns and of building studies share.
#pragma once

#include <filesystem>
#include <string>

#include "isolaw/campaign/merge.hpp"

namespace isolaw::app {

// Says on standard error which parts were absent, what was copied and what is missing.
void tell_merged(campaign::Merged const& merged, std::filesystem::path const& directory, std::string const& store);

}  // namespace isolaw::app
