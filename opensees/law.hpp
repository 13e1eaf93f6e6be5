// A law for the materials and sections of this library: the arguments that Python passes, and the values that all
// copies of a material or section share.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "program.hpp"

// The arguments of isolaw_material() and isolaw_section() in calls.cpp. The class _Law in isolaw/opensees.py has the
// same members in the same order.
extern "C" struct IsolawLaw {
  char const* id;
  double const* parameters;  // in the law's order and units
  std::size_t count;
  double dead_band;       // in the law's unit of length; a law that remembers its path ignores smaller reversals
  int parts;              // equal parts into which each step is divided
  double length_to_law;   // a length in the model's unit times this factor is the length in the law's unit
  double force_from_law;  // a force in the law's unit times this factor is the force in the model's unit
  double factor;          // multiplies the force: 1 for the law itself, else the factor of a bound
  double lower, upper;    // factors of the bounds; NaN for a bound that the law does not have
  int springs;            // for sections: the number of springs, or 0 for one law that couples both directions
  double axes[2][3];      // for sections of laws that depend on velocity: the local axes y and z in global coordinates
};

namespace isolaw::opensees {

enum class ParameterKind { factor = 1, lower, upper };

struct Law {
  std::string id;
  double length_to_law, force_from_law, lower, upper;
  bool depends_on_velocity;

  explicit Law(IsolawLaw const& given);
  // Returns the factor on the force for this value of the parameter. For ParameterKind::lower and upper, the value 1
  // gives the bound and 0 the nominal law. Returns NaN if the law has no such bound.
  double factor_of(ParameterKind parameter, double value) const;
  // Returns the value of the parameter for which factor_of() returns this factor; 0 if there is no such value.
  double value_of(ParameterKind parameter, double factor) const;
};

// Lets the Parameter object `parameter` of OpenSees change the factor on the force. words[0] says what the parameter's
// value means: "factor", "lower" or "upper" (factor_of). Gives the parameter the value that belongs to the current
// factor. Returns what setParameter() of OpenSees returns, which is -1 for another name.
int set_parameter(Program const& program, Law const& law, double factor, void* movable, char const** words, int count,
                  void* parameter);

void add_material(Program const& program, int tag, IsolawLaw const& law);  // throws Error if the tag exists
void add_section(Program const& program, int tag, IsolawLaw const& law);

}  // namespace isolaw::opensees
