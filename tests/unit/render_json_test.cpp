// Tests summary.json: its exact layout, which values are null, and that every input gives valid JSON.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "isolaw/base/json.hpp"
#include "isolaw/render/json/summary_json.hpp"
#include "unit/study_fixture.hpp"

namespace isolaw::render {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys(Json const& object) {
  std::vector<std::string> names;
  for (auto const& [name, value] : object.items()) names.push_back(name);
  return names;
}

TEST(SummaryJson, ExactText) {
  Summary summary;
  summary.version = "1.2.4";
  summary.makers = {{"1.2.3", "0123456789ab", ""}, {"1.2.2", "", ""}};
  summary.title = "Lot";
  summary.runs = 1;
  summary.expected_runs = 4;
  summary.seed = 18446744073709551615u;
  summary.settings = {{"runs", "2"}, {"laws", "[\"a\"]"}};
  summary.devices.push_back({});
  summary.devices.back().name = "D\"1";
  summary.devices.back().file = "d1.csv";
  summary.devices.back().sha256 = "00ff";
  summary.devices.back().status = "ok";
  LawResult law;
  law.id = "line";
  law.title = "Line";
  law.objective = {0.1, std::nullopt, 0.1};
  law.beta_note = "one device";
  DeviceFit fit;
  fit.device = "D\"1";
  fit.runs = 1;
  fit.objective = {0.1, std::nullopt, 0.1};
  fit.K_eff_error_percent = -1.5;
  fit.energy_error_percent = std::numeric_limits<double>::infinity();
  ParameterFit slope;
  slope.name = "k";
  slope.unit = "kN/mm";
  slope.lower = 0.0;
  slope.upper = 2.0;
  slope.value = {2.0, std::nullopt, 2.0};
  slope.at_bound = fit::AtBound::upper;
  fit.parameters.push_back(slope);
  law.devices.push_back(fit);
  summary.laws.push_back(law);

  // Compares the exact layout of everything before the warnings. The sentences of the warnings and of what follows them
  // are worded in wording/rows.cpp alone.
  auto const text = summary_json(summary);
  auto const numbers = text.substr(0, text.find("  \"warnings\": [\n"));
  EXPECT_EQ(numbers, R"({
  "schema": 2,
  "isolaw": [
    {
      "version": "1.2.3",
      "build": "0123456789ab"
    },
    {
      "version": "1.2.2",
      "build": null
    }
  ],
  "seed": 18446744073709551615,
  "settings": {
    "runs": 2,
    "laws": [
      "a"
    ]
  },
  "devices": [
    {
      "name": "D\"1",
      "file": "d1.csv",
      "sha256": "00ff",
      "status": "ok",
      "message": "",
      "dead_band_mm": 0,
      "tests": []
    }
  ],
  "laws": [
    {
      "id": "line",
      "objective": {
        "mean": 0.1,
        "std": null,
        "best": 0.1
      },
      "beta": null,
      "on_front": false,
      "devices": [
        {
          "name": "D\"1",
          "objective": {
            "mean": 0.1,
            "std": null,
            "best": 0.1
          },
          "objective_by_time": null,
          "K_eff_error_percent": -1.5,
          "energy_error_percent": null,
          "damping_error_percent": null,
          "integration_shift": null,
          "parameters": {
            "k": {
              "unit": "kN/mm",
              "mean": 2,
              "std": null,
              "best": 2,
              "at_bound": "upper",
              "free": true,
              "lower": 0,
              "upper": 2,
              "percent_of_lot": null,
              "tied_to": null,
              "paper_name": null,
              "identifiability": null
            }
          },
          "counts": true,
          "status": "ok",
          "message": "",
          "runs": 1,
          "failed_runs": 0,
          "evaluations": 0,
          "failed_evaluations": 0,
          "refinement": 1,
          "success_share": null,
          "success_reference": "",
          "optimum": null,
          "rise": null,
          "trade_offs": [],
          "intervals": {
            "level": null,
            "samples": 0,
            "block": 0,
            "replicates": 0
          },
          "lot_objective": null,
          "worst_objective": null,
          "left_out_objective": null,
          "larger_swings_objective": null,
          "larger_swings_least": null,
          "springs_objective": null,
          "springs_given_objective": null,
          "blocks": [],
          "tests": [],
          "measured_energy_fall_percent": null,
          "energy_fall_percent": null
        }
      ],
      "beta_note": "one device",
      "name": "line",
      "title": "Line",
      "notes": [],
      "success_share": null,
      "success_reference": "",
      "objective_converged": null,
      "beta_converged": null,
      "beta_converged_note": "",
      "left_out_of_beta": [],
      "reduced": false,
      "on_front_converged": false,
      "loo_objective": null,
      "loo_worst": null,
      "loo_worst_device": "",
      "on_front_loo": false,
      "larger_swings_objective": null,
      "larger_swings_least": null,
      "larger_swings_worst": null,
      "tested_mm": null,
      "asked_mm": null,
      "K_at_asked_kN_per_mm": null,
      "energy_at_asked_kN_mm": null,
      "stiffness_ratio": null,
      "damping_ratio": null,
      "lot": null,
      "population": null,
      "fitted_objective": null,
      "predicted_objective": null,
      "worst_predicted": null,
      "prediction_collapses": false,
      "prediction_grade": null,
      "reduced_form": ""
    }
  ],
  "title": "Lot",
  "outliers": [],
  "complete": false,
  "missing_runs": 3,
  "missing_analyses": 0,
)");
  EXPECT_TRUE(text.ends_with("  },\n  \"published\": null\n}\n"));
  auto const said = Json::parse(text);
  ASSERT_EQ(said["warnings"].size(), 2u);
  EXPECT_EQ(keys(said["warnings"][1]),
            (std::vector<std::string>{"kind", "topic", "severity", "sentence", "certificate", "action", "law",
                                      "other_laws", "devices", "parameters", "blocks", "each"}));
  EXPECT_EQ(said["warnings"][0]["kind"], "runs-missing");
  EXPECT_EQ(said["warnings"][0]["each"][0]["numbers"], (Json{{"runs", 1}, {"expected_runs", 4}}));
  EXPECT_EQ(said["warnings"][1]["kind"], "at-bound");
  EXPECT_EQ(said["warnings"][1]["devices"], Json::array({"D\"1"}));
  EXPECT_EQ(keys(said["recommendation"]),
            (std::vector<std::string>{"law", "headline", "explanation", "answer", "sure", "reasons", "weak", "surer",
                                      "reach", "valid_mm", "programs", "export_command", "spread", "standings"}));
  EXPECT_EQ(keys(said["recommendation"]["standings"][0]),
            (std::vector<std::string>{"law", "place", "error", "fits", "new_device", "predicts", "parameters", "reason",
                                      "reason_kind", "weak"}));
}

TEST(SummaryJson, TellsHowManyRunsWereMissing) {
  auto summary = fixture::lot();
  EXPECT_EQ(missing_runs_in(summary_json(summary)), 0u);
  summary.runs = 25;
  summary.expected_runs = 7000;
  EXPECT_EQ(missing_runs_in(summary_json(summary)), 6975u);
  for (auto const* text : {"", "{", "[]", "{}", "{\"missing_runs\": -1}", "{\"missing_runs\": \"3\"}"})
    EXPECT_FALSE(missing_runs_in(text)) << text;
}

TEST(SummaryJson, KeysInTheAgreedOrder) {
  auto const json = Json::parse(summary_json(fixture::lot()));
  EXPECT_EQ(keys(json), (std::vector<std::string>{"schema", "isolaw", "seed", "settings", "devices", "laws", "title",
                                                  "outliers", "complete", "missing_runs", "missing_analyses",
                                                  "warnings", "recommendation", "published"}));
  EXPECT_EQ(keys(json["laws"][1]["devices"][2]["parameters"]),
            (std::vector<std::string>{"kb+", "f0+", "alpha+", "beta1-", "beta2+"}));
}

TEST(SummaryJson, NumbersReadBackAsTheSameDoubles) {
  auto summary = fixture::lot();
  summary.laws[0].objective.mean = 0.1 + 0.2;
  summary.laws[0].beta = 1e-300;
  auto const json = Json::parse(summary_json(summary));
  EXPECT_EQ(json["laws"][0]["objective"]["mean"].get<double>(), 0.1 + 0.2);
  EXPECT_EQ(json["laws"][0]["beta"].get<double>(), 1e-300);
}

TEST(SummaryJson, RefusedDeviceKeepsItsNameAndReason) {
  auto const json = Json::parse(summary_json(fixture::lot()));
  EXPECT_EQ(json["devices"][3]["name"], fixture::nasty_name);
  EXPECT_EQ(json["devices"][3]["status"], "refused");
  EXPECT_EQ(json["devices"][3]["message"], "line 7: not a number: \"<script>alert(2)</script>\"");
}

TEST(SummaryJson, LawThatDoesNotApplyIsRefusedAndOneThatFailedIsFailed) {
  auto summary = fixture::lot();
  DeviceFit refused, failed;
  refused.device = "D1";
  refused.refusal = "no time channel";
  failed.device = "D2";
  failed.runs = failed.failed_runs = 20;
  failed.failure = "infinite force";
  summary.laws[0].devices = {refused, failed};
  auto const json = Json::parse(summary_json(summary));
  auto const& devices = json["laws"][0]["devices"];
  EXPECT_EQ(devices[0]["status"], "refused");
  EXPECT_EQ(devices[0]["message"], "no time channel");
  EXPECT_TRUE(devices[0]["objective"]["mean"].is_null());
  EXPECT_EQ(devices[1]["status"], "failed");
  EXPECT_EQ(devices[1]["message"], "infinite force");
  EXPECT_EQ(devices[1]["failed_runs"], 20);
}

TEST(SummaryJson, EqualSummariesGiveEqualBytes) {
  EXPECT_EQ(summary_json(fixture::lot()), summary_json(fixture::lot()));
}

TEST(JsonWriter, InvalidUtf8IsReplaced) {
  EXPECT_EQ(JsonWriter().value("caf\xe9 \xff").take(), "\"caf\xef\xbf\xbd \xef\xbf\xbd\"");
}

TEST(JsonWriter, CurvesStandOnOneLine) {
  JsonWriter out(JsonWriter::Layout::indented);
  out.begin_object();
  out.key("x").line({1.0, 2.34567, std::nan("")}, 3).key("none").line({}, 3).member("after", 1).end_object();
  EXPECT_EQ(out.take(), "{\n  \"x\": [1,2.35,null],\n  \"none\": [],\n  \"after\": 1\n}");
}

TEST(JsonWriter, SettingThatIsNotJsonIsKeptAsText) {
  EXPECT_EQ(JsonWriter().json("converged").take(), "\"converged\"");
  EXPECT_EQ(JsonWriter().json("{\"b\":1,\"a\":[]}").take(), "{\"b\":1,\"a\":[]}");
}

TEST(JsonWriter, RoundedNumbers) {
  EXPECT_EQ(JsonWriter().rounded(0.123456789, 3).take(), "0.123");
  EXPECT_EQ(JsonWriter().rounded(std::nullopt, 3).take(), "null");
  EXPECT_EQ(JsonWriter().rounded(std::numeric_limits<double>::quiet_NaN(), 3).take(), "null");
  EXPECT_EQ(JsonWriter().rounded(-0.0, 3).take(), "0");
}

TEST(ScriptSafe, ClosesNothingAndParsesTheSame) {
  std::string const text = JsonWriter().value("</script><!-- \xe2\x80\xa8\xe2\x80\xa9 caf\xc3\xa9").take();
  std::string const safe = script_safe(text);
  EXPECT_EQ(safe.find('<'), std::string::npos);
  EXPECT_EQ(safe.find("\xe2\x80"), std::string::npos);
  EXPECT_EQ(Json::parse(safe), Json::parse(text));
}

}  // namespace
}  // namespace isolaw::render
