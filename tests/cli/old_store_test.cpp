// Gives the commands a store with an older schema (tests/stores/README.md). Every command that takes a store must
// refuse it and leave it unchanged.
#include "cli/records.hpp"
#include "cli/run.hpp"

namespace isolaw::cli_test {
namespace {

class OldStore : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    fs::create_directory(path("O"));
    fs::copy_file(stored(), path("O/campaign.sqlite"));
    write("a.csv", csv(record()));
  }
  static fs::path stored() { return fs::path(ISOLAW_STORES) / "schema-8.sqlite"; }
};

TEST_F(OldStore, is_refused_with_what_to_do_and_not_changed) {
  Words const calibrate{"calibrate", "a.csv", "--laws", "bilinear", "--out", "O"};
  for (Words const& command : {Words{"report", "O"}, Words{"check", "O"}, Words{"sample", "O", "--law", "bilinear"},
                               Words{"export", "O", "--law", "bilinear", "--device", "a", "--to", "json"}, calibrate})
    expect_refused(isolaw(command), {"O/campaign.sqlite: a store of schema 8, written by isolaw '0.3.0'", "schema 12",
                                     "calibrate again with the same command and --fresh", "the isolaw that wrote it"});
  EXPECT_EQ(read("O/campaign.sqlite"), read_file(stored()));
  EXPECT_EQ(isolaw(calibrate + Words{"--runs", "1", "--analysis", "none", "--fresh"}).code, 0);
}

}  // namespace
}  // namespace isolaw::cli_test
