#include "isolaw/data/properties/remainder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

namespace isolaw::data {
namespace {

// The kinds of fault that a remainder can show. If a record has several, the first in this order decides which channel
// and which block are drawn.
constexpr std::array drawn{FindingKind::signal_spike, FindingKind::stiffness_rises, FindingKind::offset_steps,
                           FindingKind::hum, FindingKind::lag_grows};

// Whether the finding is drawn. A finding with the word "part" is not, because it concerns one of several tests of a
// device, and its times and blocks refer to that test alone.
bool is_drawn(Finding const& finding) {
  return std::ranges::find(drawn, finding.kind) != drawn.end() && finding.word("part").empty();
}

bool is_of_force(Finding const& finding) {
  return finding.word("channel") != "displacement";
}

int block_of(Finding const& finding, Properties const& properties) {
  return !finding.blocks.empty() ? finding.blocks.front() : properties.reported ? properties.reported->block : 1;
}

// The channel with each spike replaced by the mean of its neighbours, because a spike would distort the mean cycle.
std::vector<double> without_spikes(std::span<double const> values, std::span<SignalFault const* const> spikes) {
  std::vector<double> result(values.begin(), values.end());
  for (auto const* fault : spikes)
    for (auto const i : fault->samples)
      if (i > 0 && i + 1 < values.size()) result[i] = (values[i - 1] + values[i + 1]) / 2.0;
  return result;
}

// Returns the mean of the cycles at `size` + 1 phases that divide a cycle into equal parts.
std::vector<double> mean_cycle(std::span<double const> values, std::span<Cycle const* const> cycles, std::size_t size) {
  std::vector<double> mean(size + 1);
  for (auto const* cycle : cycles)
    for (std::size_t j = 0; j <= size; ++j) {
      double const part = static_cast<double>(j) / static_cast<double>(size);
      mean[j] +=
          value_at(values, cycle->first + part * (cycle->last - cycle->first)) / static_cast<double>(cycles.size());
    }
  return mean;
}

// A centred moving average over `width` parts of a mean cycle. Past the end of the cycle it goes on at the start,
// because cycles repeat.
std::vector<double> averaged(std::vector<double> const& cycle, std::size_t width) {
  auto const size = cycle.size() - 1;
  std::vector<double> result(size + 1);
  for (std::size_t j = 0; j <= size; ++j)
    for (std::size_t k = 0; k <= width / 2; ++k) {
      double const share = (k == 0 || 2 * k == width ? 0.5 : 1.0) / static_cast<double>(width);
      result[j] += share * (cycle[(j + size - k) % size] + cycle[(j + k) % size]);
    }
  return result;
}

}  // namespace

std::optional<Remainder> remainder(TestRecord const& record, Properties const& properties) {
  std::vector<Finding> doubts;
  std::ranges::copy_if(record.warnings, std::back_inserter(doubts), [&](Finding const& finding) {
    return is_drawn(finding) && std::ranges::none_of(properties.faults, [&](SignalFault const& fault) {
             return fault.is_outside() && fault.finding == finding;
           });
  });
  if (doubts.empty()) return std::nullopt;
  auto const& first = *std::ranges::min_element(
      doubts, {}, [](Finding const& each) { return std::ranges::find(drawn, each.kind) - drawn.begin(); });
  Remainder result{.of_force = is_of_force(first), .block = block_of(first, properties)};
  if (static_cast<std::size_t>(result.block) > properties.blocks.size()) return std::nullopt;
  auto const& block = properties.blocks[static_cast<std::size_t>(result.block) - 1];
  auto const cycles = block.whole();
  if (cycles.size() < 2) return std::nullopt;
  std::span<double const> const values = result.of_force ? record.force_kN : record.disp_mm;
  auto const size = static_cast<std::size_t>(std::ceil(cycles.back()->last - cycles.back()->first));
  std::vector<SignalFault const*> spikes;
  for (auto const& fault : record.faults)
    if (fault.kind == FaultKind::spike && (fault.channel == "force") == result.of_force) spikes.push_back(&fault);
  auto mean = mean_cycle(without_spikes(values, spikes), std::span(cycles).subspan(cycles.size() > 2 ? 1 : 0), size);
  for (auto const& finding : doubts) {
    if (is_of_force(finding) != result.of_force || block_of(finding, properties) != result.block) continue;
    if (finding.kind == FindingKind::hum && block.frequency_Hz)
      mean = averaged(
          mean, static_cast<std::size_t>(std::max(1.0, std::round(static_cast<double>(size) * *block.frequency_Hz /
                                                                  finding.number("frequency_Hz")))));
    if (finding.has_number("time_s") && finding.kind != FindingKind::signal_spike)
      result.at.push_back(finding.number("time_s"));
  }
  result.first = static_cast<std::size_t>(std::ceil(cycles.front()->first));
  auto const end = static_cast<std::size_t>(std::ceil(cycles.back()->last));
  for (auto const* fault : spikes)
    for (auto const sample : fault->samples)
      if (sample >= result.first && sample < end)
        result.at.push_back(record.has_time() ? record.time_s[sample] : static_cast<double>(sample));
  result.values.assign(end - result.first, std::numeric_limits<double>::quiet_NaN());
  for (auto const* cycle : cycles)
    for (auto i = static_cast<std::size_t>(std::ceil(cycle->first)); static_cast<double>(i) < cycle->last; ++i) {
      double const part = (static_cast<double>(i) - cycle->first) / (cycle->last - cycle->first);
      result.values[i - result.first] = values[i] - value_at(mean, part * static_cast<double>(size));
    }
  return result;
}

}  // namespace isolaw::data
