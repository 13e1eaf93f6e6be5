// Selects the part of a test that laws are judged by. The history before it acts on a law's state but is not scored.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/cycles.hpp"

namespace isolaw::data {

// "3", "2-5", "4-" (to the last), and several of these separated by commas.
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
  std::string text() const;  // parse_numbers() reads it back; "all" when empty
  bool operator==(Numbers const&) const = default;
};

// Throws an Error that names `option`. "all" selects all of them.
Numbers parse_numbers(std::string_view option, std::string_view text);

struct Selection {
  Numbers blocks, cycles;
  Numbers predicted = {};  // blocks that the fitted law then predicts (--score-blocks); all: every other block
  bool all() const { return blocks.all() && cycles.all(); }
  std::string text() const;  // "blocks 1-2", "cycles 1-3 of block 2"; empty if all are selected
};

// 1 for every sample that counts and 0 for the others; empty if all count. If only blocks are selected, partial cycles
// within them count too. Throws an Error that lists the blocks and cycles if fewer than two samples are left.
std::vector<double> scored_samples(Selection const& selection, Segmentation const& segmentation, std::size_t samples);

// The block number of every sample in a scored or predicted block, else 0; empty if no block is left out. Throws Error
// when none of the named blocks to predict is left.
std::vector<double> block_numbers(Selection const& selection, Segmentation const& segmentation, std::size_t samples);

}  // namespace isolaw::data
