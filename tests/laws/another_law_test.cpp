// A user adds a law by one header file and one entry in the list of laws. The law must then work in every part of
// isolaw. These tests add trilinear.hpp in this way.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "cli/models.hpp"
#include "cli/records.hpp"
#include "cli/run.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/programs/exports.hpp"
#include "laws/records.hpp"

namespace isolaw::law_tests {
namespace {

using cli_test::Json;
using cli_test::Words;

constexpr char const* another_law = "trilinear";

TEST(AnotherLaw, IsComputedInLanes) {
  auto const& entry = laws::find_law(another_law);
  auto const record = record_of(irregular(3, 208.0, 3, 40), 0.05, 0.67, 45.0);
  auto const box = fit::make_box(entry, fit::BoxKind::scaled, fit::scales_of(record, entry.info), {});
  fit::LawOnRecord const model(entry, record, laws::Integration::converged);
  std::vector<double> lanes(41), work;
  model.objectives(
      lanes.size(),
      [&](std::size_t i, std::span<double> values) {
        std::ranges::copy(candidate_in(box, static_cast<std::uint32_t>(i)), values.begin());
      },
      lanes, fit::InstructionSet::portable);
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    double const alone = model.objective(candidate_in(box, static_cast<std::uint32_t>(i)), work);
    EXPECT_NEAR(lanes[i], alone, fit::block_tolerance * alone);
  }
}

// `simulate` computes the records of two devices with the trilinear law. The second device is 10 % stiffer.
class AnotherLawInTheProgram : public cli_test::InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    write("motion.csv", cli_test::csv(cli_test::record({.samples = 181, .per_cycle = 60, .interval_s = 0.03})));
    for (auto const& [file, stiffness] : {std::pair{"a.csv", "2"}, std::pair{"b.csv", "2.2"}}) {
      auto const o =
          isolaw({"simulate", another_law, "--set", "K=0.5", "--set", std::string("k1=") + stiffness, "--set", "x1=4",
                  "--set", "k2=0.6", "--set", "x2=30", "--motion", "motion.csv", "--out", file});
      ASSERT_EQ(o.code, 0) << o;
    }
  }
  cli_test::Outcome calibrated(Words const& more = {}) {
    Words words{"calibrate", "a.csv", "b.csv", "--laws", "trilinear,bilinear", "--runs", "2", "--out", "C"};
    words.insert(words.end(), more.begin(), more.end());
    return isolaw(words);
  }
};

TEST_F(AnotherLawInTheProgram, IsListedWithItsParameters) {
  auto const all = isolaw({"laws"}).out;
  auto const listed = all.find("\ntrilinear ");
  ASSERT_NE(listed, std::string::npos) << all;
  EXPECT_NE(all.substr(listed, all.find('\n', listed + 1) - listed).find("all    5 parameters"), std::string::npos);
  auto const o = isolaw({"laws", another_law});
  for (auto const* part :
       {"Trilinear, two elements in parallel", "z1 -> z1 + k1 dx", "stiffness of the second element"})
    EXPECT_NE(o.out.find(part), std::string::npos) << part << " is missing in " << o;
}

TEST_F(AnotherLawInTheProgram, FindsItsOwnParametersAndIsReported) {
  auto const o = calibrated({"--analysis", "full", "--replicates", "40"});
  ASSERT_EQ(o.code, 0) << o;
  auto const found = json("C/summary.json")["laws"][0];
  ASSERT_EQ(found["id"], another_law);
  EXPECT_LT(found["objective"]["mean"].get<double>(), 1e-3);
  EXPECT_NEAR(found["devices"][0]["parameters"]["k2"]["best"].get<double>(), 0.6, 1e-2);
  EXPECT_NEAR(found["devices"][1]["parameters"]["k1"]["best"].get<double>(), 2.2, 1e-2);
  for (auto const* file : {"C/report.html", "C/tables/objective.csv", "C/tables/parameters.csv"})
    EXPECT_NE(read(file).find(another_law), std::string::npos) << file;
  EXPECT_EQ(isolaw({"check", "C"}).code, 0);
  auto const again = isolaw({"simulate", another_law, "--from", "C", "--device", "a", "--motion", "motion.csv"});
  EXPECT_EQ(again.code, 0) << again;
}

TEST_F(AnotherLawInTheProgram, IsHeldToItsJointLimit) {
  auto const o = calibrated({"--set", "trilinear.x1=50", "--set", "trilinear.x2=40"});
  EXPECT_EQ(o.code, 2) << o;
  EXPECT_NE(o.err.find("x1 = 50, x2 = 40; allowed: x1 <= x2"), std::string::npos) << o;
}

// OpenSees, SAP2000 and other programs have no trilinear material, so `export` fits the nearest material that they
// have. Targets in C++ are refused because nobody has written a C++ header of this law.
TEST_F(AnotherLawInTheProgram, IsExported) {
  ASSERT_EQ(calibrated().code, 0);
  auto const to = [&](std::string_view target) {
    Words words{"export", "C", "--law", another_law, "--device", "a", "--to", std::string(target)};
    for (auto const& word : cli_test::needed_by(programs::find_target(target), path("."))) words.push_back(word);
    return isolaw(words);
  };
  constexpr std::array<std::string_view, 3> law_itself{"cpp", "opensees-cpp", "abaqus"};
  for (auto const& target : programs::targets()) {
    auto const o = to(target.name);
    if (std::ranges::find(law_itself, target.name) != law_itself.end()) {
      EXPECT_EQ(o.code, 2) << o;
      EXPECT_NE(o.err.find("law trilinear: no C++ form of it; allowed: another target"), std::string::npos) << o;
      continue;
    }
    EXPECT_EQ(o.code, 0) << target.name << o;
    EXPECT_NE(o.out.find(another_law), std::string::npos) << target.name;
  }
  auto const exported = Json::parse(to("json").out);
  EXPECT_EQ(exported["fidelity"], "re-fitted");
  EXPECT_NE(to("opensees").out.find("no material of OpenSees is known to be this law"), std::string::npos);
}

}  // namespace
}  // namespace isolaw::law_tests
