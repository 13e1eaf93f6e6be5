#include "isolaw/fit/block_cost.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "isolaw/base/processor_time.hpp"
#include "isolaw/fit/workload.hpp"

namespace isolaw::fit {
namespace {

struct Counted {
  std::string_view law;
  laws::Integration integration;
  Block block;
  BlockWork work;

  bool operator==(Counted const&) const = default;
};

std::vector<Counted> counted(WorkCount const& work) {
  std::vector<Counted> all;
  work.for_each([&](BlockKind const& kind, BlockWork const& of) {
    all.push_back({laws::catalogue()[kind.law].info.id, kind.integration, kind.block, of});
  });
  return all;
}

// The work that `compute` adds to this thread's count.
template <class Compute>
WorkCount work_of(Compute&& compute) {
  work_of_this_thread() = {};
  compute();
  return std::exchange(work_of_this_thread(), {});
}

class BlockCounts : public ::testing::Test {
 protected:
  static constexpr auto converged = laws::Integration::converged, paper = laws::Integration::paper;
  static LawOnRecord model(std::string_view law, laws::Integration integration = converged, int refinement = 1) {
    return {laws::find_law(law), workload(100), integration, laws::TurningPoints::as_sampled, refinement};
  }
  static void objectives(LawOnRecord const& model, std::size_t count, InstructionSet set = instruction_set()) {
    std::vector<double> values(count);
    model.objectives(count, candidate(model), values, set);
  }
  static void residuals(LawOnRecord const& model, std::size_t count, InstructionSet set = instruction_set()) {
    std::vector<double> values(count * model.samples());
    model.residuals(count, candidate(model), values, set);
  }
  static std::function<void(std::size_t, std::span<double>)> candidate(LawOnRecord const& model) {
    auto const box = make_box(model.law(), BoxKind::published, scales_of(workload(100), model.law().info), {});
    return [box](std::size_t i, std::span<double> values) {
      std::vector<double> const point(box.free_count(), 0.3 + 0.001 * static_cast<double>(i));
      box.expand(point, values);
    };
  }
};

TEST(ShortestOfPasses, is_not_the_one_that_a_clock_cut_short) {
  EXPECT_EQ(shortest_of_passes({0.27, 0.04, 0.31, 0.28}), 0.27);
  EXPECT_EQ(shortest_of_passes({0.3, 0.29, 0.28}), 0.29);
  EXPECT_EQ(shortest_of_passes({0.3, 0.29}), 0.29);
  EXPECT_EQ(shortest_of_passes({0.3}), 0.3);
}

TEST_F(BlockCounts, EveryBlockIsCountedWithItsStepsByLawIntegrationAndWidth) {
  if (instruction_set() == InstructionSet::scalar) GTEST_SKIP() << "no blocks";
  auto const work = work_of([] {
    objectives(model("bilinear"), 100);  // three blocks of 32, and one of 8 half filled by the last four
    residuals(model("bilinear"), 18);    // one block of 16, one of 8
    objectives(model("bouc-wen", paper), 8);
  });
  EXPECT_EQ(counted(work), (std::vector<Counted>{{"bilinear", converged, Block::narrow, {1, 100}},
                                                 {"bilinear", converged, Block::wide, {3, 300}},
                                                 {"bilinear", converged, Block::narrow_residuals, {1, 100}},
                                                 {"bilinear", converged, Block::residuals, {1, 100}},
                                                 {"bouc-wen", paper, Block::narrow, {1, 100}}}));
}

TEST_F(BlockCounts, ScalarEvaluationsFinerStepsAndTheFinePathOfTheShiftCount) {
  auto const fine = model("hwang-wu", converged, 4);
  std::size_t const steps = fine.samples() * 4 - 3;  // one per finer step; the first sample needs none
  auto const work = work_of([&] {
    objectives(fine, 3, InstructionSet::scalar);
    residuals(fine, 2, InstructionSet::scalar);
  });
  EXPECT_EQ(counted(work), (std::vector<Counted>{{"hwang-wu", converged, Block::scalar, {5, 5 * steps}}}));
  std::vector<double> parameters(fine.law().parameters.size());
  candidate(fine)(0, parameters);
  auto const shift = work_of([&] { fine.integration_shift(parameters); });
  EXPECT_EQ(counted(shift).at(0).work, (BlockWork{2, steps + (fine.samples() - 1) * 4 * shift_refinement + 1}));
}

TEST_F(BlockCounts, AreOfTheThreadThatComputes) {
  auto const work = work_of([] { std::thread([] { objectives(model("bilinear"), 8); }).join(); });
  EXPECT_TRUE(counted(work).empty());
}

TEST_F(BlockCounts, KernelSecondsAreEveryStepAtItsCost) {
  if (instruction_set() == InstructionSet::scalar) GTEST_SKIP() << "no blocks";
  auto work = work_of([] {
    objectives(model("bilinear"), 100);
    residuals(model("bouc-wen", paper), 24);
  });
  work += work_of([] { objectives(model("bilinear"), 8); });
  auto const seconds = kernel_seconds(work, [](BlockKind const& kind, double steps_per_block) {
    EXPECT_EQ(steps_per_block, 100.0);
    bool const of_paper = kind.integration == paper;
    EXPECT_EQ(of_paper, kind.law == laws::find_law("bouc-wen").index);
    return of_paper ? 1e-3 : kind.block == Block::wide ? 2.0 : kind.block == Block::narrow ? 50.0 : 0.0;
  });
  EXPECT_DOUBLE_EQ(seconds, 300 * 2.0 + 200 * 50.0 + 200 * 1e-3);
}

// Uses processor time, which other work on the machine does not change by such factors.
TEST_F(BlockCounts, TheMeasuredCostIsOfTheSizeOfWhatTheWorkTook) {
  for (auto const* law : {"bilinear", "bouc-wen", "abe"}) {
    auto const of_law = model(law);
    double took_s = 0.0;
    auto const work = work_of([&] {
      double const start = thread_time_s();
      for (int i = 0; i < 40; ++i) {
        objectives(of_law, 128);
        residuals(of_law, 32);
      }
      took_s = thread_time_s() - start;
    });
    double const seconds = kernel_seconds(work, measured_cost(5e-3, 2));
    EXPECT_GT(seconds, 0.1 * took_s) << law;
    EXPECT_LT(seconds, 10.0 * took_s) << law;
  }
}

TEST_F(BlockCounts, AKindIsMeasuredOnce) {
  auto const work = work_of([] { objectives(model("jankowski"), 64); });
  auto const cost = measured_cost(1e-3, 1);
  auto const first = kernel_seconds(work, cost);
  auto const again = work_of([&] { EXPECT_EQ(kernel_seconds(work, cost), first); });
  EXPECT_TRUE(counted(again).empty());
}

}  // namespace
}  // namespace isolaw::fit
