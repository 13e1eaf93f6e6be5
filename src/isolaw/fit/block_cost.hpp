// What a block of candidates costs here, measured in this process: for `isolaw bench` and a campaign's profile.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "isolaw/fit/box.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/fit/work_counter.hpp"

namespace isolaw::fit {

// The second shortest of three passes or more, the shortest of fewer [s]: what else the machine does only adds time,
// but a clock of processor time may leave some of one pass out.
double shortest_of_passes(std::vector<double> seconds);

// A law on the record that speed is measured on, with candidates drawn in its published box.
class SpeedTest {
 public:
  static constexpr std::size_t candidates = 4 * wide_block;

  SpeedTest(laws::LawEntry const& law, laws::Integration integration, std::size_t samples);

  std::vector<double> objectives() const;

  // How long is measured: these passes at least, then more until so much processor time is spent.
  struct Effort {
    int least_passes, most_passes;
    double enough_s;
  };
  // Processor time of one sample of a block [s], `shortest_of_passes` of so many candidates in blocks of this kind.
  double seconds_per_sample(Block block, std::size_t of_candidates, Effort const& effort) const;

 private:
  std::size_t samples_;
  LawOnRecord model_;
  SearchBox box_;
  std::vector<double> points_;
};

// Processor time of one step of a block of this kind, in blocks of about so many steps [s].
using BlockCost = std::function<double(BlockKind const& kind, double steps_per_block)>;

// Measures every kind once, when it is first asked for; all of them together in about `budget_s`. For one thread.
BlockCost measured_cost(double budget_s, std::size_t kinds);

// Every step that was counted at its cost; without what surrounds the laws' code.
double kernel_seconds(WorkCount const& work, BlockCost const& cost);

}  // namespace isolaw::fit
