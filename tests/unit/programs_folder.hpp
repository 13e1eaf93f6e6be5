// A fresh folder in which a test runs exported files as a user would.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "unit/programs_fixture.hpp"

namespace isolaw::programs_test {

namespace fs = std::filesystem;

class Folder : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "isolaw-programs-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  void write(fs::path const& name, std::string const& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  std::string read(fs::path const& name) const {
    std::ostringstream text;
    text << std::ifstream(folder_ / name, std::ios::binary).rdbuf();
    return text.str();
  }
  // Returns the exit code of the command and writes its output to the file "printed".
  int run(std::string const& command) const {
    auto const whole = fmt::format("cd '{}' && {} > printed 2>&1", folder_.string(), command);
    int const status = std::system(whole.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  }
  bool has(std::string const& program) const { return run("command -v " + program) == 0; }

  fs::path folder_;
};

}  // namespace isolaw::programs_test
