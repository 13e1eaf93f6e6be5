// Writes files as a laboratory could have written them. Each file is made for one test and removed after this test.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "finding_text.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/data/read.hpp"
#include "refusal.hpp"

namespace isolaw::data::testing {

inline std::string const header_row = "Time [s];Disp [mm];Force [kN]\n";

class Files : public ::testing::Test {
 protected:
  // Writes a file with these bytes to the test's own folder.
  std::filesystem::path write(std::string_view bytes, std::string_view file_name = "test.csv") {
    auto const* info = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string folder = fmt::format("isolaw-{}-{}", info->test_suite_name(), info->name());
    for (char& c : folder)
      if (c == '/') c = '-';
    folder_ = std::filesystem::temp_directory_path() / folder;
    std::filesystem::create_directories(folder_);
    auto const file = folder_ / file_name;
    std::FILE* handle = std::fopen(file.string().c_str(), "wb");
    std::fwrite(bytes.data(), 1, bytes.size(), handle);
    std::fclose(handle);
    return file;
  }

  void TearDown() override {
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
  }

  TestRecord read(std::string_view bytes, ReadOptions const& options = {}) {
    return read_record(write(bytes), options);
  }

  // Returns the messages with which a file is refused, one per line and with FILE for its path, or "" if the file was
  // read.
  std::string refusal(std::string_view bytes, ReadOptions const& options = {},
                      std::string_view file_name = "test.csv") {
    auto const file = write(bytes, file_name);
    auto text = refusal_of([&] { read_record(file, options); });
    auto const path = file.generic_string();
    for (auto at = text.find(path); at != std::string::npos; at = text.find(path))
      text.replace(at, path.size(), "FILE");
    return text;
  }

 private:
  std::filesystem::path folder_;
};

inline ReadOptions with(std::string_view columns, std::string_view units = {}) {
  ReadOptions options;
  options.columns = parse_columns(columns);
  options.units = parse_units(units);
  return options;
}

// An elliptic loop F = K x + C v/omega. Its stiffness is positive, and it dissipates energy.
struct Ellipse {
  double amplitude_mm = 100.0;
  double K = 0.75;
  double C = 0.2;
  int samples_per_cycle = 200;
  int cycles = 3;

  int size() const { return samples_per_cycle * cycles + 1; }
  double phase(int i) const { return 2.0 * std::numbers::pi * i / samples_per_cycle; }
  double disp(int i) const { return amplitude_mm * std::sin(phase(i)); }
  double force(int i) const { return amplitude_mm * (K * std::sin(phase(i)) + C * std::cos(phase(i))); }
};

// Writes a loop as rows "time disp force" to four decimals, with this delimiter, decimal sign and line end.
inline std::string rows(Ellipse const& loop, std::string_view delimiter, char decimal = '.',
                        std::string_view end = "\n") {
  std::string text;
  for (int i = 0; i < loop.size(); ++i) {
    auto row = fmt::format("{:.4f}|{:.4f}|{:.4f}", 0.01 * i, loop.disp(i), loop.force(i));
    for (char const c : row) {
      if (c == '.')
        text += decimal;
      else if (c == '|')
        text += delimiter;
      else
        text += c;
    }
    text += end;
  }
  return text;
}

}  // namespace isolaw::data::testing
