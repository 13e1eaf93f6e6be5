// Names and places that break careless programs.
#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

Words const small{"--laws", "bilinear", "--runs", "1", "--population", "4", "--generations", "1"};

class Hostile : public InFreshDirectory {};

TEST_F(Hostile, file_name_with_quotes_blanks_and_html_is_read_and_ends_escaped_in_the_page) {
  std::string const stem = "it's \"q\" <img src=x onerror=alert(1)> &amp; \xC3\xA9";
  write(stem + ".csv", csv(record()));
  auto const o = isolaw(Words{"calibrate", stem + ".csv", "--out", "O"} + small);
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
  auto const o = isolaw(Words{"calibrate", "lot.toml", "--out", "O"} + small);
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_EQ(json("O/summary.json")["devices"][0]["file"], name);
}

TEST_F(Hostile, title_and_device_name_that_close_tags_stay_text_in_the_page) {
  write("a.csv", csv(record()));
  write("lot.toml",
        "title = \"</title><script>alert(2)</script>{{data}}\"\n[[device]]\nname = "
        "\"</script><script>alert(1)</script>\"\n"
        "file = \"a.csv\"\nserial = \"<!--<script>\"\n");
  auto const o = isolaw(Words{"calibrate", "lot.toml", "--out", "O"} + small);
  EXPECT_EQ(o.code, 0) << o;
  auto const page = read("O/report.html");
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_EQ(page.find("</script><script>alert"), std::string::npos);
  EXPECT_EQ(page.find("<!--<script>"), std::string::npos);
  EXPECT_TRUE(contains(page, "\\u003c/script>\\u003cscript>alert(1)"));
  EXPECT_TRUE(contains(page.substr(0, 2000), "{{data}}"));  // text, not filled in
}

TEST_F(Hostile, refusal_quotes_the_files_text_escaped) {
  write("a.csv", csv(record()));
  write("b.csv", csv_with_line(50, "0.4800,<script>alert(3)</script>,1"));
  auto const o = isolaw(Words{"calibrate", "a.csv", "b.csv", "--out", "O"} + small);
  EXPECT_EQ(o.code, 1) << o;
  EXPECT_TRUE(contains(json("O/summary.json")["devices"][1]["message"].get<std::string>(), "<script>alert(3)"));
  EXPECT_EQ(read("O/report.html").find("<script>alert(3)"), std::string::npos);
}

TEST_F(Hostile, names_that_spreadsheets_would_calculate_are_text_in_the_tables) {
  write("=1+2.csv", csv(record()));
  write("@x.csv", csv(record()));
  auto const o = isolaw(Words{"calibrate", "=1+2.csv", "@x.csv", "--out", "O"} + small);
  EXPECT_EQ(o.code, 0) << o;
  auto const table = read("O/tables/objective.csv");
  EXPECT_TRUE(contains(table, "bilinear,'=1+2,"));
  EXPECT_TRUE(contains(table, "bilinear,'@x,"));
}

TEST_F(Hostile, file_name_that_looks_like_an_option_is_read_after_two_dashes) {
  write("-x.csv", csv(record()));
  EXPECT_EQ(isolaw(Words{"calibrate", "--out", "O"} + small + Words{"--", "-x.csv"}).code, 0);
  EXPECT_EQ(isolaw({"inspect", "./-x.csv"}).code, 0);
}

TEST_F(Hostile, file_name_that_is_no_utf8_gives_valid_json) {
  write("bad\xff.csv", csv(record()));
  auto const o = isolaw(Words{"calibrate", "bad\xff.csv", "--out", "O", "--json"} + small);
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(Json::accept(o.out)) << o;
}

TEST_F(Hostile, equal_names_in_two_folders_are_told_apart) {
  for (auto const* folder : {"one", "two"}) write(fs::path(folder) / "test.csv", csv(record()));
  auto const o = isolaw(Words{"calibrate", "one/test.csv", "two/test.csv", "--out", "O"} + small);
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_EQ(json("O/summary.json")["devices"][0]["name"], "test");
  EXPECT_EQ(json("O/summary.json")["devices"][1]["name"], "two/test");
}

TEST_F(Hostile, output_into_a_file_is_refused_and_the_file_kept) {
  write("a.csv", csv(record()));
  write("taken", "mine");
  expect_refused(isolaw(Words{"calibrate", "a.csv", "--out", "taken"} + small),
                 {"taken", "cannot make the directory", "--out DIR"});
  expect_refused(isolaw(Words{"calibrate", "a.csv", "--out", "taken/deeper"} + small),
                 {"taken/deeper", "cannot make the directory"});
  EXPECT_EQ(read("taken"), "mine");
}

TEST_F(Hostile, output_of_no_name_is_refused) {
  write("a.csv", csv(record()));
  expect_refused(isolaw(Words{"calibrate", "a.csv", "--out", ""} + small), {"--out DIR"});
}

TEST_F(Hostile, output_that_is_in_the_way_is_named) {
  write("a.csv", csv(record()));
  fs::create_directories(path("O/summary.json"));
  expect_message(isolaw(Words{"calibrate", "a.csv", "--out", "O"} + small), 2,
                 {"O/summary.json", "cannot be written", "another output directory"});
  write("P/tables", "mine");
  expect_message(isolaw(Words{"calibrate", "a.csv", "--out", "P"} + small), 2, {"P/tables", "cannot be written"});
  EXPECT_EQ(read("P/tables"), "mine");
}

TEST_F(Hostile, store_that_cannot_be_opened_is_named) {
  write("a.csv", csv(record()));
  fs::create_directories(path("O/campaign.sqlite"));
  expect_message(isolaw(Words{"calibrate", "a.csv", "--out", "O"} + small), 2, {"O/campaign.sqlite"});
}

TEST_F(Hostile, read_only_output_directory_is_refused) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  write("a.csv", csv(record()));
  fs::create_directory(path("O"));
  fs::permissions(path("O"), fs::perms::owner_read | fs::perms::owner_exec);
  auto const o = isolaw(Words{"calibrate", "a.csv", "--out", "O"} + small);
  expect_message(o, 2, {"O/campaign.sqlite", "permissions"});
  fs::permissions(path("O"), fs::perms::owner_all);
}

TEST_F(Hostile, output_directories_are_made_as_deep_as_asked) {
  write("a.csv", csv(record()));
  EXPECT_EQ(isolaw(Words{"calibrate", "a.csv", "--out", "x/y z/O"} + small).code, 0);
  EXPECT_TRUE(exists("x/y z/O/report.html"));
}

TEST_F(Hostile, report_opens_nothing_on_the_network) {
  write("a.csv", csv(record()));
  ASSERT_EQ(isolaw(Words{"calibrate", "a.csv", "--out", "O"} + small).code, 0);
  auto const page = read("O/report.html");
  for (auto const* part : {"<script src", "<link", "<iframe", "@import"})
    EXPECT_EQ(page.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace isolaw::cli_test
