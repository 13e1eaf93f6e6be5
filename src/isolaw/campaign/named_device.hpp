// Finds the device that a user names, or the lot.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

// Like Contents::device_or_lot(), but the message about an unknown name offers the lot only if the campaign has a law
// of the lot.
inline std::optional<std::size_t> named_device(Contents const& contents, std::string_view name) {
  bool const known = std::ranges::find(contents.devices, name, &Device::name) != contents.devices.end();
  if (known || name == whole_lot || !contents.lot_analyses.empty()) return contents.device_or_lot(name);
  constexpr std::size_t shown = 30;
  std::vector<std::string> names;
  for (auto const& device : contents.devices) names.push_back(device.name);
  throw Error({.where = "device '" + std::string(name) + "'",
               .found = "not in this campaign",
               .allowed = shortened(std::move(names), shown)});
}

// The names that a user may give in place of the lot, for a campaign that has no law of the lot.
inline std::string devices_to_name(Contents const& contents) {
  constexpr std::size_t shown = 5;
  std::vector<std::string> names;
  for (auto const& device : contents.devices) names.push_back(device.name);
  return shortened(std::move(names), shown);
}

}  // namespace isolaw::campaign
