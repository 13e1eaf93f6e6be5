// Which part of a test the laws are judged by (options --fit-blocks and --fit-cycles): for example the stable cycles
// alone, leaving out scragging. The history before still acts on a law's state; it is only not scored.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/cycles.hpp"

namespace isolaw::data {

// Block or cycle numbers from 1: "3", "2-5", "4-" (to the last), and several of these separated by commas.
struct Numbers {
  struct Range {
    int first = 1;
    int last = 1;  // `largest`: to the last
    bool operator==(Range const&) const = default;
  };
  static constexpr int largest = 1'000'000;
  std::vector<Range> ranges;  // empty: all

  bool all() const { return ranges.empty(); }
  bool contains(int number) const;
  std::string text() const;  // reads back; "all" when empty
  bool operator==(Numbers const&) const = default;
};

// Throws Error that names `option`: anything else than numbers, ranges that fall, "all" is all of them.
Numbers parse_numbers(std::string_view option, std::string_view text);

struct Selection {
  Numbers blocks, cycles;
  Numbers predicted = {};  // blocks that the law of the others is then tried on (--score-blocks); all: every other one
  bool all() const { return blocks.all() && cycles.all(); }
  std::string text() const;  // "blocks 1-2", "cycles 1-3 of block 2"; empty where all is
};

// 1 for every sample that counts and 0 for the others; empty where all of them do. By blocks alone: everything from the
// block's first cut to its last, partial cycles included; by cycles: the counted cycles of these numbers. Throws Error
// when nothing is left, or only a sample: with the blocks and cycles there are.
std::vector<double> scored_samples(Selection const& selection, Segmentation const& segmentation, std::size_t samples);

// The number of its block for every sample of a block that is scored or predicted, from the block's first cut to its
// last; 0 elsewhere; empty where the selection leaves out no block. Throws Error when blocks to predict were named and
// none of them is left.
std::vector<double> block_numbers(Selection const& selection, Segmentation const& segmentation, std::size_t samples);

}  // namespace isolaw::data
