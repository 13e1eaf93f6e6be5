// Makes the analyses that follow the runs: it examines each law on each device's tests, fits one set of the law's
// parameters to all devices (the lot's law), and fits it again without each device in turn.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/estimate.hpp"
#include "isolaw/campaign/profile.hpp"
#include "isolaw/campaign/store.hpp"

namespace isolaw::campaign {

// The box in which a device's analysis varies the parameters: the box of the search, with the logarithmic scales of
// fit::on_logarithmic_scales(). The search itself uses these scales only with Method::best.
fit::SearchBox examined_box(Search const& search);
// The box in which one law is fitted to all devices that count and have a DeviceAnalysis of this law.
fit::SearchBox box_of_lot(Contents const& contents, std::string_view law);

fit::LawOnRecord law_on_device(Contents const& contents, std::size_t device, std::string_view law, int refinement = 1);
// Makes two models of the law on the device's tests: the objective of one counts only the small swings, that of the
// other only the large swings. A swing is the motion from one turning point to the next (data/cycles/swing_sizes.hpp).
// nullopt if the tests have too few small or too few large swings.
std::optional<analysis::SwingModels> law_on_swings(Contents const& contents, std::size_t device, std::string_view law,
                                                   int refinement);

struct AnalysisProgress {
  std::size_t done = 0, total = 0;
  std::string_view law;               // of the latest analysis
  std::optional<std::size_t> device;  // of the latest analysis; nullopt if it fitted the law to the whole lot
};

struct AnalyseOptions {
  std::size_t threads = 1;
  std::function<void(AnalysisProgress const&)> progress;  // called from one thread at a time
  std::function<bool()> interrupted;                      // asked from any thread
  Profile* profile = nullptr;
  Estimate* estimate = nullptr;
  // If given, several processes share the analyses, and this process makes only those of its part. It fits laws to the
  // lot only if the store already holds the analyses of laws on devices of all parts.
  std::optional<Part> share = {};
};

// Whether there is an analysis for every device and law with a usable run. The fits to the lot start from all of these.
bool every_device_examined(Contents const& contents);
// Makes the analyses that are missing and adds them to the store and to `contents`, whose runs must be complete and
// sorted. The result depends on the runs and the settings alone. Returns how many threads the system allowed.
std::size_t analyse(Contents& contents, Store& store, AnalyseOptions const& options);

}  // namespace isolaw::campaign
