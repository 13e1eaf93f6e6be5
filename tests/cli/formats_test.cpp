// Tests how isolaw reads workbooks, MATLAB files, JSON and files with several tests, directly and through lot files.
#include <xlsxwriter.h>

#include "cli/loops.hpp"
#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

class Formats : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    write("several.csv", csv(record()) + csv(record({.amplitude_mm = 90.0})));
  }
  // Writes a workbook with remarks on its first sheet and one test on each of two further sheets.
  void write_book(std::string const& name, std::vector<std::pair<char const*, char const*>> const& remarks = {}) {
    auto* book = workbook_new(path(name).c_str());
    auto* first = workbook_add_worksheet(book, "Remarks");
    worksheet_write_string(first, 0, 0, "nothing", nullptr);
    lxw_row_t at = 1;
    for (auto const& [label, value] : remarks) {
      worksheet_write_string(first, at, 0, label, nullptr);
      worksheet_write_string(first, at++, 1, value, nullptr);
    }
    for (double const amplitude : {100.0, 90.0}) {
      auto* sheet = workbook_add_worksheet(book, fmt::format("Test {:g}", amplitude).c_str());
      char const* names[] = {"Time [s]", "Disp [mm]", "Force [kN]"};
      for (lxw_col_t c = 0; c < 3; ++c) worksheet_write_string(sheet, 0, c, names[c], nullptr);
      lxw_row_t row = 1;
      for (auto const& s : record({.amplitude_mm = amplitude})) {
        worksheet_write_number(sheet, row, 0, s.time_s, nullptr);
        worksheet_write_number(sheet, row, 1, s.disp_mm, nullptr);
        worksheet_write_number(sheet, row++, 2, s.force_kN, nullptr);
      }
    }
    workbook_close(book);
  }
};

void expect_said(Outcome const& o, Words const& parts) {
  EXPECT_EQ(o.code, 2) << o;
  for (auto const& part : parts) EXPECT_TRUE(contains(o.err, part)) << part << "\n" << o;
}

TEST_F(Formats, several_tests_need_a_word) {
  expect_said(isolaw({"inspect", "several.csv"}),
              {"several.csv: 2 tests in one file: they start at lines 1, 603", "try: --test all, or --test 2"});
  EXPECT_EQ(Json::parse(isolaw({"inspect", "several.csv", "--test", "2", "--json"}).out)["samples"], 601);
  EXPECT_EQ(Json::parse(isolaw({"inspect", "several.csv", "--test", "all", "--json"}).out)["samples"], 1202);
  expect_said(isolaw({"inspect", "several.csv", "--test", "x"}),
              {"--test: 'x'; allowed: all, or the number of a test"});
}

TEST_F(Formats, init_passes_over_what_is_no_test_and_names_the_sheets_it_cannot_read) {
  auto const sheet = [](lxw_workbook* book, char const* name, std::vector<char const*> const& names, bool test) {
    auto* worksheet = workbook_add_worksheet(book, name);
    for (lxw_col_t c = 0; c < names.size(); ++c) {
      worksheet_write_string(worksheet, 0, c, names[c], nullptr);
      for (lxw_row_t i = 0; i < 3; ++i)
        worksheet_write_number(worksheet, i + 1, c, test ? i * (c + 1) % 3 : i, nullptr);
    }
  };
  auto* book = workbook_new(path("one.xlsx").c_str());
  sheet(book, "Prova", {"Disp [mm]", "Force [kN]"}, true);
  sheet(book, "Grafici", {"a", "b"}, false);
  workbook_close(book);
  auto const o = isolaw({"init", "."});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.err, "one.xlsx: sheet 'Grafici' names no time, displacement or force, passed over"));
  EXPECT_TRUE(contains(read("lot.toml"), "sheet = 'Prova'"));
  auto* other = workbook_new(path("two.xlsx").c_str());
  sheet(other, "A", {"a", "b"}, false);
  sheet(other, "B", {"a", "b"}, false);
  workbook_close(other);
  expect_said(isolaw({"init", "two.xlsx", "--force"}),
              {"two.xlsx: tables 'A', 'B' taken for tests", "try: --sheet NAME for the one that is the test"});
}

TEST_F(Formats, init_makes_a_device_of_each_test_of_a_json_list) {
  std::string list;
  for (double const amplitude : {100.0, 90.0}) {
    std::string time, disp, force;
    for (auto const& s : record({.amplitude_mm = amplitude})) {
      auto const comma = time.empty() ? "" : ",";
      time += fmt::format("{}{:.3f}", comma, s.time_s);
      disp += fmt::format("{}{:.6f}", comma, s.disp_mm);
      force += fmt::format("{}{:.6f}", comma, s.force_kN);
    }
    list += fmt::format(R"({}{{"name": "{:g}", "time_s": [{}], "disp_mm": [{}], "force_kN": [{}]}})",
                        list.empty() ? "" : ", ", amplitude, time, disp, force);
  }
  write("list.json", "{\"tests\": [" + list + "]}");
  expect_said(isolaw({"inspect", "list.json"}), {"list.json: 2 tests in one file: tests(1) '100', tests(2) '90'"});
  auto const o = isolaw({"init", "list.json"});
  EXPECT_EQ(o.code, 0) << o;
  for (auto const* part : {"name = 'list test 1'", "test = 1", "name = 'list test 2'", "test = 2"})
    EXPECT_TRUE(contains(read("lot.toml"), part)) << part;
  auto const inspected = Json::parse(isolaw({"inspect", "lot.toml", "--json"}).out);
  ASSERT_EQ(inspected["devices"].size(), 2u);
  EXPECT_NEAR(inspected["devices"][1]["blocks"][0]["amplitude_mm"].get<double>(), 90.0, 1e-3);
}

TEST_F(Formats, init_makes_a_device_of_each_test) {
  write_book("book.xlsx");
  auto const o = isolaw({"init", "several.csv", "book.xlsx"});
  EXPECT_EQ(o.code, 0) << o;
  auto const lot = read("lot.toml");
  for (auto const* part : {"name = 'several test 1'", "test = 1", "name = 'several test 2'", "test = 2",
                           "name = 'book Test 100'", "sheet = 'Test 100'", "sheet = 'Test 90'"})
    EXPECT_TRUE(contains(lot, part)) << part << "\n" << lot;
  auto const run = isolaw({"calibrate", "lot.toml", "--out", "O", "--laws", "bilinear", "--runs", "1", "--population",
                           "4", "--generations", "1"});
  EXPECT_EQ(run.code, 0) << run;
  EXPECT_EQ(json("O/summary.json")["devices"].size(), 4u);
}

TEST_F(Formats, init_fills_in_what_a_sheet_beside_the_tests_says) {
  write_book("info.xlsx", {{"Serial No", "S-77"}, {"Lot", "L5"}});
  auto const o = isolaw({"init", "info.xlsx"});
  ASSERT_EQ(o.code, 0) << o;
  auto const lot = read_file(path("lot.toml"));
  for (std::string const text : {"serial = 'S-77'", "lot = 'L5'"}) {
    auto const first = lot.find(text);
    ASSERT_NE(first, std::string::npos) << lot;
    EXPECT_NE(lot.find(text, first + 1), std::string::npos) << "of both tests: " << lot;
  }
}

TEST_F(Formats, sheets_are_chosen_in_the_file_that_has_them) {
  write_book("book.xlsx");
  write("disp.csv", csv(record({.amplitude_mm = 90.0}), "time [s],displacement [mm]", [](std::size_t, Sample const& s) {
          return fmt::format("{:.4f},{:.5f}", s.time_s, s.disp_mm);
        }));
  Words const columns{"disp.csv", "--columns", "force=book.xlsx:Force [kN]"};
  expect_said(isolaw(Words{"inspect"} + columns), {"'Test 100', 'Test 90' may each be the test", "try: --sheet"});
  expect_said(isolaw(Words{"inspect"} + columns + Words{"--sheet", "Test 7"}), {"book.xlsx: no sheet 'Test 7'"});
  auto const o = isolaw(Words{"inspect", "--json"} + columns + Words{"--sheet", "Test 90"});
  ASSERT_EQ(o.code, 0) << o;
  EXPECT_EQ(Json::parse(o.out)["samples"], 601);
  // init writes the chosen sheet to the lot file, which must give the same cycles.
  ASSERT_EQ(isolaw(Words{"init"} + columns + Words{"--sheet", "Test 90"}).code, 0);
  auto const again = isolaw({"inspect", "--json", "lot.toml"});
  ASSERT_EQ(again.code, 0) << again;
  EXPECT_EQ(Json::parse(again.out)["blocks"], Json::parse(o.out)["blocks"]);
}

TEST_F(Formats, init_joins_the_tests_where_asked_to) {
  auto const o = isolaw({"init", "several.csv", "--test", "all"});
  EXPECT_EQ(o.code, 0) << o;
  auto const lot = read("lot.toml");
  EXPECT_TRUE(contains(lot, "test = 'all'")) << lot;
  EXPECT_TRUE(contains(lot, "name = 'several'")) << lot;
}

TEST_F(Formats, a_sheet_is_chosen) {
  write_book("book.xlsx");
  expect_said(isolaw({"inspect", "book.xlsx"}),
              {"tables 'Test 100', 'Test 90' may each be the test", "try: --sheet \"Test 100\""});
  auto const o = isolaw({"inspect", "book.xlsx", "--sheet", "Test 90"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.out, "an Excel workbook, sheet 'Test 90'")) << o;
}

TEST_F(Formats, json_is_read) {
  std::string text = "{\"disp_mm\": [", force = "], \"force_kN\": [";
  for (auto const& s : record()) {
    bool const first = text.back() == '[';
    text += fmt::format("{}{}", first ? "" : ", ", s.disp_mm);
    force += fmt::format("{}{}", first ? "" : ", ", s.force_kN);
  }
  write("record.dat", text + force + "]}");
  auto const o = isolaw({"inspect", "record.dat", "--dt", "0.01"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.out, "JSON: arrays that are columns")) << o;
}

// calibrate must give the same series and runs for the directory itself as for the lot file that init writes for it.
TEST_F(Formats, init_of_a_directory_calibrates_as_the_directory_does) {
  for (int d = 1; d <= 3; ++d) {
    auto const samples = record({.stiffness_kN_per_mm = 0.4 + 0.05 * d});
    write(fmt::format("lot/D{}.csv", d), d == 2 ? csv(samples, "t;x;F",
                                                      [](std::size_t, Sample const& s) {
                                                        return fmt::format("{:.4f};{:.6f};{:.2f}", s.time_s,
                                                                           s.disp_mm / 1000.0, 1000.0 * s.force_kN);
                                                      })
                                                : csv(samples));
  }
  auto const units = isolaw({"init", "lot", "--out", "lot/lot.toml"});
  EXPECT_EQ(units.code, 1) << units;
  EXPECT_TRUE(contains(units.err, "D2.csv")) << units;
  EXPECT_EQ(count_of("[[device]]", read("lot/lot.toml")), 2u) << "nothing is guessed";
  write("lot/D2.csv", csv(record({.stiffness_kN_per_mm = 0.5}), "t [s];x [m];F [N]", [](std::size_t, Sample const& s) {
          return fmt::format("{:.4f};{:.8f};{:.2f}", s.time_s, s.disp_mm / 1000.0, 1000.0 * s.force_kN);
        }));
  auto const o = isolaw({"init", "lot", "--out", "lot/lot.toml", "--force"});
  ASSERT_EQ(o.code, 0) << o;
  ASSERT_EQ(isolaw(Words{"calibrate", "lot/lot.toml", "--out", "L"} + smallest_search).code, 0);
  ASSERT_EQ(isolaw(Words{"calibrate", "lot", "--out", "D"} + smallest_search).code, 0);
  for (auto const* rows : {"SELECT * FROM series", "SELECT id, name, file, sha256 FROM device", "SELECT * FROM run",
                           "SELECT * FROM setting"})
    EXPECT_EQ(query(path("L/campaign.sqlite"), rows), query(path("D/campaign.sqlite"), rows)) << rows;
  auto const second = Json::parse(isolaw({"inspect", "lot/lot.toml", "--json"}).out)["devices"][1];
  EXPECT_EQ(second["units"]["disp"], "m");
  auto const expected = loop_of(record({.stiffness_kN_per_mm = 0.5}), 400, 600);
  EXPECT_NEAR(cycle_of(second, 1, 3)["K_eff_kN_per_mm"].get<double>(), expected.K_eff, 1e-6);
  EXPECT_NEAR(cycle_of(second, 1, 3)["energy_kN_mm"].get<double>(), expected.energy, 1e-3 * expected.energy);
}

// The headers of these files name no channels, so the user states columns and units for the first file. init --like
// applies the same statements to a folder of further files.
TEST_F(Formats, init_like_reads_a_folder_as_another_lot_file_does) {
  auto const bare = [](double stiffness) {
    return csv(record({.stiffness_kN_per_mm = stiffness}), "A,B,C", [](std::size_t, Sample const& s) {
      return fmt::format("{:.5f},{:.5f},{:.4f}", -2.0 * s.force_kN, s.disp_mm / 10.0, s.time_s);
    });
  };
  write("old/one.csv", bare(0.5));
  auto const first = isolaw({"init", "old/one.csv", "--out", "old/lot.toml", "--columns", "force=A,disp=B,time=C",
                             "--units", "force=kN,disp=cm,time=s", "--flip-force", "--force-factor", "0.5"});
  ASSERT_EQ(first.code, 0) << first;
  auto text = read("old/lot.toml");
  text.replace(text.find("runs = 2"), 8, "runs = 5");
  write("old/lot.toml", text);
  write("new/two.csv", bare(0.55));
  write("new/three.csv", bare(0.6));
  EXPECT_EQ(isolaw({"init", "new", "--out", "new/lot.toml"}).code, 2) << "not without being told";
  auto const o = isolaw({"init", "new", "--like", "old/lot.toml", "--out", "new/lot.toml"});
  ASSERT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(read("new/lot.toml"), "runs = 5"));
  EXPECT_EQ(read("new/lot.toml").find("one.csv"), std::string::npos);
  auto const run = isolaw(
      {"calibrate", "new/lot.toml", "--out", "N", "--laws", "bilinear", "--population", "4", "--generations", "1"});
  EXPECT_EQ(run.code, 0) << run;
  auto const devices = page_data(read("N/report.html"))["devices"];
  ASSERT_EQ(devices.size(), 2u);
  for (std::size_t d = 0; d < 2; ++d) {
    EXPECT_EQ(devices[d]["name"], d == 0 ? "three" : "two");
    EXPECT_NEAR(cycle_of(devices[d], 1, 3)["K_eff_kN_per_mm"].get<double>(), d == 0 ? 0.8 : 0.75, 1e-6);
    EXPECT_TRUE(contains(devices[d]["corrections"].dump(), "force multiplied by 0.5"));
  }
  EXPECT_EQ(json("N/summary.json")["laws"][0]["devices"][0]["runs"], 5);
}

TEST_F(Formats, every_test_of_several_files_comes_back_as_its_own_device) {
  write_book("book.xlsx");
  ASSERT_EQ(isolaw({"init", "several.csv", "book.xlsx"}).code, 0);
  ASSERT_EQ(isolaw(Words{"calibrate", "lot.toml", "--out", "O"} + smallest_search).code, 0);
  auto const devices = page_data(read("O/report.html"))["devices"];
  ASSERT_EQ(devices.size(), 4u);
  for (std::size_t d = 0; d < 4; ++d) {
    auto const samples = record({.amplitude_mm = d % 2 == 0 ? 100.0 : 90.0});
    SCOPED_TRACE(devices[d]["name"].get<std::string>());
    expect_loop(cycle_of(devices[d], 1, 3), loop_of(samples, 400, 600), d < 2 ? 1e-5 : 1e-8);
  }
  EXPECT_EQ(isolaw(Words{"calibrate", "lot.toml", "--out", "O"} + smallest_search).code, 0)
      << "the same campaign again";
}

}  // namespace
}  // namespace isolaw::cli_test
