// Makes a record's channels, in its units, from the columns of a table.
#pragma once

#include <optional>

#include "isolaw/data/channels/columns.hpp"
#include "isolaw/data/channels/record_parts.hpp"
#include "isolaw/data/files/table.hpp"

namespace isolaw::data {

// The first time stamp of the first of several files. --from and --to count from it in all of the files.
struct FirstStamp {
  double since_s = 0.0;  // since midnight; since 1970 if the stamp has a date
  bool dated = false;
};

// `record` already holds the file's name and hash. Throws Error with every problem found.
RecordPart read_channels(Tests const& tests, Table const& table, TestRecord record, ReadOptions const& options,
                         Wanted wanted, std::optional<FirstStamp> const& origin = {});

}  // namespace isolaw::data
