// Twin experiments: a record that a law made itself, from parameters somewhere in its automatic box, is fitted by that law
// to the last digits, wherever the search starts.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "isolaw/base/hash.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/opt/multistart.hpp"

namespace isolaw::fit {
namespace {

// Three amplitudes of two cycles each at 0.5 Hz, 100 samples per cycle; the force is a law's to make.
data::FitRecord motion() {
  data::FitRecord record;
  constexpr double omega = std::numbers::pi;
  for (int i = 0; i <= 600; ++i) {
    double const t = 0.02 * i, amplitude_mm = 50.0 * (1 + std::min(i / 200, 2));
    record.time_s.push_back(t);
    record.disp_mm.push_back(amplitude_mm * std::sin(omega * t));
    record.vel_mm_s.push_back(amplitude_mm * omega * std::cos(omega * t));
    record.force_kN.push_back(0.7 * record.disp_mm.back() + 25.0 * std::cos(omega * t));
  }
  return record;
}

class Twin : public testing::TestWithParam<std::string> {};

TEST_P(Twin, IsFoundAgain) {
  auto const& law = laws::find_law(GetParam());
  auto record = motion();
  auto const box = make_box(law, BoxKind::scaled, scales_of(record, law.info), {});
  LawOnRecord const scale(law, record, laws::Integration::converged);
  num::Stream const stream(stable_hash(law.info.id));
  std::vector<double> truth(box.parameters.size()), point(box.free_count()), work;
  // The middle of the box; another place where the law has no force there.
  for (std::uint32_t i = 0;; ++i) {
    ASSERT_LT(i, 100u);
    num::Draws draws(stream, 0, i);
    for (double& u : point) u = 0.3 + 0.4 * draws.uniform();
    box.expand(point, truth);
    if (std::isfinite(scale.objective(truth, work))) break;
  }
  record.force_kN = scale.force_kN(truth);

  LawOnRecord const model(law, record, laws::Integration::converged);
  EXPECT_LT(model.objective(truth, work), 1e-12);
  IdentificationProblem const problem(model, box);
  for (std::uint64_t run = 1; run <= 3; ++run) {
    auto const found = opt::minimise_multistart(problem, stream.split(run));
    EXPECT_LT(found.best_value, 1e-3) << "run " << run;
    EXPECT_TRUE(found.usable());
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Twin,
                         testing::Values("bilinear", "jankowski", "vaiana", "bouc-wen", "abe", "abe-y0", "hwang-wu"),
                         [](auto const& info) {
                           auto name = info.param;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

}  // namespace
}  // namespace isolaw::fit
