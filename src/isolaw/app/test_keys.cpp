// Implements `isolaw test-keys`, which isolaw's web page calls. It prints what a lot file can state about a test, and
// which of these values the names of record files suggest.
#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/app/commands.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/option.hpp"
#include "isolaw/campaign/lot_conditions.hpp"
#include "isolaw/campaign/lot_file.hpp"
#include "isolaw/campaign/names_of_tests.hpp"

namespace isolaw::app {
namespace {

// Describes a key as the page shows it: "temperature-C" gets the label "Temperature" and the unit "°C".
Json described(OptionInfo const& row) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> units{
      {{"-C", "°C"}, {"-kN", "kN"}, {"-h", "h"}}};
  Json json{{"key", row.option()}, {"label", row.option()}, {"unit", ""}, {"help", row.help}};
  auto label = row.option();
  for (auto const& [ending, unit] : units)
    if (label.ends_with(ending)) {
      label.resize(label.size() - ending.size());
      json["unit"] = unit;
    }
  std::ranges::replace(label, '-', ' ');
  if (label.front() >= 'a' && label.front() <= 'z') label.front() = static_cast<char>(label.front() - 'a' + 'A');
  json["label"] = label;
  json["kind"] = row.kind == Kind::flag ? "flag" : row.kind == Kind::text ? "text" : "number";
  json["words"] = row.words;
  return json;
}

Json described(auto const& table) {
  auto rows = Json::array();
  for (auto const& row : table) rows.push_back(described(static_cast<OptionInfo const&>(row)));
  return rows;
}

}  // namespace

int list_test_keys(std::vector<std::filesystem::path> const& files) {
  std::vector<std::string> names;
  for (auto const& file : files) names.push_back(campaign::name_of_file(file));
  auto proposed = Json::array();
  for (auto const& test : campaign::propose_tests(names))
    proposed.push_back({{"device", test.device},
                        {"temperature-C", or_null(test.temperature_C)},
                        {"load-kN", or_null(test.load_kN)},
                        {"aged", test.is_aged}});
  Json const json{
      {"test", described(campaign::test_table())}, {"aged", described(campaign::aged_table())}, {"proposed", proposed}};
  print(json.dump() + '\n');
  return exit_done;
}

}  // namespace isolaw::app
