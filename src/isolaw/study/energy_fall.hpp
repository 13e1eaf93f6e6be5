// How the energy of a cycle falls through a block: on the device by heat, wear and damage, and by a law. It counts from
// the third counted cycle on, since the loss before that is scragging, which laws without wear may follow.
#pragma once

#include <optional>
#include <vector>

#include "isolaw/data/properties.hpp"
#include "isolaw/data/record.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// The fall in the block that loses most, among blocks of eight or more counted cycles. nullopt where no block loses a
// tenth steadily, a quarter of that or more in either half. `force_kN` is the law's force at the record's samples.
std::optional<EnergyFall> energy_fall(data::Properties const& measured, data::FitRecord const& record,
                                      std::vector<double> const& force_kN);
// True where the law loses half as much as the device, or more.
bool follows(EnergyFall const& fall);

}  // namespace isolaw::study
