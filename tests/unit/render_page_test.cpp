// Tests the page as text: it loads nothing from elsewhere, contains the user's input in its data block alone, and has
// the right numbers there.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "isolaw/data/read.hpp"
#include "isolaw/render/page/html.hpp"
#include "isolaw/render/page/page_data.hpp"
#include "isolaw/study/drawn_samples.hpp"
#include "isolaw/study/findings.hpp"
#include "page_data.hpp"
#include "unit/analysed_fixture.hpp"
#include "unit/motions.hpp"
#include "unit/study_fixture.hpp"

namespace isolaw::render {
namespace {

using Json = nlohmann::ordered_json;

std::size_t count(std::string const& text, std::string const& part) {
  std::size_t times = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++times;
  return times;
}

std::vector<double> decoded(Json const& curve) {
  std::vector<double> values;
  long level = 0;
  for (auto const& difference : curve["d"]) {
    level += difference.get<long>();
    values.push_back(curve["o"].get<double>() + curve["s"].get<double>() * static_cast<double>(level));
  }
  return values;
}

TEST(Page, OneDataBlockThatParses) {
  auto const page = html(fixture::lot());
  EXPECT_EQ(count(page, std::string(page_data_opening)), 1u);
  auto const data = page_data(page);
  EXPECT_EQ(data["devices"].size(), 4u);
  EXPECT_EQ(data["laws"].size(), 3u);
  EXPECT_EQ(data["devices"][3]["name"], fixture::nasty_name);
  EXPECT_EQ(data["seed"], "7");
}

TEST(Page, NamesOfTheInputCloseNothing) {
  auto summary = fixture::lot();
  summary.title = fixture::nasty_name;
  auto const page = html(summary);
  EXPECT_EQ(page.find(fixture::nasty_name), std::string::npos);
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_NE(
      page.find("<title>&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt;&quot;&#39;\n=1+1 – isolaw report</title>"),
      std::string::npos);
  EXPECT_EQ(count(page, "<script"), count(page, "</script"));
  EXPECT_EQ(count(page, "</script"), 5u);
}

TEST(Page, StatesWhatTheTestsWereHeldTo) {
  auto summary = fixture::lot();
  summary.asked = {
      .rules = "id = \"</script> <!-- é\"\n", .rules_file = "a/b.toml", .design = "K_eff=1.2", .lot_size = 28};
  EXPECT_EQ(asked_in(html(summary)), summary.asked);
  summary.asked = {};
  EXPECT_EQ(asked_in(html(summary)), campaign::Acceptance{});
  EXPECT_EQ(asked_in("<html></html>"), std::nullopt);
  EXPECT_EQ(asked_in("<script type=\"application/json\" id=\"isolaw-asked\">{\"rules\":3}</script>"), std::nullopt);
}

TEST(Page, PlaceholdersOfTheInputStayText) {
  auto summary = fixture::lot();
  summary.title = "{{script}} {{data}}";
  auto const page = html(summary);
  EXPECT_NE(page.find("<title>{{script}} {{data}} – isolaw report</title>"), std::string::npos);
  EXPECT_EQ(page_data(page)["title"], "{{script}} {{data}}");
}

TEST(Page, LoadsNothing) {
  auto page = html(fixture::lot());
  auto const plotly = page.find("plotly.js (basic");
  ASSERT_NE(plotly, std::string::npos);
  page.erase(plotly,
             // Plotly's code, which names the addresses of namespaces and licences, is left out. It loads nothing,
             // because the page's policy blocks all loading.
             page.find("</script", plotly) - plotly);
  EXPECT_FALSE(std::regex_search(page, std::regex(R"((src|href)\s*=\s*["']?(https?:)?//)", std::regex::icase)));
  EXPECT_FALSE(std::regex_search(page, std::regex(R"(<link|@import|url\((?!"data:)|fetch\(|XMLHttpRequest)")));
  EXPECT_NE(page.find("content=\"default-src 'none';"), std::string::npos);
}

TEST(Page, EveryPlaceholderIsFilled) {
  auto const page = html(fixture::lot());
  EXPECT_EQ(count(page, "{{"), count(std::string(embedded_text(page_files(), "plotly-basic.min.js")), "{{") +
                                   count(std::string(embedded_text(page_files(), "page.js")), "{{"));
}

TEST(Page, SameSummarySamePage) {
  EXPECT_EQ(html(fixture::lot()), html(fixture::lot()));
}

TEST(PageData, UndefinedIsNull) {
  auto const data = Json::parse(page_data_json(fixture::lot(1, 2)));
  EXPECT_TRUE(data["laws"][0]["beta"].is_null());
  EXPECT_EQ(data["findings"]["beta_note"], "one device: the difference between devices is not defined");
  EXPECT_TRUE(data["laws"][0]["devices"][0]["parameters"]["percent_of_lot"][0].is_null());
  auto summary = fixture::lot();
  summary.laws[0].devices[0].force_kN.clear();
  EXPECT_TRUE(Json::parse(page_data_json(summary))["laws"][0]["devices"][0]["force_kN"].is_null());
}

TEST(PageData, CurvesComeBackWithinTheirStep) {
  auto const summary = fixture::lot();
  auto const data = Json::parse(page_data_json(summary));
  auto const values = decoded(data["laws"][1]["devices"][2]["force_kN"]);
  auto const& expected = summary.laws[1].devices[2].force_kN;
  ASSERT_EQ(values.size(), expected.size());
  double const step = data["laws"][1]["devices"][2]["force_kN"]["s"].get<double>();
  EXPECT_LT(step, 0.02);  // in kN, for forces in a range of 250 kN
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], expected[i], 0.51 * step);
}

TEST(PageData, ConstantAndNonFiniteCurves) {
  auto summary = fixture::lot();
  auto& force = summary.laws[0].devices[0].force_kN;
  std::fill(force.begin(), force.end(), 3.0);
  force[5] = std::numeric_limits<double>::quiet_NaN();
  auto const values = decoded(Json::parse(page_data_json(summary))["laws"][0]["devices"][0]["force_kN"]);
  for (double const value : values) EXPECT_EQ(value, 3.0);
}

// The fourth cycle is larger and does not count. The remainder of the block (signal minus mean cycle) has no value
// there.
TEST(PageData, TheRemainderHasGapsBetweenItsCycles) {
  auto summary = fixture::lot();
  auto const motion = data::testing::Motion().sine(100.0, 0.5, 3).sine(110.0, 0.5, 1).sine(100.0, 0.5, 3).end().loop();
  auto& device = summary.devices[0];
  device.raw = data::record_of_values("test", {motion.disp_mm, motion.force_kN, motion.time_s, {}});
  device.properties = data::cyclic_properties(device.raw);
  device.raw.warnings = {{.kind = FindingKind::offset_steps, .blocks = {1}, .words = {{"channel", "force"}}}};
  auto const remainder = Json::parse(page_data_json(summary))["devices"][0]["remainder"];
  std::vector<std::size_t> within;
  for (auto const& gap : remainder["gaps"])
    within.push_back(remainder["first"].get<std::size_t>() + gap.get<std::size_t>());
  ASSERT_EQ(remainder["stride"], 1);
  EXPECT_GT(within.size(), 190u);
  for (auto const sample : within) EXPECT_TRUE(sample >= 600 && sample <= 800) << sample;
}

TEST(PageData, LongRecordsAreThinnedEvenlyWithBothEnds) {
  EXPECT_EQ(drawn_samples(0, 10).size(), 0u);
  EXPECT_EQ(drawn_samples(5, 10), (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  auto const drawn = drawn_samples(1000, 300);
  EXPECT_LE(drawn.size(), 301u);
  EXPECT_EQ(drawn.front(), 0u);
  EXPECT_EQ(drawn.back(), 999u);
}

// The page gives numbers with six digits in profiles and intervals, and with nine elsewhere. `relative` is the
// tolerance for this rounding.
void expect_close(Json const& written, std::optional<double> expected, double relative) {
  ASSERT_EQ(written.is_null(), !expected || !std::isfinite(*expected)) << written;
  if (written.is_null()) return;
  EXPECT_NEAR(written.get<double>(), *expected, relative * std::abs(*expected));
}
void expect_close(Json const& written, std::vector<double> const& expected, double relative) {
  ASSERT_EQ(written.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) expect_close(written[i], expected[i], relative);
}
constexpr double of_nine = 1e-8, of_six = 1e-5;

TEST(PageData, AnalysisOfADeviceIsTheSummarys) {
  auto const summary = fixture::analysed(fixture::lot());
  auto const data = Json::parse(page_data_json(summary));
  for (std::size_t j = 0; j < summary.laws.size(); ++j)
    for (std::size_t d = 0; d < summary.laws[j].devices.size(); ++d) {
      auto const& fit = summary.laws[j].devices[d];
      auto const& written = data["laws"][j]["devices"][d];
      expect_close(written["optimum"], fit.optimum, of_nine);
      expect_close(written["rise"], fit.rise, of_nine);
      expect_close(written["success_share"], fit.success_share, of_nine);
      expect_close(written["lot_objective"], fit.lot_objective, of_nine);
      expect_close(written["worst_objective"], fit.worst_objective, of_nine);
      expect_close(written["left_out_objective"], fit.left_out_objective, of_nine);
      EXPECT_EQ(written["trade_offs"], fit.trade_offs);
      EXPECT_EQ(written["intervals"], (Json{{"level", 0.95}, {"samples", 601}, {"block", 42}, {"replicates", 100}}));
      ASSERT_EQ(written["blocks"].size(), fit.blocks.size());
      for (std::size_t b = 0; b < fit.blocks.size(); ++b) {
        EXPECT_EQ(written["blocks"][b]["block"], fit.blocks[b].block);
        EXPECT_EQ(written["blocks"][b]["fitted"], fit.blocks[b].fitted);
        expect_close(written["blocks"][b]["objective"], fit.blocks[b].objective, of_nine);
      }
      for (std::size_t n = 0; n < fit.parameters.size(); ++n) {
        auto const of = [&](char const* name) { return written["determination"][name][n]; };
        auto const& a = *fit.parameters[n].analysis;
        EXPECT_EQ(of("identifiability"), name(a.identifiability));
        expect_close(of("optimum"), a.optimum, of_nine);
        expect_close(of("open_range")[0], a.open_lower, of_six);
        expect_close(of("open_range")[1], a.open_upper, of_six);
        EXPECT_EQ(of("open_below"), a.open_below);
        EXPECT_EQ(of("open_above"), a.open_above);
        expect_close(of("linear_interval")[0], a.linear_lower, of_six);
        expect_close(of("linear_interval")[1], a.linear_upper, of_six);
        expect_close(of("bootstrap_interval")[0], a.bootstrap_lower, of_six);
        expect_close(of("bootstrap_interval")[1], a.bootstrap_upper, of_six);
        expect_close(of("profile")["value"], a.profile_value, of_six);
        expect_close(of("profile")["objective"], a.profile_objective, of_six);
      }
    }
}

TEST(PageData, ParametersStandByName) {
  auto const summary = fixture::lot();
  auto const data = Json::parse(page_data_json(summary));
  auto const& fit = summary.laws[1].devices[2];
  auto const& written = data["laws"][1]["devices"][2]["parameters"];
  for (std::size_t n = 0; n < fit.parameters.size(); ++n) {
    auto const& parameter = fit.parameters[n];
    expect_close(written["mean"][n], parameter.value.mean, of_nine);
    expect_close(written["std"][n], parameter.value.std, of_nine);
    expect_close(written["best"][n], parameter.value.best, of_nine);
    expect_close(written["percent_of_lot"][n], parameter.percent_of_lot, of_nine);
    EXPECT_EQ(written["at_bound"][n], parameter.at_bound == fit::AtBound::no ? Json() : Json(name(parameter.at_bound)));
    expect_close(written["lower"][n], parameter.lower, of_nine);
    expect_close(written["upper"][n], parameter.upper, of_nine);
  }
  for (auto const& [name, column] : written.items()) EXPECT_EQ(column.size(), fit.parameters.size()) << name;
}

TEST(PageData, AnalysisOfALotIsTheSummarys) {
  auto const summary = fixture::analysed(fixture::lot());
  auto const data = Json::parse(page_data_json(summary));
  for (std::size_t j = 0; j < summary.laws.size(); ++j) {
    auto const& law = summary.laws[j];
    auto const& written = data["laws"][j];
    expect_close(written["success_share"], law.success_share, of_nine);
    EXPECT_EQ(written["success_reference"], law.success_reference);
    expect_close(written["objective_converged"], law.objective_converged, of_nine);
    expect_close(written["beta_converged"], law.beta_converged, of_nine);
    EXPECT_EQ(written["left_out_of_beta"], law.left_out_of_beta);
    EXPECT_EQ(written["on_front_converged"], law.on_front_converged);
    EXPECT_EQ(written["on_front_loo"], law.on_front_loo);
    expect_close(written["loo_objective"], law.loo_objective, of_nine);
    expect_close(written["loo_worst"], law.loo_worst, of_nine);
    EXPECT_EQ(written["loo_worst_device"], law.loo_worst_device);
    expect_close(written["lot"]["parameters"], law.lot->parameters, of_nine);
    expect_close(written["lot"]["least_worst_parameters"], law.lot->worst_parameters, of_nine);
    expect_close(written["lot"]["mean_objective"], law.lot->mean, of_nine);
    expect_close(written["lot"]["worst_objective"], law.lot->worst, of_nine);
    expect_close(written["lot"]["least_worst_objective"], law.lot->least_worst, of_nine);
    expect_close(written["lot"]["least_worst_bound"], law.lot->least_worst_bound, of_nine);
    EXPECT_EQ(written["lot"]["worst_device"], law.lot->worst_device);
    EXPECT_EQ(written["population"]["parameters"], law.population->names);
    EXPECT_EQ(written["population"]["note"], law.population->note);
    expect_close(written["population"]["medians"], law.population->medians, of_nine);
    expect_close(written["population"]["relative_std"], law.population->relative_std, of_six);
    ASSERT_EQ(written["population"]["correlation"].size(), law.population->correlation.size());
    for (std::size_t i = 0; i < law.population->correlation.size(); ++i)
      expect_close(written["population"]["correlation"][i], law.population->correlation[i], of_six);
    expect_close(written["fitted_objective"], law.fitted_objective, of_nine);
    expect_close(written["predicted_objective"], law.predicted_objective, of_nine);
    expect_close(written["worst_predicted"], law.worst_predicted, of_nine);
    EXPECT_EQ(written["prediction_collapses"], law.prediction_unusable());
    EXPECT_EQ(written["prediction_grade"], name(*law.prediction_grade));
  }
  auto const expected = wording::grouped(findings(summary).converged, wording::anywhere);
  auto const& converged = data["findings"]["converged"];
  ASSERT_EQ(converged.size(), expected.size());
  EXPECT_FALSE(expected.empty());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(converged[i]["kind"], wording::row(expected[i].front().kind).key);
    EXPECT_EQ(converged[i]["sentence"], wording::sentence(expected[i]));
  }
  ASSERT_EQ(data["outliers"].size(), summary.outliers.size());
  EXPECT_EQ(data["outliers"][0]["device"], summary.outliers[0].device);
  expect_close(data["outliers"][0]["value"], summary.outliers[0].value, of_nine);
}

TEST(PageData, NothingOfAnAnalysisThatWasNotMade) {
  auto const data = Json::parse(page_data_json(fixture::lot()));
  for (auto const& law : data["laws"]) {
    for (auto const* key : {"success_share", "objective_converged", "beta_converged", "loo_objective", "lot",
                            "population", "predicted_objective"})
      EXPECT_TRUE(law.at(key).is_null()) << key;
    for (auto const& fit : law["devices"]) {
      for (auto const* key : {"optimum", "rise", "determination", "lot_objective", "left_out_objective"})
        EXPECT_TRUE(fit.at(key).is_null()) << key;
      EXPECT_TRUE(fit["intervals"]["level"].is_null());
      EXPECT_TRUE(fit["blocks"].empty());
    }
  }
  EXPECT_TRUE(data["findings"]["converged"].empty());
  EXPECT_TRUE(data["outliers"].empty());
}

TEST(PageData, ParametersThatWereNotExaminedAreNull) {
  auto summary = fixture::analysed(fixture::lot());
  summary.laws[0].devices[0].parameters[1].analysis.reset();
  auto const data = Json::parse(page_data_json(summary));
  for (auto const& [name, column] : data["laws"][0]["devices"][0]["determination"].items()) {
    EXPECT_TRUE(column[1].is_null()) << name;
    EXPECT_FALSE(column[0].is_null()) << name;
  }
}

TEST(PageData, LargeLotStaysSmall) {
  auto const plain = html(fixture::lot(160, 7)).size();
  auto const analysed = html(fixture::analysed(fixture::lot(160, 7))).size();
  EXPECT_LT(analysed, 30u * 1024u * 1024u);
  EXPECT_LT(analysed - plain, 3u * 1024u * 1024u);
}

}  // namespace
}  // namespace isolaw::render
