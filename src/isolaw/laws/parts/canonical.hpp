// The hysteretic laws that analysis programs offer, as plain numbers in the units of isolaw's law. If a law equals one
// of them, for some or all values of its parameters, its function canonical(params) returns that form. The module
// programs/ converts the numbers to the arguments of a program.
#pragma once

#include <cmath>
#include <string_view>
#include <variant>

namespace isolaw::laws {

// F = K2 x + z, where z is elastic-perfectly plastic with the stiffness K1 - K2 and yields at the displacement uy.
struct BilinearForm {
  double K1, K2, uy;
};

// F = alpha Ke x + (1 - alpha) Ke z, dz/dx = 1 - |z|^n (beta sgn(z dx) + gamma).
struct BoucWenForm {
  double alpha, Ke, beta, gamma, n;

  double z_max() const { return std::pow(beta + gamma, -1.0 / n); }  // the largest |z|: the yield displacement
};

// F = b E x + (1 - b) z with the branches of Menegotto and Pinto between reversals. cR1 and cR2 lower the sharpness R0.
struct MenegottoPintoForm {
  double E, Fy, b, R0, cR1, cR2;
};

// F approaches the curve Kb x + f0 + beta1 (exp(beta2 x) - 1); in unloading, -f0 stands in place of f0. A step dx
// multiplies the distance of F from the curve by exp(-alpha |dx|). `sigmoid` is the size of a further term of the
// curve, a sigmoid.
struct LimitCurve {
  double Kb, f0, alpha, beta1, beta2, sigmoid;
};
struct LimitCurvesForm {
  LimitCurve loading, unloading;
};

// No form above equals the law. `lacking` names the part of the law that none of them has, or is empty.
struct NoForm {
  std::string_view lacking = {};
};

using Canonical = std::variant<NoForm, BilinearForm, BoucWenForm, MenegottoPintoForm, LimitCurvesForm>;

}  // namespace isolaw::laws
