// The materials and elements of OpenSees that laws are exported to, as they compute a force from a history of
// displacements: our own stepping from the published formulas, with the arguments in the order of the command. What an
// export is called is decided by these, not by the formulas it was derived from.
//
// Sources: Steel01, OpenSees command manual (kinematic hardening without its optional isotropic part). Steel02:
// Filippou et al. 1983 as in that manual, likewise. BoucWen: Wen 1976
// as in Haukaas and Der Kiureghian 2003, z by backward Euler. BoucWenOriginal and elastomericBearingBoucWen: Park, Wen
// and Ang 1986, z dimensionless, backward Euler. elastomericBearingPlasticity: return mapping. HystereticAsym: Vaiana
// et al. 2018/2021, algebraic. Multiplier: a factor on the force.
// The programs iterate for z; here the equation is solved to rounding, so an iteration that ends early shows in the
// self-check of the exported file and not here.
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

// One command of a program: the name of the material or element and its arguments after the tags.
struct Command {
  std::string name;
  std::vector<double> arguments;
};

// Throws Error: unknown name, too few or too many arguments. A Multiplier takes the material before it in `commands`.
std::unique_ptr<Material> make_material(std::span<Command const> commands);

// Force after each displacement, from the virgin state at displacement 0. NaN stays NaN to the end, as in the program.
std::vector<double> replay(std::span<Command const> commands, std::span<double const> disp);

}  // namespace isolaw::programs
