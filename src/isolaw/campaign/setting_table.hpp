// Tables of all settings of a campaign and of all options of the rules that its tests are checked against. The command
// line, lot file, store, Python module and docs/cli.md are built from them, and so is the command in a report.
#pragma once

#include <optional>
#include <span>

#include "isolaw/base/option.hpp"
#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

struct Setting : Option<Settings> {
  std::optional<Method> only_method = {};  // the only method that has this setting; nullopt if all have it
  bool stored_only = false;                // a constant of its method, kept with the results; users cannot set it
  Json value_if_absent = {};               // the value assumed if a store lacks it; null: every store must have it

  bool belongs_to(Method method) const { return !only_method || *only_method == method; }
  std::string where() const { return stored_only ? std::string(key) : Option::where(); }
};

// All settings in the order of stores and reports. `method` comes before the settings that only one method has.
std::span<Setting const> setting_table();
Setting const* find_setting(std::string_view key);  // nullptr for an unknown key
// Sets one setting. If only one method has the setting, also chooses that method, unless `method_given` says that the
// user named a method. Throws Error without `where`, which the caller adds.
void take(Setting const& setting, Json const& value, bool method_given, Settings& settings);
// Sets all settings that were given. Throws one Error with all complaints, each with its option.
void apply(Values const& given, Settings& settings);

struct Sides {  // how messages name the two campaigns or files that differ
  std::string one = "there", other = "now";
};
// A text such as "method: ga there, best now" for each setting that differs. If the methods differ, leaves out settings
// that only one of them has.
std::vector<std::string> differences(Settings const& there, Settings const& now, Sides const& sides = {});

// The options of the rules that tests are checked against. Setting the option `rules` only keeps the name of the rule
// set; other code loads the file.
std::span<Option<Acceptance> const> acceptance_table();
std::span<Option<Acceptance> const> alike_table();  // those options of acceptance_table() that set Acceptance::alike

}  // namespace isolaw::campaign
