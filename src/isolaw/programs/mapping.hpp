// Finds OpenSees commands that give a law's force. realise.hpp replays them before they are used.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isolaw/programs/materials.hpp"
#include "isolaw/programs/subject.hpp"
#include "isolaw/programs/unit_system.hpp"

namespace isolaw::programs {

// `value` is in kN^force_power mm^length_power.
struct Argument {
  std::string name;  // the name in the program's manual
  double value = 0.0;
  double force_power = 0.0, length_power = 0.0;
};

struct MappedCommand {
  std::string name;
  std::vector<Argument> arguments;
};

// The best accuracy of a form: algebraic forms are exact at every step, integrated ones as the step goes to zero.
enum class Exactness { every_step, small_steps };

// The last of the commands makes the material or element to use.
struct Form {
  std::string id;  // "material", "material_original", "bearing"
  std::string title;
  Exactness exactness = Exactness::every_step;
  std::vector<MappedCommand> commands;
  std::string condition = {};  // where the form is right, beyond the records; "" for everywhere
  // The longest travel in one direction, in mm, before the force becomes NaN: from rest, from side to side. Empty: any.
  std::optional<double> longest_travel_mm = {}, longest_swing_mm = {};
  std::string since = {};  // the first version of the program that has the material; "": all have it
};

std::vector<Command> in_units(Form const& form, UnitSystem const& units);

struct Mapping {
  std::vector<Form> forms;  // the first is the one to use; empty: no exact form
  std::string why;          // why there is no form
};

// scale.stiffness multiplies the part of the force that grows with displacement, scale.strength the hysteretic part.
Mapping map_law(laws::LawEntry const& law, std::span<double const> parameters, BoundFactors const& scale = {});

laws::BilinearForm scaled(laws::BilinearForm values, BoundFactors const& scale);
laws::BoucWenForm scaled(laws::BoucWenForm values, BoundFactors const& scale);
laws::MenegottoPintoForm scaled(laws::MenegottoPintoForm values, BoundFactors const& scale);

// In kN and mm. One set of limit curves without hardening is the Bouc-Wen law with n = 1.
std::optional<laws::BilinearForm> bilinear_values(laws::LawEntry const& law, std::span<double const> parameters);
std::optional<laws::BoucWenForm> bouc_wen_values(laws::LawEntry const& law, std::span<double const> parameters);

}  // namespace isolaw::programs
