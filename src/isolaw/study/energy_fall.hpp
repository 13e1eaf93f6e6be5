// How the energy of a cycle falls through a block, on the device (by heat, wear and damage) and in a law. Counting
// starts at the third counted cycle, since the loss before it is scragging, which a law without wear can follow.
#pragma once

#include <optional>
#include <vector>

#include "isolaw/data/channels/record.hpp"
#include "isolaw/data/properties/properties.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// The fall in the block that loses most, among the blocks of eight or more counted cycles. A block counts only if a
// cycle's energy falls by at least a tenth, with at least a quarter of the fall in each half of the block. `force_kN`
// is the law's force at the record's samples. Returns nullopt if no block counts.
std::optional<EnergyFall> energy_fall(data::Properties const& measured, data::FitRecord const& record,
                                      std::vector<double> const& force_kN);
// True if the law loses at least half as much energy as the device.
bool follows(EnergyFall const& fall);

}  // namespace isolaw::study
