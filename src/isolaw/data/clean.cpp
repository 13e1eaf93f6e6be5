#include "isolaw/data/clean.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <span>

#include "isolaw/base/error.hpp"
#include "isolaw/data/properties/error_budget.hpp"

namespace isolaw::data {
namespace {

struct Range {
  std::size_t first = 0, end = 0;
};

Range centring_range(Properties const& properties, std::size_t size) {
  if (!properties.reported) return {.end = size};
  auto const& cycle = *properties.reported;
  return {.first = static_cast<std::size_t>(std::floor(cycle.first)),
          .end = std::min(size, static_cast<std::size_t>(std::ceil(cycle.last)) + 1)};
}

double remove_middle(std::vector<double>& values, Range const& range) {
  auto const [least, largest] = std::ranges::minmax(std::span(values).subspan(range.first, range.end - range.first));
  double const middle = (largest + least) / 2.0;
  for (double& value : values) value -= middle;
  return middle;
}

void center(FitRecord& record, Properties const& properties) {
  auto const range = centring_range(properties, record.size());
  double const disp_mm = remove_middle(record.disp_mm, range);
  double const force_kN = remove_middle(record.force_kN, range);
  auto& step = record.cleaning.emplace_back(
      Finding{.kind = FindingKind::centred, .numbers = {{"disp_mm", disp_mm}, {"force_kN", force_kN}}});
  if (!properties.reported) {
    step.words = {{"whole", "yes"}};
    return;
  }
  step.blocks = {properties.reported->block};
  step.numbers.push_back({"cycle", static_cast<double>(properties.reported->number)});
}

void average(FitRecord& record, int window) {
  record.disp_mm = moving_average(record.disp_mm, window);
  record.force_kN = moving_average(record.force_kN, window);
}

std::size_t thinning_step(FitRecord& record, Properties const& properties, std::optional<int> wanted) {
  if (!wanted) {
    record.cleaning.push_back({.kind = FindingKind::all_samples_kept, .words = {{"option", "--samples-per-cycle"}}});
    return 1;
  }
  if (!properties.samples_per_cycle) {
    record.cleaning.push_back({.kind = FindingKind::all_samples_kept});
    return 1;
  }
  double const found = *properties.samples_per_cycle;
  // Without the factor, a rounding error could make the quotient 4.9999 instead of 5, and floor() would return 4.
  auto const step = static_cast<std::size_t>(std::floor(found / *wanted * (1.0 + 1e-9)));
  if (step >= 2) return step;
  record.cleaning.push_back({.kind = FindingKind::all_samples_kept,
                             .numbers = {{"samples_per_cycle", found}, {"wanted", static_cast<double>(*wanted)}}});
  return 1;
}

std::vector<double> every(std::vector<double> const& values, std::size_t step) {
  std::vector<double> kept;
  kept.reserve(values.size() / step + 1);
  for (std::size_t i = 0; i < values.size(); i += step) kept.push_back(values[i]);
  return kept;
}

void drop_samples(FitRecord& record, std::size_t step) {
  for (auto* values :
       {&record.time_s, &record.disp_mm, &record.vel_mm_s, &record.force_kN, &record.scored, &record.block})
    *values = every(*values, step);
}

struct Chosen {  // FitRecord::scored and FitRecord::block for each sample of the raw record; empty if all samples count
  std::vector<double> scored, block;
};

// Takes the samples in [first, last] out of the objective, and out of their blocks.
void take_out(Chosen& chosen, double first, double last) {
  auto const size = chosen.scored.size();
  auto const begin = static_cast<std::size_t>(std::max(0.0, std::ceil(first)));
  last = std::clamp(std::floor(last), 0.0, static_cast<double>(size));
  auto const end = std::min(size, static_cast<std::size_t>(last) + 1);
  for (auto* values : {&chosen.scored, &chosen.block})
    if (!values->empty() && begin < end)
      std::fill(values->begin() + static_cast<std::ptrdiff_t>(begin),
                values->begin() + static_cast<std::ptrdiff_t>(end), 0.0);
}

// Chooses the samples that the objective counts. It leaves out:
// - blocks with a signal or a loop that cannot be true,
// - faulty samples outside the blocks, and the neighbours that averaging mixes with them,
// - the samples in which a device has lost its force.
Chosen chosen_by(CleanOptions const& options, TestRecord const& raw, Properties const& properties) {
  auto const& selection = options.scored;
  Chosen chosen;
  if (!selection.all()) {
    auto const segmentation =
        segment(raw.disp_mm, raw.time_s, raw.starts,
                {.load_kN = raw.load_kN, .logged_cycle = raw.logged_cycle, .half_cycles = raw.counts_half_cycles()});
    chosen = {.scored = scored_samples(selection, segmentation, raw.size()),
              .block = block_numbers(selection, segmentation, raw.size())};
  }
  bool const any_faulty = std::ranges::any_of(properties.blocks, [](Block const& b) { return !b.fault.empty(); }) ||
                          std::ranges::any_of(properties.faults, &SignalFault::is_outside);
  // If no block is sound, the caller refuses the whole device and says why, so no samples need to be left out.
  if (properties.refusal_is_of_fault || (!any_faulty && !properties.failure)) return chosen;
  if (chosen.scored.empty()) chosen.scored.assign(raw.size(), 1.0);
  for (auto const& block : properties.blocks)
    if (!block.fault.empty() && !block.cycles.empty())
      take_out(chosen, block.cycles.front().first, block.cycles.back().last);
  double const thinned =
      options.samples_per_cycle ? properties.samples_per_cycle.value_or(0.0) / *options.samples_per_cycle : 0.0;
  double const reach = std::ceil((options.smooth + thinned) / 2.0);
  for (auto const& fault : properties.faults)
    for (std::size_t k = 0; fault.is_outside() && k < fault.samples.size(); ++k) {
      auto const at = static_cast<double>(fault.samples[k]);
      take_out(chosen, at - reach, at + static_cast<double>(fault.longest()) - 1.0 + reach);
    }
  for (auto const& [first, last] : properties.samples_without_force) take_out(chosen, first, last);
  return chosen;
}

void note_unsound(FitRecord& record, Properties const& properties) {
  for (auto const& block : properties.blocks)
    if (!block.fault.empty())
      record.cleaning.push_back({.kind = FindingKind::faulty_not_scored, .blocks = {block.number}});
  if (std::ranges::any_of(properties.faults, &SignalFault::is_outside))
    record.cleaning.push_back(
        {.kind = FindingKind::faulty_not_scored, .words = {{"outside", "the samples outside the blocks"}}});
  if (!properties.failure) return;
  bool const for_good = std::isinf(properties.samples_without_force.back().second);
  record.cleaning.push_back(
      {.kind = FindingKind::failed_not_scored,
       .blocks = properties.failure->blocks,
       .words = {{for_good ? "for_good" : "for_a_time", std::string(properties.failure->word("where"))}}});
}

void choose_scored(FitRecord& record, std::span<double const> scored, std::span<double const> block,
                   Selection const& selection) {
  if (scored.empty()) return;
  record.scored.assign(scored.begin(), scored.end());
  record.block.assign(block.begin(), block.end());
  if (selection.all()) return;
  record.cleaning.push_back({.kind = FindingKind::scored_in_part,
                             .numbers = {{"samples", static_cast<double>(std::ranges::count(record.scored, 1.0))},
                                         {"of", static_cast<double>(scored.size())}},
                             .words = {{"blocks", selection.blocks.text()}, {"cycles", selection.cycles.text()}}});
}

// Sets the weights of the samples of all tests. They stay empty if each sample counts by the time around it. If the
// user chooses no weighting, samples are weighted by swing, or by time if all swings of all tests are alike.
void weigh(FitRecord& record, bool has_time, std::vector<TestSource> const& tests, std::optional<Weighting> asked) {
  if (asked == Weighting::time) return;
  auto const ranges = test_ranges(record.starts, record.size());
  auto const time_in = [&](TestRange const& range) {
    return has_time ? range.slice(record.time_s) : std::span<double const>();
  };
  std::vector<Swing> all;
  std::vector<Weighting> used;
  for (auto const& range : ranges) {
    auto const found = swings(range.slice(record.disp_mm), time_in(range));
    all.insert(all.end(), found.begin(), found.end());
    auto const wanted = asked.value_or(Weighting::swing);
    used.push_back(wanted == Weighting::swing && found.empty() ? Weighting::time : wanted);
  }
  if (!asked && !all.empty() && are_alike(all)) return;
  bool const one_way = std::ranges::count(used, used.front()) == std::ssize(used);
  if (!one_way || used.front() != Weighting::time)
    for (std::size_t t = 0; t < ranges.size(); ++t)
      std::ranges::copy(sample_weights(ranges[t].slice(record.disp_mm), time_in(ranges[t]), used[t]),
                        std::back_inserter(record.weights));
  for (std::size_t t = 0; t < (one_way ? 1 : used.size()); ++t) {
    auto& finding = record.cleaning.emplace_back(
        Finding{.kind = FindingKind::samples_weighed, .words = {{"weights", std::string(name(used[t]))}}});
    if (!one_way) finding.words.push_back({"part", tests[t].name});
  }
}

// Refuses a moving average over a quarter of a cycle or more: it would lower the amplitude by a tenth, so parameters
// fitted to the record would mean nothing.
void refuse_wide_window(int window, Properties const& properties) {
  if (!properties.samples_per_cycle || window < 0.25 * *properties.samples_per_cycle) return;
  throw Error({fmt::format("--smooth {}", window),
               fmt::format("the average spans {:.2f} cycles of {:.1f} samples", window / *properties.samples_per_cycle,
                           *properties.samples_per_cycle),
               "less than a quarter of a cycle", "--smooth 5"});
}

std::vector<double> sample_numbers(std::size_t size) {
  std::vector<double> numbers(size);
  std::iota(numbers.begin(), numbers.end(), 0.0);
  return numbers;
}

// Does all steps of cleaning one test except the weights, which depend on the device's other tests too.
FitRecord clean_test(TestRecord const& raw, Properties const& properties, std::span<double const> scored,
                     std::span<double const> block, CleanOptions const& options) {
  FitRecord record;
  record.disp_mm = raw.disp_mm;
  record.force_kN = raw.force_kN;
  record.time_s = raw.has_time() ? raw.time_s : sample_numbers(raw.size());
  if (options.center) center(record, properties);
  refuse_wide_window(options.smooth, properties);
  if (options.smooth > 1) {
    average(record, options.smooth);
    auto& step = record.cleaning.emplace_back(
        Finding{.kind = FindingKind::smoothed, .numbers = {{"window_samples", static_cast<double>(options.smooth)}}});
    if (auto const samples = properties.samples_per_cycle) {
      step.numbers.push_back({"percent", average_loss_percent(options.smooth, *samples)});
      step.numbers.push_back({"third_harmonic_percent", average_loss_percent(options.smooth, *samples / 3.0)});
    }
  } else {
    record.cleaning.push_back({.kind = FindingKind::not_smoothed});
  }
  choose_scored(record, scored, block, options.scored);
  auto const step = thinning_step(record, properties, options.samples_per_cycle);
  int const window = static_cast<int>(step % 2 == 0 ? step + 1 : step);
  if (step >= 2) average(record, window);
  if (raw.has_time()) {
    record.vel_mm_s = central_difference(record.time_s, record.disp_mm);
    record.cleaning.push_back({.kind = FindingKind::velocity_computed});
  } else {
    record.cleaning.push_back({.kind = FindingKind::no_velocity});
  }
  if (step >= 2) {
    drop_samples(record, step);
    record.cleaning.push_back({.kind = FindingKind::samples_thinned,
                               .numbers = {{"from_per_cycle", *properties.samples_per_cycle},
                                           {"to_per_cycle", *properties.samples_per_cycle / static_cast<double>(step)},
                                           {"every", static_cast<double>(step)},
                                           {"of_samples", static_cast<double>(raw.size())},
                                           {"samples", static_cast<double>(record.size())},
                                           {"window_samples", static_cast<double>(window)}}});
  }
  record.dead_band_mm = options.dead_band_mm.value_or(dead_band_of(record.disp_mm));
  return record;
}

struct Before {  // how many samples and blocks the earlier tests of a record have
  std::size_t samples = 0;
  int blocks = 0;
};

void append(FitRecord& device, FitRecord test, TestSource const& source, Before const& before) {
  device.starts.push_back(device.size());
  if (!test.has_time())
    for (double& sample : test.time_s) sample += static_cast<double>(before.samples);
  for (auto const channel : {&FitRecord::time_s, &FitRecord::disp_mm, &FitRecord::vel_mm_s, &FitRecord::force_kN,
                             &FitRecord::scored, &FitRecord::block})
    std::ranges::copy(test.*channel, std::back_inserter(device.*channel));
  for (auto& step : test.cleaning) {
    step.words.push_back({"part", source.name});
    for (int& block : step.blocks) block += before.blocks;
    device.cleaning.push_back(std::move(step));
  }
  device.dead_band_mm = std::max(device.dead_band_mm, test.dead_band_mm);
}

}  // namespace

FitRecord clean(TestRecord const& raw, CleanOptions const& options) {
  return clean(raw, cyclic_properties(raw), options);
}

FitRecord clean(TestRecord const& raw, Properties const& properties, CleanOptions const& options) {
  if (raw.size() == 0)
    throw Error({.where = raw.file, .found = "a record of 0 samples", .allowed = "a record with samples"});
  auto const chosen = chosen_by(options, raw, properties);
  FitRecord record;
  if (raw.starts.empty()) {
    record = clean_test(raw, properties, chosen.scored, chosen.block, options);
  } else {
    auto const tests = tests_of(raw);
    auto const ranges = test_ranges(raw.starts, raw.size());
    int blocks = 0;
    for (std::size_t t = 0; t < tests.size(); ++t) {
      auto const of_test = cyclic_properties(tests[t]);
      append(record,
             clean_test(tests[t], of_test, ranges[t].slice(chosen.scored), ranges[t].slice(chosen.block), options),
             raw.tests[t], {.samples = ranges[t].first, .blocks = blocks});
      if (!of_test.blocks.empty()) blocks += of_test.blocks.back().number;
    }
  }
  if (!chosen.scored.empty()) note_unsound(record, properties);
  weigh(record, raw.has_time(), raw.tests, options.weights);
  return record;
}

double dead_band_of(std::vector<double> const& disp_mm) {
  auto const [least, most] = std::ranges::minmax(disp_mm);
  double const band = 3.0 * noise_deviation(disp_mm);
  // The displacement of a computed record has only rounding errors, which need no dead band.
  return band > 1e-6 * (most - least) ? band : 0.0;
}

FitRecord motion_of(TestRecord const& record) {
  FitRecord motion;
  motion.disp_mm = record.disp_mm;
  motion.time_s = record.has_time() ? record.time_s : sample_numbers(record.size());
  motion.starts = record.starts;
  if (record.has_time())
    for (auto const& test : tests_of(record))
      std::ranges::copy(central_difference(test.time_s, test.disp_mm), std::back_inserter(motion.vel_mm_s));
  return motion;
}

}  // namespace isolaw::data
