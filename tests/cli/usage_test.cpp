// Tests the help, the version, the refusal of wrong options, and the list of laws.
#include <regex>

#include "cli/published_laws.hpp"
#include "cli/records.hpp"
#include "cli/run.hpp"
#include "isolaw/base/error.hpp"

namespace isolaw::cli_test {
namespace {

class Usage : public InFreshDirectory {};
class Catalogue : public InFreshDirectory {};

TEST_F(Usage, help_lists_every_command_on_stdout) {
  for (auto const* option : {"--help", "-h"}) {
    auto const o = isolaw({option});
    EXPECT_EQ(o.code, 0) << o;
    EXPECT_EQ(o.err, "");
    for (auto const* command : {"calibrate", "init", "inspect", "report", "laws", "example"})
      EXPECT_TRUE(contains(o.out, command));
  }
}

TEST_F(Usage, help_of_calibrate_lists_the_options_that_scripts_rely_on) {
  auto const o = isolaw({"calibrate", "--help"});
  EXPECT_EQ(o.code, 0) << o;
  for (auto const* option : {"--laws", "--method", "--integration", "--runs", "--population", "--generations", "--seed",
                             "--jobs", "--box", "--set", "--columns", "--units", "--dt", "--smooth",
                             "--samples-per-cycle", "--center", "--out", "--json", "--fresh"})
    EXPECT_TRUE(contains(o.out, option));
  std::size_t last = 0;
  for (auto const* heading : {"\nEveryday options:", "\nReading records:", "\nCorrecting for the test rig:",
                              "\nLaws and search:", "\nAnalysis:", "\nAcceptance:", "\nRunning and output:"}) {
    auto const at = o.out.find(heading);
    EXPECT_TRUE(at != std::string::npos && at > last) << heading;
    last = at;
  }
}

TEST_F(Usage, version_says_commit_compiler_instructions_and_build) {
  auto const o = isolaw({"--version"});
  EXPECT_EQ(o.code, 0) << o;
  std::regex const expected("isolaw " ISOLAW_VERSION
                            " \\((commit [0-9a-f]+(, modified)?|unknown commit)\\)\n"
                            "(g|clang)\\+\\+ [0-9.]+, [a-z0-9]+\nbuild [0-9a-f]{12}\n");
  EXPECT_TRUE(std::regex_match(o.out, expected)) << o;
  EXPECT_TRUE(contains(read_file(ISOLAW_SOURCE_DIR "/CITATION.cff"), "\nversion: " ISOLAW_VERSION "\n"));
}

// Returns the commit that cmake/commit.cmake finds for a copy of the sources in `folder`.
std::string commit_of(fs::path const& folder) {
  auto const source = folder / "commit.cpp";
  auto const command = fmt::format("cmake '-DROOT={}' '-DOUTPUT={}' -P '{}/cmake/commit.cmake'", folder.string(),
                                   source.string(), ISOLAW_SOURCE_DIR);
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  auto const text = read_file(source);
  auto const first = text.find('"') + 1;
  return text.substr(first, text.rfind('"') - first);
}

TEST_F(Usage, commit_comes_from_an_archive_or_from_git) {
  write("archive/cmake/COMMIT", "0123abc\n");
  EXPECT_EQ(commit_of(path("archive")), "commit 0123abc");
  write("copy/cmake/COMMIT", "$Format:%h$\n");
  EXPECT_EQ(commit_of(path("copy")), "unknown commit");
  if (std::system("git --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no git";
  auto const git = [&](std::string const& words) {
    auto const command = fmt::format("git -C '{}' -c user.name=a -c user.email=a {}", path("copy").string(), words);
    return std::system(command.c_str());
  };
  ASSERT_EQ(git("init -q") + git("add cmake") + git("commit -q -m a"), 0);
  auto const clean = commit_of(path("copy"));
  EXPECT_TRUE(std::regex_match(clean, std::regex("commit [0-9a-f]+"))) << clean;
  write("copy/cmake/COMMIT", "$Format:%h$\n\n");
  EXPECT_EQ(commit_of(path("copy")), clean + ", modified");
}

TEST_F(Usage, no_command_is_refused) {
  expect_refused(isolaw({}), {"no command given", "--help"});
}

TEST_F(Usage, unknown_command_is_refused_by_name) {
  expect_refused(isolaw({"nonsense"}), {"nonsense"});
}

TEST_F(Usage, unknown_option_is_refused_by_name) {
  expect_refused(isolaw({"calibrate", "lot.toml", "--bogus"}), {"--bogus"});
  expect_refused(isolaw({"laws", "--bogus"}), {"--bogus"});
}

TEST_F(Usage, missing_argument_is_refused_by_name) {
  expect_refused(isolaw({"calibrate"}), {"inputs is required"});
  expect_refused(isolaw({"inspect"}), {"inputs is required"});
  expect_refused(isolaw({"init"}), {"files is required"});
  expect_refused(isolaw({"report"}), {"directory is required"});
  expect_refused(isolaw({"example"}), {"directory is required"});
}

TEST_F(Usage, text_where_a_number_belongs_is_refused) {
  expect_refused(isolaw({"calibrate", "lot.toml", "--runs", "many"}), {"--runs", "many"});
  expect_refused(isolaw({"calibrate", "lot.toml", "--seed", "1.5"}), {"--seed", "1.5"});
  expect_refused(isolaw({"calibrate", "lot.toml", "--runs", "99999999999"}), {"--runs", "99999999999"});
}

TEST_F(Usage, every_refusal_says_who_speaks_what_is_allowed_and_what_to_try) {
  auto const said = [&](Words const& words) {
    auto const o = isolaw(words);
    EXPECT_EQ(o.code, 2) << o;
    EXPECT_TRUE(o.err.starts_with("isolaw: ")) << o;
    EXPECT_EQ(o.out, "");
    EXPECT_TRUE(contains(o.err, "; try: "));
    return o.err;
  };
  EXPECT_TRUE(contains(said({}), "allowed: calibrate, init, inspect, conditions, report"));
  EXPECT_TRUE(contains(said({"calibrat"}), "try: isolaw calibrate, or isolaw --help"));
  EXPECT_TRUE(contains(said({"calibrate", "x", "--rums", "3"}), "isolaw: --rums: no such option; allowed: "));
  EXPECT_TRUE(contains(said({"calibrate", "x", "--rums=3"}), "try: --runs, or isolaw calibrate --help"));
  EXPECT_TRUE(contains(said({"--bogus"}), "isolaw: --bogus: no such option"));
  EXPECT_TRUE(contains(said({"laws", "abe", "vaiana"}), "isolaw: vaiana: one argument too many"));
  EXPECT_TRUE(contains(said({"calibrate"}), "isolaw calibrate: inputs is required; try: isolaw calibrate --help"));
  EXPECT_TRUE(contains(said({"calibrate", "x", "--runs", "many"}),
                       "isolaw: --runs: 'many' is not a whole number; allowed: number of independent searches"));
  EXPECT_TRUE(contains(said({"calibrate", "x", "--jobs", "5000"}), "isolaw: --jobs: '5000' is not allowed; allowed: "));
  EXPECT_TRUE(contains(said({"inspect", "x", "--dt", "fast"}), "isolaw: --dt: 'fast' is not a number"));
  EXPECT_TRUE(contains(said({"sample", "x", "--law", "abe", "--count", "99999999999"}),
                       "isolaw: --count: '99999999999' is out of range"));
  EXPECT_TRUE(contains(said({"calibrate", "x", "--out"}), "isolaw: --out: needs a value"));
}

TEST_F(Usage, a_command_with_json_that_fails_gives_its_complaints_as_an_object) {
  auto const missing =
      expect_refused_as_object(isolaw({"inspect", "no\nsuch.csv", "--json"}), {"no\\nsuch.csv: no such"});
  EXPECT_EQ(missing["error"]["kind"], "input");
  auto const& complaint = missing["error"]["complaints"][0];
  EXPECT_EQ(complaint["where"], "no\\nsuch.csv");
  for (auto const* part : {"where", "found", "allowed", "advice"}) EXPECT_TRUE(complaint[part].is_string()) << part;
  // The JSON object lists the four parts of each complaint, in the order of the messages.
  write("bad.csv", "time [s],displacement [mm],force [kN]\n0,0,0\n1,x,0\n2,0,y\n");
  auto const o = isolaw({"inspect", "bad.csv", "--json"});
  std::string messages;
  auto const several = expect_refused_as_object(o, {"bad.csv"});
  for (auto const& each : several["error"]["complaints"])
    messages += "isolaw: " + to_string(Complaint{each["where"], each["found"], each["allowed"], each["advice"]}) + "\n";
  EXPECT_EQ(messages, o.err);
  EXPECT_EQ(isolaw({"inspect", "bad.csv"}).err, o.err);
  // Wrong options give a JSON object of complaints too. After the word `--`, however, --json is no option, so the
  // complaints must then be plain text.
  auto const usage = expect_refused_as_object(isolaw({"laws", "--json", "--bogus"}), {"--bogus: no such option"});
  EXPECT_EQ(usage["error"]["complaints"][0]["where"], "--bogus");
  expect_refused(isolaw({"laws", "--bogus", "--", "--json"}), {"--bogus"});
  // Standard output already has the result of the command, so the JSON object of complaints must go to standard error.
  write("a.csv", csv(record()));
  write("file", "");
  auto const partial = isolaw({"inspect", "a.csv", "--json", "--out", "file/below"});
  EXPECT_EQ(partial.code, 2) << partial;
  EXPECT_TRUE(Json::parse(partial.out).contains("blocks")) << partial;
  auto const last = partial.err.rfind('\n', partial.err.size() - 2) + 1;
  EXPECT_FALSE(Json::parse(partial.err.substr(last))["error"]["complaints"].empty()) << partial;
}

// The web page runs isolaw with --errors-as-json. Standard error then has the message, followed by the JSON object of
// complaints.
TEST_F(Usage, the_pages_engine_gets_the_object_of_every_command) {
  auto const o = isolaw({"--errors-as-json", "init", "nowhere.csv"});
  expect_refused(o, {"isolaw: nowhere.csv: no such"});
  auto const plain = isolaw({"init", "nowhere.csv"}).err;
  EXPECT_TRUE(o.err.starts_with(plain)) << o;
  EXPECT_EQ(Json::parse(o.err.substr(plain.size()))["error"]["complaints"][0]["where"], "nowhere.csv");
  EXPECT_EQ(isolaw({"--errors-as-json", "laws"}).out, isolaw({"laws"}).out);
  EXPECT_FALSE(contains(isolaw({"--help"}).out, "--errors-as-json"));
}

TEST_F(Usage, output_that_cannot_be_written_is_no_success) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this system";
  write("a.csv", csv(record()));
  Words const campaign{"calibrate",    "a.csv", "--laws",        "bilinear", "--runs", "1",
                       "--population", "4",     "--generations", "1",        "--out",  "O"};
  ASSERT_EQ(isolaw(campaign).code, 0);
  for (Words const& command :
       {Words{"--version"}, Words{"--help"}, Words{"laws"}, Words{"laws", "--json"}, Words{"rules"},
        Words{"rules", "template"}, Words{"example", "E"}, Words{"inspect", "a.csv"},
        Words{"inspect", "a.csv", "--json"}, Words{"init", "a.csv"}, campaign, campaign + Words{"--json"},
        Words{"report", "O"}, Words{"report", "O", "--json"}, Words{"check", "O"}}) {
    Process process(Words{ISOLAW_BINARY} + without_extras(command), directory(), "/dev/full", path("err"));
    auto const o = process.wait();
    SCOPED_TRACE(command.front() + " " + command.back());
    expect_message(o, 3, {"isolaw: standard output cannot be written\n"});
  }
}

// A limit on file sizes cuts the output off. The signal that the system then sends would end isolaw silently. isolaw
// must ignore the signal and print a message.
TEST_F(Usage, output_that_is_cut_is_no_success) {
  write("a.csv", csv(record()));
  ASSERT_EQ(isolaw({"calibrate", "a.csv", "--laws", "bilinear", "--runs", "1", "--population", "4", "--generations",
                    "1", "--out", "O"})
                .code,
            0);
  Process process({"sh", "-c", "ulimit -f 1; exec \"$0\" laws --json > cut.json", ISOLAW_BINARY}, directory(),
                  path("out"), path("err"));
  expect_message(process.wait(), 3, {"standard output cannot be written"});
  Process report({"sh", "-c", "ulimit -f 1; exec \"$0\" report O", ISOLAW_BINARY}, directory(), path("out"),
                 path("err"));
  expect_message(report.wait(), 2, {"cannot be written: File too large", "; try: "});
}

TEST_F(Usage, an_option_given_twice_is_said_to_be) {
  expect_refused(isolaw({"calibrate", "x", "--generations", "31", "--generations", "30"}),
                 {"--generations: is given 2 times: 31, 30; allowed: once"});
  expect_refused(isolaw({"calibrate", "x", "--out", "A", "--out", "B"}), {"--out: is given 2 times"});
}

TEST_F(Catalogue, has_the_laws_of_the_paper_with_their_parameters) {
  for (auto const& published : published_laws()) {
    auto const listed = std::ranges::find(expected_laws(), published.id, &ExpectedLaw::id);
    ASSERT_NE(listed, expected_laws().end()) << published.id;
    EXPECT_EQ(listed->parameters, published.parameters) << published.id;
  }
}

TEST_F(Catalogue, lists_the_laws_with_their_number_of_parameters) {
  auto const o = isolaw({"laws"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_EQ(count_of("\n", o.out), expected_laws().size());
  auto const widest = std::ranges::max(expected_laws(), {}, [](auto const& law) { return law.id.size(); }).id.size();
  for (auto const& law : expected_laws()) {
    auto const line = fmt::format("{:<{}} {:<5} {:>2} parameters", law.id, widest,
                                  laws::name(laws::find_law(law.id).info.set), law.parameters.size());
    EXPECT_TRUE(contains(o.out, line));
  }
}

TEST_F(Catalogue, of_one_law_gives_source_units_and_every_parameter) {
  for (auto const& law : expected_laws()) {
    auto const o = isolaw({"laws", std::string(law.id)});
    EXPECT_EQ(o.code, 0) << o;
    EXPECT_TRUE(o.out.starts_with(std::string(law.id) + ": ")) << o;
    EXPECT_TRUE(contains(o.out, laws::find_law(law.id).info.source));
    for (auto const& [name, unit] : law.parameters)
      EXPECT_TRUE(contains(o.out, fmt::format("\n  {:<10} {:<10}", name, unit)));
  }
}

TEST_F(Catalogue, as_json_holds_every_law_and_parameter) {
  auto const o = isolaw({"laws", "--json"});
  EXPECT_EQ(o.code, 0) << o;
  auto const all = Json::parse(o.out);
  ASSERT_EQ(all.size(), expected_laws().size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto const& expected = expected_laws()[i];
    EXPECT_EQ(all[i]["id"], expected.id);
    EXPECT_EQ(all[i]["rate_independent"], laws::find_law(expected.id).info.traits.rate_independent) << expected.id;
    ASSERT_EQ(all[i]["parameters"].size(), expected.parameters.size()) << expected.id;
    for (std::size_t p = 0; p < expected.parameters.size(); ++p) {
      EXPECT_EQ(all[i]["parameters"][p]["name"], expected.parameters[p].first);
      EXPECT_EQ(all[i]["parameters"][p]["unit"], expected.parameters[p].second);
      EXPECT_NE(all[i]["parameters"][p]["meaning"], "");
    }
    EXPECT_EQ(Json::parse(isolaw({"laws", std::string(expected.id), "--json"}).out), all[i]);
  }
}

TEST_F(Catalogue, says_what_parameters_must_meet_together) {
  EXPECT_TRUE(contains(isolaw({"laws", "bouc-wen"}).out, "\n  together: beta > 0, beta + gamma > 0\n"));
  EXPECT_EQ(Json::parse(isolaw({"laws", "bilinear", "--json"}).out)["together"], Json({"K1 >= K2"}));
  EXPECT_EQ(Json::parse(isolaw({"laws", "abe", "--json"}).out)["together"], Json::array());
}

TEST_F(Catalogue, says_what_the_paper_calls_a_parameter) {
  EXPECT_TRUE(contains(isolaw({"laws", "bilinear"}).out, "yield displacement; F_y in the paper's tables\n"));
  EXPECT_TRUE(contains(isolaw({"laws", "--markdown"}).out, "yield displacement; F\\_y in the paper's tables |"));
  auto const bilinear = Json::parse(isolaw({"laws", "bilinear", "--json"}).out)["parameters"];
  EXPECT_EQ(bilinear[0]["paper_name"], Json(nullptr));
  EXPECT_EQ(bilinear[2]["paper_name"], "F_y");
}

TEST_F(Catalogue, lists_rule_sets_as_json_in_the_order_of_the_list) {
  auto const listed = isolaw({"rules"}).out;
  std::size_t at = 0;
  auto const sets = Json::parse(isolaw({"rules", "--json"}).out);
  EXPECT_EQ(sets.size() + 1, count_of("\n", listed)) << "and the template";
  for (auto const& set : sets) {
    at = listed.find(set["id"].get<std::string>(), at);
    ASSERT_NE(at, std::string::npos) << set;
    EXPECT_TRUE(contains(listed, set["title"].get<std::string>()));
  }
  expect_refused_as_object(isolaw({"rules", "ntc-2018", "--json"}), {"--json: is given with 'ntc-2018'"});
}

TEST_F(Catalogue, knows_the_published_boxes) {
  // The box of bilinear must be that of law 1 in Table 4 of Cucuzza et al. 2025.
  auto const bilinear = Json::parse(isolaw({"laws", "bilinear", "--json"}).out)["parameters"];
  EXPECT_EQ(bilinear[0]["published"], Json({1.0, 1.9}));
  EXPECT_EQ(bilinear[1]["published"], Json({0.35, 0.95}));
  EXPECT_EQ(bilinear[2]["published"], Json({30.0, 80.0}));
  // That paper does not calibrate vaiana's sigmoid, so its parameters are fixed at zero and have no published interval.
  auto const vaiana = Json::parse(isolaw({"laws", "vaiana", "--json"}).out);
  for (auto const& parameter : vaiana["parameters"]) {
    bool const sigmoid = parameter["name"].get<std::string>().starts_with("gamma");
    EXPECT_EQ(parameter["fixed"], sigmoid ? Json(0.0) : Json(nullptr)) << parameter;
    EXPECT_EQ(parameter["published"].is_null(), sigmoid) << parameter;
  }
}

TEST_F(Catalogue, unknown_law_is_refused_with_the_known_ones) {
  expect_refused(isolaw({"laws", "nope"}), {"'nope'", "no such law", "bilinear, jankowski"});
}

}  // namespace
}  // namespace isolaw::cli_test
