// The files of tests/warts with the expected outcome of each: the rows of warts.json.
#pragma once

#include "cli/run.hpp"

namespace isolaw::cli_test {

inline fs::path const wart_folder = fs::path(ISOLAW_SOURCE_DIR) / "tests/warts";

inline std::vector<Json> const& warts() {
  static auto const list = Json::parse(read_file(wart_folder / "warts.json"))["warts"].get<std::vector<Json>>();
  return list;
}

}  // namespace isolaw::cli_test
