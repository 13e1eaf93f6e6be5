// Every setting of a campaign once, and every option of what its tests are held to: command line, lot file, store,
// comparison on resume, the command in the report, Python and docs/cli.md are made from these tables.
#pragma once

#include <optional>
#include <span>

#include "isolaw/base/option.hpp"
#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

struct Setting : Option<Settings> {
  std::optional<Method> of = {};  // the method that alone has it
  bool stored_only = false;       // a constant of its method, kept with the results: nobody gives it

  bool belongs_to(Method method) const { return !of || *of == method; }
  std::string where() const { return stored_only ? std::string(key) : Option::where(); }
};

// In the order of stores and reports: the method before what it alone has.
std::span<Setting const> setting_table();
// nullptr for a key that no setting has.
Setting const* find_setting(std::string_view key);

// Sets one setting; what one method alone has chooses it, unless `method_given` says that the method was named. Throws
// Error, which leaves `where` to the way in.
void take(Setting const& setting, Json const& value, bool method_given, Settings& settings);
// Lays everything that one way in was given over `settings`. Throws one Error, where of which is the option.
void apply(Values const& given, Settings& settings);

// Where what differs was found, as messages say it.
struct Sides {
  std::string one = "there", other = "now";
};
// "method: ga there, best now", for each setting that differs; what one method alone has is said by the method.
std::vector<std::string> differences(Settings const& there, Settings const& now, Sides const& sides = {});

// What tests are held to. A name of rules means what its way in takes it for: their text is not loaded.
std::span<Option<Acceptance> const> acceptance_table();

}  // namespace isolaw::campaign
