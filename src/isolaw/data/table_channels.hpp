// Makes the channels of a record from a table: recognises columns, keeps the rows and times asked for, converts values
// to the record's units, and checks each channel by itself.
#pragma once

#include <optional>

#include "isolaw/data/columns.hpp"
#include "isolaw/data/record_parts.hpp"
#include "isolaw/data/table.hpp"

namespace isolaw::data {

// The first time stamp of another file, if the times asked for count from there.
struct FirstStamp {
  double since_s = 0.0;
  bool dated = false;
};

// The channels of one table, before they are checked together; `record` already holds what is known of the file. Throws
// Error with every problem found.
RecordPart read_channels(Tests const& tests, Table const& table, TestRecord record, ReadOptions const& options,
                         Wanted wanted, std::optional<FirstStamp> const& origin = {});

}  // namespace isolaw::data
