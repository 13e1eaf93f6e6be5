// Gives isolaw names and paths that would break a careless program.
#include <sys/stat.h>

#include <algorithm>

#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"
#include "isolaw/campaign/settings.hpp"

namespace isolaw::cli_test {
namespace {

class Hostile : public InFreshDirectory {};

void expect_no_control_characters(Outcome const& o) {
  for (auto const& text : {o.out, o.err}) {
    auto const found = std::ranges::find_if(
        text, [](char c) { return (static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == '\x7f' || c == '\x9b'; });
    EXPECT_EQ(found, text.end()) << "byte " << found - text.begin() << "\n" << o;
  }
}

TEST_F(Hostile, file_name_with_quotes_blanks_and_html_is_read_and_ends_escaped_in_the_page) {
  std::string const stem = "it's \"q\" <img src=x onerror=alert(1)> &amp; \xC3\xA9";
  write(stem + ".csv", csv(record()));
  auto const o = isolaw(Words{"calibrate", stem + ".csv", "--out", "O"} + smallest_search);
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_EQ(json("O/summary.json")["devices"][0]["name"], stem);
  EXPECT_EQ(json("O/summary.json")["devices"][0]["file"], stem + ".csv");
  auto const page = read("O/report.html");
  EXPECT_EQ(page.find("<img src=x"), std::string::npos);
  EXPECT_TRUE(contains(page.substr(0, 2000), "it&#39;s &quot;q&quot; &lt;img src=x onerror=alert(1)&gt; &amp;amp;"));
  EXPECT_TRUE(contains(read("O/tables/objective.csv"), "\"it's \"\"q\"\" <img"));
  EXPECT_TRUE(contains(json("O/run.json")["command"].get<std::string>(), "'it'\\''s \"q\" <img"));
}

TEST_F(Hostile, file_name_with_quotes_and_html_goes_through_a_lot_file) {
  std::string const name = "it's \"q\" <b>.csv";
  write(name, csv(record()));
  ASSERT_EQ(isolaw({"init", name}).code, 0);
  auto const o = isolaw(Words{"calibrate", "lot.toml", "--out", "O"} + smallest_search);
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_EQ(json("O/summary.json")["devices"][0]["file"], name);
}

TEST_F(Hostile, title_and_device_name_that_close_tags_stay_text_in_the_page) {
  write("a.csv", csv(record()));
  write(
      "lot.toml",
      "title = \"</title><script>alert(2)</script>{{data}}\"\n[[device]]\nname = \"</script><script>alert(1)</script>\"\n"
      "file = \"a.csv\"\nserial = \"<!--<script>\"\n");
  auto const o = isolaw(Words{"calibrate", "lot.toml", "--out", "O"} + smallest_search);
  EXPECT_EQ(o.code, 0) << o;
  auto const page = read("O/report.html");
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_EQ(page.find("</script><script>alert"), std::string::npos);
  EXPECT_EQ(page.find("<!--<script>"), std::string::npos);
  EXPECT_TRUE(contains(page, "\\u003c/script>\\u003cscript>alert(1)"));
  // isolaw makes the page from a template and puts the data in place of {{data}} there. A title that contains
  // {{data}} must stay as it is.
  EXPECT_TRUE(contains(page.substr(0, 2000), "{{data}}"));
}

TEST_F(Hostile, refusal_quotes_the_files_text_escaped) {
  write("a.csv", csv(record()));
  write("b.csv", csv_with_line(50, "0.4800,<script>alert(3)</script>,1"));
  auto const o = isolaw(Words{"calibrate", "a.csv", "b.csv", "--out", "O"} + smallest_search);
  EXPECT_EQ(o.code, 1) << o;
  EXPECT_TRUE(contains(json("O/summary.json")["devices"][1]["message"].get<std::string>(), "<script>alert(3)"));
  EXPECT_EQ(read("O/report.html").find("<script>alert(3)"), std::string::npos);
}

TEST_F(Hostile, names_that_spreadsheets_would_calculate_are_text_in_the_tables) {
  write("=1+2.csv", csv(record()));
  write("@x.csv", csv(record()));
  auto const o = isolaw(Words{"calibrate", "=1+2.csv", "@x.csv", "--out", "O"} + smallest_search);
  EXPECT_EQ(o.code, 0) << o;
  auto const table = read("O/tables/objective.csv");
  EXPECT_TRUE(contains(table, "bilinear,'=1+2,"));
  EXPECT_TRUE(contains(table, "bilinear,'@x,"));
}

TEST_F(Hostile, file_name_that_looks_like_an_option_is_read_after_two_dashes) {
  write("-x.csv", csv(record()));
  EXPECT_EQ(isolaw(Words{"calibrate", "--out", "O"} + smallest_search + Words{"--", "-x.csv"}).code, 0);
  EXPECT_EQ(isolaw({"inspect", "./-x.csv"}).code, 0);
}

TEST_F(Hostile, file_name_that_is_no_utf8_gives_valid_json) {
  write("bad\xff.csv", csv(record()));
  auto const o = isolaw(Words{"calibrate", "bad\xff.csv", "--out", "O", "--json"} + smallest_search);
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(Json::accept(o.out)) << o;
}

TEST_F(Hostile, equal_names_in_two_folders_are_told_apart) {
  for (auto const* folder : {"one", "two"}) write(fs::path(folder) / "test.csv", csv(record()));
  auto const o = isolaw(Words{"calibrate", "one/test.csv", "two/test.csv", "--out", "O"} + smallest_search);
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_EQ(json("O/summary.json")["devices"][0]["name"], "test");
  EXPECT_EQ(json("O/summary.json")["devices"][1]["name"], "two/test");
}

TEST_F(Hostile, output_into_a_file_is_refused_and_the_file_kept) {
  write("a.csv", csv(record()));
  write("taken", "mine");
  expect_refused(isolaw(Words{"calibrate", "a.csv", "--out", "taken"} + smallest_search),
                 {"taken", "cannot make the directory", "--out DIR"});
  expect_refused(isolaw(Words{"calibrate", "a.csv", "--out", "taken/deeper"} + smallest_search),
                 {"taken/deeper", "cannot make the directory"});
  EXPECT_EQ(read("taken"), "mine");
}

TEST_F(Hostile, output_of_no_name_is_refused) {
  write("a.csv", csv(record()));
  expect_refused(isolaw(Words{"calibrate", "a.csv", "--out", ""} + smallest_search), {"--out DIR"});
}

TEST_F(Hostile, output_that_is_in_the_way_is_named) {
  write("a.csv", csv(record()));
  fs::create_directories(path("O/summary.json"));
  expect_message(isolaw(Words{"calibrate", "a.csv", "--out", "O"} + smallest_search), 2,
                 {"O/summary.json", "cannot be written", "another output directory"});
  write("P/tables", "mine");
  expect_message(isolaw(Words{"calibrate", "a.csv", "--out", "P"} + smallest_search), 2,
                 {"P/tables", "cannot be written"});
  EXPECT_EQ(read("P/tables"), "mine");
}

TEST_F(Hostile, store_that_cannot_be_opened_is_named) {
  write("a.csv", csv(record()));
  fs::create_directories(path("O/campaign.sqlite"));
  expect_message(isolaw(Words{"calibrate", "a.csv", "--out", "O"} + smallest_search), 2, {"O/campaign.sqlite"});
}

TEST_F(Hostile, read_only_output_directory_is_refused) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  write("a.csv", csv(record()));
  fs::create_directory(path("O"));
  fs::permissions(path("O"), fs::perms::owner_read | fs::perms::owner_exec);
  auto const o = isolaw(Words{"calibrate", "a.csv", "--out", "O"} + smallest_search);
  expect_message(o, 2, {"O/campaign.sqlite", "permissions"});
  fs::permissions(path("O"), fs::perms::owner_all);
}

TEST_F(Hostile, output_directories_are_made_as_deep_as_asked) {
  write("a.csv", csv(record()));
  EXPECT_EQ(isolaw(Words{"calibrate", "a.csv", "--out", "x/y z/O"} + smallest_search).code, 0);
  EXPECT_TRUE(exists("x/y z/O/report.html"));
}

// --- hostile names of devices and files ---------------------------------------------------------------------------

TEST_F(Hostile, device_name_with_quotes_html_and_sql_is_kept_and_shown_as_text) {
  write("a.csv", csv(record()));
  std::string const name = "'; DROP TABLE run; -- \"<b onclick=x>\" ,;|{{data}}";
  write("lot.toml",
        "[[device]]\nname = " + Json(name).dump() + "\nfile = 'a.csv'\nserial = \"'); DELETE FROM device; --\"\n");
  auto const o = isolaw(Words{"calibrate", "lot.toml", "--out", "O"} + smallest_search);
  EXPECT_EQ(o.code, 0) << o;
  auto const store = path("O/campaign.sqlite");
  EXPECT_EQ(query(store, "SELECT name, serial FROM device"), Words{name + "|'); DELETE FROM device; --"});
  EXPECT_EQ(query(store, "SELECT count(*) FROM run"), Words{"1"});
  EXPECT_EQ(json("O/summary.json")["devices"][0]["name"], name);
  EXPECT_EQ(read("O/report.html").find("<b onclick"), std::string::npos);
  EXPECT_TRUE(contains(read("O/tables/objective.csv"), "\"\"<b onclick=x>\"\" ,;|"));
  EXPECT_EQ(isolaw({"report", "O"}).code, 0);
}

TEST_F(Hostile, control_characters_in_a_lot_file_are_refused) {
  write("a.csv", csv(record()));
  write("lot.toml", "title = \"T\\u0007\"\n[[device]]\nname = \"a\\u001b[2J\"\nfile = \"a.csv\"\nserial = \"1\\n2\"\n");
  auto const o = isolaw(Words{"calibrate", "lot.toml", "--out", "O"} + smallest_search);
  expect_refused(o, {"lot.toml:1: title: 'T\\x07' holds control characters", "lot.toml:3: name: 'a\\x1b[2J'",
                     "lot.toml:5: serial: '1\\n2'", "allowed: printable text"});
  expect_no_control_characters(o);
}

TEST_F(Hostile, control_characters_in_a_record_or_its_name_do_not_reach_the_terminal) {
  std::string const head = "time\x1b]0;owned\x07 [s],displacement\x1b\x1b [mm],force\xc2\x9b [kN]";
  for (std::string const name : {"a\x1b[31m.csv", "b\n.csv", "c.csv"}) {
    write(name, csv(record(), head));
    auto const inspected = isolaw({"inspect", name});
    EXPECT_EQ(inspected.code, 0) << inspected;
    expect_no_control_characters(inspected);
    auto const o = isolaw(Words{"calibrate", name, "--out", "O", "--fresh"} + smallest_search);
    EXPECT_EQ(o.code, 0) << o;
    expect_no_control_characters(o);
    expect_no_control_characters(isolaw({"report", "O"}));
  }
  write("d.csv", csv_with_line(50, "0.4800,\x1b[31m\x07,1"));
  auto const o = isolaw({"inspect", "d.csv"});
  expect_refused(o, {"d.csv:50: '\\x1b[31m\\x07' in column 2"});
  expect_no_control_characters(o);
  for (Words const& wrong : {Words{"calibrate", "--\x1b[31m"}, Words{"\x1b[31m"}, Words{"laws", "\x1b[31m"},
                             Words{"inspect", "\x1b[31m"}, Words{"calibrate", "x", "--runs", "\x1b[31m"}})
    expect_no_control_characters(isolaw(wrong));
}

TEST_F(Hostile, init_of_a_name_no_lot_file_can_hold_is_refused) {
  write("a\x1b[31m.csv", csv(record()));
  auto const o = isolaw({"init", "a\x1b[31m.csv"});
  expect_refused(o, {"a\\x1b[31m.csv: a file name that no lot file can hold", "try: rename the file"});
  EXPECT_FALSE(exists("lot.toml"));
}

// --- paths outside the lot's folder -------------------------------------------------------------------------------

TEST_F(Hostile, lot_file_cannot_read_outside_its_folder) {
  write("secret.csv", csv(record()));
  write("lot/a.csv", csv(record()));
  fs::create_symlink("../secret.csv", path("lot/link.csv"));
  fs::create_directory_symlink("..", path("lot/up"));
  for (auto const& file : Words{"../secret.csv", "link.csv", "up/secret.csv", path("secret.csv").string()}) {
    write("lot/lot.toml", "[[device]]\nname = \"a\"\nfile = \"" + file + "\"\n");
    expect_refused(isolaw(Words{"calibrate", "lot/lot.toml", "--out", "O"} + smallest_search),
                   {"lot/lot.toml:3: file: '", "leads outside, to " + fs::canonical(path("secret.csv")).string(),
                    "allowed: a file in the folder of the lot file or below it", "--allow-outside"});
    EXPECT_FALSE(exists("O"));
  }
  EXPECT_EQ(isolaw(Words{"calibrate", "lot/lot.toml", "--out", "O", "--allow-outside"} + smallest_search).code, 0);
  write("lot/lot.toml", "[calibrate]\nallow-outside = true\n[[device]]\nfile = \"a.csv\"\n");
  expect_refused(isolaw({"calibrate", "lot/lot.toml"}), {"unknown key 'allow-outside'"});
}

TEST_F(Hostile, lot_file_cannot_write_outside_the_current_directory) {
  write("work/a.csv", csv(record()));
  fs::create_directory(path("elsewhere"));
  fs::create_directory_symlink("../elsewhere", path("work/link"));
  fs::create_directory_symlink("../not-yet", path("work/dangling"));
  auto const in_work = [&](Words const& words) { return isolaw_in(path("work"), words); };
  for (std::string const out : {"../elsewhere", "/tmp/isolaw-x", "link", "link/deep", "dangling", "."}) {
    write("work/lot.toml", "[calibrate]\nout = \"" + out + "\"\n[[device]]\nfile = \"a.csv\"\n");
    expect_refused(in_work(Words{"calibrate", "lot.toml"} + smallest_search),
                   {"lot.toml:2: out: '" + out + "'", "a directory below the current one", "--out DIR"});
  }
  EXPECT_TRUE(fs::is_empty(path("elsewhere")));
  EXPECT_FALSE(exists("not-yet"));
  EXPECT_EQ(in_work(Words{"calibrate", "lot.toml", "--out", "../elsewhere"} + smallest_search).code, 0);
}

TEST_F(Hostile, init_of_files_elsewhere_says_what_calibrate_will_need) {
  write("data/a.csv", csv(record()));
  fs::create_directory(path("lots"));
  auto const o = isolaw({"init", "data/a.csv", "--out", "lots/lot.toml"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.err, "data/a.csv: not in the folder of lots/lot.toml or below it"));
  EXPECT_TRUE(contains(o.err, "--allow-outside"));
  expect_refused(isolaw(Words{"calibrate", "lots/lot.toml", "--out", "O"} + smallest_search), {"leads outside"});
  EXPECT_EQ(isolaw(Words{"calibrate", "lots/lot.toml", "--out", "O", "--allow-outside"} + smallest_search).code, 0);
  EXPECT_EQ(isolaw({"init", "data/a.csv"}).err, "");
}

// --- huge files, special files and large counts -------------------------------------------------------------------

TEST_F(Hostile, special_files_are_refused_at_once) {
  ASSERT_EQ(mkfifo(path("pipe.csv").c_str(), 0600), 0);
  ASSERT_EQ(mkfifo(path("pipe.toml").c_str(), 0600), 0);
  for (auto const& [file, what] : std::vector<std::pair<std::string, std::string>>{{"pipe.csv", "is a pipe"},
                                                                                   {"pipe.toml", "is a pipe"},
                                                                                   {"/dev/zero", "is a device"},
                                                                                   {"/dev/tty", "is a device"}}) {
    auto const o = start({"calibrate", file, "--out", "O"}).wait(20s);
    EXPECT_FALSE(o.timed_out) << file;
    expect_refused(o, {file + ": " + what});
  }
  write("lot.toml", "[[device]]\nfile = \"pipe.csv\"\n");
  expect_refused(start({"calibrate", "lot.toml", "--out", "O"}).wait(20s), {"pipe.csv: is a pipe"});
}

TEST_F(Hostile, files_above_their_size_are_refused_before_they_are_read) {
  for (std::string const name : {"large.csv", "large.toml"}) {
    write(name, "x");
    fs::resize_file(path(name), std::uintmax_t{1} << 40);  // sparse, so it takes no space on the disk
  }
  expect_refused(isolaw({"inspect", "large.csv"}),
                 {"large.csv: is 1024.00 GiB large, above 1 GiB", "one test per file"});
  expect_refused(isolaw({"calibrate", "large.toml"}), {"large.toml: is 1048576.00 MiB large, above 16 MiB"});
}

TEST_F(Hostile, deep_nesting_in_a_lot_file_is_an_error_not_a_crash) {
  std::string dots, brackets;
  for (int i = 0; i < 1'000'000; ++i) dots += "a.", brackets += "[";
  for (auto const& text : {dots + "a = 1\n", "[" + dots + "a]\n", "a = " + brackets}) {
    write("lot.toml", text);
    expect_refused(isolaw({"calibrate", "lot.toml"}), {"lot.toml:1: ", "nested deeper"});
  }
}

TEST_F(Hostile, huge_counts_are_refused_with_what_is_allowed) {
  write("a.csv", csv(record()));
  auto const refused = [&](std::string const& option, std::string const& value, std::string const& allowed) {
    expect_refused(isolaw({"calibrate", "a.csv", "--out", "O", option, value}), {option, value, allowed});
  };
  for (std::string const value : {"1000000000", "-1", "2147483647", "99999999999999999999"}) {
    refused("--runs", value, "1 to 100000");
    refused("--population", value, "4 to 100000");
    refused("--generations", value, "1 to 20000");
    refused("--jobs", value, "0 to 4096");
  }
  refused("--smooth", "-2147483648", "an odd number");
  refused("--samples-per-cycle", "-2147483648", "20 or more, or all");
  refused("--dt", "1e+300", "1e-9 to 1e6");
  for (auto const& [key, value] : std::vector<std::pair<std::string, std::string>>{
           {"runs", "1000000000"}, {"population", "9223372036854775807"}, {"jobs", "100000"}, {"jobs", "-1"}}) {
    write("lot.toml", "[calibrate]\n" + key + " = " + value + "\n[[device]]\nfile = \"a.csv\"\n");
    expect_refused(isolaw({"calibrate", "lot.toml", "--out", "O"}), {"lot.toml:2: ", key});
  }
  EXPECT_FALSE(exists("O"));
}

TEST_F(Hostile, counts_that_are_endless_together_are_refused) {
  std::string text = "[calibrate]\nruns = 100000\n";
  for (int i = 0; i < 20; ++i) text += fmt::format("[[device]]\nfile = \"{}.csv\"\n", i);
  write("lot.toml", text);
  auto const usual = campaign::parse_laws(campaign::usual_laws).size();
  expect_refused(
      isolaw({"calibrate", "lot.toml", "--out", "O"}),
      {fmt::format("--runs: 100000 runs of {} laws on 20 devices are {} runs in all", usual, usual * 2000000),
       "allowed: 10000000 in all"});
}

TEST_F(Hostile, want_of_memory_is_said_plainly) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers take more address space than this";
#endif
  write("long.csv", "x");
  fs::resize_file(path("long.csv"), 1'000'000'000);  // sparse, so it takes no space on the disk
  Process limited({"sh", "-c", "ulimit -v 500000; exec " ISOLAW_BINARY " inspect long.csv"}, directory(), path("out"),
                  path("err"));
  auto const o = limited.wait();
  EXPECT_EQ(o.code, 3) << o;
  EXPECT_TRUE(contains(o.err, "isolaw: out of memory; try: fewer devices"));
}

TEST_F(Hostile, report_opens_nothing_on_the_network) {
  write("a.csv", csv(record()));
  ASSERT_EQ(isolaw(Words{"calibrate", "a.csv", "--out", "O"} + smallest_search).code, 0);
  auto const page = read("O/report.html");
  for (auto const* part : {"<script src", "<link", "<iframe", "@import"})
    EXPECT_EQ(page.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace isolaw::cli_test
