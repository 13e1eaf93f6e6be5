// Tests the choice of the blocks and cycles whose samples are scored, which means that they count in a law's objective.
#include "isolaw/data/cycles/selection.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include "isolaw/base/error.hpp"

namespace isolaw::data {
namespace {

using Range = Numbers::Range;

Numbers parse(std::string_view text) {
  return parse_numbers("--fit-cycles", text);
}

TEST(ParseNumbers, NumbersAndRanges) {
  EXPECT_TRUE(parse("all").all());
  EXPECT_EQ(parse("3").ranges, (std::vector<Range>{{3, 3}}));
  EXPECT_EQ(parse("2-5").ranges, (std::vector<Range>{{2, 5}}));
  EXPECT_EQ(parse("4-").ranges, (std::vector<Range>{{4, Numbers::largest}}));
  EXPECT_EQ(parse(" 1, 3 - 4 ,7-").ranges, (std::vector<Range>{{1, 1}, {3, 4}, {7, Numbers::largest}}));
}

TEST(ParseNumbers, TextReadsBack) {
  for (std::string const text : {"all", "3", "2-5", "4-", "1,3-4,7-"}) EXPECT_EQ(parse(text).text(), text);
}

TEST(ParseNumbers, OtherTextIsRefusedAndQuoted) {
  for (std::string const text : {"", ",", "0", "-3", "5-2", "x", "1,", "1-2-3", "1.5", "+2", "99999999999", "3;4"}) {
    try {
      parse(text);
      ADD_FAILURE() << "'" << text << "' was read";
    } catch (Error const& error) {
      EXPECT_NE(std::string(error.what()).find("--fit-cycles: '" + text + "'"), std::string::npos) << error.what();
    }
  }
}

TEST(ParseNumbers, Contains) {
  auto const numbers = parse("2,4-5,9-");
  std::vector<int> found;
  for (int n = 0; n <= 11; ++n)
    if (numbers.contains(n)) found.push_back(n);
  EXPECT_EQ(found, (std::vector{2, 4, 5, 9, 10, 11}));
  EXPECT_TRUE(Numbers{}.contains(123456));
}

// Returns two blocks of two cycles each at about 10 samples a cycle. Half a cycle follows the second block.
Segmentation two_blocks() {
  Segmentation s;
  s.cyclic = true;
  s.cycles = {{.block = 1, .number = 1, .not_counted = {}, .first = 0.0, .last = 10.0},
              {.block = 1, .number = 2, .not_counted = {}, .first = 10.0, .last = 20.5},
              {.block = 2, .number = 1, .not_counted = {}, .first = 20.5, .last = 30.25},
              {.block = 2, .number = 2, .not_counted = {}, .first = 30.25, .last = 40.0},
              {.block = 2, .number = 0, .not_counted = "partial", .first = 40.0, .last = 45.0}};
  return s;
}

std::string scored(std::string_view blocks, std::string_view cycles) {
  Selection const selection{parse_numbers("--fit-blocks", blocks), parse_numbers("--fit-cycles", cycles)};
  std::string text;
  for (double const value : scored_samples(selection, two_blocks(), 50)) text += value == 1.0 ? '#' : '.';
  return text;
}

TEST(ScoredSamples, AreThoseOfTheChosenBlocksAndCycles) {
  EXPECT_EQ(scored("all", "all"), "");
  EXPECT_EQ(scored("1", "all"), std::string(21, '#') + std::string(29, '.'));
  EXPECT_EQ(scored("2-", "all"), std::string(21, '.') + std::string(25, '#') + std::string(4, '.'));
  EXPECT_EQ(scored("all", "2"), std::string(10, '.') + std::string(11, '#') + std::string(10, '.') +
                                    std::string(10, '#') + std::string(9, '.'));
  EXPECT_EQ(scored("2", "1"), std::string(21, '.') + std::string(10, '#') + std::string(19, '.'));
  EXPECT_EQ(scored("all", "1-"), std::string(41, '#') + std::string(9, '.'));  // the half cycle is not scored
}

TEST(ScoredSamples, NothingLeftSaysWhatThereIs) {
  try {
    scored("2", "7");
    ADD_FAILURE();
  } catch (Error const& error) {
    std::string const what = error.what();
    EXPECT_NE(what.find("--fit-blocks 2 --fit-cycles 7"), std::string::npos) << what;
    EXPECT_NE(what.find("block 1: cycles 1 to 2; block 2: cycles 1 to 2"), std::string::npos) << what;
  }
  Segmentation none;
  EXPECT_THROW(scored_samples({parse("1"), {}}, none, 50), Error);
  // A history without cycles has no blocks to choose from.
  auto not_cyclic = two_blocks();
  not_cyclic.cyclic = false;
  for (auto const& selection : {Selection{parse("1"), {}}, Selection{parse("2"), {}}, Selection{{}, parse("1")}}) {
    try {
      scored_samples(selection, not_cyclic, 50);
      ADD_FAILURE();
    } catch (Error const& error) {
      std::string const what = error.what();
      EXPECT_NE(what.find("the record is not cyclic: it has no cycles to choose among"), std::string::npos) << what;
    }
  }
}

}  // namespace
}  // namespace isolaw::data
