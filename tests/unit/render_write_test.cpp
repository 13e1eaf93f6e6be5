// Tests the writing of a report: all files that were asked for are written, each of them whole or not at all.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>

#include "isolaw/base/error.hpp"
#include "isolaw/base/write_file.hpp"
#include "isolaw/render/json/summary_json.hpp"
#include "isolaw/render/page/html.hpp"
#include "isolaw/render/write.hpp"
#include "unit/study_fixture.hpp"

namespace isolaw::render {
namespace {

namespace fs = std::filesystem;

class Write : public testing::Test {
 protected:
  Write() : dir_(fs::temp_directory_path() / ("isolaw-report-" + std::to_string(::getpid()))) { fs::remove_all(dir_); }
  ~Write() override { fs::remove_all(dir_); }

  static std::string content(fs::path const& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  fs::path dir_;
};

TEST_F(Write, AllOutputsAndNothingElse) {
  auto const summary = fixture::lot();
  write_outputs(summary, dir_ / "deep" / "out");
  std::set<std::string> files;
  for (auto const& entry : fs::recursive_directory_iterator(dir_ / "deep" / "out"))
    if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), dir_ / "deep" / "out").string());
  EXPECT_EQ(files, (std::set<std::string>{"report.html",           "summary.json",
                                          "tables/cycles.csv",     "tables/lambda.csv",
                                          "tables/lot.csv",        "tables/objective.csv",
                                          "tables/parameters.csv", "tables/robustness.csv",
                                          "tables/converged.csv",  "tables/identifiability.csv",
                                          "tables/lot_law.csv",    "tables/prediction.csv",
                                          "tables/tests.csv",      "tables/vertical.csv",
                                          "tables/levels.csv",     "tables/table_a5.csv",
                                          "tables/table_a5.tex",   "tables/robustness.tex",
                                          "tables/front.csv",      "tables/front.tex"}));
  EXPECT_EQ(content(dir_ / "deep" / "out" / "summary.json"), summary_json(summary));
  EXPECT_EQ(content(dir_ / "deep" / "out" / "report.html"), html(summary));
}

TEST_F(Write, ReplacesWhatWasThere) {
  fs::create_directories(dir_);
  write_file(dir_ / "a", "old and longer");
  write_file(dir_ / "a", "new");
  EXPECT_EQ(content(dir_ / "a"), "new");
}

TEST_F(Write, DirectoryThatCannotBeMadeIsAnError) {
  fs::create_directories(dir_);
  write_file(dir_ / "file", "in the way");
  try {
    write_outputs(fixture::lot(), dir_ / "file" / "out");
    FAIL();
  } catch (Error const& error) {
    EXPECT_NE(std::string(error.what()).find((dir_ / "file").string()), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("cannot be written"), std::string::npos);
  }
}

TEST_F(Write, FailedWriteLeavesNoPartBehind) {
  fs::create_directories(dir_ / "taken" / "inside");  // a file cannot replace a directory that is not empty
  EXPECT_THROW(write_file(dir_ / "taken", "text"), Error);
  EXPECT_EQ(std::distance(fs::directory_iterator(dir_), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace isolaw::render
