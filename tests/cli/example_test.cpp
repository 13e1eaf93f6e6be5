// `isolaw example` writes ten records in ten dialects of delimited text. inspect and init must understand them all.
#include <array>
#include <cmath>

#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

class Example : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    written_ = isolaw({"example", "ex"});
    ASSERT_EQ(written_.code, 0) << written_;
  }
  Outcome written_;
};

constexpr std::array records{"device-01.csv", "device-02.csv", "device-03.txt", "device-04.txt", "device-05.csv",
                             "device-06.csv", "device-07.txt", "device-08.csv", "device-09.csv", "device-10.csv"};

Words all_records() {
  Words files;
  for (auto const* name : records) files.push_back("ex/" + std::string(name));
  return files;
}

TEST_F(Example, writes_lot_readme_and_ten_records_and_says_what_is_next) {
  EXPECT_TRUE(contains(written_.out, "isolaw calibrate ex/lot.toml"));
  EXPECT_EQ(written_.err, "");
  std::size_t files = 0;
  for ([[maybe_unused]] auto const& entry : fs::directory_iterator(path("ex"))) ++files;
  EXPECT_EQ(files, 13u);
  for (auto const* name : records) EXPECT_GT(fs::file_size(path(fs::path("ex") / name)), 10'000u) << name;
  EXPECT_TRUE(contains(read("ex/README.md"), "not measurements"));
  EXPECT_TRUE(contains(read("ex/README.md"), "proves nothing"));
  EXPECT_EQ(count_of("[[device]]", read("ex/lot.toml")), 10u);
}

TEST_F(Example, second_call_leaves_everything_as_it_is) {
  auto const before = read("ex/device-01.csv");
  auto const again = isolaw({"example", "ex"});
  EXPECT_EQ(again.code, 0) << again;
  EXPECT_EQ(read("ex/device-01.csv"), before);
}

// `isolaw example --tests` writes records with typical problems of laboratories: a bearing outside its limit, and a
// force channel that is clipped at the largest amplitude. The laws are fitted to two amplitudes and must predict the
// third.
TEST_F(Example, tests_have_a_soft_bearing_a_clipped_channel_and_an_amplitude_to_predict) {
  auto const made = isolaw({"example", "t", "--tests"});
  ASSERT_EQ(made.code, 0) << made;
  EXPECT_TRUE(contains(made.out, "isolaw calibrate t/lot.toml"));
  EXPECT_TRUE(contains(read("t/README.md"), "computed, not measured"));
  auto const o = isolaw({"calibrate", "t/lot.toml", "--laws", "bilinear,power-masing-worn", "--runs", "1", "--analysis",
                         "full", "--replicates", "0", "--figures", "none", "--out", "T"});
  EXPECT_EQ(o.code, 1) << o;
  auto const summary = json("T/summary.json");
  // The force of B5 is clipped at its largest amplitude. Laws are fitted to its other blocks, and B5 has no verdict.
  for (auto const& device : summary["devices"]) EXPECT_EQ(device["status"], "ok") << device["name"];
  EXPECT_EQ(count_of("laws are not fitted to block 3", read("T/report.html")), 1u);
  EXPECT_EQ(summary["recommendation"]["law"], "power-masing-worn");
  // The first outlier must be the soft bearing, because of a property measured on it. A device on which a law's error
  // is only slightly larger than on other devices must not be an outlier.
  ASSERT_FALSE(summary["outliers"].empty());
  EXPECT_EQ(summary["outliers"][0]["unit"], "kN mm");
  for (auto const& outlier : summary["outliers"])
    EXPECT_TRUE(outlier["unit"] != "" || outlier["percent"].get<double>() >= 10.0) << outlier;
  EXPECT_LT(summary["recommendation"]["standings"][0]["predicts"].get<double>(), 0.05);
  EXPECT_TRUE(contains(o.out, "FAIL: NTC 2018: 1 of 5 devices fails: B4 K_eff")) << o;
  EXPECT_TRUE(contains(o.out, "without a verdict: B5")) << o;
  EXPECT_TRUE(contains(read("T/report.html"), "the force is clipped at 125 kN"));
}

TEST_F(Example, tests_and_building_cannot_both_be_asked_for) {
  expect_refused(isolaw({"example", "t", "--tests", "--building"}), {"--building", "is given with --tests"});
}

TEST_F(Example, does_not_overwrite_a_changed_file) {
  write("ex/device-03.txt", "mine");
  expect_refused(isolaw({"example", "ex"}), {"ex/device-03.txt", "with other content", "empty directory"});
  EXPECT_EQ(read("ex/device-03.txt"), "mine");
}

TEST_F(Example, into_a_file_is_refused) {
  write("file", "x");
  expect_refused(isolaw({"example", "file"}), {"file", "cannot make the directory", "another directory"});
  EXPECT_EQ(read("file"), "x");
}

TEST_F(Example, is_the_folder_that_the_repository_carries) {
  fs::path const committed = fs::path(ISOLAW_SOURCE_DIR) / "examples/published-lot";
  ASSERT_TRUE(fs::exists(committed / "lot.toml")) << committed;
  for (auto const& entry : fs::directory_iterator(path("ex")))
    EXPECT_EQ(read_file(entry.path()), read_file(committed / entry.path().filename())) << entry.path().filename();
}

// How isolaw should read a record: a sentence on its dialect, the columns (the first is 1), the units, and the line of
// the first sample.
struct Dialect {
  char const* sentence;              // isolaw prints it under "recognised"
  std::array<char const*, 3> units;  // of time, displacement and force
  int first_column = 1;
  int first_line = 2;
};
constexpr std::array<Dialect, 10> dialects{{
    {"separated by commas, decimals by a point", {"s", "mm", "kN"}},
    {"separated by semicolons, decimals by a comma", {"s", "mm", "kN"}, 1, 4},
    {"separated by tabs, decimals by a point", {"s", "mm", "kN"}, 1, 3},
    {"separated by blanks, decimals by a point", {"s", "mm", "kN"}, 1, 3},
    {"separated by semicolons, decimals by a point", {"s", "m", "N"}, 1, 4},
    {"separated by commas, decimals by a point", {"s", "cm", "tonf"}},
    {"separated by tabs, decimals by a comma", {"s", "mm", "kN"}},
    {"separated by commas, decimals by a point", {"s", "in", "kip"}, 1, 3},
    {"separated by semicolons, decimals by a comma", {"ms", "mm", "kgf"}},
    {"separated by commas, decimals by a point", {"s", "mm", "kN"}, 2},
}};

TEST_F(Example, inspect_recognises_columns_units_and_cycles_of_every_dialect) {
  for (std::size_t d = 0; d < records.size(); ++d) {
    auto const file = "ex/" + std::string(records[d]);
    SCOPED_TRACE(file);
    auto const o = isolaw({"inspect", file});
    EXPECT_EQ(o.code, 0) << o;
    EXPECT_EQ(o.err, "");
    EXPECT_TRUE(contains(o.out, dialects[d].sentence));
    char const* const channels[]{"time", "disp", "force"};
    for (int c = 0; c < 3; ++c) {
      EXPECT_TRUE(contains(o.out, fmt::format("{}: column {} ", channels[c], dialects[d].first_column + c)));
      EXPECT_TRUE(contains(o.out, fmt::format("; unit {} from ", dialects[d].units[static_cast<std::size_t>(c)])));
    }
    EXPECT_TRUE(contains(o.out, fmt::format("load: column {} ", dialects[d].first_column + 3)));
    EXPECT_TRUE(contains(
        o.out, fmt::format("601 samples, lines {} to {}", dialects[d].first_line, dialects[d].first_line + 600)));
    EXPECT_TRUE(contains(o.out, "sampling interval 0.01 s"));
    EXPECT_TRUE(contains(o.out, "reported"));
  }
}

TEST_F(Example, inspect_as_json_agrees_between_dialects) {
  for (std::size_t d = 0; d < records.size(); ++d) {
    SCOPED_TRACE(records[d]);
    auto const o = isolaw({"inspect", "ex/" + std::string(records[d]), "--json"});
    ASSERT_EQ(o.code, 0) << o;
    auto const found = Json::parse(o.out);
    EXPECT_EQ(found["samples"], 601);
    EXPECT_EQ(found["sha256"].get<std::string>().size(), 64u);
    EXPECT_EQ(found["units"]["time"], dialects[d].units[0]);
    EXPECT_EQ(found["units"]["disp"], dialects[d].units[1]);
    EXPECT_EQ(found["units"]["force"], dialects[d].units[2]);
    for (auto const* channel : {"time", "disp", "force", "load"}) EXPECT_NE(found["columns"][channel], "") << channel;
    EXPECT_EQ(found["properties_refusal"], "");
    EXPECT_NEAR(found["samples_per_cycle"].get<double>(), 200.0, 0.5);
    EXPECT_EQ(found["reported"], (Json{{"block", 1}, {"number", 3}}));
    ASSERT_EQ(found["blocks"].size(), 1u);
    EXPECT_NEAR(found["blocks"][0]["frequency_Hz"].get<double>(), 0.5, 0.005);
    ASSERT_EQ(found["blocks"][0]["cycles"].size(), 3u);
    int number = 0;
    for (auto const& cycle : found["blocks"][0]["cycles"]) {
      EXPECT_EQ(cycle["number"], ++number);
      EXPECT_EQ(cycle["counts"], true);
      // The records have an amplitude of 208 mm with a tremor of 0.1 mm and noise of 0.02 mm. Stiffness and damping are
      // those of the devices of Cucuzza et al. 2025.
      EXPECT_NEAR(cycle["amplitude_mm"].get<double>(), 208.0, 0.3);
      EXPECT_GT(cycle["K_eff_kN_per_mm"].get<double>(), 0.5);
      EXPECT_LT(cycle["K_eff_kN_per_mm"].get<double>(), 0.8);
      EXPECT_GT(cycle["damping_percent"].get<double>(), 15.0);
      EXPECT_LT(cycle["damping_percent"].get<double>(), 25.0);
      double const D = cycle["amplitude_mm"], K = cycle["K_eff_kN_per_mm"];
      EXPECT_NEAR(cycle["damping_percent"].get<double>(),
                  100.0 * cycle["energy_kN_mm"].get<double>() / (2.0 * M_PI * K * D * D), 1e-6);
    }
  }
}

TEST_F(Example, init_writes_a_lot_file_that_calibrate_takes) {
  auto const output = isolaw(Words{"init"} + all_records());
  ASSERT_EQ(output.code, 0) << output;
  EXPECT_TRUE(contains(output.out, "isolaw calibrate lot.toml"));
  EXPECT_TRUE(contains(output.out, "unit kip from line 2"));
  auto const text = read("lot.toml");
  EXPECT_EQ(count_of("[[device]]", text), 10u);
  EXPECT_TRUE(contains(text, "ex/device-01.csv"));
  auto const run = isolaw({"calibrate", "lot.toml", "--laws", "bilinear", "--runs", "1", "--population", "4",
                           "--generations", "2", "--out", "O"});
  EXPECT_EQ(run.code, 0) << run;
  auto const summary = json("O/summary.json");
  ASSERT_EQ(summary["devices"].size(), 10u);
  for (auto const& device : summary["devices"]) EXPECT_EQ(device["status"], "ok") << device;

  // The records named on the command line must give the same results as those read through the lot file.
  auto const direct =
      isolaw(Words{"calibrate"} + all_records() +
             Words{"--laws", "bilinear", "--runs", "1", "--population", "4", "--generations", "2", "--out", "P"});
  EXPECT_EQ(direct.code, 0) << direct;
  EXPECT_EQ(json("P/summary.json")["laws"], summary["laws"]);
}

TEST_F(Example, init_overwrites_only_when_forced) {
  write("lot.toml", "mine");
  auto const refused = isolaw({"init", "ex/device-01.csv"});
  expect_refused(refused, {"lot.toml", "exists already", "--force"});
  EXPECT_EQ(read("lot.toml"), "mine");
  EXPECT_EQ(isolaw({"init", "ex/device-01.csv", "--force"}).code, 0);
  EXPECT_TRUE(contains(read("lot.toml"), "device-01"));
}

TEST_F(Example, init_writes_elsewhere_with_names_relative_to_the_lot_file) {
  auto const output = isolaw({"init", "ex/device-01.csv", "--out", "ex/own.toml"});
  ASSERT_EQ(output.code, 0) << output;
  EXPECT_TRUE(contains(read("ex/own.toml"), "'device-01.csv'"));
  EXPECT_EQ(isolaw({"calibrate", "ex/own.toml", "--laws", "bilinear", "--runs", "1", "--population", "4",
                    "--generations", "1", "--out", "O"})
                .code,
            0);
}

TEST_F(Example, init_records_the_options_it_was_given) {
  auto const output = isolaw({"init", "ex/device-01.csv", "--columns", "time=none,load=none", "--dt", "0.02"});
  ASSERT_EQ(output.code, 0) << output;
  auto const o = isolaw({"calibrate", "lot.toml", "--laws", "jankowski", "--runs", "1", "--population", "4",
                         "--generations", "1", "--out", "O"});
  EXPECT_EQ(o.code, 0) << o;
  auto const store = path("O/campaign.sqlite");
  EXPECT_EQ(query(store, "SELECT channel FROM series WHERE kind = 'raw' ORDER BY channel"),
            (Words{"disp_mm", "force_kN", "time_s"}));
  EXPECT_TRUE(contains(query(store, "SELECT recognised FROM device").at(0), "sampling interval 0.02 s"));
}

TEST_F(Example, init_of_bad_records_alone_writes_nothing) {
  write("bad.csv", "");
  expect_message(isolaw({"init", "bad.csv"}), 2, {"bad.csv", "is empty"});
  EXPECT_FALSE(exists("lot.toml"));
  expect_message(isolaw({"init", "ex/device-01.csv", "bad.csv"}), 1, {"bad.csv", "is empty", "1 of 2 left out"});
  EXPECT_TRUE(exists("lot.toml"));
}

}  // namespace
}  // namespace isolaw::cli_test
