// Tests findings as JSON, the form in which a campaign's store keeps them.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "isolaw/base/error.hpp"
#include "isolaw/wording/finding_json.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::wording {
namespace {

TEST(FindingJson, ReadsBackEveryKindAndField) {
  std::vector<Finding> all;
  for (auto const& row : rows()) all.push_back({.kind = row.kind});
  all.push_back({.kind = FindingKind::drift,
                 .law = "bilinear",
                 .devices = {"a", "b \"c\""},
                 .parameters = {"K1"},
                 .blocks = {2, 1},
                 .numbers = {{"z", 1.0 / 3.0}, {"a", -1e-300}},
                 .words = {{"unit", "mm"}, {"channel", "Déplacement\n[mm]"}}});
  EXPECT_EQ(findings_of(findings_json(all)), all);
}

TEST(FindingJson, LeavesOutWhatIsEmpty) {
  EXPECT_EQ(findings_json({{.kind = FindingKind::signal_spike, .words = {{"unit", "kN"}}}}),
            R"([{"kind":"signal-spike","words":{"unit":"kN"}}])");
  EXPECT_EQ(findings_json({}), "[]");
}

TEST(FindingJson, KeepsNumbersThatAreNotFiniteAsNone) {
  auto const read = findings_of(findings_json({{.kind = FindingKind::drift, .numbers = {{"x", std::nan("")}}}}));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_TRUE(std::isnan(read[0].number("x")));
}

TEST(FindingJson, RefusesWhatItDoesNotWrite) {
  for (auto const* json : {R"([{"kind":"no-such-kind"}])", R"([{"words":{"text":"x"}}])", R"({"kind":"drift"})",
                           R"([{"kind":"drift","other":1}])", R"([3])", R"(["text"])", R"("text")", "null"})
    EXPECT_THROW(findings_of(json), Error) << json;
  for (auto const* json : {R"([{"kind":3}])", R"([{"kind":"drift","numbers":{"x":"1"}}])",
                           R"([{"kind":"drift","words":[1]}])", R"([{"kind":"drift","blocks":["1"]}])", "[", ""})
    EXPECT_THROW(findings_of(json), nlohmann::json::exception) << json;
}

}  // namespace
}  // namespace isolaw::wording
