// Every setting of a campaign once, and every option of the rules that its tests are checked against. The command line,
// lot file, store, comparison on resume, the command in the report, Python and docs/cli.md are built from these tables.
#pragma once

#include <optional>
#include <span>

#include "isolaw/base/option.hpp"
#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

struct Setting : Option<Settings> {
  std::optional<Method> of = {};  // the only method that has this setting; nullopt if all have it
  bool stored_only = false;       // a constant of its method, kept with the results; users cannot set it
  Json without = {};  // the value that a store without it stands for; null: every store of the schema has it

  bool belongs_to(Method method) const { return !of || *of == method; }
  std::string where() const { return stored_only ? std::string(key) : Option::where(); }
};

// In the order of stores and reports: the method before the settings that it alone has.
std::span<Setting const> setting_table();
Setting const* find_setting(std::string_view key);  // nullptr for an unknown key
// Sets one setting. A setting that only one method has also chooses that method, unless `method_given` says that the
// method was named. Throws Error; the caller adds `where`.
void take(Setting const& setting, Json const& value, bool method_given, Settings& settings);
// Sets all settings that were given. Throws one Error of all complaints, each with its option.
void apply(Values const& given, Settings& settings);

struct Sides {  // the two places that differ, as messages name them
  std::string one = "there", other = "now";
};
// "method: ga there, best now" for each setting that differs, without settings that only one of two methods has.
std::vector<std::string> differences(Settings const& there, Settings const& now, Sides const& sides = {});

// The options of the rules that tests are checked against. `rules` holds the name only; other code loads the file.
std::span<Option<Acceptance> const> acceptance_table();

}  // namespace isolaw::campaign
