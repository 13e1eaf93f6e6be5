// The OpenSees materials and elements that exports use, programmed from published formulas and never from the code of
// OpenSees. Arguments are in the order of the command. An export is called exact only if replaying its commands here
// agrees with the law. The formulas and their sources are:
//   Steel01: OpenSees command manual (kinematic hardening, without the optional isotropic part)
//   Steel02: Filippou et al. 1983 as in that manual, without the isotropic part
//   BoucWen: Wen 1976 as in Haukaas and Der Kiureghian 2003, with backward Euler
//   BoucWenOriginal, elastomericBearingBoucWen: Park, Wen and Ang 1986, z without unit, with backward Euler
//   elastomericBearingPlasticity: return mapping
//   HystereticAsym: Vaiana et al. 2018/2021
// The Bouc-Wen commands find their variable z by Newton's rule, with the start value and the iteration limit of
// OpenSees. If Newton's rule fails, the force is NaN.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace isolaw::programs {

class Material {
 public:
  virtual ~Material() = default;
  // Moves to `disp`, commits, and returns the force. A new material has displacement 0 and force 0.
  virtual double force(double disp) = 0;
};

// The option -iter of elastomericBearingBoucWen in exports. Without it OpenSees stops after 25 iterations.
inline constexpr int bearing_iterations = 100;
inline constexpr double bearing_tolerance = 1e-9;

// A command of OpenSees that makes a material or an element. The command Multiplier uses the last material before it
// that no other command has used; Parallel uses the last two.
struct Command {
  std::string name;
  std::vector<double> arguments;
};

// The tags of the material that a command makes and of the materials that it uses, as offsets from the tag that the
// user gives. The last command of a list makes the material that the user asked for, so the tag of this material has
// the offset 0. The materials of the other commands have the offsets 1, 2, ...
struct Tags {
  std::size_t own = 0;
  std::vector<std::size_t> inner;  // offsets of the materials that this command uses
};
// Throws Error if a command finds too few materials to use, or if not exactly one unused material is left at the end.
std::vector<Tags> tags_of(std::span<Command const> commands);

// Returns a text that names the first argument that OpenSees refuses and the limit it breaks, or "" if it accepts all.
std::string refused_by_program(std::span<Command const> commands);

// Throws Error for an unknown name, for a wrong number of arguments, and where tags_of() does.
std::unique_ptr<Material> make_material(std::span<Command const> commands);

// Returns the force after each displacement, from displacement 0 on. After a force of NaN all are NaN, as in OpenSees.
std::vector<double> replay(std::span<Command const> commands, std::span<double const> disp);

}  // namespace isolaw::programs
