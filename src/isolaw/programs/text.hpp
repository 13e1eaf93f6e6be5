// Shared by the exported texts: names made harmless, numbers, and the facts that every export states.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isolaw/programs/realise.hpp"

namespace isolaw::programs {

// Makes a text safe for a comment: all characters that Tcl, Python or C++ could act on become '_'.
std::string harmless(std::string_view text);
std::string harmless_markdown(std::string_view text);
// "isolaw_bouc_wen_P_1": letters, digits and single underscores; different for each device of a campaign.
std::string identifier(Subject const& subject);

// Shortest text that reads back as the same number.
std::string exactly(double value);
std::string argument_values(Command const& command, std::string_view separator);
// "Command argument argument; Command ...".
std::string argument_names(Form const& form);

// Asks for more iterations for z than the program's 25; "" for elements that do not iterate.
std::string element_options(Command const& command, std::string_view separator, std::string_view quote);
std::string briefly(double value);

struct Fact {
  std::string label, text;
};
// An export holds source text of isolaw, which is MIT. Within an export it needs no notice (LICENSES/MIT-0.txt).
inline constexpr std::string_view export_licence = "MIT-0",
                                  export_licence_text =
                                      "use, change and pass on what isolaw wrote here as you like; no notice is needed";
// `program` is the target's name as users know it.
std::vector<Fact> facts(Subject const& subject, Realisation const& realisation, UnitSystem const& units,
                        std::string_view program, bool one_factor = false);
std::vector<Fact> facts_of_the_law(Subject const& subject, UnitSystem const& units, std::string_view program,
                                   std::string explanation);
// Facts as lines no wider than 110 characters, made harmless() for comments.
std::vector<std::string> fact_lines(std::vector<Fact> const& facts);

// "K1 = 2.0 kN/mm, ...".
std::string parameter_text(laws::LawEntry const& law, std::span<double const> parameters);
// The ranges that the law was fitted to and tested in, "not stated" if the records do not say.
std::vector<Fact> validity(Subject const& subject, UnitSystem const& units);
std::vector<Fact> measured_facts(Subject const& subject);
std::vector<Fact> away_facts(Subject const& subject, Realisation const& realisation);
std::vector<Fact> bound_facts(Subject const& subject, bool one_factor);
std::string deviation_text(Deviation const& deviation);

}  // namespace isolaw::programs
