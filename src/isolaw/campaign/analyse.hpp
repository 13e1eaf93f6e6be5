// After the runs: what each device's test determines of a law, one law for all devices, and that law without each of
// them.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/estimate.hpp"
#include "isolaw/campaign/profile.hpp"
#include "isolaw/campaign/store.hpp"

namespace isolaw::campaign {

// Where a law's parameters are examined on a device: the box of the search, on the scales of `best`.
fit::SearchBox examined_box(Search const& search);
// And in which the one law of all devices was looked for on which the law was examined.
fit::SearchBox box_of_lot(Contents const& contents, std::string_view law);

// A law on a device's record, as a campaign of these settings integrates it.
fit::LawOnRecord law_on_device(Contents const& contents, std::size_t device, std::string_view law, int refinement = 1);

struct AnalyseOptions {
  std::size_t threads = 1;
  std::function<void(std::size_t done, std::size_t total)> progress;  // called from one thread at a time
  std::function<bool()> interrupted;                                  // asked from any thread
  Profile* profile = nullptr;
  Estimate* estimate = nullptr;
  // Of the devices alone, dealt into so many; and where all of them are examined then, of the laws of the lot.
  std::optional<Part> share = {};
};

// Whether each device was examined for each law that has a usable run there: what the laws of the lot start from.
bool every_device_examined(Contents const& contents);

// Makes the analyses that are missing and adds them to the store and to `contents`, whose runs must be complete and
// sorted. The result depends on the runs and the settings alone. Returns how many threads worked.
std::size_t analyse(Contents& contents, Store& store, AnalyseOptions const& options);

}  // namespace isolaw::campaign
