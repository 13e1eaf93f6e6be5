// The materials and elements of OpenSees that laws are exported to, as they compute a force from a history of
// displacements: our own stepping from the published formulas, with the arguments in the order of the command. What an
// export is called is decided by these, not by the formulas it was derived from.
//
// Sources: Steel01, OpenSees command manual (kinematic hardening without its optional isotropic part). Steel02:
// Filippou et al. 1983 as in that manual, likewise. BoucWen: Wen 1976
// as in Haukaas and Der Kiureghian 2003, z by backward Euler. BoucWenOriginal and elastomericBearingBoucWen: Park, Wen
// and Ang 1986, z dimensionless, backward Euler. elastomericBearingPlasticity: return mapping. HystereticAsym: Vaiana
// et al. 2018/2021, algebraic. Multiplier: a factor on the force. Parallel: the sum of two.
// Where the programs iterate for z by Newton's rule so does this, from where they begin and as often: a force is no
// number where that does not end.
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

// What the bearing's -iter option is given; the program's own is 25 times.
inline constexpr int bearing_iterations = 100;
inline constexpr double bearing_tolerance = 1e-9;

// One command of a program: the name of the material or element and its arguments after the tags. What stands on other
// materials comes after them: a Multiplier takes the last one that nothing has taken, Parallel the last two.
struct Command {
  std::string name;
  std::vector<double> arguments;
};

// The tags of commands: the last one has the tag that is asked for, those that it stands on the ones after that.
struct Tags {
  std::size_t own = 0;             // above the tag asked for
  std::vector<std::size_t> inner;  // of what it stands on
};
// Throws Error: a command that lacks what it stands on, or one that nothing takes before the last.
std::vector<Tags> tags_of(std::span<Command const> commands);

// What the program refuses in the arguments: "" where it takes them. Limits as its parsers state them.
std::string refused_by_program(std::span<Command const> commands);

// Throws Error: unknown name, too few or too many arguments, or as tags_of.
std::unique_ptr<Material> make_material(std::span<Command const> commands);

// Force after each displacement, from the virgin state at displacement 0. NaN stays NaN to the end, as in the program.
std::vector<double> replay(std::span<Command const> commands, std::span<double const> disp);

}  // namespace isolaw::programs
