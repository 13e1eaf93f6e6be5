// Messages that the merges of campaigns and of building studies have in common.
#pragma once

#include <filesystem>
#include <string>

#include "isolaw/campaign/merge_stores.hpp"

namespace isolaw::app {

void tell_merged(campaign::Merged const& merged, std::filesystem::path const& directory, std::string const& store);

}  // namespace isolaw::app
