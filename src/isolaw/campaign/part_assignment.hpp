// Assigns the runs and analyses of a campaign to its parts, so that the parts take about equally long. Runs are sorted
// by estimated cost and given to the parts in turn. The costs are estimated from the settings and records and not
// measured, so that every machine finds the same assignment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

class RunAssignment {
 public:
  RunAssignment(Contents const& contents, int parts);  // `contents` must hold the records
  // The part, counted from 1, of run `number` of contents.searches[search], which must not be refused.
  int part_of(std::size_t search, int number) const {
    return part_[search * runs_ + static_cast<std::size_t>(number) - 1];
  }

 private:
  std::size_t runs_;
  std::vector<int> part_;
};

// Returns, for each of contents.searches, the part that analyses the device for the law (campaign/analyse.hpp), or 0 if
// the search was refused. The costliest analyses are assigned first, each to the part with the least work so far.
std::vector<int> assign_analyses(Contents const& contents, int parts);
// Returns, for each of settings.laws, the part that fits the law to the lot and to the lot without each device.
std::vector<int> assign_laws(Contents const& contents, int parts);

std::uint64_t relative_cost(Contents const& contents, Search const& search);  // only ratios have a meaning

}  // namespace isolaw::campaign
