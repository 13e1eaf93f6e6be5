// What merges of campaigns and of buildings say alike.
#pragma once

#include <filesystem>
#include <string>

#include "isolaw/campaign/merge.hpp"

namespace isolaw::app {

// To standard error: what was not there, what was copied, what is missing.
void tell_merged(campaign::Merged const& merged, std::filesystem::path const& directory, std::string const& store);

}  // namespace isolaw::app
