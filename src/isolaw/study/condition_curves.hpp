// The lines of the figures of `isolaw conditions`: the factor over temperature, frequency, load or cycles, for every
// device and for their mean.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isolaw/study/conditions.hpp"

namespace isolaw::study {

enum class CurveKind {
  device,        // one device, through the levels at which it was tested
  mean,          // mean over the devices that were tested at both of two neighbouring levels
  extrapolated,  // from the outermost level to an end of the design range
  smooth,        // a curve fitted to the levels (CurveRow), only for drawing
};
std::string_view name(CurveKind kind);

struct ConditionCurve {
  rules::Quantity quantity;
  conditions::Effect effect;
  CurveKind kind;
  std::string device;              // for CurveKind::device, and for CurveKind::smooth over cycles
  std::vector<double> at, lambda;  // the condition in C, Hz or kN, or the cycle, and the factor
};

std::vector<ConditionCurve> condition_curves(ConditionsResult const& result);

}  // namespace isolaw::study
