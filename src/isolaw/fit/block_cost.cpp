#include "isolaw/fit/block_cost.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include "isolaw/base/processor_time.hpp"
#include "isolaw/fit/workload.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::fit {
namespace {

std::size_t candidates_of(Block block) {
  switch (block) {
    case Block::scalar:
      return 1;
    case Block::wide:
      return wide_block;
    case Block::residuals:
      return residual_block;
    default:
      return narrow_block;
  }
}

}  // namespace

double shortest_of_passes(std::vector<double> seconds) {
  // A shared host has been seen to count a pass at a seventh of its time.
  auto const place = seconds.begin() + (seconds.size() > 2 ? 1 : 0);
  std::ranges::nth_element(seconds, place);
  return *place;
}

SpeedTest::SpeedTest(laws::LawEntry const& law, laws::Integration integration, std::size_t samples)
    : samples_(samples),
      model_(law, workload(samples), integration),
      box_(make_box(law, BoxKind::published, scales_of(workload(samples), law.info), {})),
      points_(candidates * box_.free_count()) {
  num::Draws draws(num::Stream(1), 0, 0);
  for (double& coordinate : points_) coordinate = draws.uniform();
}

std::vector<double> SpeedTest::objectives() const {
  std::vector<double> values(candidates);
  auto const candidate = [&](std::size_t i, std::span<double> parameters) {
    box_.expand(std::span(points_).subspan(i * box_.free_count(), box_.free_count()), parameters);
  };
  model_.objectives(candidates, candidate, values);
  return values;
}

double SpeedTest::seconds_per_sample(Block block, std::size_t of_candidates, Effort const& effort) const {
  std::size_t const width = candidates_of(block), blocks = std::max<std::size_t>(of_candidates / width, 1);
  bool const of_residuals = block == Block::residuals || block == Block::narrow_residuals;
  std::vector<double> values(of_residuals ? width * samples_ : width), one(model_.law().parameters.size()), work;
  auto const compute = [&](std::size_t first) {
    auto const candidate = [&](std::size_t i, std::span<double> parameters) {
      auto const at = (first + i) % candidates * box_.free_count();
      box_.expand(std::span(points_).subspan(at, box_.free_count()), parameters);
    };
    if (of_residuals) return model_.residual_rows(width, candidate, width, values);
    if (block != Block::scalar) return model_.objectives(width, candidate, values);
    candidate(0, one);
    values[0] = model_.objective(one, work);
  };
  std::vector<double> passes;
  double spent = 0.0;
  for (int pass = 0; pass < effort.least_passes || (spent < effort.enough_s && pass < effort.most_passes); ++pass) {
    double const start = thread_time_s();
    for (std::size_t i = 0; i < blocks; ++i) compute(i * width);
    double const seconds = thread_time_s() - start;
    passes.push_back(seconds);
    spent += seconds;
  }
  return shortest_of_passes(std::move(passes)) / static_cast<double>(blocks * samples_);
}

BlockCost measured_cost(double budget_s, std::size_t kinds) {
  // The test record is as long as the blocks that were counted, since the fixed cost of a block weighs more on a short
  // record. Beyond the length that `isolaw bench` uses that cost is small.
  constexpr double fewest = 50.0, most = 600.0, resolved_s = 20e-6;
  using Known = std::map<std::tuple<std::size_t, laws::Integration, Block>, double>;
  auto known = std::make_shared<Known>();
  return [=](BlockKind const& kind, double steps_per_block) {
    auto const [entry, is_new] = known->try_emplace({kind.law, kind.integration, kind.block}, 0.0);
    if (is_new) {
      auto const counted = std::exchange(work_of_this_thread(), {});  // put back below: measuring is not to be counted
      auto const samples = static_cast<std::size_t>(std::clamp(steps_per_block, fewest, most));
      SpeedTest const test(laws::catalogue()[kind.law], kind.integration, samples);
      // The first pass only tells how many blocks take long enough for the clock.
      auto const width = candidates_of(kind.block);
      double const once =
          test.seconds_per_sample(kind.block, width, {.least_passes = 1, .most_passes = 1, .enough_s = 0.0});
      auto const blocks = static_cast<std::size_t>(
          std::clamp(resolved_s / (once * static_cast<double>(samples)), 1.0, SpeedTest::candidates / 1.0));
      entry->second = test.seconds_per_sample(
          kind.block, blocks * width,
          {.least_passes = 3, .most_passes = 50, .enough_s = budget_s / static_cast<double>(kinds)});
      work_of_this_thread() = counted;
    }
    return entry->second;
  };
}

double kernel_seconds(WorkCount const& work, BlockCost const& cost) {
  double sum = 0.0;
  work.for_each([&](BlockKind const& kind, BlockWork const& counted) {
    auto const steps = static_cast<double>(counted.steps);
    sum += steps * cost(kind, steps / static_cast<double>(counted.blocks));
  });
  return sum;
}

}  // namespace isolaw::fit
