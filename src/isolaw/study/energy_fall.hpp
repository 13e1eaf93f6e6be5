// Compares how much the energy of a cycle falls in the course of a block: on the device, where heat, wear and damage
// lower it, and in a law. The fall is measured from the third counted cycle (data/cycles) on. The loss before that
// cycle is scragging, which a law without wear can follow.
#pragma once

#include <optional>
#include <vector>

#include "isolaw/data/channels/record.hpp"
#include "isolaw/data/properties/properties.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Chooses the block in which the energy on the device falls by the largest percentage from the third counted cycle to
// the last. A block is considered only if it has at least eight counted cycles and the energy falls by at least a
// tenth. At least a quarter of the fall must occur in each half of these cycles. `force_kN` is the law's force at the
// record's samples. nullopt without such a block.
std::optional<EnergyFall> energy_fall(data::Properties const& measured, data::FitRecord const& record,
                                      std::vector<double> const& force_kN);
// True if the energy falls in the law by at least half the percentage by which it falls on the device.
bool follows(EnergyFall const& fall);

}  // namespace isolaw::study
