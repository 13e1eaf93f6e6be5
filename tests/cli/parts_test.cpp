// Tests records that are a part of a file or spread over two files, headers that describe the device, and files that
// are no records. Each is given on the command line and in a lot file.
#include "cli/records.hpp"
#include "cli/run.hpp"

namespace isolaw::cli_test {
namespace {

class Parts : public InFreshDirectory {
 protected:
  static std::string channel(bool of_force) {
    return csv(record(), of_force ? "time [s],force [kN]" : "time [s],displacement [mm]",
               [of_force](std::size_t, Sample const& s) {
                 return fmt::format("{:.4f},{:.5f}", s.time_s, of_force ? s.force_kN : s.disp_mm);
               });
  }
  Json inspected(Words const& words) {
    auto const o = isolaw(Words{"inspect", "--json"} + words);
    EXPECT_EQ(o.code, 0) << o;
    return o.code == 0 ? Json::parse(o.out) : Json{};
  }
  static std::string said(Json const& found) {
    std::string text;
    for (auto const& line : found["recognised"]) text += line.get<std::string>() + "\n";
    return text;
  }
};

TEST_F(Parts, options_of_the_command_line_are_keys_of_the_lot_file) {
  write("a.csv", csv(record()) + "\nTested by A. Smith\n");
  auto const words = inspected({"a.csv", "--rows", "101:500", "--from", "1.5", "--to", "4", "--footer", "skip",
                                "--thousands", "'", "--date-order", "dmy"});
  write("lot.toml",
        "[read]\nrows = \"101:500\"\nfrom = 1.5\nto = 4\nfooter = \"skip\"\nthousands = \"'\"\ndate-order = \"dmy\"\n"
        "[[device]]\nname = \"a\"\nfile = \"a.csv\"\n");
  auto const lot = inspected({"lot.toml"});
  EXPECT_EQ(lot, words);
  EXPECT_EQ(lot["samples"], 251);
  EXPECT_TRUE(contains(said(lot), "rows 101 to 500 of 601 are read (--rows 101:500)"));
  EXPECT_TRUE(contains(said(lot), "samples 51 to 301 of 400 are read (--from 1.5 --to 4)"));
  EXPECT_TRUE(contains(said(lot), "(--footer skip)"));
}

// isolaw lists the details of how it read a file. If the user stated a detail, its line ends with the option in
// brackets. If isolaw recognised the detail itself, the line has no option.
TEST_F(Parts, what_the_program_was_told_stands_with_its_option) {
  auto const told = [&](Words const& words) {
    Words found;
    auto const all = inspected(words);
    for (auto const& line : all["recognised"])
      if (auto const text = line.get<std::string>(); contains(text, "(--")) found.push_back(text);
    return found;
  };
  write("a.csv", csv(record()));
  write("footer.csv", csv(record()) + "\nTested by A. Smith\n");
  write("bare.csv", csv(record(), "time,displacement,force"));
  write("force.csv", channel(true));
  write("disp.csv", channel(false));
  write("up.csv", csv(record(), "time [s],displacement [mm],force [kN]", [](std::size_t, Sample const& s) {
          return fmt::format("{:.4f},{:.5f},{:.5f}", s.time_s, s.disp_mm, -s.force_kN);
        }));
  write("grouped.csv", csv(record(), "time [s],displacement [mm],force [N]", [](std::size_t, Sample const& s) {
          auto const newton = static_cast<int>(1000.0 * std::abs(s.force_kN));
          return fmt::format(
              "{:.4f},{:.5f},{}{}", s.time_s, s.disp_mm, s.force_kN < 0.0 ? "-" : "",
              newton < 1000 ? fmt::format("{}", newton) : fmt::format("{}'{:03}", newton / 1000, newton % 1000));
        }));
  write("dates.csv", csv(record(), "Date/Time,displacement [mm],force [kN]", [](std::size_t, Sample const& s) {
          return fmt::format("05/06/2024 10:00:{:06.3f},{:.5f},{:.5f}", s.time_s, s.disp_mm, s.force_kN);
        }));
  EXPECT_EQ(told({"a.csv"}), Words{});
  std::vector<std::pair<Words, std::string>> const options{
      {{"a.csv", "--rows", "101:500"}, "rows"},
      {{"a.csv", "--from", "1"}, "from"},
      {{"a.csv", "--to", "5"}, "to"},
      {{"a.csv", "--columns", "time=none"}, "columns"},
      {{"footer.csv", "--footer", "skip"}, "footer"},
      {{"grouped.csv", "--thousands", "'"}, "thousands"},
      {{"dates.csv", "--date-order", "dmy"}, "date-order"},
      {{"bare.csv", "--units", "time=s,disp=mm,force=kN"}, "units"},
      {{"disp.csv", "--columns", "force=force.csv:force"}, "columns"},
      {{"up.csv", "--flip-force"}, "flip-force"}};
  for (auto const& [words, option] : options) {
    auto const lines = told(words);
    EXPECT_EQ(lines.size(), 1u) << option;
    for (auto const& line : lines) EXPECT_TRUE(contains(line, "(--" + option)) << line;
  }
}

TEST_F(Parts, values_that_are_not_allowed_are_refused_with_those_that_are) {
  write("a.csv", csv(record()));
  expect_refused(isolaw({"inspect", "a.csv", "--rows", "5"}), {"--rows: '5'", "allowed: A:B", "try: --rows 101:700"});
  expect_refused(isolaw({"inspect", "a.csv", "--footer", "keep"}), {"--footer: 'keep'", "allowed: 'skip'"});
  expect_refused(isolaw({"inspect", "a.csv", "--thousands", ";"}),
                 {"--thousands: ';'", "',' or '.' or ''' or 'blank'"});
  expect_refused(isolaw({"inspect", "a.csv", "--date-order", "ymd"}), {"--date-order: 'ymd'", "'dmy' or 'mdy'"});
}

TEST_F(Parts, displacement_and_force_in_two_files_also_from_a_lot_file) {
  write("recs/disp.csv", channel(false));
  write("recs/force.csv", channel(true));
  write("recs/both.csv", csv(record()));
  auto const both = inspected({"recs/both.csv"});
  auto const joined = inspected({"recs/disp.csv", "--columns", "force=recs/force.csv:force"});
  EXPECT_EQ(joined["blocks"], both["blocks"]);
  write("recs/lot.toml", "[[device]]\nname = \"a\"\nfile = \"disp.csv\"\ncolumns = { force = \"force.csv:force\" }\n");
  auto const lot = inspected({"recs/lot.toml"});
  EXPECT_EQ(lot["blocks"], both["blocks"]);
  EXPECT_TRUE(contains(said(lot), "force.csv is joined to disp.csv, row by row")) << "named as in the lot file";
  // init must write the name of the force file relative to the lot file.
  auto const output =
      isolaw({"init", "recs/disp.csv", "--columns", "force=recs/force.csv:force", "--out", "recs/made.toml"});
  EXPECT_EQ(output.code, 0) << output;
  EXPECT_TRUE(contains(read("recs/made.toml"), "force = 'force.csv:force [kN]'"));
  EXPECT_EQ(inspected({"recs/made.toml"})["blocks"], both["blocks"]);
}

TEST_F(Parts, a_lot_file_names_no_file_outside_for_a_channel_either) {
  write("force.csv", channel(true));
  write("lot/disp.csv", channel(false));
  write("lot/lot.toml",
        "[[device]]\nname = \"a\"\nfile = \"disp.csv\"\ncolumns = { force = \"../force.csv:force\" }\n");
  expect_refused(isolaw({"inspect", "lot/lot.toml"}),
                 {"lot/lot.toml:1: columns: '../force.csv' leads outside", "--allow-outside on the command line"});
  EXPECT_EQ(isolaw({"inspect", "lot/lot.toml", "--allow-outside"}).code, 0);
}

// A lot file may take the force from a second file. init --like does not copy the name of that file to another lot.
TEST_F(Parts, like_another_lot_takes_no_file_of_it) {
  write("recs/disp.csv", channel(false));
  write("recs/force.csv", channel(true));
  write("recs/lot.toml",
        "[read]\ncolumns = { disp = 2, force = \"force.csv:force\" }\n[[device]]\nname = \"a\"\nfile = \"disp.csv\"\n");
  write("next/b.csv", csv(record({.strength_kN = 30.0})));
  auto const o = isolaw({"init", "next", "--like", "recs/lot.toml", "--out", "next/lot.toml"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.err, "columns force = 'force.csv:force' of recs/lot.toml not taken over")) << o;
  EXPECT_FALSE(contains(read("next/lot.toml"), "force.csv"));
  EXPECT_EQ(inspected({"next/lot.toml"})["blocks"], inspected({"next/b.csv"})["blocks"]);
}

// The force comes from a second file. init must not replace that file, and must warn if the file lies outside the lot's
// folder. The content of the file is part of the device's hash.
TEST_F(Parts, the_file_of_a_channel_is_a_file_of_the_device) {
  write("recs/disp.csv", channel(false));
  write("force.csv", channel(true));
  auto const force = read("force.csv");
  Words const init{"init", "recs/disp.csv", "--columns", "force=force.csv:force", "--force", "--out"};
  expect_message(isolaw(init + Words{"force.csv"}), 2,
                 {"force.csv: is an input of this command and would be replaced"});
  EXPECT_EQ(read("force.csv"), force);
  auto const o = isolaw(init + Words{"recs/lot.toml"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.err, "force.csv: not in the folder of recs/lot.toml or below it")) << o;
  write("recs/force.csv", "no record\n");
  write("recs/good.csv", csv(record()));
  write("recs/two.toml",
        "[[device]]\nname = \"good\"\nfile = \"good.csv\"\n[[device]]\nname = \"bad\"\nfile = \"disp.csv\"\n"
        "columns = { force = \"force.csv:force\" }\n");
  auto const hash = [&] {
    return Json::parse(isolaw({"inspect", "recs/two.toml", "--json"}).out)["devices"][1]["sha256"];
  };
  auto const before = hash();
  write("recs/force.csv", "another\n");
  EXPECT_NE(hash(), before);
}

TEST_F(Parts, a_motion_may_be_one_column) {
  std::string motion = "Displacement [mm]\n";
  for (auto const& s : record()) motion += fmt::format("{:.5f}\n", s.disp_mm);
  write("u.txt", motion);
  auto const o = isolaw({"simulate", "bilinear", "--set", "K1=2", "--set", "K2=0.5", "--set", "xy=10", "--motion",
                         "u.txt", "--dt", "0.01"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_EQ(count_of("\n", o.out), 602u);
  expect_refused(
      isolaw({"simulate", "bilinear", "--set", "K1=2", "--set", "K2=0.5", "--set", "xy=10", "--motion", "u.txt"}),
      {"u.txt: one column of numbers", "--dt SECONDS for a motion"});
}

// --- init -----------------------------------------------------------------------------------------------------------

TEST_F(Parts, init_goes_on_past_files_that_are_no_records) {
  write("recs/a.csv", csv(record()));
  write("recs/b.csv", "no record\n");
  write("recs/c.csv", csv(record(), "time [s],displacement,force [kN]"));
  auto const o = isolaw({"init", "recs", "--out", "recs/lot.toml"});
  EXPECT_EQ(o.code, 1) << o;
  EXPECT_TRUE(contains(o.err, "recs/b.csv: no rows of numbers"));
  EXPECT_TRUE(contains(o.err, "column 2 'displacement' (disp) has no unit"));
  EXPECT_TRUE(contains(o.err, "2 of 3 left out, as comments at the end of recs/lot.toml"));
  auto const lot = read("recs/lot.toml");
  EXPECT_EQ(count_of("[[device]]", lot), 1u);
  EXPECT_TRUE(contains(lot, "# file = 'b.csv'  # recs/b.csv: no rows of numbers"));
  EXPECT_TRUE(contains(lot, "# file = 'c.csv'  # "));
  EXPECT_EQ(inspected({"recs/lot.toml"})["samples"], 601);
  fs::remove(path("recs/a.csv"));
  expect_refused(isolaw({"init", "recs", "--out", "recs/other.toml"}),
                 {"recs/b.csv: no rows of numbers", "recs/c.csv:1"});
  EXPECT_FALSE(exists("recs/other.toml"));
}

TEST_F(Parts, init_fills_the_keys_that_headers_say_and_writes_the_others_as_comments) {
  auto const rows = csv(record());
  write("a.csv",
        "Serial No: S-101\nBatch,L7\nTest date: 2024-05-02\nTemperature: 73.4 \xC2\xB0"
        "F\nTotal rubber thickness: 20.8 cm\nRubber area [cm2],2827.43\n" +
            rows);
  write("b.csv",
        "Seriennummer: 17\nPr\xC3\xBC"
        "fdatum: 03.05.2024\nRaumtemperatur: 23\n" +
            rows);
  write("c.csv", "Matricola: M 1\nTemperatura di prova: 22,5 C\n" + rows);
  write("d.csv", "試験体番号：LRB-7\n試験温度,23 ℃\n試験日,2024/5/2\nロット番号,12\nゴム総厚さ,208 mm\n" + rows);
  write("e.csv",
        "Seri No: IZ-3\nDeney tarihi: 2024-05-02\nS\xC4\xB1"
        "cakl\xC4\xB1k: 21 \xC2\xB0"
        "C\n" +
            rows);
  auto const o = isolaw({"init", "a.csv", "b.csv", "c.csv", "d.csv", "e.csv"});
  EXPECT_EQ(o.code, 0) << o;
  auto const text = read("lot.toml");
  auto const part = [&](std::string const& name) {
    auto const at = text.find("file = '" + name);
    return text.substr(at, text.find("[[device]]", at) - at);
  };
  for (auto const* line : {"serial = 'S-101'", "lot = 'L7'", "test-date = '2024-05-02'", "temperature-C = 23.",
                           "rubber-thickness-mm = 208.0", "rubber-area-mm2 = 282743.0"})
    EXPECT_TRUE(contains(part("a.csv"), line));
  for (auto const* line : {"serial = '17'", "test-date = '03.05.2024'", "# temperature-C = 0.0  # the file says: 23",
                           "# lot = \"\"", "# rubber-thickness-mm = 0.0", "# rubber-area-mm2 = 0.0"})
    EXPECT_TRUE(contains(part("b.csv"), line));
  for (auto const* line : {"serial = 'M 1'", "temperature-C = 22.5"}) EXPECT_TRUE(contains(part("c.csv"), line));
  for (auto const* line : {"serial = 'LRB-7'", "temperature-C = 23.0", "test-date = '2024/5/2'", "lot = '12'",
                           "rubber-thickness-mm = 208.0"})
    EXPECT_TRUE(contains(part("d.csv"), line));
  for (auto const* line : {"serial = 'IZ-3'", "temperature-C = 21.0", "test-date = '2024-05-02'"})
    EXPECT_TRUE(contains(part("e.csv"), line));
  EXPECT_EQ(inspected({"lot.toml"})["devices"].size(), 5u);
}

// --- titles of lots, and exit codes -------------------------------------------------------------------------------

TEST_F(Parts, several_files_are_called_by_their_folder_or_their_number) {
  for (auto const* name : {"lot-7/a.csv", "lot-7/b.csv", "other/c.csv"})
    write(name, csv(record({.amplitude_mm = 90.0 + static_cast<double>(name[6])})));
  EXPECT_EQ(inspected({"lot-7/a.csv", "lot-7/b.csv"})["title"], "lot-7");
  EXPECT_EQ(inspected({"lot-7/a.csv", "other/c.csv"})["title"], "2 records");
  auto const o = isolaw(Words{"calibrate", "lot-7/a.csv", "lot-7/b.csv"} + smallest_search);
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_EQ(json("out/lot-7/summary.json")["title"], "lot-7");
}

TEST_F(Parts, nothing_usable_is_an_error_of_several_files_too) {
  write("a.csv", "no record\n");
  write("b.csv", csv(record(), "time [s],displacement,force [kN]"));
  auto const o = isolaw({"inspect", "a.csv", "b.csv"});
  expect_message(o, 2, {"none of 2 records can be used"});
  EXPECT_TRUE(contains(o.out, "no rows of numbers"));
  write("c.csv", csv(record()));
  EXPECT_EQ(isolaw({"inspect", "a.csv", "c.csv"}).code, 1);
}

// inspect advises 100 samples per cycle or more. A record with a hundred must not get this advice, although its
// measured period gives 99.99.
TEST_F(Parts, a_hundred_samples_a_cycle_are_enough) {
  write("a.csv", csv(record({.samples = 301, .per_cycle = 100})));
  auto const o = isolaw({"inspect", "a.csv"});
  EXPECT_TRUE(contains(o.out, "100.0 samples per cycle"));
  EXPECT_EQ(o.out.find(" or more."), std::string::npos) << o;
  write("b.csv", csv(record({.samples = 298, .per_cycle = 99})));
  EXPECT_TRUE(contains(isolaw({"inspect", "b.csv"}).out, " Use 100 or more."));
}

}  // namespace
}  // namespace isolaw::cli_test
