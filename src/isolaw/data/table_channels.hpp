// Makes the channels of a record from a table, in the record's units.
#pragma once

#include <optional>

#include "isolaw/data/columns.hpp"
#include "isolaw/data/record_parts.hpp"
#include "isolaw/data/table.hpp"

namespace isolaw::data {

// Another file's first time stamp, if --from and --to count from it.
struct FirstStamp {
  double since_s = 0.0;
  bool dated = false;
};

// `record` already holds the facts about the file. Throws Error with every problem found.
RecordPart read_channels(Tests const& tests, Table const& table, TestRecord record, ReadOptions const& options,
                         Wanted wanted, std::optional<FirstStamp> const& origin = {});

}  // namespace isolaw::data
