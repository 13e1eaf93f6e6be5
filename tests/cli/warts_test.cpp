// The files in tests/warts have the oddities of laboratory files (warts). `isolaw inspect` must say of each file what
// warts.json expects and docs/records.md lists. To add a wart, add a file, an entry in warts.json and the row of the
// table that the last test prints. For a sound record, warts.json states the stiffness and all warnings.
#include <cctype>
#include <set>

#include "cli/warts.hpp"

namespace isolaw::cli_test {
namespace {

Words options_of(Json const& wart) {
  return wart.value("options", Words{});
}

// Returns the file of the entry and the files that its options name.
std::set<std::string> files_of(Json const& wart) {
  std::set<std::string> files{wart["file"].get<std::string>()};
  for (auto const& word : options_of(wart))
    for (auto const& entry : fs::directory_iterator(wart_folder))
      if (word.find(entry.path().filename().string()) != std::string::npos) files.insert(entry.path().filename());
  return files;
}

class Warts : public InFreshDirectory, public ::testing::WithParamInterface<Json> {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    for (auto const& file : files_of(GetParam())) fs::copy_file(wart_folder / file, path(file));
  }
  static void expect_says(std::string const& text, Json const& wart) {
    ASSERT_FALSE(wart["says"].empty());
    for (auto const& part : wart["says"]) EXPECT_TRUE(contains(text, part.get<std::string>()));
  }
  static void expect_numbers(Json const& found, Json const& wart) {
    if (wart.contains("samples")) {
      EXPECT_EQ(found["samples"], wart["samples"]);
    }
    if (wart.contains("K_v")) {
      EXPECT_NEAR(found["vertical"]["K_v_kN_per_mm"].get<double>(), wart["K_v"].get<double>(), 0.5);
    }
    if (!wart.contains("K_eff") && !wart.contains("frequency_Hz")) return;
    ASSERT_TRUE(found["reported"].is_object()) << found["warnings"].dump();
    auto const number = [](Json const& from, char const* key) { return from[key].get<double>(); };
    for (auto const& block : found["blocks"]) {
      if (block["number"] != found["reported"]["block"]) continue;
      if (wart.contains("frequency_Hz")) {
        EXPECT_NEAR(number(block, "frequency_Hz"), number(wart, "frequency_Hz"), 1e-3);
      }
      for (auto const& cycle : block["cycles"])
        if (wart.contains("K_eff") && cycle["number"] == found["reported"]["number"]) {
          // The files round displacement and force, most of them to three decimals. This changes K_eff by far less
          // than the tolerance, and a column or unit that is read wrongly changes it by far more.
          EXPECT_NEAR(number(cycle, "K_eff_kN_per_mm"), number(wart, "K_eff"), 1e-3);
          return;
        }
    }
    EXPECT_FALSE(wart.contains("K_eff")) << "no cycle is reported";
  }
};

TEST_P(Warts, ComeOutAsTheTableSays) {
  auto const& wart = GetParam();
  auto const words = Words{"inspect", wart["file"].get<std::string>()} + options_of(wart);
  auto const o = isolaw(words);
  if (wart["outcome"] == "refused") {
    EXPECT_EQ(o.code, 2) << o;
    EXPECT_TRUE(o.out.empty()) << o;
    expect_says(o.err, wart);
    return;
  }
  bool const usable = wart["outcome"] != "no properties", no_K_v = wart["outcome"] == "no K_v";
  ASSERT_EQ(o.code, usable && !no_K_v ? 0 : 1) << o;
  auto const json = isolaw(words + Words{"--json"});
  ASSERT_EQ(json.code, o.code) << json;
  auto const found = Json::parse(json.out);
  EXPECT_EQ(found["properties_refusal"].get<std::string>().empty(), usable);
  if (!usable) {
    EXPECT_TRUE(found["reported"].is_null());
    expect_says(found["properties_refusal"], wart);
    expect_says(o.out, wart);
    return;
  }
  if (no_K_v) {
    EXPECT_TRUE(found["reported"].is_object());
    EXPECT_TRUE(found["vertical"]["K_v_kN_per_mm"].is_null()) << found["vertical"].dump();
    expect_says(o.out, wart);
    return;
  }
  expect_numbers(found, wart);
  if (wart.contains("warnings")) {
    auto const& warnings = found["warnings"];
    ASSERT_EQ(warnings.size(), wart["warnings"].size()) << warnings.dump();
    for (std::size_t i = 0; i < warnings.size(); ++i)
      EXPECT_TRUE(contains(warnings[i].get<std::string>(), wart["warnings"][i].get<std::string>()));
    return;
  }
  std::string said;
  for (auto const& line : wart["outcome"] == "warned" ? found["warnings"] : found["recognised"])
    said += line.get<std::string>() + "\n";
  if (auto const& vertical = found["vertical"]; !vertical.is_null()) {
    said += vertical["how"].get<std::string>() + "\n";
    for (auto const& line : vertical["recognised"]) said += line.get<std::string>() + "\n";
  }
  expect_says(said, wart);
  if (wart["outcome"] == "warned") expect_says(o.out, wart);  // the terminal must show the warning too
}

INSTANTIATE_TEST_SUITE_P(All, Warts, ::testing::ValuesIn(warts()), [](auto const& wart) {
  std::string name = wart.param["file"];
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name + "_" + std::to_string(wart.index);
});

TEST(WartTable, names_every_file_once_and_only_outcomes_there_are) {
  std::set<std::string> named{"make.py", "warts.json"};
  std::set<std::string> whats;
  for (auto const& wart : warts()) {
    named.merge(files_of(wart));
    auto const outcome = wart["outcome"].get<std::string>();
    EXPECT_TRUE(outcome == "read" || outcome == "refused" || outcome == "warned" || outcome == "no properties" ||
                outcome == "no K_v")
        << outcome;
    EXPECT_TRUE(whats.insert(wart["what"].get<std::string>() + wart["file"].get<std::string>()).second) << wart["what"];
  }
  for (auto const& entry : fs::directory_iterator(wart_folder))
    EXPECT_TRUE(named.contains(entry.path().filename())) << entry.path() << " stands in no row of warts.json";
}

// docs/records.md must contain the table that this test makes from warts.json.
TEST(WartTable, stands_in_the_documentation) {
  std::string table = "| wart | file | options | outcome |\n|---|---|---|---|\n";
  for (auto const& wart : warts()) {
    std::string options;
    for (auto const& word : options_of(wart)) options += (options.empty() ? "" : " ") + word;
    table += fmt::format("| {} | `{}` | {} | {} |\n", wart["what"].get<std::string>(), wart["file"].get<std::string>(),
                         options.empty() ? "" : "`" + options + "`", wart["outcome"].get<std::string>());
  }
  EXPECT_NE(read_file(fs::path(ISOLAW_SOURCE_DIR) / "docs/records.md").find(table), std::string::npos)
      << "docs/records.md lacks this table:\n"
      << table;
}

}  // namespace
}  // namespace isolaw::cli_test
