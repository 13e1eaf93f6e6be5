// Where the time of a campaign goes, phase by phase.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <initializer_list>
#include <mutex>
#include <string_view>

#include "isolaw/base/ahead.hpp"
#include "isolaw/fit/block_cost.hpp"

namespace isolaw::campaign {

// read: until the search begins; report: everything after the last search or analysis, without figures.
enum class Phase { read, search, determination, intervals, lot, left_out, report };
inline constexpr std::array phases{Phase::read, Phase::search,   Phase::determination, Phase::intervals,
                                   Phase::lot,  Phase::left_out, Phase::report};
std::string_view name(Phase phase);

struct PhaseCost {
  double cpu_s = 0.0;   // of the threads that worked on it
  double wall_s = 0.0;  // while it went on
  std::uint64_t evaluations = 0;
  fit::WorkCount work = {};
};

// Of one process: what a campaign held already when it was continued cost nothing. Thread-safe but for reading.
class Profile {
 public:
  void add(Phase phase, double cpu_s, fit::WorkCount const& work);
  void count_evaluations(Phase phase, int evaluations);
  // The time since the mark before, or since the profile was made, belongs to these phases: where there are several,
  // whose pieces take turns, each gets as much as its share of the processor time added since then.
  void mark(std::initializer_list<Phase> of);

  PhaseCost const& operator[](Phase phase) const { return costs_[static_cast<std::size_t>(phase)]; }
  // Measures what has not been measured yet: once for all phases, within a hundredth of their processor time and 20 ms,
  // as far as two passes allow.
  std::array<double, phases.size()> kernel_seconds() const;
  std::array<double, phases.size()> kernel_seconds(fit::BlockCost const& cost) const;

 private:
  using Clock = std::chrono::steady_clock;
  std::mutex mutex_;
  std::array<PhaseCost, phases.size()> costs_;
  std::array<double, phases.size()> cpu_at_mark_{};
  Clock::time_point last_mark_ = Clock::now();
};

// What the calling thread does, and those that help it, for a profile that may not be there.
class Meter final : HelpWatch {
 public:
  explicit Meter(Profile* profile);
  // What was done since it was made, or since the last lap, was for this phase.
  void lap(Phase phase);
  void restart();  // it was for another's meter
  void count_evaluations(Phase phase, int evaluations) const;

 private:
  void help_begins() override;
  void help_ends() override;

  Profile* profile_;
  double before_s_ = 0.0;
  std::mutex mutex_;  // of what helpers did since the last lap
  double helped_s_ = 0.0;
  fit::WorkCount helped_;
};

}  // namespace isolaw::campaign
