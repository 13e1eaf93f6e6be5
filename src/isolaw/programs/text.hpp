// Helpers for exported texts: safe names, numbers, and the facts that every export states.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isolaw/programs/realise.hpp"

namespace isolaw::programs {

// Writes '_' for every character that begins a substitution or joins lines in Tcl, Python or C++. The text is then safe
// in a comment.
std::string harmless(std::string_view text);
std::string harmless_markdown(std::string_view text);
// Returns the name of the export: Subject::name or, if it is empty, a name made from law, campaign, device and units,
// such as "isolaw_bouc_wen_lot_P_1_kN_mm". It has letters, digits and single underscores only, and differs between the
// devices of a campaign.
std::string identifier(Subject const& subject, UnitSystem const& units);
// Throws Error if `name` cannot be the name of an export in Tcl, Python and C++.
void require_export_name(std::string_view name);
// Two different files that define the same name must not be used in one program. Every script and C++ file therefore
// holds a number computed from its whole text, by which it recognises another file that defines the same name.
// with_own_number() puts this number in place of `own_number_mark`.
inline constexpr std::string_view own_number_mark = "@own number@";
std::string with_own_number(std::string text);

// Returns the shortest text that is read back as the same number.
std::string exact_text(double value);
std::string argument_values(Command const& command, std::string_view separator);
// Returns the commands of a form with their arguments' names, for users: "Command argument argument; Command ...".
std::string argument_names(Form const& form);

// Returns options for more iterations than the 25 of OpenSees' default; "" for elements that do not iterate.
std::string element_options(Command const& command, std::string_view separator, std::string_view quote);
std::string briefly(double value);

struct Fact {
  std::string label, text;
};
// isolaw is under MIT. The source text of isolaw inside an export needs no licence notice (LICENSES/MIT-0.txt).
inline constexpr std::string_view export_licence = "MIT-0",
                                  export_licence_text =
                                      "use, change and pass on what isolaw wrote here as you like; no notice is needed";
// The facts that an export states about itself. `program` is the name of the analysis program, for users.
std::vector<Fact> facts(Subject const& subject, Realisation const& realisation, UnitSystem const& units,
                        std::string_view program, bool one_factor = false);
std::vector<Fact> facts_of_the_law(Subject const& subject, UnitSystem const& units, std::string_view program,
                                   std::string explanation);
// Breaks facts into lines of at most 110 characters and makes them harmless() in comments.
std::vector<std::string> fact_lines(std::vector<Fact> const& facts);

// Returns the parameters as text for users, for example "K1 = 2.0 kN/mm, ...".
std::string parameter_text(laws::LawEntry const& law, std::span<double const> parameters);
std::vector<Fact> response_facts(Subject const& subject, RefitResponse const& response, UnitSystem const& units);
// The ranges in which the law was fitted and tested; "not stated" if the records do not say.
std::vector<Fact> validity(Subject const& subject, UnitSystem const& units);
std::string equations(laws::LawInfo const& law);  // the law's formula in one line
std::vector<Fact> measured_facts(Subject const& subject);
// Says how well the law predicts and, if there is another reason not to use the law, this reason.
std::vector<Fact> prediction_facts(Subject const& subject, UnitSystem const& units);
std::vector<Fact> away_facts(Subject const& subject, Realisation const& realisation);
std::vector<Fact> bound_facts(Subject const& subject, bool one_factor);
std::string deviation_text(Deviation const& deviation);

}  // namespace isolaw::programs
