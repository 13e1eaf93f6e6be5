// Writes the text of an export, with one function for each target. A function throws Error for a law it cannot express.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/unit_system.hpp"
#include "isolaw/programs/realise.hpp"
#include "isolaw/programs/script_addition.hpp"
#include "isolaw/programs/subject.hpp"

namespace isolaw::programs {

struct Remarks {
  std::vector<std::string> objections;  // reasons to refuse the export, unless the user asks for it `anyway`
  std::vector<std::string> cautions;    // warnings that are shown with the export
  std::vector<Finding> responses;       // how each re-fit changes the response of a building (response.hpp)
  // Adds the finding of `response`, or a caution if it has none. Adds nothing if there is no re-fit and so no response.
  void add(RefitResponse const& response, Subject const& subject);
};

struct Target {
  std::string_view name;
  std::string (*write)(Subject const& subject, UnitSystem const& units, Remarks& remarks);
  bool needs_building = false;  // writes a whole building and needs Subject::model
  bool is_named = false;        // the file defines a name, which the user may choose (Subject::name)
  bool refits = false;          // may write a re-fit, which is another law fitted to this one, in the law's place
};
std::span<Target const> targets();
std::vector<std::string_view> targets_where(bool Target::*is);
Target const& find_target(std::string_view name);  // throws Error with a list of the targets

struct Export {
  std::string text;
  std::vector<std::string> overridden_objections, cautions;
  std::vector<Finding> responses;
};
// Throws Error if the law is not fit for use (its prediction is unusable, for example), or if the material that stands
// for it in the analysis program is far off the law. With `anyway` these reasons go to `overridden_objections` instead.
// Always throws Error if the target needs a building and `subject` has none.
Export write_export(Subject const& subject, Target const& target, UnitSystem const& units, bool anyway);

std::string opensees_script(Subject const& subject, Realisation const& realisation, UnitSystem const& units,
                            ScriptAddition const& addition = {});
std::string openseespy_script(Subject const& subject, Realisation const& realisation, UnitSystem const& units,
                              ScriptAddition const& addition = {});
// Write the law's script with the building of `subject`. add_draws() must have added the laws drawn for its bearings.
std::string opensees_model(Subject const& subject, Realisation const& realisation, UnitSystem const& units);
std::string openseespy_model(Subject const& subject, Realisation const& realisation, UnitSystem const& units);
std::string openseespy_law(Subject const& subject, UnitSystem const& units);
// Returns Python code that uses the law itself through isolaw.opensees: the law's parameters and bounds, and the
// functions arguments(), material() and self_check(). The names of functions begin with `prefix` ("" or "law_"), and
// those of constants with `prefix` in capitals. The module must have imported `ops` and `isolaw`.
std::string law_in_python(Subject const& subject, UnitSystem const& units, std::string_view prefix);
std::string cpp_header(Subject const& subject, UnitSystem const& units);
std::string opensees_material(Subject const& subject, UnitSystem const& units);
std::string abaqus_element(Subject const& subject, UnitSystem const& units);
std::string export_json(Subject const& subject, Realisation const& realisation, UnitSystem const& units);
std::string value_sheet(Subject const& subject, UnitSystem const& units, Remarks& remarks);
std::string protocol_csv(Subject const& subject, UnitSystem const& units);

}  // namespace isolaw::programs
