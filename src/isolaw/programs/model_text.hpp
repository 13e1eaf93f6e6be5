// The facts and numbers of a building model, which its Tcl script and its Python module both contain.
#pragma once

#include <string>
#include <vector>

#include "isolaw/programs/self_check.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {

// Returns the form that a model uses. A form is a list of commands that stand for the law in the analysis program. A
// bearing element that couples both directions is preferred, if there is one.
Realised& form_of_model(Realisation& realisation);
Realised const& form_of_model(Realisation const& realisation);

// Adds a form, which is a law in the terms of the target program, for every bearing of every draw. If the program lacks
// the law itself, the form is a re-fit to the drawn law. Throws Error for the first drawn law that has no form. Returns
// the largest deviation of a form from its drawn law.
Deviation add_draws(Realisation& realisation, Subject const& subject);
std::string drawn_variant(std::size_t draw, std::size_t bearing);  // counted from 1: "draw_3_12"

// The model's numbers, in the units of the exported file.
struct ModelNumbers {
  bool coupled = false;
  std::string function;  // name of the script's function that makes an isolator: "bearing" or "material"
  double gravity = 0.0, mass = 0.0, inertia = 0.0, x = 0.0, y = 0.0, weight = 0.0;
  struct One {
    std::string name;
    double x, y, angle_rad, load, K_v, mass;
  };
  std::vector<One> bearings;
  double motion_step_s = 0.0;
  int pieces = 1;  // number of analysis steps in one step of the ground motion
  std::vector<std::vector<double>> motions;
  double tolerance = 0.0;          // Newton's rule stops at displacement changes below this
  double tested = 0.0;             // largest displacement in the tests
  std::vector<std::string> cases;  // names of the analyses: "lower", "nominal", ... or "nominal", "draw_1", ...
  bool held = false;               // true if the slab rests on one bearing and is therefore held against turning
};
ModelNumbers model_numbers(Subject const& subject, Realisation const& realisation, UnitSystem const& units);
std::vector<std::string> model_cautions(Subject const& subject, UnitSystem const& units);

std::vector<Fact> model_facts(Subject const& subject, Realisation const& realisation, UnitSystem const& units);
std::string run_usage(std::string_view command, std::string const& folder, ModelNumbers const& numbers);

std::string slab_header(UnitSystem const& units);
std::string peaks_header(UnitSystem const& units);

}  // namespace isolaw::programs
