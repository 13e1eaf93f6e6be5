// How the energy of a cycle falls through a block: what a device loses by heat, wear and damage, and what a law has of
// it. From the third counted cycle on, for what goes before is scragging, which laws without wear may follow.
#pragma once

#include <optional>
#include <vector>

#include "isolaw/data/properties.hpp"
#include "isolaw/data/record.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Of the block where most is lost, of those of eight counted cycles or more; nullopt where none loses a tenth steadily:
// a quarter of it or more in either half of the cycles. `force_kN` is the law's at the record's samples.
std::optional<EnergyFall> energy_fall(data::Properties const& measured, data::FitRecord const& record,
                                      std::vector<double> const& force_kN);

// Whether a law has half of it or more.
bool follows(EnergyFall const& fall);

}  // namespace isolaw::study
