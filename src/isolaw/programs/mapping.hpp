// Finds OpenSees commands for a law. Before they are exported, realise.hpp compares their force with the law's.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isolaw/base/unit_system.hpp"
#include "isolaw/programs/materials.hpp"
#include "isolaw/programs/subject.hpp"

namespace isolaw::programs {

// An argument of a command. The unit of `value` is kN^force_power mm^length_power.
struct Argument {
  std::string name;  // the argument's name in the manual of OpenSees
  double value = 0.0;
  double force_power = 0.0, length_power = 0.0;
};

struct MappedCommand {
  std::string name;
  std::vector<Argument> arguments;
};

// Whether commands give the law's force at steps of any size (every_step), or only in the limit of small steps, because
// OpenSees integrates a differential equation (small_steps).
enum class Exactness { every_step, small_steps };

// Commands that together make a material or an element. The model uses what the last command makes.
struct Form {
  std::string id;  // "material", "material_original", "bearing"
  std::string title;
  Exactness exactness = Exactness::every_step;
  std::vector<MappedCommand> commands;
  std::string condition = {};  // a limitation that users are told, such as where the force is NaN; "" if there is none
  // The longest travel in one direction with a force that is not yet NaN: from rest, and from one side to the other.
  // Empty without such a limit.
  std::optional<double> longest_travel_mm = {}, longest_swing_mm = {};
  std::string since = {};  // first version of OpenSees that has the material; "" if all have it
};

std::vector<Command> in_units(Form const& form, UnitSystem const& units);

struct Mapping {
  std::vector<Form> forms;  // the preferred form is first; empty if OpenSees cannot express the law
  std::string reason;       // why OpenSees cannot express the law
};

// scale.stiffness multiplies the part of the force that grows with displacement, scale.strength the hysteretic part.
Mapping map_law(laws::LawEntry const& law, std::span<double const> parameters, BoundFactors const& scale = {});

laws::BilinearForm scaled(laws::BilinearForm values, BoundFactors const& scale);
laws::BoucWenForm scaled(laws::BoucWenForm values, BoundFactors const& scale);
laws::MenegottoPintoForm scaled(laws::MenegottoPintoForm values, BoundFactors const& scale);

// Return the law's values in kN and mm if it is bilinear, or if it is Bouc-Wen; nullopt for other laws. Limit curves
// without hardening count as Bouc-Wen with n = 1.
std::optional<laws::BilinearForm> bilinear_values(laws::LawEntry const& law, std::span<double const> parameters);
std::optional<laws::BoucWenForm> bouc_wen_values(laws::LawEntry const& law, std::span<double const> parameters);

}  // namespace isolaw::programs
