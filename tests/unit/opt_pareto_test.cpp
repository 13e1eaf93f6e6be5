// Tests the front of non-dominated points on cases worked out by hand, and on random points against a second
// computation from the definition of the front.
#include "isolaw/opt/pareto.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "isolaw/num/random.hpp"
#include "not_finite.hpp"

namespace isolaw::opt {
namespace {

using Flags = std::vector<bool>;
using Values = std::vector<double>;

TEST(NonDominated, NoPointOnePointAndATrade) {
  EXPECT_EQ(non_dominated({}, {}), Flags{});
  EXPECT_EQ(non_dominated(Values{1}, Values{1}), Flags{true});
  EXPECT_EQ(non_dominated(Values{1, 2, 3, 3}, Values{3, 2, 1, 3}), (Flags{true, true, true, false}));
}

TEST(NonDominated, ATieInOneObjectiveIsDecidedByTheOther) {
  EXPECT_EQ(non_dominated(Values{1, 1}, Values{2, 1}), (Flags{false, true}));
  EXPECT_EQ(non_dominated(Values{2, 1}, Values{1, 1}), (Flags{false, true}));
}

TEST(NonDominated, DuplicatesAreOnTheFrontTogetherOrNotAtAll) {
  EXPECT_EQ(non_dominated(Values{1, 1, 2, 2}, Values{1, 1, 2, 2}), (Flags{true, true, false, false}));
}

TEST(NonDominated, ValuesThatAreNotFiniteNeitherWinNorDominate) {
  EXPECT_EQ(non_dominated(Values{0, nan, -infinity, 1}, Values{nan, 0, -infinity, 1}),
            (Flags{false, false, false, true}));
  EXPECT_EQ(non_dominated(Values{infinity, nan}, Values{1, nan}), (Flags{false, false}));
}

// The second computation sorts the points by a, then by b. A point is on the front if its b is below the b of every
// point that comes before it. A point equal to a point of the front is on the front too.
TEST(NonDominated, AgreesWithASweepOnRandomPoints) {
  num::Draws draws(num::Stream(1), 0, 0);
  for (int repetition = 0; repetition < 50; ++repetition) {
    Values a(40), b(40);
    for (auto* values : {&a, &b})
      // Only 12 different values occur, so there are many ties.
      for (double& value : *values) value = static_cast<double>(draws.below(12));
    std::vector<std::size_t> order(a.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [&](std::size_t i, std::size_t j) { return a[i] != a[j] ? a[i] < a[j] : b[i] < b[j]; });
    Flags expected(a.size());
    double lowest = infinity, a_of_lowest = -infinity;
    for (auto const i : order) {
      expected[i] = b[i] < lowest || (b[i] == lowest && a[i] == a_of_lowest);
      if (b[i] < lowest) lowest = b[i], a_of_lowest = a[i];
    }
    EXPECT_EQ(non_dominated(a, b), expected);
  }
}

}  // namespace
}  // namespace isolaw::opt
