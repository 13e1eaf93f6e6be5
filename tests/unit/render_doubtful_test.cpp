// Tests the warnings that a reader needs before trusting a report: missing runs, copies of a record, implausible
// numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "contains.hpp"
#include "finding_text.hpp"
#include "isolaw/render/tables/tables.hpp"
#include "isolaw/render/terminal/terminal.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::render {
namespace {

Finding no_cycles(std::string const& device) {
  auto finding = stated("no cycles");
  finding.devices = {device};
  return finding;
}

Summary two_devices() {
  Summary summary;
  summary.title = "Lot";
  summary.runs = summary.expected_runs = 4;
  for (std::string const name : {"A", "B"}) {
    DeviceResult device;
    device.name = name;
    device.status = "ok";
    device.raw.disp_mm = {0.0, 1.0, name == "A" ? 2.0 : 2.5};
    device.raw.force_kN = {0.0, 1.0, 2.0};
    device.properties.refusal = {stated("no cycles")};
    summary.devices.push_back(device);
  }
  for (std::string const id : {"abe", "bilinear"}) {
    LawResult law;
    law.id = id;
    law.objective = {.mean = 0.1, .std = 0.01, .best = 0.09};
    law.beta = id == "abe" ? 0.2 : 0.3;
    law.on_front = id == "abe";
    for (std::string const name : {"A", "B"}) {
      DeviceFit fit;
      fit.device = name;
      fit.runs = 1;
      fit.objective = law.objective;
      law.devices.push_back(fit);
    }
    summary.laws.push_back(law);
  }
  return summary;
}

std::vector<std::string> topics(Summary const& summary) {
  std::vector<std::string> found;
  for (auto const& warning : findings(summary).warnings) found.emplace_back(wording::row(warning.kind).topic);
  return found;
}

TEST(Doubtful, MissingRunsAreTheFirstWarning) {
  auto summary = two_devices();
  auto const without = topics(summary);
  EXPECT_EQ(std::ranges::count(without, "not complete"), 0);
  EXPECT_FALSE(contains(ranking(summary, 80), " of 4 runs"));
  summary.devices[1].status = "refused";
  summary.expected_runs = 7000;
  ASSERT_GE(topics(summary).size(), 2u);
  EXPECT_EQ(topics(summary)[0], "not complete");
  EXPECT_EQ(topics(summary)[1], "refused");
  auto const missing = findings(summary).warnings[0];
  EXPECT_EQ(missing.number("runs"), 4.0);
  EXPECT_EQ(missing.number("expected_runs"), 7000.0);
  EXPECT_TRUE(contains(missing, "4 of 7000 runs are done: every number and the choice of a law may still change."));
  EXPECT_TRUE(contains(ranking(summary, 80), "2 laws, 4 of 7000 runs, seed 0"));
}

TEST(Doubtful, CopiesOfARecordAreNamed) {
  auto summary = two_devices();
  EXPECT_EQ(std::ranges::count(topics(summary), "copies"), 0);
  summary.devices[1].raw.disp_mm = summary.devices[0].raw.disp_mm;
  summary.devices[1].copy_of = "A";
  auto const found = findings(summary).warnings;
  auto const copies = std::ranges::find(found, FindingKind::same_record, &Finding::kind);
  ASSERT_NE(copies, found.end());
  EXPECT_EQ(copies->devices, (std::vector<std::string>{"A", "B"}));
  EXPECT_EQ(wording::sentence(*copies),
            "A and B hold the same record: it counts as one device. Means, spreads, draws and bounds leave out B.");
  // The warnings of a device are its own findings and the finding that A and B are copies.
  summary.devices[1].raw.warnings.push_back(stated("a column is constant"));
  auto const of_devices = device_warnings(summary);
  ASSERT_EQ(of_devices.size(), 2u);
  EXPECT_EQ(of_devices[0], (std::vector<Finding>{no_cycles("A"), *copies}));
  ASSERT_EQ(of_devices[1].size(), 3u);
  EXPECT_EQ(wording::sentence(of_devices[1][0]), "B: a column is constant");
  EXPECT_EQ(of_devices[1][2], *copies);
  summary.devices[1].raw.force_kN.back() = 7.0;
  EXPECT_EQ(wording::sentence(findings(summary).warnings[static_cast<std::size_t>(copies - found.begin())]),
            "A and B hold the same record, scaled, shifted, sampled anew or with noise added: it counts as one device. "
            "Means, spreads, draws and bounds leave out B.");
  summary.devices[1].copy_of.clear();
  EXPECT_EQ(std::ranges::count(topics(summary), "copies"), 0);
}

TEST(Doubtful, HugeNumbersKeepTheColumnsApart) {
  auto summary = two_devices();
  summary.laws[0].objective = {.mean = 506975621.6694, .std = 877939889.1621, .best = 87588.2856};
  summary.laws[1].objective = {.mean = 1.5e308, .std = 1.25e307, .best = 3e300};
  summary.laws[1].beta = 4e299;
  auto const text = ranking(summary, 80);
  EXPECT_TRUE(contains(text, "5.07e+08 ± 8.78e+08"));
  EXPECT_TRUE(contains(text, "1.50e+308 ± 1.25e+307"));
  EXPECT_FALSE(contains(text, "e+0887588"));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    auto const columns = std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; });
    EXPECT_LE(columns, 85) << line;
  }
}

TEST(Doubtful, ARefusedDeviceHasARowInTheTableOfObjectives) {
  auto summary = two_devices();
  summary.devices[1].status = "refused";
  summary.devices[1].message = "no force";
  for (auto& law : summary.laws) law.devices.pop_back();
  summary.laws[0].devices[0].missing_runs = 3;
  auto const table = objective_csv(summary);
  EXPECT_TRUE(contains(table, "\r\nabe,B,,,,,,,,,,,,refused,no force,0\r\n")) << table;
  EXPECT_TRUE(contains(table, "\r\nbilinear,B,,,,,,,,,,,,refused,no force,0\r\n")) << table;
  EXPECT_TRUE(contains(table, ",ok,,3\r\n")) << table;
}

}  // namespace
}  // namespace isolaw::render
