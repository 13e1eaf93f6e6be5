// Workbooks, MATLAB files, JSON and files of several tests, from the command line to a lot file and back.
#include <xlsxwriter.h>

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
  // Two sheets with a test each, and one of remarks.
  void write_book(std::string const& name) {
    auto* book = workbook_new(path(name).c_str());
    worksheet_write_string(workbook_add_worksheet(book, "Remarks"), 0, 0, "nothing", nullptr);
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

}  // namespace
}  // namespace isolaw::cli_test
