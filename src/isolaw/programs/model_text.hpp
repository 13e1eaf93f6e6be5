// Shared by the Tcl and the Python text of a model.
#pragma once

#include <string>
#include <vector>

#include "isolaw/programs/self_check.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {

// Prefers a bearing element that couples both directions to springs.
Realised& form_of_model(Realisation& realisation);
Realised const& form_of_model(Realisation const& realisation);

// Adds a variant for every bearing of every draw; a law that stands in for another is fitted to each draw. Throws Error
// that names the first draw and bearing that the program cannot give. Returns the worst deviation of a form from its
// law.
Deviation add_draws(Realisation& realisation, Subject const& subject);
std::string drawn_variant(std::size_t draw, std::size_t bearing);  // both from 1: "draw_3_12"

// All numbers are in the units of the file.
struct ModelNumbers {
  bool coupled = false;
  std::string function;  // "bearing", "material"
  double gravity = 0.0, mass = 0.0, inertia = 0.0, x = 0.0, y = 0.0, weight = 0.0;
  struct One {
    std::string name;
    double x, y, angle_rad, load, K_v, mass;
  };
  std::vector<One> bearings;
  double motion_step_s = 0.0;
  int pieces = 1;  // analysis steps in one step of the motion
  std::vector<std::vector<double>> motions;
  double tolerance = 0.0;          // of Newton's rule, for displacements
  double tested = 0.0;             // largest tested displacement
  std::vector<std::string> cases;  // "lower", "nominal", ...; "nominal", "draw_1", ...
  bool held = false;               // held against turning, if there is only one bearing
};
ModelNumbers model_numbers(Subject const& subject, Realisation const& realisation, UnitSystem const& units);
std::vector<std::string> model_cautions(Subject const& subject, UnitSystem const& units);

std::vector<Fact> model_facts(Subject const& subject, Realisation const& realisation, UnitSystem const& units);
std::string run_usage(std::string_view command, std::string const& folder, ModelNumbers const& numbers);

std::string slab_header(UnitSystem const& units);
std::string peaks_header(UnitSystem const& units);

}  // namespace isolaw::programs
