// Runs campaigns with analyses. Tests what the terminal and the files then say, and what the user can do next.
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

// Returns the record of a bilinear device: three cycles at 50 mm and three at 100 mm, 60 samples a cycle. The force has
// a small third harmonic, so the bilinear law does not fit it exactly. `stiffness` multiplies the whole force.
std::string two_blocks(double stiffness) {
  std::string text = "time [s],disp [mm],force [kN]\n";
  double hysteretic = 0.0, before = 0.0;
  for (int i = 0; i <= 360; ++i) {
    double const amplitude = i <= 180 ? 50.0 : 100.0, phase = 2.0 * std::numbers::pi * i / 60.0;
    double const x = amplitude * std::sin(phase);
    hysteretic = std::clamp(hysteretic + 2.0 * (x - before), -20.0, 20.0);
    before = x;
    text += fmt::format("{:.4f},{:.5f},{:.5f}\n", i / 30.0, x,
                        stiffness * (0.4 * x + hysteretic + 1.0 * std::sin(3.0 * phase)));
  }
  return text;
}

class Analysis : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    double stiffness = 1.0;
    for (auto const* name : {"a.csv", "b.csv", "c.csv"}) {
      write(name, two_blocks(stiffness));
      stiffness += 0.05;
    }
  }
  Words campaign(std::string const& out, Words const& more = {}) const {
    return Words{"calibrate", "a.csv",      "b.csv", "c.csv",        "--laws", "bilinear,vaiana", "--runs",
                 "2",         "--analysis", "full",  "--replicates", "40",     "--out",           out} +
           more;
  }
};

TEST_F(Analysis, tells_what_tests_determine_and_what_an_engineer_meets) {
  auto const o = isolaw(campaign("O", {"--details"}));
  ASSERT_EQ(o.code, 0) << o;
  for (auto const* part : {"Without the optimiser's noise", "On a device that was not tested",
                           "Share of the parameters that the tests fix"})
    EXPECT_TRUE(contains(unwrapped(o.out), part)) << part;
  auto const summary = json("O/summary.json");
  EXPECT_EQ(summary["missing_analyses"], 0);
  for (auto const& law : summary["laws"]) {
    SCOPED_TRACE(law["id"].get<std::string>());
    EXPECT_EQ(law["success_share"], 1.0);
    EXPECT_EQ(law["success_reference"], "best of this campaign");
    EXPECT_GT(law["beta_converged"], 0.0);
    // The forces of the devices differ by 5 and 10 %. A law that was fitted to the other devices therefore fits a
    // device worse than that device's own law does. The error of one law for all devices lies between the errors of
    // these two.
    EXPECT_GT(law["loo_objective"], law["objective_converged"]);
    EXPECT_GT(law["lot"]["mean_objective"], law["objective_converged"]);
    EXPECT_GE(law["loo_objective"], law["lot"]["mean_objective"]);
    EXPECT_LE(law["lot"]["least_worst_objective"], law["lot"]["worst_objective"]);
    EXPECT_GE(law["lot"]["least_worst_objective"], law["lot"]["least_worst_bound"]);
    for (auto const& fit : law["devices"])
      for (auto const& [name, p] : fit["parameters"].items()) {
        if (!p["free"]) {
          EXPECT_TRUE(p["identifiability"].is_null()) << name;
          continue;
        }
        EXPECT_LE(p["open_range"][0], p["optimum"]) << name;
        EXPECT_GE(p["open_range"][1], p["optimum"]) << name;
        EXPECT_LE(p["linear_interval"][0], p["linear_interval"][1]) << name;
        EXPECT_LE(p["bootstrap_interval"][0], p["bootstrap_interval"][1]) << name;
        EXPECT_EQ(p["profile"]["value"].size(), p["profile"]["objective"].size()) << name;
      }
  }
  auto const& k2 = summary["laws"][0]["devices"][0]["parameters"]["K2"];
  EXPECT_EQ(k2["identifiability"], "determined");
  EXPECT_NEAR(k2["optimum"], 0.4, 0.02);
  for (auto const* table : {"converged", "identifiability", "lot_law", "prediction"})
    EXPECT_GT(count_of("\n", read(fmt::format("O/tables/{}.csv", table))), 1u) << table;
  auto const checked = isolaw({"check", "O"});
  EXPECT_EQ(checked.code, 0) << checked;
  EXPECT_TRUE(contains(checked.out, "12 of 12 runs, 14 of 14 analyses"));
}

TEST_F(Analysis, number_of_threads_changes_nothing) {
  ASSERT_EQ(isolaw(campaign("O", {"--jobs", "1"})).code, 0);
  ASSERT_EQ(isolaw(campaign("P", {"--jobs", "3"})).code, 0);
  EXPECT_EQ(read("O/summary.json"), read("P/summary.json"));
  EXPECT_EQ(all_rows(path("O/campaign.sqlite")), all_rows(path("P/campaign.sqlite")));
}

TEST_F(Analysis, interrupted_ones_continue_and_end_as_if_never_stopped) {
  auto const analyses = [&] { return stored_rows(path("O/campaign.sqlite"), "device_analysis"); };
  auto process = start(campaign("O", {"--jobs", "1"}));
  Outcome result;
  auto const end = std::chrono::steady_clock::now() + 60s;
  bool ended = false;
  while (!(ended = process.ended(result)) && analyses() < 2 && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(1ms);
  if (!ended) {
    process.send(SIGINT);
    result = process.wait();
    EXPECT_EQ(result.code, 1) << result;
  }
  int const kept = analyses();
  EXPECT_GE(kept, 2);
  auto const continued = isolaw(campaign("O"));
  EXPECT_EQ(continued.code, 0) << continued;
  ASSERT_EQ(isolaw(campaign("P")).code, 0);
  EXPECT_EQ(read("O/summary.json"), read("P/summary.json"));
  EXPECT_EQ(all_rows(path("O/campaign.sqlite")), all_rows(path("P/campaign.sqlite")));
}

TEST_F(Analysis, is_added_to_a_campaign_that_was_made_without) {
  auto words = campaign("O");
  *std::ranges::find(words, "full") = "none";
  auto const without = isolaw(words);
  ASSERT_EQ(without.code, 0) << without;
  EXPECT_EQ(without.out.find("Without the optimiser's noise"), std::string::npos);
  auto const with = isolaw(campaign("O"));
  EXPECT_EQ(with.code, 0) << with;
  ASSERT_EQ(isolaw(campaign("P")).code, 0);
  EXPECT_EQ(read("O/summary.json"), read("P/summary.json"));
  EXPECT_EQ(isolaw({"check", "O"}).code, 0);
}

TEST_F(Analysis, changed_ones_are_found_by_check) {
  ASSERT_EQ(isolaw(campaign("O")).code, 0);
  auto const sound = read("O/campaign.sqlite");
  for (auto const* sql :
       {"UPDATE device_analysis SET json = replace(json, '\"objective\":0.', '\"objective\":0.9') WHERE device = 0",
        "UPDATE lot_analysis SET json = replace(json, '\"objectives\":[0.', '\"objectives\":[0.9')",
        "UPDATE left_out SET json = replace(json, '\"objective\":0.', '\"objective\":0.9')",
        "DELETE FROM left_out WHERE device = 1", "UPDATE device_analysis SET json = '{}'",
        "UPDATE device_analysis SET json = replace(json, '\"parameter\":0', '\"parameter\":99')"}) {
    SCOPED_TRACE(sql);
    write("O/campaign.sqlite", sound);
    sqlite3* db = nullptr;
    ASSERT_EQ(sqlite3_open(path("O/campaign.sqlite").c_str(), &db), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(db, sql, nullptr, nullptr, nullptr), SQLITE_OK);
    EXPECT_GT(sqlite3_changes(db), 0);
    sqlite3_close(db);
    EXPECT_NE(isolaw({"check", "O"}).code, 0);
  }
}

TEST_F(Analysis, what_one_block_was_fitted_to_predicts_the_other) {
  auto const o = isolaw(campaign("O", {"--fit-blocks", "1"}));
  ASSERT_EQ(o.code, 0) << o;
  auto const summary = json("O/summary.json");
  for (auto const& law : summary["laws"]) {
    auto const& blocks = law["devices"][0]["blocks"];
    ASSERT_EQ(blocks.size(), 2u);
    EXPECT_EQ(blocks[0]["fitted"], true);
    EXPECT_EQ(blocks[1]["fitted"], false);
  }
  // The record is that of a bilinear device, apart from a small third harmonic. The bilinear law therefore also
  // predicts the block that was left out of the fit.
  EXPECT_LT(summary["laws"][0]["predicted_objective"], 0.1);
  EXPECT_EQ(summary["laws"][0]["prediction_collapses"], false);
  EXPECT_TRUE(contains(read("O/tables/prediction.csv"), "bilinear,a,\"block 2, predicted\",the device itself,"));
  // Every export states how well the law predicted the block that was left out of the fit.
  for (auto const* target : {"opensees", "cpp", "opensees-cpp", "abaqus", "sheet", "csv"}) {
    auto const text = isolaw({"export", "O", "--law", "bilinear", "--device", "a", "--to", target}).out;
    for (auto const* part : {"block 1 of the tests alone", "Displacement fitted", "up to 50 mm", "Displacement tested",
                             "up to 100 mm", "good: objective 0.0"})
      EXPECT_TRUE(contains(text, part)) << target << ": " << part;
  }
  auto const form = Json::parse(isolaw({"export", "O", "--law", "bilinear", "--device", "a", "--to", "json"}).out);
  EXPECT_EQ(form["fitted"]["part"], "block 1");
  EXPECT_EQ(form["fitted"]["disp_mm"], 50.0);
  EXPECT_EQ(form["tested"]["disp_mm"], 100.0);
  // `fitted` describes the samples that the law was fitted to, `tested` all samples. simulate compares a motion with
  // both.
  auto const speed = [](double amplitude_mm) { return amplitude_mm * std::numbers::pi; };
  EXPECT_NEAR(form["fitted"]["velocity_mm_s"].get<double>(), speed(50.0), 0.05 * speed(50.0));
  EXPECT_NEAR(form["tested"]["velocity_mm_s"].get<double>(), speed(100.0), 0.05 * speed(100.0));
  auto const simulated = isolaw({"simulate", "bilinear", "--from", "O", "--device", "a", "--motion", "a.csv"});
  for (auto const& text : {simulated.err, simulated.out}) {
    EXPECT_TRUE(contains(text, "device 'a', block 1 of the tests alone, up to 50 mm; tested up to 100 mm")) << text;
    EXPECT_TRUE(contains(text, "prediction is good: objective 0.0")) << text;
  }
  EXPECT_TRUE(contains(simulated.err, "what the law was fitted to"));
  EXPECT_FALSE(contains(simulated.err, "nothing was measured"));
  write("far.csv", "displacement [mm],x\n0,0\n150,0\n0,0\n");
  auto const far = isolaw({"simulate", "bilinear", "--from", "O", "--device", "a", "--motion", "far.csv"});
  for (auto const* part : {"150 mm, what the law was fitted to 50 mm", "150 mm, the test 100 mm: beyond it nothing"})
    EXPECT_TRUE(contains(far.err, part)) << far.err;
  expect_refused(isolaw(campaign("P", {"--score-blocks", "2"})), {"--score-blocks", "together with --fit-blocks"});
  expect_message(isolaw(campaign("Q", {"--fit-blocks", "1", "--score-blocks", "7"})), 2,
                 {"no block of the record is among them", "block 2: cycles 1 to 3"});
}

// hwang-wu fits the block at 50 mm but fails at 100 mm. Exports refuse such a law unless the user adds --anyway.
TEST_F(Analysis, a_law_that_cannot_predict_is_refused_unless_asked_for_anyway) {
  auto const o = isolaw({"calibrate", "a.csv", "--laws", "bilinear,hwang-wu", "--runs", "1", "--analysis", "none",
                         "--fit-blocks", "1", "--out", "O"});
  ASSERT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.out, "Hwang-Wu"));
  EXPECT_TRUE(contains(o.out, "ruled out"));
  EXPECT_TRUE(contains(isolaw({"report", "O", "--details", "--figures", "none"}).out, "unusable"));
  auto const laws = json("O/summary.json")["laws"];
  EXPECT_EQ(laws[0]["prediction_grade"], "good");
  EXPECT_EQ(laws[1]["prediction_grade"], "unusable");
  EXPECT_EQ(laws[1]["prediction_collapses"], true);
  std::vector<Words> commands;
  for (auto const* target : {"opensees", "openseespy", "cpp", "sheet", "csv", "json", "opensees-cpp", "abaqus"})
    commands.push_back({"export", "O", "--law", "hwang-wu", "--device", "a", "--to", target});
  commands.push_back({"simulate", "hwang-wu", "--from", "O", "--device", "a", "--motion", "a.csv"});
  for (auto const& command : commands) {
    SCOPED_TRACE(command.back());
    expect_refused(isolaw(command), {"law hwang-wu, device 'a'", "its prediction is unusable: objective ", "--anyway"});
    auto const anyway = isolaw(command + Words{"--anyway"});
    EXPECT_EQ(anyway.code, 0) << anyway;
    EXPECT_TRUE(contains(anyway.err, "taken because of --anyway, although its prediction is unusable: objective "))
        << anyway.err;
    EXPECT_TRUE(contains(anyway.out, "its prediction is unusable: ")) << anyway.out;
  }
  // OpenSees has no hwang-wu, so the export fits the nearest material, which is also far off at 100 mm.
  auto const script = isolaw(commands[0] + Words{"--anyway"});
  EXPECT_TRUE(contains(script.err, "taken because of --anyway, although uniaxialMaterial BoucWen"));
  EXPECT_TRUE(contains(script.err, ", the closest material of the program, is far off the law: largest "));
  EXPECT_TRUE(contains(script.out, "# Far off: "));
  EXPECT_TRUE(contains(isolaw(commands[3] + Words{"--anyway"}).out, "FAR OFF, "));
  auto const form = Json::parse(isolaw(commands[5] + Words{"--anyway"}).out);
  EXPECT_EQ(form["forms"][0]["far_off"], true);
  EXPECT_TRUE(form["objection"].get<std::string>().starts_with("its prediction is unusable"));
}

// Exports state what the campaign lacks and what is doubtful in the result; here K1 ends at a bound of its box.
TEST_F(Analysis, exports_say_what_is_known_against_the_law) {
  auto const o = isolaw({"calibrate", "a.csv", "--laws", "bilinear", "--runs", "2", "--analysis", "full",
                         "--replicates", "0", "--set", "bilinear.K1=0.1:1", "--out", "O"});
  ASSERT_EQ(o.code, 0) << o;
  for (auto const* target : {"opensees", "openseespy", "cpp", "opensees-cpp", "abaqus", "sheet", "csv", "json"}) {
    auto const exported = isolaw({"export", "O", "--law", "bilinear", "--device", "a", "--to", target});
    EXPECT_EQ(exported.code, 0) << exported;
    EXPECT_TRUE(contains(exported.out, "Bilinear: K1 at its upper bound on a")) << target;
    EXPECT_TRUE(contains(exported.err, "warning: Bilinear: K1 at its upper bound on a")) << target;
  }
  auto const simulated = isolaw({"simulate", "bilinear", "--from", "O", "--device", "a", "--motion", "a.csv"});
  EXPECT_TRUE(contains(simulated.err, "warning: Bilinear: K1 at its upper bound on a"));
  EXPECT_TRUE(contains(simulated.out, "# warning: Bilinear: K1 at its upper bound on a"));
}

// The genetic algorithm of Cucuzza et al. 2025 stops above the smallest possible objective. The analysis searches on
// and must find an objective that is smaller than the mean of the runs and not above the best run.
TEST_F(Analysis, of_the_genetic_algorithm_compares_with_the_least_objective) {
  auto const o = isolaw(campaign("O", {"--method", "ga", "--population", "10", "--generations", "5"}));
  ASSERT_EQ(o.code, 0) << o;
  auto const summary = json("O/summary.json");
  for (auto const& law : summary["laws"]) {
    EXPECT_LT(law["success_share"], 1.0);
    EXPECT_LT(law["objective_converged"], law["objective"]["mean"]);
    EXPECT_LE(law["devices"][0]["optimum"], law["devices"][0]["objective"]["best"]);
  }
}

TEST_F(Analysis, devices_are_drawn_from_the_lots_population) {
  ASSERT_EQ(isolaw(campaign("O")).code, 0);
  auto const few = isolaw({"sample", "O", "--law", "bilinear", "--count", "5"}),
             many = isolaw({"sample", "O", "--law", "bilinear", "--count", "400"});
  ASSERT_EQ(few.code, 0) << few;
  EXPECT_TRUE(contains(few.out, "device,K1 [kN/mm],K2 [kN/mm],xy [mm]\n1,"));
  EXPECT_EQ(count_of("\n", few.out), 6u);
  EXPECT_TRUE(many.out.starts_with(few.out)) << "a draw depends on its number alone";
  EXPECT_TRUE(contains(few.err, "5 devices drawn from a population that was estimated from 3 tested devices"));
  // Every device multiplies both stiffnesses by one factor, so their ratio is the same in all devices. The drawn
  // devices must keep this ratio.
  std::istringstream rows(many.out);
  std::string row;
  std::getline(rows, row);
  double least = 1e9, most = 0.0;
  while (std::getline(rows, row)) {
    double number = 0.0, k1 = 0.0, k2 = 0.0;
    char comma = 0;
    std::istringstream(row) >> number >> comma >> k1 >> comma >> k2;
    least = std::min(least, k1 / k2);
    most = std::max(most, k1 / k2);
  }
  EXPECT_LT(most / least, 1.03);
  EXPECT_NE(isolaw({"sample", "O", "--law", "bilinear", "--seed", "7"}).out,
            isolaw({"sample", "O", "--law", "bilinear"}).out);
  expect_refused(isolaw({"sample", "O", "--law", "abe"}), {"law abe", "not in this campaign"});
  expect_refused(isolaw({"sample", "O", "--law", "bilinear", "--count", "0"}), {"--count", "1 to 10000000"});
}

// If vaiana's beta1 is zero, beta2 has no effect and the search leaves it anywhere in its box. The population of a lot
// must not count this as scatter between devices.
TEST_F(Analysis, of_a_parameter_that_does_not_act_gives_it_no_scatter) {
  ASSERT_EQ(isolaw({"example", "ex"}).code, 0);
  auto const o = isolaw({"calibrate", "ex/study.toml", "--laws", "vaiana", "--runs", "1", "--analysis", "full",
                         "--replicates", "0", "--out", "O"});
  ASSERT_EQ(o.code, 0) << o;
  auto const law = json("O/summary.json")["laws"][0];
  auto const& population = law["population"];
  int without_effect = 0, with_scatter = 0;
  for (std::size_t n = 0; n < population["parameters"].size(); ++n) {
    auto const name = population["parameters"][n].get<std::string>();
    bool undetermined = true;
    for (auto const& device : law["devices"]) {
      auto const& identified = device["parameters"][name]["identifiability"];
      undetermined = undetermined && (identified.is_object() ? identified["verdict"] : identified) == "undetermined";
    }
    double const std = std::sqrt(population["covariance"][n][n].get<double>());
    without_effect += undetermined ? 1 : 0;
    with_scatter += std > 1e-3 ? 1 : 0;
    if (undetermined) {
      EXPECT_LT(std, 1e-9) << name;
    }
  }
  EXPECT_GE(without_effect, 2);
  EXPECT_GE(with_scatter, 4);
}

// The record of the fitted block was computed with the bilinear law itself, so its objective consists only of rounding
// errors. `isolaw check` and the grade of the prediction must not take a multiple of these rounding errors for an error
// of the law.
TEST_F(Analysis, of_a_record_that_a_law_made_itself) {
  std::string text = "time [s],disp [mm],force [kN]\n";
  double hysteretic = 0.0, before = 0.0;
  for (int i = 0; i <= 360; ++i) {
    double const x = (i <= 180 ? 50.0 : 100.0) * std::sin(2.0 * std::numbers::pi * i / 60.0);
    hysteretic = std::clamp(hysteretic + 2.0 * (x - before), -20.0, 20.0);
    before = x;
    text +=
        fmt::format("{:.4f},{:.17g},{:.17g}\n", i / 30.0, x, 0.4 * x + hysteretic + (i > 180 ? 0.05 * (i % 2) : 0.0));
  }
  write("own.csv", text);
  auto const o = isolaw({"calibrate", "own.csv", "--laws", "bilinear", "--analysis", "full", "--replicates", "0",
                         "--fit-blocks", "1", "--out", "O"});
  ASSERT_EQ(o.code, 0) << o;
  EXPECT_EQ(isolaw({"check", "O"}).code, 0);
  auto const law = json("O/summary.json")["laws"][0];
  EXPECT_LT(law["fitted_objective"], 1e-6);
  EXPECT_GT(law["predicted_objective"], 100.0 * law["fitted_objective"].get<double>());
  EXPECT_EQ(law["prediction_collapses"], false);
  expect_refused(isolaw({"calibrate", "own.csv", "--replicates", "10", "--out", "P"}),
                 {"--replicates", "40 to 100000"});
}

// The test deletes some analyses from the store. The report must then put no law on the front of accuracy and
// robustness, because laws are compared only if their analyses cover the same devices. The same campaign must compute
// the deleted analyses again.
TEST_F(Analysis, what_is_not_complete_gives_no_front) {
  ASSERT_EQ(isolaw(campaign("O")).code, 0);
  sqlite3* db = nullptr;
  ASSERT_EQ(sqlite3_open(path("O/campaign.sqlite").c_str(), &db), SQLITE_OK);
  EXPECT_EQ(
      sqlite3_exec(
          db,
          "DELETE FROM device_analysis WHERE law = 'vaiana' AND device > 0; DELETE FROM lot_analysis; DELETE FROM left_out",
          nullptr, nullptr, nullptr),
      SQLITE_OK);
  sqlite3_close(db);
  auto const o = isolaw({"report", "O"});
  expect_message(o, 1, {"not complete: 10 analyses are missing"});
  EXPECT_EQ(o.out.find("Without the optimiser's noise"), std::string::npos);
  for (auto const& law : json("O/summary.json")["laws"]) EXPECT_EQ(law["on_front_converged"], false);
  EXPECT_EQ(isolaw(campaign("O")).code, 0);
  ASSERT_EQ(isolaw(campaign("P")).code, 0);
  EXPECT_EQ(read("O/summary.json"), read("P/summary.json"));
}

TEST_F(Analysis, tied_parameters_share_a_value) {
  auto const o = isolaw(campaign("O", {"--set", "vaiana.Kb-=Kb+"}));
  ASSERT_EQ(o.code, 0) << o;
  auto const parameters = json("O/summary.json")["laws"][1]["devices"][0]["parameters"];
  EXPECT_EQ(parameters["Kb-"]["tied_to"], "Kb+");
  EXPECT_EQ(parameters["Kb-"]["best"], parameters["Kb+"]["best"]);
  EXPECT_EQ(parameters["Kb-"]["free"], false);
  EXPECT_EQ(isolaw({"check", "O"}).code, 0);
  expect_refused(isolaw(campaign("P", {"--set", "vaiana.Kb-=Kb-"})), {"Kb- is tied to itself", "another parameter"});
  expect_refused(isolaw(campaign("P", {"--set", "vaiana.Kb-=f0+"})), {"Kb- is in N/m, f0+ in N"});
  expect_refused(isolaw(campaign("P", {"--set", "vaiana.Kb-=Kb+", "--set", "vaiana.Kb+=Kb-"})), {"is tied to"});
}

}  // namespace
}  // namespace isolaw::cli_test
