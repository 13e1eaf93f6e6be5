// Checks the values of one channel: overloads of a sensor, a constant channel, time that goes back.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>
#include "isolaw/base/error.hpp"
#include "isolaw/data/files/table.hpp"

namespace isolaw::data {

// `lines` holds the line number of each value.
void check_channel(std::string const& file, RawChannel const& raw, std::span<std::size_t const> lines,
                   std::vector<Complaint>& complaints);

}  // namespace isolaw::data
