// A law remembers only a bounded number of turning points. These tests compare its force with that of a law without
// this bound.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "isolaw/laws/memory/open_branches.hpp"
#include "isolaw/laws/online/motion.hpp"
#include "laws/candidates.hpp"
#include "laws/motion.hpp"

namespace isolaw::law_tests {
namespace {

template <class Law>
class TurningPoints : public ::testing::Test {};
TYPED_TEST_SUITE(TurningPoints, EveryLaw, LawName);

constexpr int shrinking_turns = 3000;
constexpr double amplitude = 200.0;

// Returns four paths whose turns come closer and closer together: by equal amounts about 0 mm and about 150 mm, by
// equal shares about 0 mm, and by random shares.
std::vector<std::vector<double>> shrinking() {
  std::vector<std::vector<double>> paths(4, {0.0});
  num::Draws draws(num::Stream(11), 0, 0);
  double top = amplitude, bottom = -amplitude;
  for (int i = 0; i < shrinking_turns; ++i) {
    double const side = i % 2 == 0 ? 1.0 : -1.0, left = 1.0 - static_cast<double>(i) / shrinking_turns;
    paths[0].push_back(side * amplitude * left);
    paths[1].push_back(150.0 + 50.0 * side * left);
    paths[2].push_back(side * amplitude * std::pow(0.999, i));
    double const middle = 0.5 * (top + bottom), share = std::pow(draws.uniform(), 20.0 / shrinking_turns);
    double& end = side > 0.0 ? top : bottom;
    end = middle + (end - middle) * share;
    paths[3].push_back(end);
  }
  return paths;
}

// Computes the remembered turning points of the path again, without a limit on their number.
void keep_all(laws::Path& path) {
  std::vector<double> turned;
  double before = 0.0;
  for (std::size_t i = 0; i < path.steps.size(); ++i) {
    auto& memory = path.memory[i];
    double const x = path.steps[i].x1, direction = memory.direction;
    memory.turn_index = memory.turns ? turned.size() : laws::Memory::none;
    memory.first_dropped = laws::Memory::none;
    if (memory.turns) turned.push_back(before);
    path.deepest = std::max(path.deepest, turned.size());
    while (turned.size() >= 2 && direction * (x - turned[turned.size() - 2]) >= 0.0) turned.resize(turned.size() - 2);
    if (turned.size() == 1 && direction * (x + turned[0]) >= 0.0) turned.clear();
    memory.branch_index = turned.empty() ? laws::Memory::none : turned.size() - 1;
    memory.branch_x = turned.empty() ? 0.0 : turned.back();
    before = x;
  }
}

// After the turns the motion goes on to the full amplitude, to one side or the other. docs/laws.md states how much the
// forces may differ.
TYPED_TEST(TurningPoints, DroppingThemChangesTheForceLittle) {
  if (!TypeParam::info.traits.masing) GTEST_SKIP() << "keeps no turning points";
  for (auto const& path_in : shrinking())
    for (double const side : {1.0, -1.0}) {
      auto x = path_in;
      double const from = x.back();
      for (int i = 1; i <= 400; ++i) x.push_back(from + (side * amplitude - from) * i / 400);
      auto const path = laws::make_path(x, {});
      auto unlimited = path;
      keep_all(unlimited);
      EXPECT_EQ(path.deepest, laws::OpenBranches::most);
      EXPECT_GT(unlimited.deepest, 2 * laws::OpenBranches::most);
      for (std::uint32_t index = 0; index < 10; ++index) {
        auto const values = scaled_candidate<TypeParam>(index);
        auto const force = forces<TypeParam>(values, path), all = forces<TypeParam>(values, unlimited);
        EXPECT_LT(largest_difference(force, all), 4e-3 * largest_magnitude(all)) << describe<TypeParam>(values);
      }
    }
}

TYPED_TEST(TurningPoints, TheStateOfATrialIsBounded) {
  using Motion = laws::Motion<TypeParam>;
  typename Motion::Parameters const parameters{
      laws::unpack<TypeParam, double>(std::span<double const>(scaled_candidate<TypeParam>(0))), 0.0};
  auto const constants = laws::constants_of<TypeParam, double, laws::Dual>(parameters);
  typename Motion::State committed, trial;
  committed.law = Motion::first_state(parameters, constants);
  double const to_law = 1.0 / TypeParam::info.length.in_record_units;
  auto const path = shrinking().front();
  for (double const x : path) {
    Motion::move(parameters, constants, committed, x * to_law, 0.0, 1, trial);
    Motion::keep(trial, committed);
  }
  std::size_t size = 0;
  laws::Members counted([&](double&) { ++size; });
  counted(committed);
  EXPECT_LE(size, 64 + 5 * laws::OpenBranches::most);
}

}  // namespace
}  // namespace isolaw::law_tests
