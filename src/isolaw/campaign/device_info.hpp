// The facts that the table of a device in a lot file may state, and the options for reading its compression test.
#pragma once

#include <vector>

#include "isolaw/base/option.hpp"
#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/stated_quantity.hpp"
#include "isolaw/data/reading.hpp"

namespace isolaw::campaign {

struct InfoOption : Option<DeviceInfo> {  // a key of a device's table that states a fact about the device
  Measure measure = Measure::text;
};

// Returns the table, which has a row for each fact. A row also checks whether a value is allowed.
std::vector<InfoOption> const& info_table();

// Visits the options for reading a compression test: all but those about the force of a shear test (`of_test`).
template <class Visit>
void for_each_vertical_option(Visit&& visit) {
  for (auto const& option : data::reading_table())
    if (!option.of_test) visit(option);
}

}  // namespace isolaw::campaign
