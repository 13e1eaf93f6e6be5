// Checks a record as a whole: refuses channels that seem exchanged or flipped, and warns of other implausible values.
#pragma once

#include <string>

#include "isolaw/data/properties/properties.hpp"

namespace isolaw::data {

// Throws Error if force and displacement seem to be exchanged, or the force's sign to be flipped. `exchange_advice`
// tells the user how to exchange the columns.
void check_physics(TestRecord const& record, Properties const& properties, std::string const& exchange_advice);

// Finds the faults of the signals test by test. The caller needs this for records from a store that an earlier build
// wrote, because such a store does not hold the faults.
void find_faults(TestRecord& record);

void add_warnings(TestRecord& record, Properties const& properties);

}  // namespace isolaw::data
