// Which part of a campaign computes a run: runs in the order of what they cost in all likelihood, dealt in turn, so
// that parts are even. The same deal on every machine: nothing is measured for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

class Deal {
 public:
  // Of a campaign with its records.
  Deal(Contents const& contents, int parts);

  // Of a run of contents.searches[search], which was not refused.
  int part_of(std::size_t search, int number) const {
    return part_[search * runs_ + static_cast<std::size_t>(number) - 1];
  }

 private:
  std::size_t runs_;
  std::vector<int> part_;
};

// Which of `parts` examines a device for a law (campaign/analyse.hpp), for each of contents.searches: the dearest
// first, each to the part that has least to do. 0 where the search was refused.
std::vector<int> deal_of_analyses(Contents const& contents, int parts);
// And which fits a law to the lot and leaves each device out, for each of settings.laws.
std::vector<int> deal_of_laws(Contents const& contents, int parts);

// What a run costs in all likelihood, in proportion alone.
std::uint64_t relative_cost(Contents const& contents, Search const& search);

}  // namespace isolaw::campaign
