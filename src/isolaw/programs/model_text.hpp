// Shared by the Tcl and the Python text of a model: the form that carries the bearings, steps in time, tags, cases and
// the facts in the file's head.
#pragma once

#include <string>
#include <vector>

#include "isolaw/programs/self_check.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {

// The form that the model uses: the bearing element that couples both directions if there is one, else springs.
Realised& form_of_model(Realisation& realisation);
Realised const& form_of_model(Realisation const& realisation);

// Adds a variant of the model's form for every bearing of every draw; a law that stands in is fitted to each of them.
// Throws Error that names the first draw and bearing whose law the program cannot give. Returns the worst deviation of
// a drawn form from its own law.
Deviation add_draws(Realisation& realisation, Subject const& subject);
std::string drawn_variant(std::size_t draw, std::size_t bearing);  // both from 1: "draw_3_12"

// All in the units of the file.
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
  int pieces = 1;  // steps of the analysis to one of the motion
  std::vector<std::vector<double>> motions;
  double tolerance = 0.0;          // of Newton's rule, on displacements
  double tested = 0.0;             // largest tested displacement
  std::vector<std::string> cases;  // "lower", "nominal", ...; "nominal", "draw_1", ...
  bool held = false;               // against turning, where there is only one bearing
};
ModelNumbers model_numbers(Subject const& subject, Realisation const& realisation, UnitSystem const& units);

// One sentence for each thing in the model that lies outside the tests.
std::vector<std::string> model_cautions(Subject const& subject, UnitSystem const& units);

std::vector<Fact> model_facts(Subject const& subject, Realisation const& realisation, UnitSystem const& units);

// Comment lines that tell how to run the analyses.
std::string run_usage(std::string_view command, std::string const& folder, ModelNumbers const& numbers);

// First lines of the result files.
std::string slab_header(UnitSystem const& units);
std::string peaks_header(UnitSystem const& units);

}  // namespace isolaw::programs
