// Tests the units in which reports show values, and the letterhead. The terminal, the tables, the figures and the page
// must follow the option or the key of a lot file. JSON and the store must stay in kN, mm and s.
#include "cli/records.hpp"
#include "cli/run.hpp"

namespace isolaw::cli_test {
namespace {

Words const search{"--laws", "bilinear",      "--runs", "1",          "--population",
                   "4",      "--generations", "1",      "--analysis", "none"};

class ReportUnits : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    write("lot/A.csv", csv(record()));
    write("lot/B.csv", csv(record({.stiffness_kN_per_mm = 0.6})));
  }
  // Returns the number in the first row of a table's column.
  double cell(std::string const& table, std::string const& column) const {
    std::istringstream lines(read(table));
    std::string head, first;
    std::getline(lines, head);
    std::getline(lines, first);
    std::istringstream names(head), values(first);
    for (std::string name, value; std::getline(names, name, ',') && std::getline(values, value, ',');)
      if (name == column) return std::stod(value);
    ADD_FAILURE() << table << " has no column " << column << ": " << head;
    return 0.0;
  }
};

TEST_F(ReportUnits, everything_shown_is_converted_and_everything_stored_is_not) {
  ASSERT_EQ(isolaw(Words{"calibrate", "lot", "--out", "mm"} + search).code, 0);
  ASSERT_EQ(isolaw({"report", "mm", "--report-units", "kip-in", "--figures", "lot", "--out", "in"}).code, 0);
  EXPECT_EQ(read("mm/summary.json"), read("in/summary.json"));
  constexpr double kip = 4.4482216152605, inch = 25.4;
  EXPECT_NEAR(cell("in/tables/cycles.csv", "amplitude [in]"), cell("mm/tables/cycles.csv", "amplitude [mm]") / inch,
              1e-4);
  EXPECT_NEAR(cell("in/tables/cycles.csv", "K_eff [kip/in]"),
              cell("mm/tables/cycles.csv", "K_eff [kN/mm]") * inch / kip, 1e-4);
  EXPECT_TRUE(contains(read("in/figures/properties.gp"), "(kip/in)"));
  EXPECT_TRUE(contains(read("in/figures/loops_B.gp"), "Displacement (in)"));
  EXPECT_TRUE(contains(read("in/report.html"), R"("units":{"chosen":"kip-in")"));
  EXPECT_TRUE(contains(read("mm/report.html"), R"("units":{"chosen":"kN-mm")"));
  auto const inspected = isolaw({"inspect", "lot/A.csv", "--report-units", "kip-in"});
  EXPECT_TRUE(contains(inspected.out, "cycles of 3.937 in")) << inspected;  // 100 mm
  EXPECT_TRUE(contains(inspected.out, "kip/in")) << inspected;
  EXPECT_FALSE(contains(inspected.out, "kN/mm")) << inspected;
}

TEST_F(ReportUnits, a_lot_file_sets_them_for_reports_and_exports) {
  write("lot/lot.toml",
        "[acceptance]\nreport-units = \"N-m\"\n[[device]]\nfile = \"A.csv\"\n[[device]]\nfile = \"B.csv\"\n");
  ASSERT_EQ(isolaw(Words{"calibrate", "lot/lot.toml", "--out", "O"} + search).code, 0);
  EXPECT_TRUE(contains(read("O/tables/cycles.csv"), "K_eff [N/m]"));
  ASSERT_EQ(isolaw({"report", "O"}).code, 0);
  EXPECT_TRUE(contains(read("O/tables/cycles.csv"), "K_eff [N/m]"));
  auto const exported = isolaw({"export", "O", "--law", "bilinear", "--device", "A", "--to", "json"});
  EXPECT_EQ(Json::parse(exported.out)["units"]["force"], "N") << exported;
  expect_refused(isolaw({"report", "O", "--report-units", "lb-ft"}), {"--report-units", "kN-mm, N-m, kip-in"});
}

TEST_F(ReportUnits, the_letterhead_is_kept_with_the_campaign) {
  write("lot/head.txt", "Laboratory of Devices\n");
  write("lot/head.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
  write("lot/lot.toml", "[acceptance]\nletterhead = \"head.svg\"\n[[device]]\nfile = \"A.csv\"\n");
  ASSERT_EQ(isolaw(Words{"calibrate", "lot/lot.toml", "--out", "O"} + search).code, 0);
  fs::remove(path("lot/head.svg"));
  ASSERT_EQ(isolaw({"report", "O"}).code, 0);
  EXPECT_TRUE(
      contains(read("O/report.html"),
               R"("letterhead":"data:image/svg+xml;base64,PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciLz4=")"));
  ASSERT_EQ(isolaw({"report", "O", "--letterhead", "lot/head.txt"}).code, 0);
  EXPECT_TRUE(contains(read("O/report.html"), R"("letterhead":"Laboratory of Devices")"));
  expect_refused(isolaw({"report", "O", "--letterhead", "lot/A.csv"}), {"letterhead 'lot/A.csv'", ".svg, .png, .jpg"});
  expect_refused(isolaw({"report", "O", "--letterhead", "none.png"}), {"none.png"});
  write("text.png", "no picture");
  expect_refused(isolaw({"report", "O", "--letterhead", "text.png"}), {"text.png", "holds no such picture"});
  write("long.txt", "1\n2\n3\n4\n5\n6\n7\n8\n9\n10\n11\n12\n13");
  expect_refused(isolaw({"report", "O", "--letterhead", "long.txt"}), {"long.txt", "the file has 13 lines"});
  write("blank.txt", "\n \n");
  expect_refused(isolaw({"report", "O", "--letterhead", "blank.txt"}), {"blank.txt", "the file is empty"});
  // The letterhead may come from Windows, and blank lines at its end do not count.
  write("windows.txt",
        "Pr\xFC"
        "fstelle\n\n\n\n\n\n\n\n\n\n\n\n\n\n");
  ASSERT_EQ(isolaw({"report", "O", "--letterhead", "windows.txt"}).code, 0);
  EXPECT_TRUE(contains(read("O/report.html"), "\"letterhead\":\"Pr\u00fcfstelle\""));
  write("tiny.png", "\x89PNG");
  ASSERT_EQ(isolaw({"report", "O", "--letterhead", "tiny.png"}).code, 0);
  EXPECT_TRUE(contains(read("O/report.html"), R"("letterhead":"data:image/png;base64,iVBORw==")"));
}

}  // namespace
}  // namespace isolaw::cli_test
