// Selects the samples of a test that the objective counts. A law also runs through the samples before them: these
// change its state, but do not enter the objective.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/cycles/cycles.hpp"

namespace isolaw::data {

// Numbers of blocks or cycles that the user selects: "3", "2-5", "4-" (up to the last), or several of these with
// commas.
struct Numbers {
  struct Range {
    int first = 1;
    int last = 1;  // `largest`: up to the last one
    bool operator==(Range const&) const = default;
  };
  static constexpr int largest = 1'000'000;
  std::vector<Range> ranges;  // empty: all numbers

  bool all() const { return ranges.empty(); }
  bool contains(int number) const;
  std::string text() const;  // as parse_numbers() reads it; "all" if `ranges` is empty
  bool operator==(Numbers const&) const = default;
};

// Parses a selection such as "1,3-5"; "all" gives empty ranges. Throws an Error that names `option`.
Numbers parse_numbers(std::string_view option, std::string_view text);

struct Selection {
  Numbers blocks, cycles;
  Numbers predicted = {};  // blocks on which the fitted law is tested (--score-blocks); all: every block not fitted
  bool all() const { return blocks.all() && cycles.all(); }
  std::string text() const;  // "blocks 1-2", "cycles 1-3 of block 2"; empty if all are selected
};

// 1 for each sample that the objective counts, 0 for the others; empty if it counts all. If only blocks and no cycles
// are selected, their partial cycles count too. Throws an Error that lists blocks and cycles if fewer than two samples
// are selected.
std::vector<double> scored_samples(Selection const& selection, Segmentation const& segmentation, std::size_t samples);

// For each sample, the number of its block if that block is fitted or predicted, else 0. Empty if all blocks are
// fitted. Throws Error if blocks to predict are named and the record has none of them, or only fitted ones.
std::vector<double> block_numbers(Selection const& selection, Segmentation const& segmentation, std::size_t samples);

}  // namespace isolaw::data
