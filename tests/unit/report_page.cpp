// The page as text: self-contained, nothing of the input outside its data block, and the block's numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "isolaw/report/assets.hpp"
#include "isolaw/report/html.hpp"
#include "isolaw/report/page_data.hpp"
#include "unit/report_fixture.hpp"

namespace isolaw::report {
namespace {

using Json = nlohmann::json;

std::string const opening = "<script type=\"application/json\" id=\"isolaw-data\">";

std::size_t count(std::string const& text, std::string const& part) {
  std::size_t times = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++times;
  return times;
}

Json data_of(std::string const& page) {
  auto const begin = page.find(opening) + opening.size();
  return Json::parse(page.substr(begin, page.find("</script", begin) - begin));
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
  EXPECT_EQ(count(page, opening), 1u);
  auto const data = data_of(page);
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
  EXPECT_EQ(data_of(page)["title"], "{{script}} {{data}}");
}

TEST(Page, LoadsNothing) {
  auto page = html(fixture::lot());
  auto const plotly = page.find("plotly.js (basic");
  ASSERT_NE(plotly, std::string::npos);
  page.erase(plotly,
             page.find("</script", plotly) - plotly);  // names namespaces and licences; the policy blocks it anyway
  EXPECT_FALSE(std::regex_search(page, std::regex(R"((src|href)\s*=\s*["']?(https?:)?//)", std::regex::icase)));
  EXPECT_FALSE(std::regex_search(page, std::regex(R"(<link|@import|url\(|fetch\(|XMLHttpRequest)")));
  EXPECT_NE(page.find("content=\"default-src 'none';"), std::string::npos);
}

TEST(Page, EveryPlaceholderIsFilled) {
  auto const page = html(fixture::lot());
  EXPECT_EQ(count(page, "{{"),
            count(std::string(assets::plotly_js()), "{{") + count(std::string(assets::page_js()), "{{"));
}

TEST(Page, SameSummarySamePage) {
  EXPECT_EQ(html(fixture::lot()), html(fixture::lot()));
}

TEST(PageData, UndefinedIsNull) {
  auto const data = Json::parse(page_data_json(fixture::lot(1, 2)));
  EXPECT_TRUE(data["laws"][0]["beta"].is_null());
  EXPECT_EQ(data["findings"]["beta_note"], "one device: the difference between devices is not defined");
  EXPECT_TRUE(data["laws"][0]["devices"][0]["parameters"][0][3].is_null());
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
  EXPECT_LT(step, 0.02);  // kN, of a range of 250
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

TEST(PageData, LongRecordsAreThinnedEvenlyWithBothEnds) {
  EXPECT_EQ(drawn_samples(0, 10).size(), 0u);
  EXPECT_EQ(drawn_samples(5, 10), (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  auto const drawn = drawn_samples(1000, 300);
  EXPECT_LE(drawn.size(), 301u);
  EXPECT_EQ(drawn.front(), 0u);
  EXPECT_EQ(drawn.back(), 999u);
}

TEST(PageData, LargeLotStaysSmall) {
  EXPECT_LT(html(fixture::lot(160, 7)).size(), 30u * 1024u * 1024u);
}

}  // namespace
}  // namespace isolaw::report
