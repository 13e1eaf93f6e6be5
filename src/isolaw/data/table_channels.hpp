// From a table to the channels of a record: columns recognised, rows and time cut to what was asked for, values in the
// record's units, and each channel checked by itself.
#pragma once

#include <optional>

#include "isolaw/data/columns.hpp"
#include "isolaw/data/record_parts.hpp"
#include "isolaw/data/table.hpp"

namespace isolaw::data {

// What the times asked for count from, where that is the first time stamp of another file.
struct FirstStamp {
  double since_s = 0.0;
  bool dated = false;
};

// The channels of one table, before anything is asked of them together; what is known of the file stands in `record`
// already. Throws Error with every problem found.
RecordPart read_channels(Tests const& tests, Table const& table, TestRecord record, ReadOptions const& options,
                         Wanted wanted, std::optional<FirstStamp> const& origin = {});

}  // namespace isolaw::data
