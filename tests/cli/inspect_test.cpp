// Runs `isolaw inspect` on a lot. Every number of cycles, devices and properties must equal a value that the test
// computes from the samples.
#include "cli/loops.hpp"
#include "cli/records.hpp"
#include "cli/run.hpp"

namespace isolaw::cli_test {
namespace {

constexpr int per_cycle = 200;

struct Moments {
  double mean = 0.0, sd = 0.0, min = 0.0, max = 0.0;
};

Moments moments_of(std::vector<double> const& values) {
  Moments moments{.min = std::ranges::min(values), .max = std::ranges::max(values)};
  auto const n = static_cast<double>(values.size());
  for (double const v : values) moments.mean += v / n;
  for (double const v : values) moments.sd += (v - moments.mean) * (v - moments.mean) / (n - 1.0);
  moments.sd = std::sqrt(moments.sd);
  return moments;
}

class Inspect : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    for (std::size_t d = 0; d < 4; ++d) {
      samples_.push_back(rounded(record({.stiffness_kN_per_mm = stiffness_[d], .strength_kN = strength_[d]})));
      write("lot/" + names_[d] + ".csv", csv(samples_[d]));
    }
  }
  // Rounds the samples to the digits that the file has.
  static std::vector<Sample> rounded(std::vector<Sample> samples) {
    for (auto& s : samples) {
      s.disp_mm = std::round(1e5 * s.disp_mm) / 1e5;
      s.force_kN = std::round(1e5 * s.force_kN) / 1e5;
    }
    return samples;
  }
  Loop loop(std::size_t device, int cycle) const {
    auto const end = static_cast<std::size_t>(cycle * per_cycle);
    return loop_of(samples_[device], end - per_cycle, end);
  }
  std::vector<double> third(double Loop::*property) const {
    std::vector<double> values;
    for (std::size_t d = 0; d < 4; ++d) values.push_back(loop(d, 3).*property);
    return values;
  }
  Words files() const { return {"lot/D1.csv", "lot/D2.csv", "lot/D3.csv", "lot/D4.csv"}; }
  Json inspected(Words const& words) {
    auto const o = isolaw(Words{"inspect", "--json"} + words);
    EXPECT_EQ(o.code, 0) << o;
    return Json::parse(o.out);
  }
  void expect_devices(Json const& found) const {
    ASSERT_EQ(found["devices"].size(), 4u);
    for (std::size_t d = 0; d < 4; ++d) {
      auto const& device = found["devices"][d];
      EXPECT_EQ(device["name"], names_[d]);
      EXPECT_EQ(device["samples"], 601);
      ASSERT_EQ(device["blocks"].size(), 1u);
      EXPECT_EQ(device["blocks"][0]["cycles"].size(), 3u);
      EXPECT_NEAR(device["blocks"][0]["frequency_Hz"].get<double>(), 0.5, 1e-6);
      for (int n = 1; n <= 3; ++n) expect_loop(cycle_of(device, 1, n), loop(d, n));
      EXPECT_EQ(device["reported"], (Json{{"block", 1}, {"number", 3}}));
    }
  }

  std::vector<std::vector<Sample>> samples_;
  std::vector<std::string> const names_{"D1", "D2", "D3", "D4"};
  std::vector<double> const stiffness_{0.50, 0.53, 0.46, 0.511}, strength_{20.0, 21.0, 19.5, 22.0};
};

TEST_F(Inspect, files_a_directory_and_a_lot_file_give_the_same_devices) {
  auto const files = inspected(this->files());
  expect_devices(files);
  auto const directory = inspected({"lot"});
  EXPECT_EQ(directory["devices"], files["devices"]);
  EXPECT_EQ(directory["assessment"], files["assessment"]);
  EXPECT_EQ(directory["title"], "lot");
  write("lot/device.xyz", "1 2 3\n");
  EXPECT_TRUE(contains(isolaw({"inspect", "lot"}).err,
                       "note: lot: not read, because their names are not those of test records: device.xyz"));
  std::string lot = "title = \"Four\"\n";
  for (auto const& name : names_) lot += fmt::format("[[device]]\nname = \"{0}\"\nfile = \"{0}.csv\"\n", name);
  write("lot/lot.toml", lot);
  auto const from_lot = inspected({"lot/lot.toml"});
  EXPECT_EQ(from_lot["devices"], files["devices"]);
  EXPECT_EQ(from_lot["title"], "Four");
}

TEST_F(Inspect, values_and_what_shows_each_column_are_said_for_programs) {
  auto const by_name = inspected({"lot/D1.csv"});
  for (auto const& [key, value] : {std::pair("disp_mm", &Sample::disp_mm), std::pair("force_kN", &Sample::force_kN)}) {
    std::vector<double> all;
    for (auto const& sample : samples_[0]) all.push_back(sample.*value);
    auto const& values = by_name["values"][key];
    ASSERT_EQ(values["first"].size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(values["first"][i].get<double>(), all[i], 1e-8);
    EXPECT_NEAR(values["least"].get<double>(), std::ranges::min(all), 1e-6);
    EXPECT_NEAR(values["largest"].get<double>(), std::ranges::max(all), 1e-6);
  }
  auto const taken = [](Json const& device, std::string const& channel) {
    for (auto const& one : device["decisions"])
      if (one["kind"] == "column-taken" && one["channel"] == channel) return one;
    return Json();
  };
  EXPECT_EQ(taken(by_name, "force"),
            Json::parse(R"({"kind": "column-taken", "channel": "force", "column_by": "name", "stated_unit": "kN"})"));
  // inspect must state the unit in the file even if an option names the column and another unit.
  write("symbols.csv", csv(samples_[0], "t [s],d,F [kN]"));
  auto const asked = inspected({"symbols.csv", "--columns", "force=F [kN],disp=d", "--units", "force=N,disp=mm"});
  EXPECT_EQ(taken(asked, "force"),
            Json::parse(R"({"kind": "column-taken", "channel": "force", "column_by": "symbol", "stated_unit": "kN"})"));
  EXPECT_FALSE(taken(asked, "disp").contains("stated_unit"));
  write("other.csv", csv(samples_[0], "p,q,r"));
  auto const other =
      inspected({"other.csv", "--columns", "time=p,disp=q,force=r", "--units", "time=s,disp=mm,force=kN"});
  EXPECT_EQ(taken(other, "disp")["column_by"], "option");
  EXPECT_TRUE(inspected({"symbols.csv", "--units", "disp=mm", "--columns", "time=none", "--dt", "0.01"})["decisions"]
                  .back()["option"] == "--dt");
}

TEST_F(Inspect, the_lot_is_described_by_its_third_cycles) {
  auto const found = inspected(files() + Words{"--lot-size", "20", "--design", "K_eff=0.72"});
  auto const& lot = found["assessment"]["lot"];
  EXPECT_EQ(lot["size"], 20);
  EXPECT_EQ(lot["tested"], 4);
  EXPECT_TRUE(lot["required"].is_null());
  EXPECT_EQ(lot["sample"]["reason"], "no rule set was asked for");
  std::vector<std::pair<std::string, double Loop::*>> const properties{
      {"K_eff", &Loop::K_eff}, {"damping", &Loop::damping}, {"energy", &Loop::energy}};
  ASSERT_EQ(lot["quantities"].size(), 5u);
  for (auto const& [name, property] : properties) {
    auto const values = third(property);
    auto const expected = moments_of(values);
    auto const& quantity =
        *std::ranges::find_if(lot["quantities"], [&](Json const& q) { return q["quantity"] == name; });
    auto const near = [&](char const* key, double value, double share = 1e-6) {
      EXPECT_NEAR(quantity[key].get<double>(), value, share * std::abs(value)) << name << " " << key;
    };
    EXPECT_EQ(quantity["n"], 4);
    near("mean", expected.mean);
    near("sd", expected.sd, 1e-4);
    near("cov_percent", 100.0 * expected.sd / expected.mean, 1e-4);
    near("min", expected.min);
    near("max", expected.max);
    EXPECT_EQ(quantity["min_device"],
              names_[static_cast<std::size_t>(std::ranges::min_element(values) - values.begin())]);
    near("fractile_5", expected.mean - 1.644854 * expected.sd);
    near("fractile_95", expected.mean + 1.644854 * expected.sd);
    near("tolerance_k", 6.3411, 1e-5);  // exact factor for four values, a share of 95 % and a confidence of 95 %
    near("tolerance_lower", expected.mean - 6.3411 * expected.sd, 1e-4);
    EXPECT_TRUE(quantity["outlier_note"].is_null() || quantity["outlier_note"] == "");
    if (name == "K_eff") {
      near("nominal", 0.72);
      near("deviation_of_mean_percent", 100.0 * (expected.mean / 0.72 - 1.0), 1e-4);
    } else {
      EXPECT_TRUE(quantity["nominal"].is_null());
    }
  }
  auto const K = moments_of(third(&Loop::K_eff));
  for (auto const& factor : lot["factors"]) {
    EXPECT_LE(factor["lambda_min"].get<double>(), factor["lambda_max"].get<double>()) << factor;
    EXPECT_LE(factor["lower"].get<double>(), factor["upper"].get<double>()) << factor;
    if (factor["property"] != "K_eff" || factor["source"] != "statistical, system") continue;
    double const half = 1.959964 * K.sd / std::sqrt(20.0) * std::sqrt(16.0 / 19.0);
    EXPECT_NEAR(factor["spec_max"].get<double>(), (K.mean + half) / 0.72, 1e-6);
    EXPECT_NEAR(factor["spec_min"].get<double>(), (K.mean - half) / 0.72, 1e-6);
  }
}

TEST_F(Inspect, an_outlier_is_named_with_its_property) {
  for (int i = 5; i <= 8; ++i)
    write(fmt::format("lot/D{}.csv", i), csv(record({.stiffness_kN_per_mm = i == 8 ? 0.9 : 0.5 + 0.005 * i})));
  auto const found = inspected({"lot"});
  auto const& outliers = found["assessment"]["lot"]["outliers"];
  auto const named = [&](std::string const& device, std::string const& quantity) {
    return std::ranges::any_of(outliers,
                               [&](Json const& o) { return o["device"] == device && o["quantity"] == quantity; });
  };
  EXPECT_TRUE(named("D8", "K_eff")) << outliers;
  EXPECT_FALSE(named("D1", "K_eff")) << outliers;
  auto const text = isolaw({"inspect", "lot"});
  EXPECT_TRUE(contains(text.out, "outlier: D8: K_eff 1.1 kN/mm, ")) << text;
}

TEST_F(Inspect, out_holds_page_json_and_tables_of_the_same_numbers) {
  auto const o = isolaw(Words{"inspect", "--json", "--lot-size", "20", "--out", "O"} + files());
  ASSERT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.err, "written: O/inspection.html")) << o;
  EXPECT_EQ(read("O/inspection.json") + "\n", o.out);
  auto const found = Json::parse(o.out);
  expect_devices(found);

  constexpr double six_digits = 5e-6;  // the tables have six digits
  auto const cycles = cells_of(read("O/tables/cycles.csv"));
  ASSERT_EQ(cycles.size(), 1u + 4 * 3);
  for (std::size_t row = 1; row < cycles.size(); ++row) {
    std::size_t const d = (row - 1) / 3;
    int const n = static_cast<int>((row - 1) % 3) + 1;
    auto const expected = loop(d, n);
    EXPECT_EQ(cell(cycles, row, "device"), names_[d]);
    EXPECT_EQ(cell(cycles, row, "cycle"), std::to_string(n));
    EXPECT_EQ(cell(cycles, row, "counts"), "yes");
    EXPECT_EQ(cell(cycles, row, "reported"), n == 3 ? "yes" : "no");
    EXPECT_NEAR(number(cycles, row, "K_eff [kN/mm]"), expected.K_eff, six_digits * expected.K_eff);
    EXPECT_NEAR(number(cycles, row, "energy [kN mm]"), expected.energy, six_digits * expected.energy);
    EXPECT_NEAR(number(cycles, row, "damping [%]"), expected.damping, six_digits * expected.damping);
    EXPECT_NEAR(number(cycles, row, "F- [kN]"), expected.F_minus, 1e-3);
    EXPECT_NEAR(number(cycles, row, "period [s]"), 2.0, 1e-6);
  }
  EXPECT_EQ(cells_of(read("O/tables/tests.csv")).size(), 1u) << "no rules, no verdicts";
  auto const lot = cells_of(read("O/tables/lot.csv"));
  ASSERT_EQ(lot.size(), 6u);
  auto const K = moments_of(third(&Loop::K_eff));
  EXPECT_EQ(cell(lot, 1, "quantity"), "K_eff");
  EXPECT_EQ(cell(lot, 1, "lot size"), "20");
  EXPECT_EQ(cell(lot, 1, "tested"), "4");
  EXPECT_NEAR(number(lot, 1, "mean"), K.mean, six_digits);
  EXPECT_NEAR(number(lot, 1, "std"), K.sd, six_digits);
  EXPECT_EQ(cell(lot, 1, "max device"), "D2");
  auto const lambda = cells_of(read("O/tables/lambda.csv"));
  // Five properties have one row of observed factors and three rows of statistical factors each.
  ASSERT_EQ(lambda.size(), 1u + 5 * 4);
  EXPECT_EQ(cell(lambda, 1, "source"), "observed");
  EXPECT_NEAR(number(lambda, 1, "lambda_spec min"), K.min / K.mean, six_digits);
  EXPECT_NEAR(number(lambda, 1, "lambda_spec max"), K.max / K.mean, six_digits);

  auto const page = page_data(read("O/inspection.html"));
  EXPECT_TRUE(page["laws"].empty());
  expect_devices([&] {
    Json devices = page;
    for (auto& device : devices["devices"]) device["samples"] = device["raw"]["samples"];
    return devices;
  }());
  EXPECT_EQ(page["assessment"], found["assessment"]);
}

TEST_F(Inspect, the_text_of_a_lot_holds_a_line_for_each_device) {
  auto const o = isolaw(Words{"inspect"} + files());
  EXPECT_EQ(o.code, 0) << o;
  for (std::size_t d = 0; d < 4; ++d) {
    auto const l = loop(d, 3);
    EXPECT_TRUE(contains(o.out, fmt::format("{:<6} {:>5} {:>5} {:>9.2f} {:>9.4f} {:>10.4g} {:>8.2f}", names_[d], 1, 3,
                                            100.0, l.K_eff, l.energy, l.damping)));
  }
  auto const K = moments_of(third(&Loop::K_eff));
  EXPECT_TRUE(contains(o.out, fmt::format("K_eff     kN/mm    4 {:>10.4g} {:>7.2f}", K.mean, 100.0 * K.sd / K.mean)));
}

TEST_F(Inspect, a_refused_device_is_shown_and_ends_with_1) {
  write("lot/D5.csv", "time [s],displacement [mm],force [kN]\n0,0,0\n1,x,2\n2,1,1\n");
  auto const o = isolaw({"inspect", "lot", "--json", "--out", "O"});
  EXPECT_EQ(o.code, 1) << o;
  auto const found = Json::parse(o.out);
  ASSERT_EQ(found["devices"].size(), 5u);
  EXPECT_EQ(found["devices"][4]["status"], "refused");
  EXPECT_TRUE(contains(found["devices"][4]["message"].get<std::string>(), "'x'"));
  EXPECT_EQ(found["assessment"]["lot"]["tested"], 4);
  auto const cycles = cells_of(read("O/tables/cycles.csv"));
  EXPECT_EQ(cell(cycles, cycles.size() - 1, "device"), "D5");
  EXPECT_TRUE(contains(cell(cycles, cycles.size() - 1, "no properties"), "'x'"));
}

TEST_F(Inspect, which_part_of_a_file_was_read_is_told) {
  auto const alone = inspected({"lot/D1.csv"});
  EXPECT_TRUE(alone["sheet"].is_null());
  EXPECT_TRUE(alone["test"].is_null());
  write("several.csv", csv(samples_[0]) + csv(samples_[1]));
  auto const second = inspected({"several.csv", "--test", "2"});
  EXPECT_EQ(second["test"], "2");
  expect_loop(cycle_of(second, 1, 3), loop(1, 3));
  EXPECT_EQ(inspected({"several.csv", "--test", "all"})["test"], "all");
  Json both;
  for (std::size_t d = 0; d < 2; ++d)
    for (auto const& s : samples_[d])
      both[names_[d]].push_back({{"time [s]", s.time_s}, {"disp [mm]", s.disp_mm}, {"force [kN]", s.force_kN}});
  write("both.json", both.dump());
  auto const sheet = inspected({"both.json", "--sheet", "D2"});
  EXPECT_EQ(sheet["sheet"], "D2");
  expect_loop(cycle_of(sheet, 1, 3), loop(1, 3));
}

// Returns the entry `name` of the device's error budget.
Json effect(Json const& device, std::string const& name) {
  for (auto const& one : device["effects"])
    if (one["effect"] == name) return one;
  ADD_FAILURE() << "no effect " << name << " in " << device["effects"];
  return {};
}

TEST_F(Inspect, the_effects_of_the_error_budget_are_numbers) {
  auto const good = inspected({"lot/D1.csv"});
  EXPECT_NEAR(effect(good, "samples per cycle")["value"].get<double>(), 200.0, 1e-6);
  EXPECT_EQ(effect(good, "samples per cycle")["limit"], 100);
  EXPECT_EQ(effect(good, "samples per cycle")["exceeds"], false);
  // With N samples per cycle the loop loses the share 1 - N/(2 pi) sin(2 pi/N) of its energy, and the peak the share 1
  // - cos(pi/N).
  double const angle = 2.0 * std::numbers::pi / 200.0;
  EXPECT_NEAR(effect(good, "energy lost between samples")["value"].get<double>(),
              100.0 * (1.0 - std::sin(angle) / angle), 1e-6);
  EXPECT_NEAR(effect(good, "peak missed between samples")["value"].get<double>(), 100.0 * (1.0 - std::cos(angle / 2.0)),
              1e-6);
  EXPECT_TRUE(effect(good, "peak missed between samples")["limit"].is_null());
  // The inertia of a moving mass m lowers the measured stiffness by m (2 pi f)^2. Here m is a tonne and f 0.5 Hz.
  auto const mass = effect(good, "stiffness taken by a tonne of moving mass");
  EXPECT_NEAR(mass["value"].get<double>(), 1e-3 * std::numbers::pi * std::numbers::pi, 1e-6);
  EXPECT_EQ(mass["unit"], "kN/mm");
  write("few.csv", csv(record({.samples = 181, .per_cycle = 60, .interval_s = 1.0 / 30.0})));
  auto const few = inspected({"few.csv"});
  EXPECT_NEAR(effect(few, "samples per cycle")["value"].get<double>(), 60.0, 0.01);
  EXPECT_EQ(effect(few, "samples per cycle")["exceeds"], true);
  EXPECT_TRUE(contains(few["warnings"].dump(), "60.0 samples per cycle"));
}

TEST_F(Inspect, a_record_without_a_complete_cycle_says_so_once) {
  write("short.csv", csv(std::vector<Sample>(samples_[0].begin(), samples_[0].begin() + 150)));
  auto const o = isolaw({"inspect", "short.csv"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.out, "Block 1: no complete cycle")) << o;
  EXPECT_EQ(count_of("less than one complete cycle", o.out), 1u) << o;
  EXPECT_EQ(o.out.find(" cycles of "), std::string::npos) << o;
  auto const found = inspected({"short.csv"});
  EXPECT_TRUE(found["reported"].is_null());
  EXPECT_TRUE(contains(found["properties_refusal"].get<std::string>(), "less than one complete cycle"));
}

// For the committed example lot, the statistics of the lot must agree with the devices' own values.
TEST_F(Inspect, the_example_lot) {
  fs::path const example = fs::path(ISOLAW_SOURCE_DIR) / "examples/published-lot";
  auto const found = inspected({example / "lot.toml"});
  ASSERT_EQ(found["devices"].size(), 10u);
  std::vector<double> K;
  for (auto const& device : found["devices"]) {
    auto const& reported = device["reported"];
    K.push_back(cycle_of(device, reported["block"], reported["number"])["K_eff_kN_per_mm"]);
  }
  auto const expected = moments_of(K);
  auto const& stiffness = found["assessment"]["lot"]["quantities"][0];
  EXPECT_EQ(stiffness["quantity"], "K_eff");
  EXPECT_NEAR(stiffness["mean"].get<double>(), expected.mean, 1e-7);
  EXPECT_NEAR(stiffness["sd"].get<double>(), expected.sd, 1e-7);
  // The test reads the first device's samples itself and computes the properties of the cycle that inspect reports.
  std::istringstream lines(read_file(example / "device-01.csv"));
  std::vector<Sample> samples;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    Sample s{};
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf", &s.time_s, &s.disp_mm, &s.force_kN), 3) << line;
    samples.push_back(s);
  }
  auto const& cycle = cycle_of(found["devices"][0], 1, 3);
  auto const first = static_cast<std::size_t>(std::lround(cycle["first"].get<double>()));
  auto const last = static_cast<std::size_t>(std::lround(cycle["last"].get<double>()));
  EXPECT_LE(std::abs(samples[first].disp_mm), 6.6) << "within a sample of the crossing";
  auto const expected_loop = loop_of(samples, first, last);
  EXPECT_NEAR(cycle["K_eff_kN_per_mm"].get<double>(), expected_loop.K_eff, 1e-6);
  EXPECT_NEAR(cycle["energy_kN_mm"].get<double>(), expected_loop.energy, 0.01 * expected_loop.energy);
}

TEST_F(Inspect, BothStreamsInOneFileKeepTheirLinesWhole) {
  auto const all = Words{"inspect", "--json", "--out", "x"} + files();
  ASSERT_EQ(Process(Words{"/bin/sh", "-c", R"(exec "$0" "$@" >both.txt 2>&1)", ISOLAW_BINARY} + all, directory(),
                    path("out.txt"), path("err.txt"))
                .wait()
                .code,
            0);
  auto const both = read("both.txt");
  std::string const message = "written: x/inspection.html\n";
  ASSERT_TRUE(both.ends_with("\n" + message)) << both.substr(both.size() - std::min<std::size_t>(both.size(), 300));
  auto const output = both.substr(0, both.size() - message.size());
  ASSERT_GT(output.size(), 10'000u) << "more than the stream holds back";
  EXPECT_TRUE(Json::accept(output));
}

// The records of these tests have values that no real test has. Each message must name the mistake that explains the
// value.
class Implausible : public InFreshDirectory {
 protected:
  std::vector<std::string> kinds(Words const& words) {
    auto const o = isolaw(Words{"inspect", "--json"} + words);
    EXPECT_EQ(o.code, 0) << o;
    std::vector<std::string> kinds;
    auto const found = Json::parse(o.out);  // of a lot, or of a single record
    for (auto const& finding : found.contains("devices") ? found["devices"][0]["findings"] : found["findings"])
      kinds.push_back(finding["kind"]);
    return kinds;
  }
  static bool has(std::vector<std::string> const& kinds, std::string const& kind) {
    return std::ranges::find(kinds, kind) != kinds.end();
  }
};

TEST_F(Implausible, displacement_and_speed) {
  write("a.csv", csv(record(), "time [s],displacement [cm],force [kN]"));  // 1000 mm at 3142 mm/s
  EXPECT_TRUE(has(kinds({"a.csv"}), "motion-implausible"));
  EXPECT_TRUE(contains(isolaw({"inspect", "a.csv"}).out, "displacements really in cm? They may be in mm."));
  write("b.csv", csv(record()));
  EXPECT_FALSE(has(kinds({"b.csv"}), "motion-implausible"));
}

TEST_F(Implausible, force_beyond_the_vertical_load) {
  auto const with_load = [](double load_kN) {
    return csv(record(), "time [s],displacement [mm],force [kN],vertical load [kN]",
               [&](std::size_t, Sample const& s) { return row(s) + fmt::format(",{}", load_kN); });
  };
  write("a.csv", with_load(10.0));
  write("b.csv", with_load(-1000.0));
  EXPECT_TRUE(has(kinds({"a.csv"}), "force-beyond-load"));
  EXPECT_FALSE(has(kinds({"b.csv"}), "force-beyond-load"));
}

TEST_F(Implausible, stiffness_unlike_the_design) {
  write("a.csv", csv(record()));  // K_eff 0.7 kN/mm
  auto const asked = [&](std::string const& K_eff) { return kinds({"a.csv", "--design", "K_eff=" + K_eff}); };
  for (auto const* wrong : {"7", "0.07", "0.0007", "0.157", "1.4", "17.8"})
    EXPECT_TRUE(has(asked(wrong), "stiffness-unlike-design")) << wrong;
  for (auto const* other : {"0.7", "0.5", "1", "2.1"})
    EXPECT_FALSE(has(asked(other), "stiffness-unlike-design")) << other;
}

TEST_F(Implausible, strain_of_the_rubber) {
  write("a.csv", csv(record()));
  for (auto const& [height, wrong] : {std::pair{"10", true}, std::pair{"100", false}}) {
    write("lot.toml", fmt::format("[[device]]\nfile = 'a.csv'\nrubber-thickness-mm = {}\n", height));
    EXPECT_EQ(has(kinds({"lot.toml"}), "strain-implausible"), wrong) << height;
  }
}

// Paths that cannot be opened: links that point to each other, a name that is too long, and a link to a missing file in
// a folder of records.
TEST_F(Implausible, paths_that_lead_nowhere) {
  fs::create_symlink("b.csv", path("a.csv"));
  fs::create_symlink("a.csv", path("b.csv"));
  write("folder/good.csv", csv(record()));
  fs::create_symlink("loop.csv", path("folder/loop.csv"));
  auto const long_name = std::string(300, 'a') + ".csv";
  for (auto const& words :
       {Words{"inspect", "a.csv"}, Words{"calibrate", "a.csv"}, Words{"report", "a.csv"}, Words{"inspect", long_name}})
    EXPECT_EQ(isolaw(words).code, 2) << words[1];
  auto const o = isolaw({"inspect", "folder"});  // the other record is inspected all the same
  EXPECT_EQ(o.code, 1) << o;
  EXPECT_TRUE(contains(o.out, "folder/loop.csv: cannot be read: Too many levels"));
}

// The record has three and a half cycles. The store keeps the option --half-cycles, so reports of the campaign list the
// half cycle too.
TEST_F(Inspect, half_cycles_count_on_request) {
  write("half.csv", csv(record({.samples = 701})));
  auto const without = isolaw({"inspect", "half.csv"});
  EXPECT_TRUE(contains(without.out, "not counted: partial: the record ends at 0 mm")) << without;
  auto const with = isolaw({"inspect", "half.csv", "--half-cycles"});
  EXPECT_EQ(with.code, 0) << with;
  EXPECT_TRUE(contains(with.out, "  half cycle, energy doubled\n")) << with;
  EXPECT_TRUE(contains(with.out, "each swing that belongs to no full cycle counts as a half cycle")) << with;
  auto const one = Json::parse(isolaw({"inspect", "half.csv", "--half-cycles", "--json"}).out);
  auto const& blocks = one.contains("devices") ? one["devices"][0]["blocks"] : one["blocks"];
  ASSERT_EQ(blocks.size(), 3u);
  auto const &full = blocks[0]["cycles"][2], &half = blocks[1]["cycles"][0];
  EXPECT_EQ(full["half"], false);
  EXPECT_EQ(half["half"], true);
  EXPECT_NEAR(half["K_eff_kN_per_mm"].get<double>(), full["K_eff_kN_per_mm"].get<double>(), 1e-4);
  EXPECT_NEAR(half["energy_kN_mm"].get<double>(), full["energy_kN_mm"].get<double>(), 10.0);
  write(
      "half.toml",
      "[calibrate]\nlaws = ['bilinear']\nruns = 1\nreplicates = 0\n[[device]]\nfile = 'half.csv'\nhalf-cycles = true\n");
  auto const o = isolaw({"calibrate", "half.toml", "--out", "H"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(read("H/tables/cycles.csv"), ",650,700,yes,")) << read("H/tables/cycles.csv");
}

}  // namespace
}  // namespace isolaw::cli_test
