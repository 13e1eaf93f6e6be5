#include "isolaw/data/channels/record.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace isolaw::data {
namespace {

template <class Record>
void keep_only(TestRange const& range, std::initializer_list<std::vector<double> Record::*> channels, Record& record) {
  for (auto const channel : channels) {
    auto const kept = range.slice(record.*channel);
    record.*channel = std::vector<double>(kept.begin(), kept.end());
  }
  record.starts.clear();
}

}  // namespace

bool TestRecord::counts_half_cycles() const {
  return std::ranges::find(recognised, FindingKind::half_cycles_count, &Finding::kind) != recognised.end();
}

std::size_t SignalFault::longest() const {
  constexpr double most = 1e15;  // a damaged store may hold a number that is too large for std::size_t
  return static_cast<std::size_t>(std::min(most, std::max(1.0, finding.number("longest_samples"))));
}

double FitRecord::largest_scored(std::vector<double> const& values) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (is_scored(i)) largest = std::max(largest, std::abs(values[i]));
  return largest;
}

std::vector<TestRange> test_ranges(std::span<std::size_t const> starts, std::size_t samples) {
  if (starts.empty()) return {{.first = 0, .end = samples}};
  std::vector<TestRange> ranges;
  for (std::size_t i = 0; i < starts.size(); ++i)
    ranges.push_back({.first = starts[i], .end = i + 1 < starts.size() ? starts[i + 1] : samples});
  return ranges;
}

std::vector<SignalFault> faults_in(TestRange const& range, std::span<SignalFault const> faults) {
  std::vector<SignalFault> found(faults.begin(), faults.end());
  for (auto& fault : found) {
    std::erase_if(fault.samples,
                  [&](std::size_t sample) { return sample + fault.longest() <= range.first || sample >= range.end; });
    for (auto& sample : fault.samples) sample = std::max(sample, range.first) - range.first;
  }
  std::erase_if(found, [](SignalFault const& fault) { return fault.samples.empty(); });
  return found;
}

std::vector<TestRecord> tests_of(TestRecord const& record) {
  std::vector<TestRecord> tests;
  for (auto const& range : test_ranges(record.starts, record.size())) {
    auto& test = tests.emplace_back(record);
    keep_only(range,
              {&TestRecord::time_s, &TestRecord::disp_mm, &TestRecord::force_kN, &TestRecord::load_kN,
               &TestRecord::logged_cycle, &TestRecord::second_disp_mm},
              test);
    test.tests.clear();
    test.faults = faults_in(range, record.faults);
  }
  return tests;
}

std::vector<FitRecord> tests_of(FitRecord const& record) {
  std::vector<FitRecord> tests;
  for (auto const& range : test_ranges(record.starts, record.size()))
    keep_only(range,
              {&FitRecord::time_s, &FitRecord::disp_mm, &FitRecord::vel_mm_s, &FitRecord::force_kN, &FitRecord::scored,
               &FitRecord::weights, &FitRecord::block},
              tests.emplace_back(record));
  return tests;
}

bool is_corrected(TestRecord const& record) {
  return std::ranges::any_of(record.corrections, [](Finding const& each) {
    bool const no_spikes = each.kind == FindingKind::spikes_repaired && each.number("count") == 0.0;
    return each.kind != FindingKind::force_multiplied && !no_spikes;
  });
}

}  // namespace isolaw::data
