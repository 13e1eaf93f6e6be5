// Reads the entries of tests/warts/warts.json. Each entry names a file of that folder, which has an oddity of
// laboratory files (a wart), and what inspect must say of the file.
#pragma once

#include "cli/run.hpp"

namespace isolaw::cli_test {

inline fs::path const wart_folder = fs::path(ISOLAW_SOURCE_DIR) / "tests/warts";

inline std::vector<Json> const& warts() {
  static auto const list = Json::parse(read_file(wart_folder / "warts.json"))["warts"].get<std::vector<Json>>();
  return list;
}

}  // namespace isolaw::cli_test
