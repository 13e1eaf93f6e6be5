// A law for the materials and sections of this library, and what all copies of one of them share.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "program.hpp"

// The arguments of the calls for Python (calls.cpp), in the order of the class of the same name in isolaw/opensees.py.
extern "C" struct IsolawLaw {
  char const* id;
  double const* parameters;  // in the law's order and units
  std::size_t count;
  double dead_band;       // in the law's unit of length; only laws with a memory use it
  int parts;              // equal parts into which each step is divided
  double length_to_law;   // the law's units of length in one of the model
  double force_from_law;  // the model's units of force in one of the law
  double factor;          // on the force: 1, or the factor of a bound
  double lower, upper;    // factors of the bounds; not a number if there are none
  int springs;            // sections: 0 for one state in both directions, else the number of springs
  double axes[2][3];      // sections of laws that depend on velocity: the local axes y and z in global coordinates
};

namespace isolaw::opensees {

enum class ParameterKind { factor = 1, lower, upper };

struct Law {
  std::string id;
  double length_to_law, force_from_law, lower, upper;
  bool depends_on_velocity;

  explicit Law(IsolawLaw const& given);
  // The factor on the force after the parameter was set to `value`. 1 makes `lower` the lower bound and 0 the nominal
  // law. Not a number if the law has no such bound.
  double factor_of(ParameterKind parameter, double value) const;
  double value_of(ParameterKind parameter, double factor) const;  // the value that gives this factor; 0 if none does
};

// Adds the parameter that `words` name to the program's Parameter, with the value that `factor` has. Returns what
// setParameter() returns.
int set_parameter(Program const& program, Law const& law, double factor, void* movable, char const** words, int count,
                  void* parameter);

void add_material(Program const& program, int tag, IsolawLaw const& law);  // throws Error if the tag exists
void add_section(Program const& program, int tag, IsolawLaw const& law);

}  // namespace isolaw::opensees
