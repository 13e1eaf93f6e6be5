// What the exported texts share: names made harmless, numbers, and the sentences that every export states.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isolaw/programs/realise.hpp"

namespace isolaw::programs {

// Text of others for a comment of a script: control characters, quotes, backslashes and all that a language could act
// on become '_'.
std::string harmless(std::string_view text);
// The same for a table of Markdown.
std::string harmless_markdown(std::string_view text);
// Letters, digits and single underscores, not beginning with a digit: "isolaw_bouc_wen_P_1". One for each device of a
// campaign.
std::string identifier(Subject const& subject);

// Shortest text that reads back as the same number.
std::string exactly(double value);
// The arguments of a command in a script, each behind the separator.
std::string argument_values(Command const& command, std::string_view separator);
// "Command argument argument; Command ...".
std::string argument_names(Form const& form);

// What an element's command ends with, before the options of its user: iterations for z as the materials have them,
// where the program's own 25 are too few. "" for most.
std::string element_options(Command const& command, std::string_view separator, std::string_view quote);
// For people: five significant digits.
std::string briefly(double value);

struct Fact {
  std::string label, text;
};
// An export holds source text of isolaw, which is MIT; as part of an export it asks for no notice (LICENSES/MIT-0.txt).
inline constexpr std::string_view export_licence = "MIT-0",
                                  export_licence_text =
                                      "use, change and pass on what isolaw wrote here as you like; no notice is needed";
// Law, parameters, units, fidelity, errors, validity, bounds. `program` is the target's name.
std::vector<Fact> facts(Subject const& subject, Realisation const& realisation, UnitSystem const& units,
                        std::string_view program);
// The same of an export that holds the law itself: exact, and bounds by one factor on the force.
std::vector<Fact> facts_of_the_law(Subject const& subject, UnitSystem const& units, std::string_view program,
                                   std::string explanation);
// Facts as lines no wider than 110 characters, harmless, for comments.
std::vector<std::string> fact_lines(std::vector<Fact> const& facts);

// "law's parameter = value unit, ...".
std::string parameter_text(laws::LawEntry const& law, std::span<double const> parameters);
// Where the law was tested, or "not stated".
std::vector<Fact> validity(Subject const& subject, UnitSystem const& units);
// How far the law is from what was measured.
std::vector<Fact> measured_facts(Subject const& subject);
// What an analysis meets beyond the tests, and where the bearing moves in two directions.
std::vector<Fact> away_facts(Subject const& subject, Realisation const& realisation);
std::vector<Fact> bound_facts(Subject const& subject, bool one_factor);
std::string deviation_text(Deviation const& deviation);

}  // namespace isolaw::programs
