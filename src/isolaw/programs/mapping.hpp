// From a law's parameters to the commands of OpenSees that give the same force: argument orders, normalisations and units.
// What is mapped is not yet believed: realise.hpp replays it on the calibration record.
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
  std::string condition;  // where it holds, beyond the records; "" for everywhere
  // The longest travel in one direction that it stands, in mm; empty: any.
  std::optional<double> longest_travel_mm;
};

std::vector<Command> in_units(Form const& form, UnitSystem const& units);

// The three numbers of a bilinear loop, and Bouc-Wen with A = 1.
struct BilinearValues {
  double K1, K2, uy;  // kN/mm, mm
};
struct BoucWenValues {
  double alpha, Ke, beta, gamma, n;  // kN/mm, 1/mm^n

  double z_max() const;  // mm; the yield displacement
};

struct Mapping {
  std::vector<Form> forms;  // the first is the one to use; empty: none is exact
  std::string why;          // why there is none
};

// The exact forms of a law, its parameters in its own units. `scale` multiplies the part of the force that grows with
// displacement and the hysteretic part; laws whose parameters cannot tell them apart take `stiffness` for all.
Mapping map_law(laws::LawEntry const& law, std::span<double const> parameters, BoundFactors const& scale = {});

// Whether the two factors can act on the law's parts by themselves.
bool has_separate_parts(laws::LawEntry const& law, std::span<double const> parameters);

BilinearValues scaled(BilinearValues values, BoundFactors const& scale);
BoucWenValues scaled(BoucWenValues values, BoundFactors const& scale);

// The Bouc-Wen values of the same force: of bouc-wen itself, and of vaiana without hardening and with equal branches.
std::optional<BoucWenValues> equivalent_bouc_wen(laws::LawEntry const& law, std::span<double const> parameters);

std::optional<BilinearValues> bilinear_values(laws::LawEntry const& law, std::span<double const> parameters);
std::optional<BoucWenValues> bouc_wen_values(laws::LawEntry const& law, std::span<double const> parameters);

}  // namespace isolaw::programs
