// Tests `isolaw simulate`: its forces must equal those of the report, parameters may come from several sources, and
// wrong requests must be refused.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "cli/records.hpp"
#include "cli/run.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/study/build_summary.hpp"

namespace isolaw::cli_test {
namespace {

struct Simulated {
  std::string header;
  std::vector<std::vector<double>> columns;
};

std::string without_comments(std::string const& text) {
  std::string kept;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (!line.starts_with('#')) kept += line + '\n';
  return kept;
}

Simulated parsed(std::string const& text) {
  Simulated table;
  std::istringstream in(without_comments(text));
  std::getline(in, table.header);
  table.columns.resize(static_cast<std::size_t>(std::ranges::count(table.header, ',')) + 1);
  for (std::string line; std::getline(in, line);) {
    char const* at = line.data();
    for (auto& column : table.columns) {
      double value = std::nan("");
      at = std::from_chars(at, line.data() + line.size(), value).ptr + 1;
      column.push_back(value);
    }
  }
  return table;
}

class Simulate : public InFreshDirectory {
 protected:
  // Calibrates one device. Among the laws, hwang-wu needs velocities.
  void calibrated(std::string const& laws = "bilinear,bouc-wen,hwang-wu", Words const& more = {}) {
    write("d.csv", csv(record()));
    auto const o = isolaw(Words{"calibrate", "d.csv", "--laws", laws, "--runs", "1", "--out", "O"} + more);
    ASSERT_EQ(o.code, 0) << o;
  }
  study::Summary summary() const { return study::build_summary(campaign::Store::read(path("O/campaign.sqlite"))); }
};

TEST_F(Simulate, on_a_devices_own_record_gives_the_force_of_the_report) {
  calibrated();
  for (auto const& law : summary().laws) {
    auto const o = isolaw({"simulate", law.id, "--from", "O", "--device", "d", "--motion", "d.csv"});
    ASSERT_EQ(o.code, 0) << o;
    auto const table = parsed(o.out);
    EXPECT_EQ(table.header, "time [s],displacement [mm],velocity [mm/s],force [kN]");
    EXPECT_EQ(table.columns.back(), law.devices.at(0).force_kN) << law.id;
  }
}

TEST_F(Simulate, integration_of_the_campaign_is_taken_over_and_may_be_changed) {
  calibrated("bouc-wen", {"--integration", "paper", "--method", "ga", "--population", "20", "--generations", "4"});
  Words const words{"simulate", "bouc-wen", "--from", "O", "--device", "d", "--motion", "d.csv"};
  auto const as_fitted = parsed(isolaw(words).out);
  EXPECT_EQ(as_fitted.columns.back(), summary().laws.at(0).devices.at(0).force_kN);
  auto const other = parsed(isolaw(words + Words{"--integration", "converged"}).out);
  EXPECT_NE(other.columns.back(), as_fitted.columns.back());
  auto const finer = isolaw(words + Words{"--refinement", "8"});
  EXPECT_TRUE(contains(finer.err, "8 steps per sample"));
  EXPECT_NE(parsed(finer.out).columns.back(), as_fitted.columns.back());
}

TEST_F(Simulate, parameters_come_from_toml_json_tables_or_options_alike) {
  write("d.csv", csv(record()));
  write("p.toml", "K1 = 2.5\nK2 = 0.5\nxy = 10\n");
  write("q.json", R"({"bilinear": {"K1": 2.5, "K2": 0.5, "xy": 10}, "abe": {"c": 1}})");
  write("r.toml", "[bilinear]\nK1 = 9\nK2 = 0.5\nxy = 10\n");
  Words const start{"simulate", "bilinear", "--motion", "d.csv"};
  auto const by_toml = isolaw(start + Words{"--parameters", "p.toml"});
  ASSERT_EQ(by_toml.code, 0) << by_toml;
  EXPECT_EQ(isolaw(start + Words{"--parameters", "q.json"}).out, by_toml.out);
  EXPECT_EQ(isolaw(start + Words{"--parameters", "r.toml", "--set", "K1=2.5"}).out, by_toml.out);
  EXPECT_EQ(isolaw(start + Words{"--set", "K1=2.5", "--set", "K2=0.5", "--set", "xy=10"}).out, by_toml.out);
  auto const written = isolaw(start + Words{"--parameters", "p.toml", "--out", "f.csv"});
  EXPECT_EQ(written.out, "");
  EXPECT_EQ(read("f.csv"), by_toml.out);
  // The peak force of the bilinear law is K2 x + (K1 - K2) xy.
  auto const force = parsed(by_toml.out).columns.back();
  EXPECT_NEAR(std::ranges::max(force), 0.5 * 100.0 + 2.0 * 10.0, 1e-9);
}

TEST_F(Simulate, a_motion_needs_no_force_and_no_time_where_the_law_needs_none) {
  write("m.csv", "displacement [cm]\tother\n0\t1\n1\t1\n-1\t1\n0.5\t2\n");
  Words const parameters{"--set", "K1=2.5", "--set", "K2=0.5", "--set", "xy=100"};
  auto const o = isolaw(Words{"simulate", "bilinear", "--motion", "m.csv"} + parameters);
  ASSERT_EQ(o.code, 0) << o;
  EXPECT_EQ(o.out, "displacement [mm],force [kN]\n0,0\n10,25\n-10,-25\n5,12.5\n");
  auto const timed = isolaw(Words{"simulate", "bilinear", "--motion", "m.csv", "--dt", "0.5"} + parameters);
  EXPECT_EQ(timed.out,
            "time [s],displacement [mm],velocity [mm/s],force [kN]\n"
            "0,0,50,0\n0.5,10,-10,25\n1,-10,-5,-25\n1.5,5,65,12.5\n");
  write("hw.toml", "a1=1\na2=0\na3=0\na4=0\na5=0\na6=0\na7=0\na8=1\na9=0\na10=0\n");
  expect_refused(isolaw({"simulate", "hwang-wu", "--parameters", "hw.toml", "--motion", "m.csv"}),
                 {"depends on velocity", "--dt SECONDS"});
}

TEST_F(Simulate, everything_wrong_with_parameters_is_said_at_once) {
  write("d.csv", csv(record()));
  write("p.toml", "K1 = -2.5\nKa = 0.5\n");
  expect_refused(isolaw({"simulate", "bilinear", "--parameters", "p.toml", "--motion", "d.csv"}),
                 {"p.toml:1: K1 = -2.5 leaves its physical limits; allowed: above 0 kN/mm",
                  "p.toml:2: bilinear has no parameter 'Ka'; allowed: K1 [kN/mm]",
                  "p.toml: bilinear also needs K2 [kN/mm], xy [mm]"});
  write("p.json", R"({"K1": 1, "K1": 2, "K2": "stiff", "xy": null})");
  expect_refused(isolaw({"simulate", "bilinear", "--parameters", "p.json", "--motion", "d.csv"}),
                 {"'K1' is given twice", "'K2' is no number", "'xy' is no number"});
  write("p.json", R"({"K1": )");
  expect_refused(isolaw({"simulate", "bilinear", "--parameters", "p.json", "--motion", "d.csv"}), {"p.json", "JSON"});
  for (auto const* deep : {"[", "{\"a\":"}) {
    std::string text;
    for (int i = 0; i < 100000; ++i) text += deep;
    write("p.json", text);
    expect_refused(isolaw({"simulate", "bilinear", "--parameters", "p.json", "--motion", "d.csv"}), {"p.json", "JSON"});
  }
  expect_refused(isolaw({"simulate", "bilinear", "--set", "K1=big", "--motion", "d.csv"}),
                 {"--set: 'K1=big'", "PARAMETER=NUMBER"});
  expect_refused(isolaw({"simulate", "bilinear", "--set", "K1=nan", "--motion", "d.csv"}), {"--set"});
  expect_refused(isolaw({"simulate", "bilinear", "--motion", "d.csv"}), {"bilinear also needs K1"});
}

TEST_F(Simulate, what_cannot_be_found_is_said_with_what_there_is) {
  calibrated("bilinear");
  auto const with = [&](Words const& words) { return isolaw(Words{"simulate"} + words + Words{"--motion", "d.csv"}); };
  expect_refused(with({"bilinea"}), {"no such law", "bilinear"});
  expect_refused(with({"bilinear", "--from", "O", "--device", "e"}), {"device 'e'", "allowed: d"});
  expect_refused(with({"abe", "--from", "O", "--device", "d"}), {"law abe: not in this campaign; allowed: bilinear"});
  expect_refused(with({"bilinear", "--from", "O", "--device", "lot"}), {"no one law for the lot", "--analysis full"});
  expect_refused(with({"bilinear", "--from", "O"}), {"--from", "--device NAME"});
  expect_refused(with({"bilinear", "--from", "O", "--device", "d", "--parameters", "x"}), {"both are given"});
  expect_refused(with({"bilinear", "--from", "O", "--device", "d", "--refinement", "0"}),
                 {"--refinement", "1 to 1000"});
  expect_refused(with({"bilinear", "--from", "nowhere", "--device", "d"}), {"nowhere"});
  expect_refused(isolaw({"simulate", "bilinear"}), {"--motion is required"});
}

TEST_F(Simulate, says_where_the_history_goes_beyond_the_test) {
  calibrated("bilinear");
  write("far.csv", "displacement [mm],x\n0,0\n150,0\n0,0\n");
  auto const o = isolaw({"simulate", "bilinear", "--from", "O", "--device", "d", "--motion", "far.csv"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.err, "the history reaches 150 mm, the test 100 mm"));
}

// simulate must give each warning about the motion both on the terminal and in the table of forces.
TEST_F(Simulate, beyond_the_test_is_said_in_the_table) {
  calibrated("bilinear");
  write("m.csv", "time [s],displacement [mm]\n0,10\n1,150\n2,300\n3,0\n");
  auto const o = isolaw({"simulate", "bilinear", "--from", "O", "--device", "d", "--motion", "m.csv"});
  ASSERT_EQ(o.code, 0) << o;
  for (auto const& text : {o.err, o.out}) {
    EXPECT_TRUE(contains(text, "warning: the history reaches 300 mm, the test 100 mm")) << text;
    EXPECT_TRUE(contains(text, "warning: the motion starts at 10 mm")) << text;
  }
}

// --set changes a parameter of the fitted law. The output must then not repeat how well the unchanged law predicts.
TEST_F(Simulate, a_changed_law_takes_no_word_of_the_fitted_one) {
  calibrated("bilinear");
  Words const words{"simulate", "bilinear", "--from", "O", "--device", "d", "--motion", "d.csv"};
  EXPECT_TRUE(contains(isolaw(words).out, "# how well it predicts is not known"));
  auto const o = isolaw(words + Words{"--set", "K2=0.3"});
  ASSERT_EQ(o.code, 0) << o;
  for (auto const& text : {o.err, o.out}) {
    EXPECT_TRUE(contains(text, "changed by --set K2=0.3: ")) << text;
    EXPECT_TRUE(contains(text, "tested up to 100 mm")) << text;
    EXPECT_FALSE(contains(text, "prediction ")) << text;
  }
}

TEST_F(Simulate, anyway_is_of_a_campaigns_law) {
  expect_refused(isolaw({"simulate", "bilinear", "--set", "K1=2", "--set", "K2=0.5", "--set", "xy=10", "--motion",
                         "d.csv", "--anyway"}),
                 {"--anyway", "is given alone", "with --from DIR"});
}

TEST_F(Simulate, a_dead_band_by_itself_is_that_of_a_campaign) {
  write("d.csv", csv(record()));
  Words const words{"simulate", "bilinear", "--set", "K1=2.5",   "--set",
                    "K2=0.5",   "--set",    "xy=10", "--motion", "d.csv"};
  EXPECT_EQ(isolaw(words + Words{"--dead-band", "0.1"}).code, 0);
  auto const o = isolaw(words + Words{"--dead-band", "auto"});
  EXPECT_EQ(o.code, 2) << o;
  EXPECT_TRUE(contains(o.err, "--dead-band: auto is given without --from")) << o;
}

TEST_F(Simulate, the_one_law_of_a_lot) {
  write("r/a.csv", csv(record()));
  write("r/b.csv", csv(record({.strength_kN = 24.0})));
  auto const calibration = isolaw(
      {"calibrate", "r", "--laws", "bilinear", "--runs", "1", "--analysis", "full", "--replicates", "0", "--out", "O"});
  ASSERT_EQ(calibration.code, 0) << calibration;
  auto const o = isolaw({"simulate", "bilinear", "--from", "O", "--device", "lot", "--motion", "r/a.csv"});
  ASSERT_EQ(o.code, 0) << o;
  auto const lot = summary().laws.at(0).lot;
  ASSERT_TRUE(lot);
  Words words{"simulate", "bilinear", "--motion", "r/a.csv"};
  for (std::size_t i = 0; i < 3; ++i)
    words = words + Words{"--set", fmt::format("{}={}", Words{"K1", "K2", "xy"}[i], lot->parameters[i])};
  EXPECT_EQ(isolaw(words).out, without_comments(o.out));
}

TEST_F(Simulate, what_was_read_and_stores_are_not_replaced) {
  calibrated("bilinear");
  auto const motion = read("d.csv"), store = read("O/campaign.sqlite");
  Words const words{"simulate", "bilinear", "--from", "O", "--device", "d", "--motion", "d.csv", "--out"};
  expect_refused(isolaw(words + Words{"d.csv"}),
                 {"d.csv: is an input of this command and would be replaced", "another name after --out"});
  expect_refused(isolaw(words + Words{"O/campaign.sqlite"}), {"a campaign's store and would be replaced"});
  expect_refused(
      isolaw({"export", "O", "--law", "bilinear", "--device", "d", "--to", "json", "--out", "O/campaign.sqlite"}),
      {"a campaign's store and would be replaced"});
  expect_message(isolaw({"init", "d.csv", "--out", "d.csv", "--force"}), 2, {"d.csv: is an input of this command"});
  EXPECT_EQ(read("d.csv"), motion);
  EXPECT_EQ(read("O/campaign.sqlite"), store);
  EXPECT_EQ(isolaw(words + Words{"f.csv"}).code, 0);
  EXPECT_EQ(isolaw(words + Words{"f.csv"}).code, 0) << "one written before may be written again";
}

// simulate, Python and exports take the name "lot" for a device if there is one, and otherwise for the law of the lot.
TEST_F(Simulate, a_device_called_lot_is_that_device) {
  write("r/lot.csv", csv(record()));
  write("r/b.csv", csv(record({.strength_kN = 24.0})));
  auto const calibration = isolaw(
      {"calibrate", "r", "--laws", "bilinear", "--runs", "1", "--analysis", "full", "--replicates", "0", "--out", "O"});
  ASSERT_EQ(calibration.code, 0) << calibration;
  ASSERT_TRUE(summary().laws.at(0).lot);
  auto const exported = isolaw({"export", "O", "--law", "bilinear", "--device", "lot", "--to", "json"});
  ASSERT_EQ(exported.code, 0) << exported;
  auto const form = Json::parse(exported.out);
  EXPECT_EQ(form["of_the_lot"], false);
  Words words{"simulate", "bilinear", "--motion", "r/b.csv"};
  for (auto const& p : form["parameters"])
    words = words + Words{"--set", fmt::format("{}={}", p["name"].get<std::string>(), p["value"].get<double>())};
  auto const o = isolaw({"simulate", "bilinear", "--from", "O", "--device", "lot", "--motion", "r/b.csv"});
  ASSERT_EQ(o.code, 0) << o;
  EXPECT_EQ(isolaw(words).out, without_comments(o.out));
}

// The motion starts at 5 mm and does not say how the device came there. isolaw takes the device as virgin at the first
// sample. An analysis program moves the device from 0 to 5 mm first, so isolaw must warn.
TEST_F(Simulate, a_motion_that_does_not_start_at_zero_is_warned_of) {
  Words const words{"simulate", "bilinear", "--set", "K1=2.5", "--set", "K2=0.5", "--set", "xy=2", "--motion", "m.csv"};
  write("m.csv", "displacement [mm],x\n5,0\n10,0\n0,0\n");
  auto const off = isolaw(words);
  ASSERT_EQ(off.code, 0) << off;
  EXPECT_TRUE(contains(off.err, "the motion starts at 5 mm: the device is taken as virgin there")) << off;
  EXPECT_TRUE(contains(off.err, "put a path from 0 in front")) << off;
  // isolaw takes the device as virgin, so the first force is elastic only.
  EXPECT_EQ(parsed(off.out).columns.back().front(), 0.5 * 5.0);
  write("m.csv", "displacement [mm],x\n0.000001,0\n10,0\n0,0\n");
  auto const at_zero = isolaw(words);
  ASSERT_EQ(at_zero.code, 0) << at_zero;
  EXPECT_FALSE(contains(at_zero.err, "virgin")) << at_zero;
}

// Each parameter is within its own limits, but no device can have this combination, for example K1 < K2. simulate must
// refuse it.
TEST_F(Simulate, parameters_that_together_are_no_device_are_refused) {
  write("d.csv", csv(record()));
  Words const bilinear{"simulate", "bilinear", "--motion", "d.csv", "--set", "xy=10", "--set", "K2=0.42"};
  expect_refused(isolaw(bilinear + Words{"--set", "K1=0.1"}), {"K1 = 0.1, K2 = 0.42; allowed: K1 >= K2"});
  EXPECT_EQ(isolaw(bilinear + Words{"--set", "K1=0.42"}).code, 0);
  Words const bouc_wen{"simulate", "bouc-wen", "--motion", "d.csv", "--set", "alpha=0.12",
                       "--set",    "Ke=2.4",   "--set",    "n=1.1", "--set", "A=1"};
  expect_refused(isolaw(bouc_wen + Words{"--set", "beta=0.05", "--set", "gamma=-0.1"}),
                 {"beta = 0.05, gamma = -0.1; allowed: beta + gamma > 0"});
  expect_refused(isolaw(bouc_wen + Words{"--set", "beta=-0.05", "--set", "gamma=0.1"}),
                 {"beta = -0.05; allowed: beta > 0"});
  EXPECT_EQ(isolaw(bouc_wen + Words{"--set", "beta=0.05", "--set", "gamma=-0.02"}).code, 0);
  expect_refused(isolaw(bouc_wen + Words{"--set", "A=-1"}), {"A = -1 leaves its physical limits; allowed: above 0"});
}

// simulate must accept every result of calibrate. calibrate refuses a box in which no device is possible (K1 < K2
// everywhere). If only a part of the box is possible and the best values lie outside that part, calibrate warns, and
// simulate needs --anyway, because such a law gives back energy.
TEST_F(Simulate, takes_every_campaign_that_calibrate_made) {
  write("d.csv", csv(record({.strength_kN = 0.5})));
  Words const start{"calibrate", "d.csv", "--laws", "bilinear", "--runs", "1", "--out", "O"};
  expect_refused(isolaw(start + Words{"--set", "bilinear.K1=0.1", "--set", "bilinear.K2=0.42"}),
                 {"--set bilinear.K1=0.1 bilinear.K2=0.42: K1 = 0.1, K2 = 0.42; allowed: K1 >= K2"});
  expect_refused(isolaw(start + Words{"--set", "bilinear.K1=0.1:0.3", "--set", "bilinear.K2=0.35:1"}),
                 {"K1 from 0.1 to 0.3, K2 from 0.35 to 1; allowed: K1 >= K2"});
  EXPECT_FALSE(exists("O"));
  auto const crossing = isolaw(start + Words{"--set", "bilinear.K1=0.45", "--set", "bilinear.K2=0.4:1"});
  ASSERT_EQ(crossing.code, 0) << crossing;
  Words const again{"simulate", "bilinear", "--from", "O", "--device", "d", "--motion", "d.csv"};
  expect_refused(isolaw(again), {"its force is not possible, even within the tests: it gives back energy"});
  auto const o = isolaw(again + Words{"--anyway"});
  ASSERT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.err, "warning: K1 = 0.45, K2 = 0.")) << o;
  EXPECT_TRUE(contains(o.err, "outside K1 >= K2")) << o;
  expect_refused(isolaw(again + Words{"--anyway", "--set", "K1=0.1"}), {"K1 = 0.1, K2 = ", "allowed: K1 >= K2"});
}

// The unit in the header shows that the record contains ground accelerations. simulate needs displacements of the
// device, so it must refuse the record and say what it needs.
TEST_F(Simulate, a_record_of_acceleration_is_refused_with_what_is_needed) {
  write(
      "g.txt",
      "STATION\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 10, DT= .01 SEC\n 0.1 0.2 0.1 0.3 0.2\n 0.1 0.2 0.1 0.3 0.2\n");
  write("h.csv", "time [s],acceleration [m/s2]\n0,0\n0.1,1\n0.2,0\n0.3,-1\n");
  for (auto const* file : {"g.txt", "h.csv"})
    expect_refused(
        isolaw({"simulate", "bilinear", "--set", "K1=2", "--set", "K2=1", "--set", "xy=9", "--motion", file}),
        {"a record of acceleration", "displacement of the device"});
}

TEST_F(Simulate, measured_motions) {
  auto const orbit = data / "hdrb-gallardo-device/biaxial_input_Fig8b.txt";
  auto const ground = data / "ground-motions/peer/RSN763_LOMAP_GIL067.AT2";
  if (!fs::exists(orbit) || !fs::exists(ground)) GTEST_SKIP() << "measured data are not here: " << data;
  Words const start{"simulate", "bilinear", "--set", "K1=2", "--set", "K2=1", "--set", "xy=9", "--motion"};
  auto const o = isolaw(start + Words{orbit, "--columns", "disp=1", "--units", "disp=mm"});
  ASSERT_EQ(o.code, 0) << o;
  auto const table = parsed(o.out);
  ASSERT_EQ(table.columns.back().size(), 26000u);
  auto const [least, most] = std::ranges::minmax(table.columns.front());
  for (double const force : table.columns.back()) {
    EXPECT_LE(force, 1.0 * most + 9.0 + 1e-9);
    EXPECT_GE(force, 1.0 * least - 9.0 - 1e-9);
  }
  expect_refused(isolaw(start + Words{ground}), {"a record of acceleration", "UNITS OF G"});
}

// Returns a motion in two directions in one file. `angle` turns the path, and `across` is the ratio of the two
// amplitudes.
std::string orbit(double angle, double across = 0.6) {
  std::string text = "time [s],east [mm],north [mm]\n";
  for (int i = 0; i <= 300; ++i) {
    double const x = 80.0 * std::sin(0.06 * i), y = across * 80.0 * std::sin(0.1 * i);
    text += fmt::format("{},{},{}\n", 0.01 * i, std::cos(angle) * x - std::sin(angle) * y,
                        std::sin(angle) * x + std::cos(angle) * y);
  }
  return text;
}
Words in_plane(std::string const& how, Words const& more = {}) {
  return Words{"--motion", "m.csv", "--columns", "disp=east", "--second-disp", "north", "--bidirectional", how} + more;
}
Words const bouc_wen{"simulate", "bouc-wen", "--set",     "alpha=0.1", "--set", "Ke=3",  "--set",
                     "A=1",      "--set",    "beta=0.05", "--set",     "n=1.2", "--set", "gamma=0.05"};

TEST_F(Simulate, two_displacements_give_two_forces_that_turn_with_them) {
  write("m.csv", orbit(0.0));
  auto const o = isolaw(bouc_wen + in_plane("coupled"));
  ASSERT_EQ(o.code, 0) << o;
  auto const straight = parsed(o.out);
  EXPECT_EQ(
      straight.header,
      "time [s],displacement x [mm],displacement y [mm],velocity x [mm/s],velocity y [mm/s],force x [kN],force y [kN]");
  double const angle = 0.8;
  write("m.csv", orbit(angle));
  auto const turned = parsed(isolaw(bouc_wen + in_plane("coupled")).out);
  for (std::size_t i = 0; i < straight.columns[0].size(); ++i) {
    double const x = straight.columns[5][i], y = straight.columns[6][i];
    EXPECT_NEAR(turned.columns[5][i], std::cos(angle) * x - std::sin(angle) * y, 1e-9) << i;
    EXPECT_NEAR(turned.columns[6][i], std::sin(angle) * x + std::cos(angle) * y, 1e-9) << i;
  }
}

TEST_F(Simulate, two_directions_along_one_are_the_law_coupled_exactly_and_springs_nearly) {
  write("m.csv", orbit(0.0, 0.0));
  auto const one = parsed(isolaw(bouc_wen + Words{"--motion", "m.csv", "--columns", "disp=east"}).out);
  // isolaw would not read a file with one constant displacement as a motion in two directions, so the second
  // displacement is tiny instead.
  write("m.csv", orbit(0.0, 1e-6));
  auto const coupled = parsed(isolaw(bouc_wen + in_plane("coupled")).out);
  auto const o = isolaw(bouc_wen + in_plane("springs"));
  EXPECT_TRUE(contains(o.err, "springs round the knee")) << o;
  auto const springs = parsed(o.out);
  auto const& force = one.columns.back();
  ASSERT_EQ(coupled.columns[5].size(), force.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    EXPECT_NEAR(coupled.columns[5][i], force[i], 1e-4) << i;
    worst = std::max(worst, std::abs(springs.columns[5][i] - force[i]));
  }
  EXPECT_GT(worst, 0.01);
  EXPECT_LT(worst, 3.0);
}

TEST_F(Simulate, what_one_direction_leaves_open_is_said_by_rule) {
  write("m.csv", orbit(0.3));
  write(
      "abe.toml",
      "K1 = 0.5\nalpha = 8\nbeta = 0.3\na = 0.8\nb = 7\nn = 0.3\nY0 = 40\nUh = 100\nU0 = 4\nUs = 20\nK2 = 0.2\nr = 0.1\n");
  Words const abe{"simulate", "abe-y0", "--parameters", "abe.toml"};
  auto const by_distance = isolaw(abe + in_plane("coupled"));
  ASSERT_EQ(by_distance.code, 0) << by_distance;
  for (auto const* word :
       {"on a figure of eight of", "coupled, softened by distance: ", "coupled, softened by axis: ", "springs: "})
    EXPECT_TRUE(contains(by_distance.err, word)) << word << by_distance;
  auto const by_axis = isolaw(abe + in_plane("coupled", {"--softening", "axis"}));
  ASSERT_EQ(by_axis.code, 0) << by_axis;
  EXPECT_NE(by_axis.out, by_distance.out);
}

TEST_F(Simulate, springs_of_a_device_are_fitted_to_its_record) {
  calibrated("bouc-wen,power-masing");
  write("m.csv", orbit(0.3));
  for (auto const* law : {"bouc-wen", "power-masing"}) {
    Words const words{"simulate", law, "--from", "O", "--device", "d"};
    auto const o = isolaw(words + in_plane("springs"));
    ASSERT_EQ(o.code, 0) << o;
    EXPECT_TRUE(contains(o.err, "springs with parameters of their own, fitted to the device's record")) << o;
    auto const given = isolaw(words + in_plane("springs", {"--springs", "given"}));
    ASSERT_EQ(given.code, 0) << given;
    EXPECT_FALSE(contains(given.err, "parameters of their own"));
    EXPECT_NE(without_comments(given.out), without_comments(o.out));
  }
}

TEST_F(Simulate, two_directions_refuse_what_they_cannot_be) {
  write("m.csv", orbit(0.0));
  auto const refused = [&](Words const& words, std::string const& found) {
    auto const o = isolaw(words);
    EXPECT_EQ(o.code, 2) << o;
    EXPECT_TRUE(contains(o.err, found)) << o;
  };
  refused(bouc_wen + in_plane("sideways"), "coupled or springs");
  refused(bouc_wen + Words{"--motion", "m.csv", "--columns", "disp=east", "--bidirectional", "coupled"},
          "--second-disp");
  refused(bouc_wen + Words{"--motion", "m.csv", "--columns", "disp=east", "--second-disp", "north"}, "--bidirectional");
  refused(bouc_wen + in_plane("springs", {"--softening", "axis"}), "each of which keeps its own peak");
  refused(bouc_wen + in_plane("coupled", {"--softening", "axis"}), "no peak softens this law");
  refused(bouc_wen + in_plane("springs", {"--springs", "fitted"}), "not fitted to a device's record");
  refused(bouc_wen + in_plane("coupled", {"--springs", "given"}), "with --bidirectional springs");
  refused(bouc_wen + in_plane("springs", {"--springs", "taken"}), "given or fitted");
  refused(bouc_wen + in_plane("coupled", {"--softening", "up"}), "distance or axis");
  refused(bouc_wen + in_plane("coupled", {"--integration", "paper"}), "--integration converged");
  refused(bouc_wen + in_plane("coupled", {"--turning-points", "interpolated"}), "--turning-points sampled");
  refused(Words{"simulate", "menegotto-pinto", "--set", "E=3", "--set", "Fy=30", "--set", "b=0.1", "--set", "R0=2",
                "--set", "cR1=0.925", "--set", "cR2=0.15"} +
              in_plane("coupled"),
          "menegotto-pinto");
}

}  // namespace
}  // namespace isolaw::cli_test
