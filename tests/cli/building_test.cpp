// `isolaw building` as a user meets it: template, example, a run from a campaign, what is refused.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "cli/run.hpp"

namespace isolaw::cli_test {
namespace {

class Building : public InFreshDirectory {
 protected:
  // Two blocks of a bilinear device with a little third harmonic.
  void campaign() {
    double stiffness = 5.0;
    for (auto const* name : {"a.csv", "b.csv", "c.csv"}) {
      std::string text = "time [s],disp [mm],force [kN]\n";
      double hysteretic = 0.0, before = 0.0;
      for (int i = 0; i <= 360; ++i) {
        double const phase = 2.0 * std::numbers::pi * i / 60.0, x = (i <= 180 ? 50.0 : 100.0) * std::sin(phase);
        hysteretic = std::clamp(hysteretic + 2.0 * (x - before), -20.0, 20.0);
        before = x;
        text += fmt::format("{:.4f},{:.5f},{:.5f}\n", i / 30.0, x,
                            stiffness * (0.4 * x + hysteretic + std::sin(3.0 * phase)));
      }
      write(name, text);
      stiffness += 0.4;
    }
    auto const made = isolaw({"calibrate", "a.csv", "b.csv", "c.csv", "--laws", "bilinear", "--runs", "1", "--analysis",
                              "full", "--replicates", "40", "--figures", "none", "--out", "lot"});
    ASSERT_EQ(made.code, 0) << made;
  }
};

TEST_F(Building, from_template_to_verdict) {
  campaign();
  auto const written = isolaw({"example", "case", "--building"});
  ASSERT_EQ(written.code, 0) << written;
  EXPECT_EQ(read_file(directory() / "case/building.toml").find(isolaw({"building", "--template"}).out.substr(0, 200)),
            0u);
  auto text = read_file(directory() / "case/building.toml");
  auto const change = [&](std::string const& from, std::string const& to) {
    auto const at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  };
  change("draws = 1000", "draws = 40");
  change("laws = []", "laws = [\"bilinear\"]");
  write("case/building.toml", text);
  Words const command{"building", "case/building.toml", "--from", "lot", "--out", "B"};
  auto const made = isolaw(command);
  ASSERT_EQ(made.code, 0) << made;
  EXPECT_EQ(made.out.find("The bounds cover "), 0u) << made;
  EXPECT_TRUE(contains(made.out, "energy error at most"));
  auto const json = this->json("B/building.json");
  EXPECT_EQ(json["laws"][0]["id"], "bilinear");
  EXPECT_EQ(json["laws"][0]["draws"], 40);
  EXPECT_GT(json["laws"][0]["peak_mm"]["p84"], json["laws"][0]["peak_mm"]["p16"]);
  EXPECT_LT(json["laws"][0]["energy_error"], 2e-3);
  for (auto const* key : {"inside", "lower", "upper"}) EXPECT_TRUE(json["laws"][0]["coverage"].contains(key));
  EXPECT_EQ(json["motions"].size(), 7u);
  // Again: what is stored is not run, and says the same.
  auto const before = read_file(directory() / "B/building.json");
  EXPECT_EQ(isolaw(command + Words{"--jobs", "3"}).code, 0);
  EXPECT_EQ(read_file(directory() / "B/building.json"), before);
  change("seed = 1", "seed = 2");
  write("case/building.toml", text);
  expect_refused(isolaw(command), {"building.sqlite", "another building", "--fresh"});
  EXPECT_EQ(isolaw(command + Words{"--fresh"}).code, 0);
  expect_refused(isolaw(command + Words{"--fresh", "--arrange"}), {"--arrange", "3 tested devices for 28 bearings"});
  auto const nominal = isolaw(Words{"building", "case/building.toml", "--from", "lot", "--out", "N", "--nominal"});
  EXPECT_EQ(nominal.code, 0) << nominal;
  EXPECT_EQ(nominal.out.find("law,motion,outcome,isolator_mm"), 0u) << nominal;
  EXPECT_TRUE(contains(nominal.out, "bilinear,motion-7-x,completed,")) << nominal;
  EXPECT_TRUE(contains(read_file(directory() / "N/histories/bilinear-7.csv"), "acceleration_5_y [mm/s2]"));
  EXPECT_FALSE(std::filesystem::exists(directory() / "N/building.sqlite"));
  // Three places for the three devices that were tested.
  change("along = 7", "along = 3");
  change("across = 4", "across = 1");
  write("case/building.toml", text);
  auto const arranged = isolaw(command + Words{"--fresh", "--arrange"});
  EXPECT_EQ(arranged.code, 0) << arranged;
  EXPECT_TRUE(contains(arranged.out, "eccentricity of stiffness"));
}

TEST_F(Building, refuses) {
  expect_refused(isolaw({"building"}), {"isolaw building", "BUILDING.toml --from CAMPAIGN", "--template"});
  write("b.toml", "[building]\ndraws = 0\n");
  expect_refused(isolaw({"building", "b.toml", "--from", "nowhere"}), {"b.toml:2", "draws", "[base]", "no motions"});
}

}  // namespace
}  // namespace isolaw::cli_test
