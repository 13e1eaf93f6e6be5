// Counts the steps that the laws' code computes, for a campaign's profile; one addition per block of candidates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "isolaw/laws/catalogue.hpp"

namespace isolaw::fit {

// How a law is called: with one candidate on plain doubles, with narrow_block or wide_block candidates for their
// objectives, or with narrow_block or residual_block candidates for their residuals.
enum class Block { scalar, narrow, wide, narrow_residuals, residuals };
inline constexpr std::size_t block_kinds = 5;

struct BlockKind {
  std::size_t law = 0;  // index in the catalogue
  laws::Integration integration = laws::Integration::converged;
  Block block = Block::scalar;
};

struct BlockWork {
  std::uint64_t blocks = 0;
  std::uint64_t steps = 0;  // in all of these blocks together; usually one per sample

  bool operator==(BlockWork const&) const = default;
};

class WorkCount {
 public:
  void add(BlockKind const& kind, std::size_t steps) {
    if (by_law_.size() <= kind.law) by_law_.resize(kind.law + 1);
    auto& work = by_law_[kind.law][place(kind)];
    ++work.blocks;
    work.steps += steps;
  }

  WorkCount& operator+=(WorkCount const& other) {
    if (by_law_.size() < other.by_law_.size()) by_law_.resize(other.by_law_.size());
    for (std::size_t law = 0; law < other.by_law_.size(); ++law)
      for (std::size_t i = 0; i < kinds; ++i) {
        by_law_[law][i].blocks += other.by_law_[law][i].blocks;
        by_law_[law][i].steps += other.by_law_[law][i].steps;
      }
    return *this;
  }

  // Calls visit(BlockKind, BlockWork) for every kind that was counted.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t law = 0; law < by_law_.size(); ++law)
      for (std::size_t i = 0; i < kinds; ++i)
        if (by_law_[law][i].blocks > 0)
          visit(BlockKind{law, static_cast<laws::Integration>(i / block_kinds), static_cast<Block>(i % block_kinds)},
                by_law_[law][i]);
  }

 private:
  static constexpr std::size_t kinds = 2 * block_kinds;  // for each of the two integrations
  static std::size_t place(BlockKind const& kind) {
    return static_cast<std::size_t>(kind.integration) * block_kinds + static_cast<std::size_t>(kind.block);
  }
  std::vector<std::array<BlockWork, kinds>> by_law_;
};

// The count of the calling thread; the caller may reset it.
WorkCount& work_of_this_thread();

inline void count_block(laws::LawEntry const& law, laws::Integration integration, Block block, laws::Path const& path) {
  work_of_this_thread().add({law.index, integration, block}, path.steps.size());
}

}  // namespace isolaw::fit
