// How the energy of a cycle falls through a block: on the device, by heat, wear and damage, and in a law. The fall is
// counted from the third counted cycle on: the loss before that is scragging, which laws without wear may follow.
#pragma once

#include <optional>
#include <vector>

#include "isolaw/data/properties.hpp"
#include "isolaw/data/record.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// The fall in the block of eight or more counted cycles that loses most. Returns nullopt unless a cycle's energy falls
// by a tenth, at least a quarter of that in each half of the block. `force_kN` is the law's force at the record's
// samples.
std::optional<EnergyFall> energy_fall(data::Properties const& measured, data::FitRecord const& record,
                                      std::vector<double> const& force_kN);
// True if the law loses at least half as much as the device.
bool follows(EnergyFall const& fall);

}  // namespace isolaw::study
