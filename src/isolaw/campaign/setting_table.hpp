// Two tables: the settings of a campaign, and the options of its acceptance (rules, design values, lot size). Command
// line, lot file, store, comparison on resume, the command in the report, Python and docs/cli.md follow from them.
#pragma once

#include <optional>
#include <span>

#include "isolaw/base/option.hpp"
#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

struct Setting : Option<Settings> {
  std::optional<Method> of = {};  // the only method that has this setting; nullopt: all have it
  bool stored_only = false;       // a constant of the method, stored with the results; users cannot set it

  bool belongs_to(Method method) const { return !of || *of == method; }
  std::string where() const { return stored_only ? std::string(key) : Option::where(); }
};

// In the order of stores and reports: a method comes before the settings that only it has.
std::span<Setting const> setting_table();
// nullptr for an unknown key.
Setting const* find_setting(std::string_view key);

// Sets one setting. A setting that only one method has also chooses that method, unless `method_given` tells that the
// user named the method. Throws Error without `where`, which the caller fills in.
void take(Setting const& setting, Json const& value, bool method_given, Settings& settings);
// Takes all given values into `settings`. Throws one Error whose `where` are the options.
void apply(Values const& given, Settings& settings);

// How messages call the two places that are compared.
struct Sides {
  std::string one = "there", other = "now";
};
// "method: ga there, best now", for each setting that differs. If the methods differ, settings that only one of them
// has are left out.
std::vector<std::string> differences(Settings const& there, Settings const& now, Sides const& sides = {});

// The options of the acceptance. The value of "rules" is only a name: the caller decides what it means and loads it.
std::span<Option<Acceptance> const> acceptance_table();

}  // namespace isolaw::campaign
