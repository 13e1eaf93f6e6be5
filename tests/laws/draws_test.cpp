// Draws parameter sets at random from the whole box of every law. Each force must be finite. Exceptions are sets that
// are known to have no finite force, and for those the objective must be infinite. The environment variable
// ISOLAW_DRAWS sets the number of sets per law and box. The test prints how many had no finite force.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "laws/paper.hpp"
#include "laws/records.hpp"
#include "laws/single_laws.hpp"
#include "not_finite.hpp"

namespace isolaw::law_tests {
namespace {

using laws::Integration;

struct Box {
  std::string name;
  fit::BoxKind kind;
  data::FitRecord record;
  std::vector<fit::Override> overrides = {};
};

// Returns the published search box, and the boxes that isolaw chooses for devices from a small specimen to a large
// bearing. The records have twenty samples a cycle, the fewest that isolaw accepts. For bouc-wen a last box allows
// negative beta and gamma, so many of its parameter sets have no bounded force.
std::vector<Box> boxes_of(std::string const& law) {
  using fit::BoxKind;
  auto const published = record_of(sine(208.0, 0.5, 3, 20), 0.1, 0.67, 45.0);
  std::vector<Box> boxes{
      {"published, 208 mm", BoxKind::published, published},
      {"published, irregular", BoxKind::published, record_of(irregular(1, 208.0, 3, 20), 0.02, 0.67, 45.0)},
      {"auto, 208 mm", BoxKind::scaled, published},
      {"auto, 2 mm", BoxKind::scaled, record_of(sine(2.0, 5.0, 3, 20), 0.01, 0.5, 0.3)},
      {"auto, 900 mm irregular", BoxKind::scaled, record_of(irregular(2, 900.0, 3, 20), 0.02, 5.0, 900.0)},
  };
  if (law == "bouc-wen")
    boxes.push_back({"beta, gamma signed",
                     BoxKind::scaled,
                     published,
                     {fit::parse_override("bouc-wen.beta=-0.1:0.1"), fit::parse_override("bouc-wen.gamma=-0.1:0.1")}});
  return boxes;
}

struct Count {
  std::uint32_t drawn = 0, inadmissible = 0, not_finite = 0;
};

Count draw(laws::LawEntry const& law, Box const& in, Integration integration) {
  auto const box = fit::make_box(law, in.kind, fit::scales_of(in.record, law.info), in.overrides);
  fit::LawOnRecord const model(law, in.record, integration);
  double const peak_mm = largest_magnitude(in.record.disp_mm);
  Count count;
  std::vector<double> work;
  for (count.drawn = 0; count.drawn < draws(2000); ++count.drawn) {
    auto const candidate = candidate_in(box, count.drawn);
    double const objective = model.objective(candidate, work);
    bool const finite = all_finite(model.force_kN(candidate)), refused = inadmissible(law, candidate);
    count.inadmissible += refused ? 1 : 0;
    count.not_finite += finite ? 0 : 1;
    auto const complain = [&](char const* what) {
      ADD_FAILURE() << what << ", objective " << objective << ": " << describe(law, candidate);
    };
    if (!std::isfinite(objective) && objective != infinity) complain("neither a number nor +infinity");
    if (!finite && objective != infinity) complain("a force is not finite, and the objective does not say so");
    if (refused && objective != infinity) complain("an inadmissible candidate is not flagged");
    // The integration of Cucuzza et al. 2025 takes one explicit Runge-Kutta step per sample, which may overflow for any
    // parameter set.
    if (integration == Integration::converged && !finite && !refused && !may_run_away(law, candidate, peak_mm))
      complain("a force is not finite for no known reason");
    if (::testing::Test::HasFailure()) break;
  }
  return count;
}

class Draws : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Every, Draws, ::testing::ValuesIn(law_ids()), ByLaw());

TEST_P(Draws, GiveAForceOrAreFlagged) {
  auto const& law = laws::find_law(GetParam());
  for (auto const& box : boxes_of(GetParam()))
    for (auto const integration : {Integration::converged, Integration::paper}) {
      auto const began = std::chrono::steady_clock::now();
      auto const count = draw(law, box, integration);
      double const time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
      fmt::print("{:10} {:22} {:9} {:6} drawn, {:5} inadmissible, {:5} not finite, {:.1f} s\n", law.info.id, box.name,
                 integration == Integration::paper ? "paper" : "converged", count.drawn, count.inadmissible,
                 count.not_finite, time_s);
      std::fflush(stdout);
      // In a corner of hwang-wu's automatic box the force grows without bound. 0.4 to 0.8 % of the drawn sets lay in
      // that corner; 3 % are allowed.
      if (integration == Integration::converged) {
        EXPECT_LE(count.not_finite - count.inadmissible, 0.03 * count.drawn) << box.name;
      }
    }
}

}  // namespace
}  // namespace isolaw::law_tests
