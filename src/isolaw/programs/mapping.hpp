// From a law's parameters to the commands of OpenSees that give the same force: argument orders, normalisations and
// units. What is mapped is not yet believed: realise.hpp replays it on the calibration record.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isolaw/programs/materials.hpp"
#include "isolaw/programs/subject.hpp"
#include "isolaw/programs/unit_system.hpp"

namespace isolaw::programs {

// A value in kN^force_power mm^length_power, as it is converted to another unit system.
struct Argument {
  std::string name;  // as in the program's manual
  double value = 0.0;
  double force_power = 0.0, length_power = 0.0;
};

struct MappedCommand {
  std::string name;
  std::vector<Argument> arguments;
};

// How exact a form can be at best: algebraic ones are so at every step, others as the step goes to zero.
enum class Exactness { every_step, small_steps };

// One way to realise a law: commands one after another, the last of them the one to be used.
struct Form {
  std::string id;  // "material", "material_original", "bearing"
  std::string title;
  Exactness exactness = Exactness::every_step;
  std::vector<MappedCommand> commands;
  std::string condition = {};  // where it holds, beyond the records; "" for everywhere
  // The longest travel in one direction that it stands, from rest and between two sides alike, in mm; empty: any.
  std::optional<double> longest_travel_mm = {}, longest_swing_mm = {};
  std::string since = {};  // the first version of the program that has it; "" where any has
};

std::vector<Command> in_units(Form const& form, UnitSystem const& units);

struct Mapping {
  std::vector<Form> forms;  // the first is the one to use; empty: none is exact
  std::string why;          // why there is none
};

// The exact forms of a law, its parameters in its own units. `scale` multiplies the part of the force that grows with
// displacement and the hysteretic part; laws whose parameters cannot tell them apart take `stiffness` for all.
Mapping map_law(laws::LawEntry const& law, std::span<double const> parameters, BoundFactors const& scale = {});

laws::BilinearForm scaled(laws::BilinearForm values, BoundFactors const& scale);
laws::BoucWenForm scaled(laws::BoucWenForm values, BoundFactors const& scale);
laws::MenegottoPintoForm scaled(laws::MenegottoPintoForm values, BoundFactors const& scale);

// The numbers of a law that has the form by itself, in kN and mm; Bouc-Wen's also where limit curves are those of it.
std::optional<laws::BilinearForm> bilinear_values(laws::LawEntry const& law, std::span<double const> parameters);
std::optional<laws::BoucWenForm> bouc_wen_values(laws::LawEntry const& law, std::span<double const> parameters);

}  // namespace isolaw::programs
