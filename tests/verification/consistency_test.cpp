// The laws, with the published means of ten devices, are compared with one another and with an independent program, as
// docs/source.md describes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "laws/motion.hpp"
#include "laws/paper.hpp"
#include "verification/consistency_data.hpp"

namespace isolaw::law_tests {
namespace {

constexpr int samples_per_cycle = 200;
constexpr std::size_t third_cycle = 2 * samples_per_cycle;
Motion motion() {
  return sine(208.0, 0.5, 3, samples_per_cycle);
}

consistency::Law const& expected(std::string_view id) {
  return *std::ranges::find_if(consistency::laws, [&](auto const& law) { return law.id == id; });
}

template <class Law>
std::vector<double> force_kN(std::size_t device) {
  auto force = forces<Law>(published_means<Law>(device), motion());
  for (double& f : force) f *= Law::info.force.in_record_units;
  return force;
}

struct Loop {
  double force_max_kN, effective_stiffness_kN_per_mm, damping_percent;
};

Loop third_loop(std::vector<double> const& force_kN) {
  auto const x = motion().disp_mm;
  auto const first = x.begin() + third_cycle;
  auto const at = [&](auto it) { return force_kN[static_cast<std::size_t>(it - x.begin())]; };
  auto const [low, high] = std::minmax_element(first, x.end());
  double const stiffness = (at(high) - at(low)) / (*high - *low), D = 0.5 * (*high - *low);
  double energy = 0.0;
  for (std::size_t i = third_cycle; i + 1 < x.size(); ++i)
    energy += 0.5 * (force_kN[i] + force_kN[i + 1]) * (x[i + 1] - x[i]);
  return {*std::max_element(force_kN.begin() + third_cycle, force_kN.end()), stiffness,
          100.0 * energy / (2.0 * std::numbers::pi * stiffness * D * D)};
}

template <class Law>
class Consistency : public ::testing::Test {};
TYPED_TEST_SUITE(Consistency, PaperLaws, LawName);

// The project's specification gives the tolerances. The expected values are printed with few digits, which rounds them
// by up to 0.005 kN, 0.00005 kN/mm and 0.005 %.
TYPED_TEST(Consistency, ThirdCycleOfTenDevices) {
  auto const& reference = expected(TypeParam::info.id);
  for (std::size_t device = 0; device < table_a5::devices; ++device) {
    SCOPED_TRACE("device " + std::to_string(device + 1));
    auto const loop = third_loop(force_kN<TypeParam>(device));
    EXPECT_NEAR(loop.force_max_kN, reference.force_max_kN[device], 0.05);
    EXPECT_NEAR(loop.effective_stiffness_kN_per_mm, reference.effective_stiffness_kN_per_mm[device], 0.0005);
    EXPECT_NEAR(loop.damping_percent, reference.damping_percent[device], 0.05);
  }
}

TYPED_TEST(Consistency, DifferenceFromLaws2And3) {
  auto const& reference = expected(TypeParam::info.id);
  for (std::size_t device = 0; device < table_a5::devices; ++device) {
    auto const force = force_kN<TypeParam>(device), second = force_kN<laws::Jankowski>(device),
               third = force_kN<laws::Vaiana>(device);
    double const count = static_cast<double>(force.size());
    double mean = 0.0, square = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i) {
      double const ref = 0.5 * (second[i] + third[i]);
      mean += ref / count;
      square += ref * ref / count;
      difference += std::abs(force[i] - ref) / count;
    }
    EXPECT_NEAR(difference / std::sqrt(square - mean * mean), reference.difference[device], 0.001)
        << "device " << device + 1;
  }
}

}  // namespace
}  // namespace isolaw::law_tests
