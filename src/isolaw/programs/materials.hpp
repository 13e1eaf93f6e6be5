// The OpenSees materials and elements that laws are exported to, implemented from their published formulas (never from
// the program's code), with arguments in the order of the command. An export is called exact only if replaying them
// agrees. Sources: Steel01, OpenSees command manual (kinematic hardening, without its optional isotropic part).
// Steel02: Filippou et al. 1983 as in that manual, likewise. BoucWen: Wen 1976 as in Haukaas and Der Kiureghian 2003, z
// by backward Euler. BoucWenOriginal and elastomericBearingBoucWen: Park, Wen and Ang 1986, z dimensionless, backward
// Euler. elastomericBearingPlasticity: return mapping. HystereticAsym: Vaiana et al. 2018/2021. Newton's rule finds z
// from the program's start with its number of iterations; if it does not converge, the force is NaN.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace isolaw::programs {

class Material {
 public:
  virtual ~Material() = default;
  // Sets the displacement, commits, returns the force. Starts at displacement 0, force 0.
  virtual double force(double disp) = 0;
};

// Values of the bearing's -iter option; the program's default is 25 iterations.
inline constexpr int bearing_iterations = 100;
inline constexpr double bearing_tolerance = 1e-9;

// A command that combines materials follows them: a Multiplier takes the last one not yet taken, Parallel the last two.
struct Command {
  std::string name;
  std::vector<double> arguments;
};

// Offsets to the tag that the user gives: 0 for the last command, 1, 2, ... for the others.
struct Tags {
  std::size_t own = 0;
  std::vector<std::size_t> inner;  // offsets of the materials that it combines
};
// Throws Error if a command lacks a material to combine, or if more than the last material is left over.
std::vector<Tags> tags_of(std::span<Command const> commands);

// Why the program refuses the arguments, by the limits that its parsers state; "" if it accepts them.
std::string refused_by_program(std::span<Command const> commands);

// Throws Error for an unknown name, too few or too many arguments, and as tags_of does.
std::unique_ptr<Material> make_material(std::span<Command const> commands);

// Force after each displacement, from the virgin state at displacement 0. After a NaN all forces are NaN, as in the
// program.
std::vector<double> replay(std::span<Command const> commands, std::span<double const> disp);

}  // namespace isolaw::programs
