// The numbers of the self-check in every exported file: the motion, the law's forces, and the forces that the analysis
// program must give.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isolaw/programs/realise.hpp"

namespace isolaw::programs {

// The largest difference from the expected force that a self-check allows, as a share of the largest expected force.
// The numbers in the file have ten digits, and the analysis program adds rounding of its own.
inline constexpr double check_tolerance = 1e-8;

// For a check of the law itself: the motion, rounded as in the file, and the force that the law's exported code gives.
// This force is not taken from law_force(): for a law with an exact flow (laws/flows/), the exported code reads the
// law's curve from a table and law_force() does not, so the two forces differ slightly.
struct LawCheck {
  std::vector<double> disp, velocity, force;
};
LawCheck law_check(Subject const& subject, UnitSystem const& units);

struct CheckedVariant {
  std::string name;  // "nominal", "lower", "upper", or the name of a draw
  std::vector<Command> commands;
  std::vector<Tags> tags;     // one element for each command
  std::vector<double> force;  // the force that the program must give
};

struct CheckedForm {
  Form const* form = nullptr;
  std::string function;  // name of the script's function that makes this form, such as "material"
  bool is_element = false;
  std::vector<CheckedVariant> variants;
};

struct SelfCheck {
  std::vector<double> disp, law;  // in the units of the script
  std::vector<CheckedForm> forms;
};

// Returns a text for users about the tags that a form needs, such as "uses the tag after the given one too". Returns ""
// if the form needs only the given tag.
std::string tags_text(Form const& form);

SelfCheck self_check(Subject const& subject, Realisation const& realisation, UnitSystem const& units);

std::string number_lines(std::vector<double> const& values, std::string_view separator, std::string_view indent);

}  // namespace isolaw::programs
