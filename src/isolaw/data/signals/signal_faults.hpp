// Finds signals that cannot be true. Results from such a signal are wrong, so a block of cycles with a fault has no
// properties. A stage that is much smaller than the record is also searched by itself, on its own scale.
// docs/properties.md has the limits and rates of error. A plateau of displacement is a hold if the force only relaxes
// during it, faster at first than later. It is clipping if the force goes on rising during it and then turns. A plateau
// of force is yielding if it ends at the motion's reversal, and clipping if it lasts longer. Steps of a coarse
// digitiser and noise are no faults.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/data/channels/record.hpp"
#include "isolaw/data/signals/dropouts.hpp"
#include "isolaw/data/signals/spikes.hpp"

namespace isolaw::data {

// The words for a channel with this fault: "clipped", "stuck", "disturbed by spikes", "without its sign", ...
std::string_view said_of(FaultKind kind);

// The kind of fault that a finding is about; nullopt for any other finding.
std::optional<FaultKind> fault_kind(FindingKind kind);

// A finding that says how many `samples` there are (the argument counts them from 0) and names the first five (counted
// from 1): "sample", "time_s", "sample_2", etc.
Finding finding_at(FindingKind kind, std::string const& channel, std::string_view unit,
                   std::span<std::size_t const> samples, std::span<double const> time_s);

// The stages of a test, as ranges of samples, that are much smaller than the whole motion. `disp_mm` must be without
// its spikes and dropouts. Empty if the record is not cyclic.
std::vector<TestRange> small_stages(std::span<double const> disp_mm, std::span<double const> time_s);
// The spikes of a channel: those of the whole record, and those that stand out only within their own stage.
std::vector<Spike> spikes_in(std::span<double const> values, std::span<TestRange const> stages);

// All channels have the same length, but time_s may be empty. O(n log n) in time, O(n) in memory.
std::vector<SignalFault> signal_faults(std::span<double const> disp_mm, std::span<double const> force_kN,
                                       std::span<double const> time_s = {});

// Makes a fault that consists of plateaus. `samples` holds the first sample of each plateau, `longest` is the longest
// plateau's length.
SignalFault standing_fault(FaultKind kind, std::string const& channel, std::string_view unit,
                           std::vector<std::size_t> samples, std::span<double const> time_s, double level,
                           std::size_t longest);
std::vector<SignalFault> spike_faults(std::string const& channel, std::string_view unit, std::vector<Spike> const& off,
                                      std::span<double const> time_s);
std::vector<SignalFault> dropout_faults(std::string const& channel, std::string_view unit,
                                        std::vector<Dropout> const& gone, std::span<double const> time_s);

// Names samples for messages, with their times if there are any: "sample 213 (2.12 s)", or "samples 3, 17 and 21"
// without time. If there are more than five samples, it names five and says how many others there are. The text counts
// samples from 1, the argument counts them from 0.
std::string sample_text(std::span<std::size_t const> samples, std::span<double const> time_s);

}  // namespace isolaw::data
