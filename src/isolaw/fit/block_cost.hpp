// Measures, in this process, the processor time of a block of candidates; for `isolaw bench` and a campaign's profile.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "isolaw/fit/box.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/fit/work_counter.hpp"

namespace isolaw::fit {

// The second shortest of three or more passes, or the shortest of fewer [s]. Other work on the machine only adds time,
// but a clock of processor time may miss part of one pass.
double shortest_of_passes(std::vector<double> seconds);

// A law on the record that speed is measured on (workload.hpp), with candidates drawn in its published box.
class SpeedTest {
 public:
  static constexpr std::size_t candidates = 4 * wide_block;

  SpeedTest(laws::LawEntry const& law, laws::Integration integration, std::size_t samples);

  std::vector<double> objectives() const;

  // How long to measure: at least least_passes, then up to most_passes until enough_s of processor time is spent [s].
  struct Effort {
    int least_passes, most_passes;
    double enough_s;
  };
  // Processor time of one sample of one block [s]. A pass computes `of_candidates` candidates in blocks of this kind;
  // shortest_of_passes chooses among the passes.
  double seconds_per_sample(Block block, std::size_t of_candidates, Effort const& effort) const;

 private:
  std::size_t samples_;
  LawOnRecord model_;
  SearchBox box_;
  std::vector<double> points_;
};

// Processor time of one step of a block of this kind [s], where a block has about `steps_per_block` steps.
using BlockCost = std::function<double(BlockKind const& kind, double steps_per_block)>;

// Measures each kind of block when it is first asked for, all `kinds` together in about `budget_s`. Not thread-safe.
BlockCost measured_cost(double budget_s, std::size_t kinds);

// The processor time of all counted steps [s], without the code around the laws' own.
double kernel_seconds(WorkCount const& work, BlockCost const& cost);

}  // namespace isolaw::fit
