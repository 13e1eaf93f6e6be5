// Finds OpenSees commands for a law. realise.hpp replays the commands and compares the forces before they are used.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isolaw/programs/materials.hpp"
#include "isolaw/programs/subject.hpp"
#include "isolaw/programs/unit_system.hpp"

namespace isolaw::programs {

// The unit of `value` is kN^force_power mm^length_power.
struct Argument {
  std::string name;  // as in the program's manual
  double value = 0.0;
  double force_power = 0.0, length_power = 0.0;
};

struct MappedCommand {
  std::string name;
  std::vector<Argument> arguments;
};

// How exact a form can be: at every step if it is algebraic, or as the step goes to zero if the program integrates.
enum class Exactness { every_step, small_steps };

// The commands that make a material or an element. The last command makes the one to use.
struct Form {
  std::string id;  // "material", "material_original", "bearing"
  std::string title;
  Exactness exactness = Exactness::every_step;
  std::vector<MappedCommand> commands;
  std::string condition = {};  // where, beyond the records, the form is right; "" for everywhere
  // Longest travel in one direction before the force becomes NaN: from rest, and from side to side. Empty: any.
  std::optional<double> longest_travel_mm = {}, longest_swing_mm = {};
  std::string since = {};  // first version of the program that has the material; "" if all have it
};

std::vector<Command> in_units(Form const& form, UnitSystem const& units);

struct Mapping {
  std::vector<Form> forms;  // the form to use comes first; empty if the program cannot express the law
  std::string why;          // the reason if there is no form
};

// scale.stiffness multiplies the part of the force that grows with displacement, scale.strength the hysteretic part.
Mapping map_law(laws::LawEntry const& law, std::span<double const> parameters, BoundFactors const& scale = {});

laws::BilinearForm scaled(laws::BilinearForm values, BoundFactors const& scale);
laws::BoucWenForm scaled(laws::BoucWenForm values, BoundFactors const& scale);
laws::MenegottoPintoForm scaled(laws::MenegottoPintoForm values, BoundFactors const& scale);

// Values in kN and mm; nullopt for other laws. Limit curves without hardening count as Bouc-Wen with n = 1.
std::optional<laws::BilinearForm> bilinear_values(laws::LawEntry const& law, std::span<double const> parameters);
std::optional<laws::BoucWenForm> bouc_wen_values(laws::LawEntry const& law, std::span<double const> parameters);

}  // namespace isolaw::programs
