// Writes the exported texts, with one function for each target. Each throws Error if the target cannot express the law.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/programs/realise.hpp"
#include "isolaw/programs/script_addition.hpp"
#include "isolaw/programs/subject.hpp"
#include "isolaw/programs/unit_system.hpp"

namespace isolaw::programs {

struct Remarks {
  std::vector<std::string> objections;  // why the form must not replace the law; refused unless asked for anyway
  std::vector<std::string> cautions;    // warnings that the user sees with the export
};

struct Target {
  std::string_view name;
  std::string (*write)(Subject const& subject, UnitSystem const& units, Remarks& remarks);
  bool of_model = false;  // writes a whole building: the subject needs a Model
};
std::span<Target const> targets();
std::vector<std::string_view> model_targets();     // names of the targets that write a whole building
Target const& find_target(std::string_view name);  // throws Error that lists the targets

struct Export {
  std::string text;
  std::vector<std::string> let_through, cautions;
};
// Throws Error for an unusable prediction or a substitute far off the law, unless `anyway`; `let_through` then says so.
Export write_export(Subject const& subject, Target const& target, UnitSystem const& units, bool anyway);

std::string opensees_script(Subject const& subject, Realisation const& realisation, UnitSystem const& units,
                            ScriptAddition const& addition = {});
std::string openseespy_script(Subject const& subject, Realisation const& realisation, UnitSystem const& units,
                              ScriptAddition const& addition = {});
// Adds the subject's model to the law's script. The model's draws must already be forms of the realisation.
std::string opensees_model(Subject const& subject, Realisation const& realisation, UnitSystem const& units);
std::string openseespy_model(Subject const& subject, Realisation const& realisation, UnitSystem const& units);
std::string cpp_header(Subject const& subject, UnitSystem const& units);
std::string opensees_material(Subject const& subject, UnitSystem const& units);
std::string abaqus_element(Subject const& subject, UnitSystem const& units);
std::string export_json(Subject const& subject, Realisation const& realisation, UnitSystem const& units);
std::string value_sheet(Subject const& subject, UnitSystem const& units, Remarks& remarks);
std::string protocol_csv(Subject const& subject, UnitSystem const& units);

}  // namespace isolaw::programs
