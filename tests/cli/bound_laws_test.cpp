// Tests the bound laws over the design conditions in `simulate`, `export` and `building`, with a bilinear law that is
// fitted to the devices of `isolaw example --conditions`. The factors on K_eff and energy are those that follow from
// the formulas of the example's records.
#include <cmath>
#include <numbers>

#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

constexpr double upper_K_eff = 1.869155861, upper_energy = 1.859391152, lower_K_eff = 0.705430235,
                 lower_energy = 0.665827352;

class BoundLaws : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    ASSERT_EQ(isolaw({"example", "ex", "--conditions"}).code, 0);
  }
  void calibrate() {
    auto const o = isolaw({"calibrate", "ex/lot.toml", "--laws", "bilinear", "--runs", "1", "--analysis", "full",
                           "--replicates", "0", "--figures", "none", "--out", "C"});
    ASSERT_LE(o.code, 1) << o;
  }
  // Extends the design conditions to -35 C, 15 degrees below the coldest test, so that no test covers the cold end.
  void leave_cold_open() {
    auto text = read("ex/lot.toml");
    auto const at = text.find("temperature-C = [-15, 45]");
    ASSERT_NE(at, std::string::npos);
    write("ex/lot.toml", text.replace(at, 25, "temperature-C = [-35, 45]"));
  }
  static void near(Json const& value, double wanted, double relative) {
    EXPECT_NEAR(value.get<double>(), wanted, relative * std::abs(wanted));
  }
};

struct Loop {
  double K_eff = 0.0, energy = 0.0;
};
// Returns K_eff and energy of the third cycle, with 400 samples a cycle. The last column of the CSV is the force.
Loop third_cycle(std::string const& csv) {
  std::vector<double> disp, force;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || !(std::isdigit(static_cast<unsigned char>(line.front())) != 0)) continue;
    std::vector<double> values;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
    disp.push_back(values.at(1));
    force.push_back(values.back());
  }
  Loop loop{.K_eff = (force.at(900) - force.at(1100)) / (disp.at(900) - disp.at(1100))};
  for (std::size_t i = 801; i <= 1200; ++i)
    loop.energy += 0.5 * (force.at(i) + force.at(i - 1)) * (disp.at(i) - disp.at(i - 1));
  return loop;
}

TEST_F(BoundLaws, in_simulate_have_the_K_eff_and_the_energy_of_the_design) {
  calibrate();
  std::string motion = "time [s],disp [mm]\n";
  for (int i = 0; i <= 1200; ++i)
    motion += fmt::format("{},{}\n", i / 200.0, 208.0 * std::sin(2.0 * std::numbers::pi * i / 400.0));
  write("u.csv", motion);
  auto const simulated = [&](Words const& more) {
    auto const o = isolaw(Words{"simulate", "bilinear", "--from", "C", "--device", "P4", "--motion", "u.csv"} + more);
    EXPECT_LE(o.code, 1) << o;
    return o;
  };
  auto const at_reference = third_cycle(simulated({}).out);
  auto const upper = simulated({"--bound", "upper"}), lower = simulated({"--bound", "lower"});
  EXPECT_NEAR(third_cycle(upper.out).K_eff / at_reference.K_eff, upper_K_eff, 1e-6);
  EXPECT_NEAR(third_cycle(upper.out).energy / at_reference.energy, upper_energy, 1e-3);
  EXPECT_NEAR(third_cycle(lower.out).K_eff / at_reference.K_eff, lower_K_eff, 1e-6);
  EXPECT_NEAR(third_cycle(lower.out).energy / at_reference.energy, lower_energy, 1e-3);
  EXPECT_TRUE(contains(upper.out, "upper bound over the design conditions (interpolated; 100 % of it rests on tests"))
      << upper;
  EXPECT_TRUE(contains(lower.out, "lower bound over the design conditions (extrapolated; 4")) << lower;
  for (auto const& [words, said] :
       {std::pair{Words{"--from", "C", "--device", "P4", "--bound", "both"}, "lower or upper"},
        {Words{"--from", "C", "--device", "P4", "--bound", "upper", "--set", "K1=2"}, "without --set"},
        {Words{"--bound", "upper"}, "with --from DIR"}}) {
    auto const o = isolaw(Words{"simulate", "bilinear", "--motion", "u.csv"} + words);
    EXPECT_EQ(o.code, 2) << o;
    EXPECT_TRUE(contains(o.err, said)) << o;
  }
}

TEST_F(BoundLaws, in_exports_are_the_bounds) {
  calibrate();
  auto const o = isolaw({"export", "C", "--law", "bilinear", "--device", "lot", "--to", "json", "--out", "e.json"});
  ASSERT_LE(o.code, 1) << o;
  auto const j = json("e.json");
  auto const value = [](Json const& parameters, std::string const& name) {
    for (auto const& parameter : parameters)
      if (parameter["name"] == name) return parameter["value"].get<double>();
    ADD_FAILURE() << name;
    return 0.0;
  };
  auto const& own = j["parameters"];
  double const K1 = value(own, "K1"), K2 = value(own, "K2"), xy = value(own, "xy"), amplitude_mm = 208.0;
  double const secant = (K1 - K2) * xy / amplitude_mm;
  for (auto const& [which, K_eff, energy] :
       {std::tuple{"upper", upper_K_eff, upper_energy}, {"lower", lower_K_eff, lower_energy}}) {
    auto const& bound = j["bounds"][which];
    double const a = bound["stiffness"], b = bound["strength"];
    EXPECT_TRUE(bound["separate"].get<bool>());
    near(bound["force"], K_eff, 1e-8);
    EXPECT_NEAR(b, energy, 1e-3);
    EXPECT_NEAR(a * K2 + b * secant, K_eff * (K2 + secant), 1e-6);
    EXPECT_NEAR(value(bound["parameters"], "K2"), a * K2, 1e-8);
    EXPECT_NEAR(value(bound["parameters"], "K1"), a * K2 + b * (K1 - K2), 1e-8);
    EXPECT_NEAR(value(bound["parameters"], "xy"), xy, 1e-8);
  }
  std::string const source = j["bounds"]["source"];
  EXPECT_TRUE(contains(source, "lower bound over the design conditions (extrapolated")) << source;
  EXPECT_TRUE(contains(source, "upper bound over the design conditions (interpolated")) << source;
  EXPECT_TRUE(j["bounds"]["tolerance_k"].is_null());

  auto const script =
      isolaw({"export", "C", "--law", "bilinear", "--device", "lot", "--to", "openseespy", "--out", "e.py"});
  ASSERT_EQ(script.code, 0) << script;
  EXPECT_TRUE(contains(read("e.py"), "elastic part x 1.8")) << read("e.py");
  auto const header = isolaw({"export", "C", "--law", "bilinear", "--device", "lot", "--to", "cpp", "--out", "e.hpp"});
  ASSERT_EQ(header.code, 0) << header;
  EXPECT_TRUE(contains(read("e.hpp"), "inline constexpr double upper = 1.86915586")) << read("e.hpp");
  EXPECT_TRUE(contains(read("e.hpp"), "which is that of K_eff")) << read("e.hpp");
}

constexpr char const* building_file =
    "[building]\ndraws = 2\nlower = \"conditions\"\nupper = 1.2\nstep_s = 0.02\nrest_s = 0.0\nlaws = [\"bilinear\"]\n"
    "[base]\nmass_Mg = 400.0\ngyration_m = 5.0\n[grid]\nalong = 2\nacross = 1\nspacing_x_m = 6.0\nspacing_y_m = 6.0\n"
    "[plan]\nleft_m = -4.0\nright_m = 4.0\nfront_m = -3.0\nback_m = 3.0\n[[motion]]\nx = \"m.csv\"\n";
std::string strong_pulse() {
  std::string rows = "time [s],acceleration [m/s2]\n";
  for (int i = 0; i < 200; ++i)
    rows += fmt::format("{:.4f},{:.5g}\n", i * 0.01, 2.0 * std::sin(0.1 * i) * std::sin(std::numbers::pi * i / 200.0));
  return rows;
}

TEST_F(BoundLaws, in_a_building_take_the_place_of_a_factor) {
  calibrate();
  write("m.csv", strong_pulse());
  write("b.toml", building_file);
  auto const o = isolaw({"building", "b.toml", "--from", "C", "--out", "B", "--figures", "none"});
  ASSERT_LE(o.code, 1) << o;
  EXPECT_TRUE(contains(o.out + o.err, "lower bound over the design conditions (extrapolated")) << o;
  EXPECT_FALSE(contains(o.out + o.err, "upper bound over the design conditions")) << o;
  auto const j = json("B/building.json");
  EXPECT_TRUE(j["lower_factor"].is_null());
  EXPECT_EQ(j["upper_factor"], 1.2);
  // The lower bound makes the bearings softer, so they take less force.
  auto const& shear = j["laws"][0]["quantities"]["shear_over_weight"];
  EXPECT_LT(shear["lower"], shear["nominal"]);
  // The file may state a factor for each part of the force.
  std::string text(building_file), stated = "upper = 1.2";
  write("b.toml", text.replace(text.find(stated), stated.size(), "upper = { elastic = 1.2, hysteretic = 1.1 }"));
  ASSERT_LE(isolaw({"building", "b.toml", "--from", "C", "--out", "P", "--figures", "none"}).code, 1);
  auto const parts = json("P/building.json");
  EXPECT_EQ(parts["upper_factor"], Json({{"elastic", 1.2}, {"hysteretic", 1.1}}));
  EXPECT_TRUE(contains(parts["assumed"].dump(), "times 1.20 in the elastic and 1.10 in the hysteretic part"));
}

TEST_F(BoundLaws, that_no_test_covers_are_missing_with_the_reason) {
  leave_cold_open();
  calibrate();
  write("u.csv", "time [s],disp [mm]\n0,0\n1,100\n2,0\n");
  auto const simulated =
      isolaw({"simulate", "bilinear", "--from", "C", "--device", "P4", "--motion", "u.csv", "--bound", "upper"});
  EXPECT_EQ(simulated.code, 2) << simulated;
  EXPECT_TRUE(contains(simulated.err, "no bound law over the design conditions: no test covers temperature"))
      << simulated;
  write("m.csv", strong_pulse());
  write("b.toml", building_file);
  auto const building = isolaw({"building", "b.toml", "--from", "C", "--out", "B"});
  EXPECT_EQ(building.code, 2) << building;
  EXPECT_TRUE(contains(building.err, "no test covers temperature")) << building;
  auto const exported =
      isolaw({"export", "C", "--law", "bilinear", "--device", "lot", "--to", "json", "--out", "e.json"});
  ASSERT_EQ(exported.code, 0) << exported;
  auto const bounds = json("e.json")["bounds"];
  EXPECT_TRUE(contains(bounds["source"].get<std::string>(), "no test covers temperature")) << bounds;
  // isolaw must not use bounds from the scatter between devices instead, because these would be narrower than the tests
  // show.
  for (auto const* which : {"lower", "upper"}) EXPECT_TRUE(bounds[which].is_null()) << bounds;
}

}  // namespace
}  // namespace isolaw::cli_test
