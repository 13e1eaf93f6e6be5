// Stores of every former schema, written by the programs of their time (tests/stores/README.md), can be read, reported,
// checked and exported, but not continued.
#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

struct OldStore {
  std::string name;
  int schema;
  std::string method;
  std::string version = "0.1.0", build = {};  // the writing program's; empty if not known

  std::string maker() const { return "isolaw " + version + ", build " + (build.empty() ? "not known" : build); }
};
void PrintTo(OldStore const& store, std::ostream* out) {
  *out << store.name;
}

class Old : public InFreshDirectory, public testing::WithParamInterface<OldStore> {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    fs::create_directory(path("O"));
    fs::copy_file(fs::path(ISOLAW_STORES) / (GetParam().name + ".sqlite"), path("O/campaign.sqlite"));
  }
  void TearDown() override {
    EXPECT_EQ(read("O/campaign.sqlite"), read_file(fs::path(ISOLAW_STORES) / (GetParam().name + ".sqlite")))
        << "an old store was written to";
    InFreshDirectory::TearDown();
  }
};

TEST_P(Old, is_of_its_schema) {
  EXPECT_EQ(query(path("O/campaign.sqlite"), "SELECT value FROM meta WHERE key = 'schema'"),
            Words{std::to_string(GetParam().schema)});
}

TEST_P(Old, is_reported_with_its_maker_and_the_settings_of_its_time) {
  auto const o = isolaw({"report", "O"});
  ASSERT_EQ(o.code, 1) << o;  // a device was refused
  auto const s = json("O/summary.json");
  auto const& old = GetParam();
  ASSERT_EQ(s["isolaw"].size(), 1u);
  EXPECT_EQ(s["isolaw"][0]["version"], old.version);
  EXPECT_EQ(s["isolaw"][0]["build"], old.build.empty() ? Json() : Json(old.build));
  EXPECT_EQ(s["title"], "an older store");
  EXPECT_EQ(s["missing_runs"], 0);
  EXPECT_EQ(s["settings"]["method"], GetParam().method);
  EXPECT_EQ(s["settings"]["turning-points"], "sampled");
  EXPECT_EQ(s["settings"]["fit-cycles"], "all");
  EXPECT_EQ(s["settings"]["score-blocks"], "all");
  EXPECT_EQ(s["settings"]["dead-band"], GetParam().schema < 6 ? Json(0.0) : Json("auto"));
  EXPECT_EQ(s["settings"]["analysis"], GetParam().schema < 4 ? "none" : "full");
  ASSERT_EQ(s["laws"].size(), 2u);
  for (auto const& law : s["laws"])
    for (auto const& fit : law["devices"]) EXPECT_EQ(fit["status"], "ok");
  EXPECT_TRUE(
      contains(read("O/report.html"), old.version + ", build " + (old.build.empty() ? "not known" : old.build)));
}

TEST_P(Old, is_checked) {
  ASSERT_EQ(isolaw({"report", "O"}).code, 1);
  auto const o = isolaw({"check", "O"});
  EXPECT_TRUE(contains(o.out, "computed by " + GetParam().maker() + "; this is")) << o;
  EXPECT_EQ(o.out.find("fault"), std::string::npos) << o;
}

TEST_P(Old, that_was_changed_is_found_out) {
  sqlite3* db = nullptr;
  ASSERT_EQ(sqlite3_open(path("O/campaign.sqlite").c_str(), &db), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(db, "UPDATE run SET objective = objective * 1.001 WHERE number = 1 AND law = 'bilinear'",
                         nullptr, nullptr, nullptr),
            SQLITE_OK);
  sqlite3_close(db);
  auto const o = isolaw({"check", "O"});
  EXPECT_EQ(o.code, 1) << o;
  EXPECT_TRUE(contains(o.out, "bilinear on a, run 1: its parameters give the objective")) << o;
  fs::copy_file(fs::path(ISOLAW_STORES) / (GetParam().name + ".sqlite"), path("O/campaign.sqlite"),
                fs::copy_options::overwrite_existing);
}

TEST_P(Old, gives_its_laws) {
  write("m.csv", "time [s],displacement [mm]\n0,0\n0.1,10\n0.2,0\n");
  auto const simulated = isolaw({"simulate", "bouc-wen", "--from", "O", "--device", "a", "--motion", "m.csv"});
  EXPECT_EQ(simulated.code, 0) << simulated;
  auto const exported = isolaw({"export", "O", "--law", "bilinear", "--device", "a", "--to", "json", "--out", "E"});
  EXPECT_EQ(exported.code, 0) << exported;
  auto const sampled = isolaw({"sample", "O", "--law", "bilinear", "--count", "3"});
  EXPECT_EQ(sampled.err.find("damaged"), std::string::npos) << sampled;
}

TEST_P(Old, is_not_continued_and_says_what_to_do) {
  write("a.csv", csv(record()));
  auto const o = isolaw({"calibrate", "a.csv", "--laws", "bilinear", "--out", "O"});
  expect_refused(o, {"O/campaign.sqlite", "--fresh", "another --out DIR"});
}

INSTANTIATE_TEST_SUITE_P(Stores, Old,
                         testing::Values(OldStore{"schema-1", 1, "ga"}, OldStore{"schema-2", 2, "ga"},
                                         OldStore{"schema-3-ga", 3, "ga"}, OldStore{"schema-3-best", 3, "best"},
                                         OldStore{"schema-4", 4, "best"},
                                         OldStore{"schema-5", 5, "best", "0.2.0", "a3ff8a28a3fe"},
                                         OldStore{"schema-6", 6, "best", "0.3.0", "739a26b2273a"},
                                         OldStore{"schema-7", 7, "best", "0.3.0", "43ecd2137f7f"},
                                         OldStore{"schema-8", 8, "best", "0.3.0", "7b5597ed424f"},
                                         OldStore{"schema-9", 9, "best", "0.3.0", "a3bf76736f9c"}),
                         [](auto const& instance) {
                           auto name = instance.param.name;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace isolaw::cli_test
