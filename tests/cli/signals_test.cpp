// Runs `isolaw inspect` and `isolaw calibrate` on records with impossible signals, such as clipped ones.
// tests/warts has most of the files and states what inspect must say of each.
#include <filesystem>

#include "cli/loops.hpp"
#include "cli/warts.hpp"

namespace isolaw::cli_test {
namespace {

class Signals : public InFreshDirectory {
 protected:
  std::string take(std::string const& name) {
    fs::copy_file(wart_folder / (name + ".csv"), path(name + ".csv"));
    return name + ".csv";
  }
};

// If a signal is impossible, inspect must only say so. It must give no other warnings and no advice on the rig.
TEST_F(Signals, a_fault_is_all_that_is_said) {
  int files = 0;
  for (auto const& wart : warts()) {
    if (wart["outcome"] != "no properties") continue;
    auto const file = take(fs::path(wart["file"].get<std::string>()).stem());
    auto const device = Json::parse(isolaw({"inspect", file, "--json"}).out);
    for (auto const& warning : device["warnings"]) {
      auto const text = warning.get<std::string>();
      EXPECT_TRUE(contains(text, " computed from ")) << file << ": " << text;
    }
    EXPECT_TRUE(device["notes"].empty()) << file << device["notes"];
    ++files;
  }
  EXPECT_GE(files, 12);
}

TEST_F(Signals, spikes_are_repaired_on_request_and_recorded) {
  auto const properties = [&](std::string const& file, Words const& more) {
    auto const o = isolaw(Words{"inspect", file, "--json"} + more);
    EXPECT_EQ(o.code, 0) << o;
    return Json::parse(o.out);
  };
  auto const truth = cycle_of(properties(take("true"), {}), 1, 3);
  for (auto const* name : {"force-spike", "disp-spike", "force-spikes", "force-dropout"}) {
    auto const repaired = properties(take(name), {"--repair", "spikes"});
    auto const& cycle = cycle_of(repaired, 1, 3);
    for (auto const* key : {"K_eff_kN_per_mm", "energy_kN_mm"})
      EXPECT_NEAR(cycle[key].get<double>(), truth[key].get<double>(), 0.005 * truth[key].get<double>()) << name << key;
    EXPECT_NE(repaired["corrections"].dump().find("repaired by interpolation: sample "), std::string::npos)
        << name << repaired["corrections"];
  }
  auto const other = isolaw({"inspect", "true.csv", "--repair", "clipping"});
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.err.find("--repair"), std::string::npos) << other;
  // `repair` may also stand in a lot file. Its value `spikes` repairs spikes but not clipping.
  write("lot.toml", "[read]\nrepair = \"spikes\"\n[[device]]\nfile = \"force-spike.csv\"\n");
  EXPECT_EQ(isolaw({"inspect", "lot.toml"}).code, 0);
  EXPECT_EQ(isolaw({"inspect", take("disp-clipped-one-side"), "--repair", "spikes"}).code, 1);
}

TEST_F(Signals, no_law_is_fitted_to_a_false_signal) {
  auto const clipped = take("disp-clipped-both-sides"), good = take("true");
  auto const alone = isolaw(Words{"calibrate", clipped, "--out", "alone"} + smallest_search);
  EXPECT_EQ(alone.code, 2) << alone;
  EXPECT_NE(alone.err.find("displacement is clipped at "), std::string::npos) << alone;
  auto const both = isolaw(Words{"calibrate", good, clipped, "--out", "both"} + smallest_search);
  EXPECT_EQ(both.code, 1) << both;
  auto const summary = Json::parse(read("both/summary.json"));
  EXPECT_EQ(summary["devices"][1]["status"], "refused");
  EXPECT_NE(summary["devices"][1]["message"].get<std::string>().find("displacement is clipped at "), std::string::npos);
  EXPECT_NE(summary["warnings"].dump().find("was refused: the displacement is clipped at "), std::string::npos);
}

TEST_F(Signals, warnings_of_several_devices_stand_on_the_terminal_grouped) {
  auto const a = take("true"), b = take("force-spike");
  fs::copy_file(path(a), path("again.csv"));
  auto const o = isolaw({"inspect", a, b, "again.csv"});
  EXPECT_EQ(o.code, 1) << o;
  EXPECT_NE(o.out.find("force-spike: the force has a single-sample spike at "), std::string::npos) << o;
  EXPECT_NE(o.out.find("true and again hold the same record"), std::string::npos) << o;
  auto const json = Json::parse(isolaw({"inspect", a, b, "again.csv", "--json"}).out);
  EXPECT_EQ(json["warnings"][0]["topic"], "copies");
  // Two records have only 50 samples a cycle. The warning must appear once and name both.
  auto const coarse = [&](std::string const& name, double factor) {
    std::string text = "time [s],disp [mm],force [kN]\n";
    for (int i = 0; i <= 150; ++i) {
      double const phase = 2.0 * std::numbers::pi * i / 50.0;
      text += fmt::format("{:.3f},{:.4f},{:.4f}\n", 0.04 * i, 100.0 * std::sin(phase),
                          factor * (60.0 * std::sin(phase) + 20.0 * std::cos(phase)));
    }
    write(name, text);
  };
  coarse("c.csv", 1.0);
  coarse("d.csv", 1.1);
  auto const two = isolaw({"inspect", "c.csv", "d.csv"});
  EXPECT_NE(two.out.find("c and d: 50.0 samples per cycle"), std::string::npos) << two;
}

// A sensor whose force wraps around at the end of its range reverses the stiffness of the loop. No device does this, so
// no law is fitted to these cycles. The block before them is sound.
TEST_F(Signals, cycles_that_no_device_makes_are_not_fitted) {
  auto const wrapped = [](double range) {
    std::string text = "time [s],disp [mm],force [kN]\n";
    for (int i = 0; i <= 1000; ++i) {
      // The sensor's range is 50 kN. Seven cycles stay within it; the three later ones exceed it.
      double const phase = 2.0 * std::numbers::pi * i / 100.0, size = i <= 700 ? 0.7 : 1.0;
      double const force = size * (60.0 * std::sin(phase) + 20.0 * std::cos(phase));
      text += fmt::format("{:.3f},{:.4f},{:.4f}\n", 0.02 * i, size * 100.0 * std::sin(phase),
                          force - 2.0 * range * std::round(force / (2.0 * range)));
    }
    return text;
  };
  write("wrapped.csv", wrapped(50.0));
  auto const o = isolaw({"inspect", "wrapped.csv"});
  EXPECT_TRUE(contains(o.out, "the force wraps around")) << o;  // in the later cycles; the block before them counts
  auto const fitted = isolaw(Words{"calibrate", "wrapped.csv", "--out", "W"} + smallest_search);
  EXPECT_EQ(fitted.code, 0) << fitted;
  EXPECT_TRUE(contains(read("W/report.html"), "laws are not fitted to block 2")) << fitted;
}

TEST_F(Signals, a_clipped_device_does_not_pass) {
  auto const good = take("true"), clipped = take("disp-clipped-both-sides");
  auto const o = isolaw({"inspect", good, clipped, "--rules", "ntc-2018", "--design", "K_eff=0.8", "--out", "out"});
  EXPECT_EQ(o.code, 1) << o;
  auto const at = o.out.find("\ndisp-clipped-both-sides ");
  ASSERT_NE(at, std::string::npos) << o;
  auto const line = o.out.substr(at + 1, o.out.find('\n', at + 1) - at);
  EXPECT_EQ(line.find("pass"), std::string::npos) << line;
  EXPECT_NE(line.find("displacement is clipped"), std::string::npos) << line;
}

// The first record is that of a lead rubber bearing that heats up over 25 cycles: bouc-wen with n = 1 and a yield
// displacement of 4 mm, whose strength falls by 2 % a cycle. The second bearing keeps its strength. Only the first may
// get the warning that no law follows the fall of its energy.
TEST_F(Signals, no_law_follows_a_device_that_degrades) {
  auto const bearing = [](double kept) {
    std::string text = "time [s],disp [mm],force [kN]\n";
    double z = 0.0, before = 0.0;
    for (int i = 0; i <= 25 * 100; ++i) {
      double const x = 100.0 * std::sin(2.0 * std::numbers::pi * i / 100.0);
      double const way = (x - before) / 4.0, up = way > 0.0 ? 1.0 : -1.0;
      z = up - (up - z) * std::exp(-std::abs(way));
      before = x;
      text += fmt::format("{:.3f},{:.4f},{:.4f}\n", 0.02 * i, x, 0.4 * x + 40.0 * std::pow(kept, i / 100) * z);
    }
    return text;
  };
  write("degrading.csv", bearing(0.98));
  write("constant.csv", bearing(1.0));
  auto const o = isolaw(
      {"calibrate", "degrading.csv", "constant.csv", "--laws", "bouc-wen,bilinear", "--runs", "1", "--out", "out"});
  EXPECT_EQ(o.code, 0) << o;
  auto const summary = json("out/summary.json");
  std::vector<std::string> said;
  for (auto const& warning : summary["warnings"])
    if (warning["topic"] == "degradation") said.push_back(warning["sentence"]);
  ASSERT_EQ(said.size(), 1u) << summary["warnings"];
  EXPECT_TRUE(
      said.front().starts_with("degrading: the energy of a cycle falls by 36 % from cycle 3 to cycle 25 of block 1"))
      << said.front();
  EXPECT_TRUE(contains(said.front(), "No law follows this fall"));
  EXPECT_TRUE(contains(unwrapped(o.out), said.front())) << o;
  EXPECT_TRUE(contains(read("out/report.html"), said.front()));
  auto const& fits = summary["laws"][0]["devices"];
  EXPECT_NEAR(fits[0]["measured_energy_fall_percent"].get<double>(), 36.0, 2.0);
  EXPECT_NEAR(fits[0]["energy_fall_percent"].get<double>(), 0.0, 1.0);
  EXPECT_TRUE(fits[1]["measured_energy_fall_percent"].is_null());
}

}  // namespace
}  // namespace isolaw::cli_test
