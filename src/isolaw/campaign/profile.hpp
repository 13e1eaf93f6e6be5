// Measures the time and work of each phase of a campaign.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <initializer_list>
#include <mutex>
#include <string_view>

#include "isolaw/base/work_ahead.hpp"

namespace isolaw::campaign {

// `read` ends when the search begins. `report` is all work after the last search or analysis except drawing figures.
enum class Phase { read, search, determination, intervals, larger_swings, lot, left_out, report };
inline constexpr std::array phases{Phase::read,          Phase::search, Phase::determination, Phase::intervals,
                                   Phase::larger_swings, Phase::lot,    Phase::left_out,      Phase::report};
std::string_view name(Phase phase);

struct PhaseCost {
  double cpu_s = 0.0;     // processor time of all threads
  double kernel_s = 0.0;  // the part of cpu_s spent in the laws' code
  double wall_s = 0.0;    // elapsed time
  std::uint64_t evaluations = 0;

  PhaseCost& operator+=(PhaseCost const& other);
};

// The cost of this process, without results that an earlier process stored. Adding is thread-safe, reading is not.
class Profile {
 public:
  void add(Phase phase, PhaseCost const& cost);
  // Adds the elapsed time since the last mark, or since construction, to these phases. Phases whose tasks take turns
  // share this time in proportion to the processor time that was added for each since the last mark.
  void mark(std::initializer_list<Phase> ended);

  PhaseCost const& operator[](Phase phase) const { return costs_[static_cast<std::size_t>(phase)]; }

 private:
  using Clock = std::chrono::steady_clock;
  std::mutex mutex_;
  std::array<PhaseCost, phases.size()> costs_;
  std::array<double, phases.size()> cpu_at_mark_{};
  Clock::time_point last_mark_ = Clock::now();
};

// Adds the work of the calling thread, and of threads that help it, to a profile. Does nothing without a profile.
class Meter final : HelpListener {
 public:
  explicit Meter(Profile* profile);
  // Assigns to `phase` the thread's work since it last called lap() on any meter, made a meter, or called restart().
  void lap(Phase phase);
  static void restart();
  void count_evaluations(Phase phase, int evaluations) const;

 private:
  void help_begins() override { restart(); }
  void help_ends() override;

  Profile* profile_;
  std::mutex mutex_;  // guards helped_
  PhaseCost helped_;
};

}  // namespace isolaw::campaign
