// Runs calibrate on the example lot. Tests the files that it writes, the structure of summary.json, and options that
// must not change any number.
#include <cmath>
#include <map>
#include <set>

#include "cli/published_laws.hpp"
#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

Words const reduced{"--runs", "2", "--population", "20", "--generations", "5"};

class Calibrate : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    ASSERT_EQ(isolaw({"example", "ex"}).code, 0);
  }
  Outcome calibrate(std::string const& out, Words const& more = {}, std::string const& lot = "ex/study.toml") {
    return isolaw(Words{"calibrate", lot} + reduced + Words{"--out", out} + more);
  }
};

std::vector<std::string> keys(Json const& object) {
  std::vector<std::string> names;
  for (auto const& [key, value] : object.items()) names.push_back(key);
  return names;
}

void expect_statistic(Json const& statistic) {
  EXPECT_EQ(keys(statistic), (Words{"mean", "std", "best"}));
  for (auto const& value : statistic) EXPECT_TRUE(value.is_number()) << statistic;
  EXPECT_LE(statistic["best"].get<double>(), statistic["mean"].get<double>());
  EXPECT_GT(statistic["best"].get<double>(), 0.0);
}

// report.html shows the command of the campaign. If this command is run again, it must give the same results, verdicts
// and bounds.
TEST_F(Calibrate, the_command_of_the_page_makes_it_again) {
  for (auto const* name : {"device-01.csv", "device-02.csv"})
    fs::copy_file(path("ex") / name, path(name), fs::copy_options::overwrite_existing);
  auto const once = isolaw(Words{"calibrate", "device-01.csv", "device-02.csv", "--laws", "bilinear,bouc-wen",
                                 "--method", "ga", "--set", "bouc-wen.A=1", "--seed", "7", "--rules", "ntc-2018",
                                 "--design", "K_eff=0.62,damping=19.5,disp=208,frequency=0.5", "--lot-size", "28"} +
                           reduced + Words{"--out", "O"});
  ASSERT_LE(once.code, 1) << once;
  auto const page = read("O/report.html");
  auto const start = page.find("\"command\":\"") + 11;
  auto const command = page.substr(start, page.find('"', start) - start);
  Words words;
  std::istringstream stream(command);
  for (std::string word; stream >> word;) words.push_back(word);
  ASSERT_EQ(words.at(0), "isolaw") << command;
  words.erase(words.begin());
  auto const again = isolaw(words + Words{"--out", "P"});
  EXPECT_EQ(again.code, once.code) << command << again;
  for (auto const* file :
       {"summary.json", "tables/tests.csv", "tables/lot.csv", "tables/lambda.csv", "tables/parameters.csv"})
    EXPECT_EQ(read(fs::path("P") / file), read(fs::path("O") / file)) << file << "\n" << command;
}

TEST_F(Calibrate, leaves_every_file_of_a_campaign) {
  auto const o = calibrate("O");
  EXPECT_EQ(o.code, 0) << o;
  std::set<std::string> files;
  for (auto const& entry : fs::recursive_directory_iterator(path("O")))
    if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), path("O")).generic_string());
  EXPECT_EQ(files, (std::set<std::string>{"campaign.sqlite",
                                          "run.json",
                                          "summary.json",
                                          "report.html",
                                          "tables/parameters.csv",
                                          "tables/objective.csv",
                                          "tables/robustness.csv",
                                          "tables/converged.csv",
                                          "tables/identifiability.csv",
                                          "tables/lot_law.csv",
                                          "tables/prediction.csv",
                                          "tables/cycles.csv",
                                          "tables/tests.csv",
                                          "tables/vertical.csv",
                                          "tables/levels.csv",
                                          "tables/lot.csv",
                                          "tables/lambda.csv",
                                          "tables/table_a5.csv",
                                          "tables/table_a5.tex",
                                          "tables/robustness.tex",
                                          "tables/front.csv",
                                          "tables/front.tex"}));
  EXPECT_TRUE(contains(o.out, "O/report.html"));
  auto const run = json("O/run.json");
  for (auto const* key : {"isolaw", "command", "directory", "started", "total_seconds", "threads", "host"})
    EXPECT_TRUE(run.contains(key)) << key;
  EXPECT_TRUE(contains(run["command"].get<std::string>(), "calibrate ex/study.toml --runs 2"));
  // A progress line would contain carriage returns. calibrate prints none here, because standard error is not a
  // terminal.
  EXPECT_EQ(o.err.find('\r'), std::string::npos);
}

TEST_F(Calibrate, ranks_every_law_on_the_terminal_best_first) {
  ASSERT_EQ(calibrate("O").code, 0);
  auto const o = isolaw({"report", "O", "--details", "--figures", "none"});
  ASSERT_EQ(o.code, 0) << o;
  auto const summary = json("O/summary.json");
  std::map<double, std::string> by_objective;
  for (auto const& law : summary["laws"]) by_objective[law["objective"]["mean"]] = law["id"];
  std::size_t at = 0;
  int rank = 0;
  for (auto const& [objective, id] : by_objective) {
    auto const found = o.out.find(fmt::format("\n  {}  {} ", ++rank, id));
    ASSERT_NE(found, std::string::npos) << id << o;
    EXPECT_GT(found, at);
    at = found;
    EXPECT_TRUE(
        contains(o.out.substr(found + 1, o.out.find('\n', found + 1) - found), fmt::format(" {:.4f} ", objective)));
  }
  EXPECT_EQ(static_cast<std::size_t>(rank), published_laws().size());
  EXPECT_TRUE(contains(o.out, fmt::format("10 devices, {} laws, seed 1", rank)));
  EXPECT_TRUE(contains(o.out, "lower is more accurate"));
}

// Scripts depend on the keys of summary.json, on their order and their types. This test fails if any of them changes.
TEST_F(Calibrate, summary_has_the_documented_schema) {
  ASSERT_EQ(calibrate("O").code, 0);
  auto const s = json("O/summary.json");
  EXPECT_EQ(keys(s), (Words{"schema", "isolaw", "seed", "settings", "devices", "laws", "title", "outliers", "complete",
                            "missing_runs", "missing_analyses", "warnings", "recommendation", "published"}));
  EXPECT_EQ(s["schema"], 2);
  ASSERT_EQ(s["isolaw"].size(), 1u);
  EXPECT_EQ(s["isolaw"][0]["version"], ISOLAW_VERSION);
  EXPECT_EQ(s["isolaw"][0]["build"].get<std::string>().size(), 12u);
  EXPECT_EQ(s["seed"], 1);
  ASSERT_EQ(s["devices"].size(), 10u);
  for (auto const& device : s["devices"]) {
    EXPECT_EQ(keys(device), (Words{"name", "file", "sha256", "status", "message", "dead_band_mm", "tests"}));
    EXPECT_EQ(device["status"], "ok");
    EXPECT_EQ(device["message"], "");
    EXPECT_EQ(device["sha256"].get<std::string>().size(), 64u);
    EXPECT_TRUE(exists(fs::path("ex") / device["file"].get<std::string>()));
  }
  ASSERT_EQ(s["laws"].size(), published_laws().size());
  for (std::size_t l = 0; l < published_laws().size(); ++l) {
    auto const& law = s["laws"][l];
    auto const& expected = published_laws()[l];
    SCOPED_TRACE(expected.id);
    EXPECT_EQ(keys(law), (Words{"id",
                                "objective",
                                "beta",
                                "on_front",
                                "devices",
                                "beta_note",
                                "name",
                                "title",
                                "notes",
                                "success_share",
                                "success_reference",
                                "objective_converged",
                                "beta_converged",
                                "beta_converged_note",
                                "left_out_of_beta",
                                "reduced",
                                "on_front_converged",
                                "loo_objective",
                                "loo_worst",
                                "loo_worst_device",
                                "on_front_loo",
                                "larger_swings_objective",
                                "larger_swings_least",
                                "larger_swings_worst",
                                "tested_mm",
                                "asked_mm",
                                "K_at_asked_kN_per_mm",
                                "energy_at_asked_kN_mm",
                                "stiffness_ratio",
                                "damping_ratio",
                                "lot",
                                "population",
                                "fitted_objective",
                                "predicted_objective",
                                "worst_predicted",
                                "prediction_collapses",
                                "prediction_grade",
                                "reduced_form"}));
    EXPECT_EQ(law["id"], expected.id);
    expect_statistic(law["objective"]);
    EXPECT_GT(law["beta"].get<double>(), 0.0);
    EXPECT_TRUE(law["on_front"].is_boolean());
    ASSERT_EQ(law["devices"].size(), 10u);
    for (std::size_t d = 0; d < 10; ++d) {
      auto const& fit = law["devices"][d];
      EXPECT_EQ(keys(fit), (Words{"name",
                                  "objective",
                                  "objective_by_time",
                                  "K_eff_error_percent",
                                  "energy_error_percent",
                                  "damping_error_percent",
                                  "integration_shift",
                                  "parameters",
                                  "counts",
                                  "status",
                                  "message",
                                  "runs",
                                  "failed_runs",
                                  "evaluations",
                                  "failed_evaluations",
                                  "refinement",
                                  "success_share",
                                  "success_reference",
                                  "optimum",
                                  "rise",
                                  "trade_offs",
                                  "intervals",
                                  "lot_objective",
                                  "worst_objective",
                                  "left_out_objective",
                                  "larger_swings_objective",
                                  "larger_swings_least",
                                  "springs_objective",
                                  "springs_given_objective",
                                  "blocks",
                                  "tests",
                                  "measured_energy_fall_percent",
                                  "energy_fall_percent"}));
      EXPECT_EQ(fit["name"], s["devices"][d]["name"]);
      expect_statistic(fit["objective"]);
      for (auto const* key : {"K_eff_error_percent", "energy_error_percent", "damping_error_percent"})
        EXPECT_TRUE(fit[key].is_number()) << key;
      EXPECT_GE(fit["integration_shift"].get<double>(), 0.0);
      EXPECT_EQ(fit["runs"], 2);
      EXPECT_EQ(fit["failed_runs"], 0);
      EXPECT_GT(fit["evaluations"], 0);
      EXPECT_EQ(fit["failed_evaluations"], 0);
      EXPECT_EQ(fit["status"], "ok");
      ASSERT_EQ(fit["parameters"].size(), expected.parameters.size());
      for (auto const& [name, unit] : expected.parameters) {
        ASSERT_TRUE(fit["parameters"].contains(name)) << name;
        auto const& parameter = fit["parameters"][std::string(name)];
        EXPECT_EQ(keys(parameter), (Words{"unit", "mean", "std", "best", "at_bound", "free", "lower", "upper",
                                          "percent_of_lot", "tied_to", "paper_name", "identifiability"}));
        EXPECT_EQ(parameter["unit"], unit);
        for (auto const* key : {"mean", "std", "best", "lower", "upper"})
          EXPECT_TRUE(parameter[key].is_number()) << name << key;
        auto const& bound = parameter["at_bound"];
        EXPECT_TRUE(bound.is_null() || bound == "lower" || bound == "upper") << bound;
        if (!parameter["free"].get<bool>()) continue;
        EXPECT_GE(parameter["best"].get<double>(), parameter["lower"].get<double>()) << name;
        EXPECT_LE(parameter["best"].get<double>(), parameter["upper"].get<double>()) << name;
      }
    }
  }
}

TEST_F(Calibrate, summary_records_the_settings_of_lot_file_and_command_line) {
  ASSERT_EQ(calibrate("O", {"--seed", "77", "--laws", "bilinear,abe", "--integration", "paper", "--set",
                            "bilinear.K2=0.4", "--samples-per-cycle", "all", "--center"})
                .code,
            0);
  auto const s = json("O/summary.json");
  EXPECT_EQ(s["seed"], 77);
  auto const& settings = s["settings"];
  EXPECT_EQ(settings["laws"], Json({"bilinear", "abe"}));
  EXPECT_EQ(settings["method"], "ga");
  EXPECT_EQ(settings["integration"], "paper");
  EXPECT_EQ(settings["runs"], 2);
  EXPECT_EQ(settings["population"], 20);
  EXPECT_EQ(settings["generations"], 5);
  EXPECT_EQ(settings["box"], "published");  // the lot file sets it
  EXPECT_EQ(settings["smooth"], 5);         // the lot file sets it
  EXPECT_EQ(settings["set"], Json::array({"bilinear.K2=0.4"}));
  EXPECT_EQ(settings["samples-per-cycle"], "all");
  EXPECT_EQ(settings["center"], true);
}

// calibrate --json prints summary.json with the profile of run.json at its end. summary.json itself has no times.
TEST_F(Calibrate, json_prints_summary_json_and_the_profile_of_run_json) {
  auto const o = calibrate("O", {"--json"});
  EXPECT_EQ(o.code, 0) << o;
  auto const summary = read("O/summary.json");
  ASSERT_TRUE(summary.ends_with("\n}\n"));
  auto const same = summary.substr(0, summary.size() - 3) + ",\n  \"profile\": [";
  EXPECT_EQ(o.out.substr(0, same.size()), same);
  auto const printed = Json::parse(o.out);
  EXPECT_EQ(printed["profile"], json("O/run.json")["profile"]);
  EXPECT_EQ(std::prev(printed.end()).key(), "profile");
}

TEST_F(Calibrate, the_profile_adds_up_to_the_total) {
  ASSERT_EQ(calibrate("O", {"--laws", "jankowski,abe", "--jobs", "2"}).code, 0);
  auto const run = json("O/run.json");
  std::vector<std::string> phases;
  std::map<std::string, double> sum;
  for (auto const& phase : run["profile"]) {
    phases.push_back(phase["phase"]);
    for (auto const* key : {"cpu_seconds", "wall_seconds", "kernel_seconds", "evaluations"})
      sum[key] += phase[key].get<double>();
  }
  EXPECT_EQ(phases,
            (Words{"read", "search", "determination", "intervals", "larger_swings", "lot", "left_out", "report"}));
  // Starting and ending threads takes time that the profile counts in no phase.
  double const wall = run["total_seconds"], cpu = run["cpu_seconds"];
  EXPECT_NEAR(sum["wall_seconds"], wall, 0.02 * wall + 2e-3);
  EXPECT_NEAR(sum["cpu_seconds"], cpu, 0.02 * cpu + 5e-3);
  EXPECT_GT(sum["kernel_seconds"], 0.0);
  double evaluations = 0.0;
  auto const summary = json("O/summary.json");
  for (auto const& law : summary["laws"])
    for (auto const& device : law["devices"]) evaluations += device["evaluations"].get<double>();
  EXPECT_EQ(run["profile"][1]["evaluations"], evaluations);
}

// calibrate and bench run the same code, so their times per evaluation and sample must agree. The factor of 5 allows
// for other records and parameter sets, other load of the machine, and batches with fewer parameter sets than lanes.
TEST_F(Calibrate, kernel_seconds_are_what_bench_measures_times_evaluations_times_samples) {
  Words const command{"calibrate",
                      "ex/study.toml",
                      "--laws",
                      "bouc-wen",
                      "--population",
                      "128",
                      "--generations",
                      "30",
                      "--runs",
                      "2",
                      "--samples-per-cycle",
                      "all",
                      "--analysis",
                      "none",
                      "--figures",
                      "none",
                      "--out",
                      "O"};
  ASSERT_EQ(isolaw(command).code, 0);
  auto const searched = json("O/run.json")["profile"][1];
  auto const bench = Json::parse(isolaw({"bench", "--json"}).out);
  auto const samples = static_cast<double>(std::ranges::count(read("ex/device-01.csv"), '\n') - 1);
  double const expected =
      1e-9 * bench["laws"]["bouc-wen"].get<double>() * searched["evaluations"].get<double>() * samples;
  EXPECT_GT(searched["kernel_seconds"].get<double>(), expected / 5.0);
  EXPECT_LT(searched["kernel_seconds"].get<double>(), expected * 5.0);
}

TEST_F(Calibrate, report_makes_the_same_outputs_from_the_store_alone_and_does_not_touch_it) {
  ASSERT_EQ(calibrate("O").code, 0);
  std::map<std::string, std::string> before;
  for (auto const* name : {"summary.json", "report.html", "tables/parameters.csv", "tables/objective.csv",
                           "tables/robustness.csv", "tables/cycles.csv"}) {
    before[name] = read(fs::path("O") / name);
    fs::remove(path(fs::path("O") / name));
  }
  auto const store = read("O/campaign.sqlite");
  fs::remove_all(path("ex"));
  auto const o = isolaw({"report", "O"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.out, fmt::format("10 devices, {} laws", published_laws().size())));
  for (auto const& [name, bytes] : before) EXPECT_EQ(read(fs::path("O") / name), bytes) << name;
  EXPECT_EQ(read("O/campaign.sqlite"), store);
  EXPECT_EQ(isolaw({"report", "O", "--json"}).out, before["summary.json"]);
  EXPECT_FALSE(exists("O/campaign.sqlite-wal"));
  EXPECT_FALSE(exists("O/campaign.sqlite-shm"));
}

TEST_F(Calibrate, number_of_threads_changes_nothing) {
  ASSERT_EQ(calibrate("one", {"--jobs", "1"}).code, 0);
  ASSERT_EQ(calibrate("two", {"--jobs", "2"}).code, 0);
  EXPECT_EQ(read("one/summary.json"), read("two/summary.json"));
  EXPECT_EQ(read("one/report.html"), read("two/report.html"));
  auto const rows = all_rows(path("one/campaign.sqlite"));
  EXPECT_EQ(rows, all_rows(path("two/campaign.sqlite")));
  EXPECT_EQ(query(path("one/campaign.sqlite"), "SELECT count(*) FROM run").at(0),
            std::to_string(20 * published_laws().size()));
}

TEST_F(Calibrate, same_command_from_another_directory_gives_the_same_summary) {
  ASSERT_EQ(calibrate("O", {"--laws", "bilinear"}).code, 0);
  auto const o =
      isolaw_in(path("ex"), Words{"calibrate", "study.toml"} + reduced + Words{"--laws", "bilinear", "--out", "../P"});
  ASSERT_EQ(o.code, 0) << o;
  EXPECT_EQ(read("P/summary.json"), read("O/summary.json"));
}

TEST_F(Calibrate, refusals_in_the_summary_do_not_depend_on_where_the_command_was_given) {
  write("ex/device-02.csv", csv_with_line(101, "0.9900,nan,12.0"));
  ASSERT_EQ(calibrate("O", {"--laws", "bilinear"}).code, 1);
  auto const o =
      isolaw_in(path("ex"), Words{"calibrate", "study.toml"} + reduced + Words{"--laws", "bilinear", "--out", "../P"});
  ASSERT_EQ(o.code, 1) << o;
  EXPECT_EQ(read("P/summary.json"), read("O/summary.json"));
}

TEST_F(Calibrate, order_of_the_devices_changes_no_devices_result) {
  auto const lot = read("ex/study.toml");
  std::vector<std::string> parts;
  std::size_t const first = lot.find("[[device]]");
  for (auto at = first; at != std::string::npos;) {
    auto const next = lot.find("[[device]]", at + 1);
    parts.push_back(lot.substr(at, next == std::string::npos ? next : next - at) + "\n");
    at = next;
  }
  ASSERT_EQ(parts.size(), 10u);
  std::string turned = lot.substr(0, first);
  for (std::size_t i = parts.size(); i-- > 0;) turned += parts[i];
  write("ex/turned.toml", turned);
  ASSERT_EQ(calibrate("O").code, 0);
  ASSERT_EQ(calibrate("P", {}, "ex/turned.toml").code, 0);

  auto const by_name = [](Json const& law) {
    std::map<std::string, Json> fits;
    for (auto fit : law["devices"]) {
      for (auto& [name, parameter] : fit["parameters"].items())
        // percent_of_lot depends on a sum over all devices, which rounds differently when their order is reversed.
        parameter.erase("percent_of_lot");
      fits[fit["name"]] = fit;
    }
    return fits;
  };
  auto const a = json("O/summary.json"), b = json("P/summary.json");
  EXPECT_EQ(b["devices"][0]["name"], "D10");
  for (std::size_t l = 0; l < a["laws"].size(); ++l) {
    EXPECT_EQ(by_name(a["laws"][l]), by_name(b["laws"][l])) << a["laws"][l]["id"];
    EXPECT_NEAR(a["laws"][l]["beta"].get<double>(), b["laws"][l]["beta"].get<double>(), 1e-12);
    EXPECT_NEAR(a["laws"][l]["objective"]["mean"].get<double>(), b["laws"][l]["objective"]["mean"].get<double>(),
                1e-12);
  }
}

TEST_F(Calibrate, a_law_alone_gives_the_same_rows_as_among_all) {
  ASSERT_EQ(calibrate("all").code, 0);
  ASSERT_EQ(calibrate("one", {"--laws", "bilinear"}).code, 0);
  for (auto const* table : {"run", "run_parameter", "search", "search_parameter"}) {
    auto const sql = fmt::format("SELECT * FROM {} WHERE law = 'bilinear' ORDER BY 1, 2, 3", table);
    auto const rows = query(path("one/campaign.sqlite"), sql);
    EXPECT_FALSE(rows.empty()) << table;
    EXPECT_EQ(rows, query(path("all/campaign.sqlite"), sql)) << table;
    EXPECT_EQ(query(path("one/campaign.sqlite"), fmt::format("SELECT DISTINCT law FROM {}", table)), Words{"bilinear"});
  }
  EXPECT_EQ(json("one/summary.json")["laws"][0], [&] {
    auto law = json("all/summary.json")["laws"][0];
    law["on_front"] = true;  // a law alone is on the front, because no other law is better
    return law;
  }());
}

TEST_F(Calibrate, more_runs_keep_the_first_ones) {
  ASSERT_EQ(calibrate("O", {"--laws", "bilinear"}).code, 0);
  ASSERT_EQ(isolaw({"calibrate", "ex/study.toml", "--runs", "3", "--population", "20", "--generations", "5", "--laws",
                    "bilinear", "--out", "P"})
                .code,
            0);
  auto const sql = "SELECT device, number, objective, history FROM run WHERE number <= 2 ORDER BY 1, 2";
  EXPECT_EQ(query(path("O/campaign.sqlite"), sql), query(path("P/campaign.sqlite"), sql));
}

TEST_F(Calibrate, another_seed_gives_other_numbers) {
  ASSERT_EQ(calibrate("O", {"--laws", "bilinear"}).code, 0);
  ASSERT_EQ(calibrate("P", {"--laws", "bilinear", "--seed", "2"}).code, 0);
  auto const a = json("O/summary.json"), b = json("P/summary.json");
  for (std::size_t d = 0; d < 10; ++d)
    EXPECT_NE(a["laws"][0]["devices"][d]["objective"]["mean"], b["laws"][0]["devices"][d]["objective"]["mean"]);
  EXPECT_EQ(a["devices"], b["devices"]);
}

TEST_F(Calibrate, tables_have_units_in_their_headers_and_every_device_and_law) {
  ASSERT_EQ(calibrate("O").code, 0);
  auto const objective = read("O/tables/objective.csv");
  EXPECT_TRUE(objective.starts_with(
      "law,device,mean OF [-],std OF [-],best OF [-],runs,failed runs,evaluations,failed evaluations,K_eff error [%],energy error [%],damping error [%]"));
  EXPECT_EQ(count_of("\n", objective), 1 + 10 * published_laws().size());
  auto const properties = read("O/tables/cycles.csv");
  EXPECT_TRUE(properties.starts_with("device,block,cycle,counts,why not,reported,strain [%],frequency [Hz]"));
  EXPECT_EQ(count_of("\n", properties), 31u);
  auto const robustness = read("O/tables/robustness.csv");
  EXPECT_EQ(count_of("\n", robustness), 1 + published_laws().size());
  EXPECT_TRUE(contains(robustness, "beta [-]"));
  auto const parameters = read("O/tables/parameters.csv");
  std::size_t rows = 1;
  for (auto const& law : published_laws()) rows += 1 + law.parameters.size();
  EXPECT_EQ(count_of("\n", parameters), rows);
  EXPECT_TRUE(contains(parameters, "D10 mean,D10 std"));
  EXPECT_EQ(parameters.find("'-"), std::string::npos) << "a unit is no spreadsheet formula";
  for (auto const& law : published_laws())
    for (auto const& [name, unit] : law.parameters)
      EXPECT_TRUE(contains(parameters, fmt::format("\n{},{},{},", law.id, name, unit))) << name;
}

TEST_F(Calibrate, store_holds_raw_and_cleaned_records_and_the_objectives_history) {
  ASSERT_EQ(calibrate("O", {"--laws", "bilinear"}).code, 0);
  auto const store = path("O/campaign.sqlite");
  EXPECT_EQ(query(store, "SELECT kind, channel, count FROM series WHERE device = 0 ORDER BY kind, channel"),
            (Words{"fit|disp_mm|601", "fit|force_kN|601", "fit|time_s|601", "fit|vel_mm_s|601", "raw|disp_mm|601",
                   "raw|force_kN|601", "raw|load_kN|601", "raw|time_s|601"}));
  EXPECT_EQ(query(store, "SELECT DISTINCT length(history) / 8, evaluations FROM run"), Words{"5|100"});
  EXPECT_EQ(query(store, "SELECT value FROM meta WHERE key = 'schema'"), Words{"12"});
  EXPECT_EQ(query(store, "PRAGMA journal_mode"), Words{"delete"});
}

TEST_F(Calibrate, without_out_writes_below_out) {
  ASSERT_EQ(isolaw(Words{"calibrate", "ex/study.toml", "--laws", "bilinear"} + reduced).code, 0);
  EXPECT_TRUE(exists("out/ex/summary.json"));
  write("one.csv", csv(record()));
  ASSERT_EQ(isolaw(Words{"calibrate", "one.csv", "--laws", "bilinear"} + reduced).code, 0);
  EXPECT_TRUE(exists("out/one/summary.json"));
}

TEST_F(Calibrate, one_device_has_no_robustness_and_says_so) {
  write("one.csv", csv(record()));
  auto const o = isolaw(Words{"calibrate", "one.csv", "--out", "O", "--laws", "bilinear,bouc-wen"} + reduced);
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(isolaw({"report", "O", "--details", "--figures", "none"}).out, "one device"));
  auto const summary = json("O/summary.json");
  for (auto const& law : summary["laws"]) {
    EXPECT_TRUE(law["beta"].is_null());
    EXPECT_TRUE(contains(law["beta_note"].get<std::string>(), "one device"));
    EXPECT_EQ(law["on_front"], false);
  }
}

TEST_F(Calibrate, bilinear_device_is_identified_by_the_bilinear_law) {
  // The record's device has K2 0.5 kN/mm, Qd 20 kN and xy 10 mm, so K1 = 0.5 + 20 / 10 = 2.5 kN/mm. The bilinear law
  // with these values fits the record exactly. The tolerances allow for a search that ends near them.
  write("one.csv", csv(record()));
  auto const o = isolaw({"calibrate", "one.csv", "--laws", "bilinear", "--runs", "2", "--population", "100",
                         "--generations", "50", "--out", "O"});
  EXPECT_EQ(o.code, 0) << o;
  auto const fit = json("O/summary.json")["laws"][0]["devices"][0];
  EXPECT_LT(fit["objective"]["best"].get<double>(), 0.05) << fit;
  EXPECT_NEAR(fit["parameters"]["K2"]["best"].get<double>(), 0.5, 0.05) << fit;
  EXPECT_LT(std::abs(fit["energy_error_percent"].get<double>()), 10.0);
}

}  // namespace
}  // namespace isolaw::cli_test
