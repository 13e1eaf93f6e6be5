// Search boxes of Table 4 of Cucuzza et al. 2025 (Structures 73, 108355) as printed, in its order and units, with
// isolaw's parameter names. They were typed in independently of Table A.5. std::nullopt means that a bound is illegible
// in our copy.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace isolaw::table_4 {

struct Box {
  std::string_view law, parameter, unit;
  std::optional<double> lower, upper;
};

inline constexpr std::array boxes{
    Box{"bilinear", "K1", "kN/mm", 1.0, 1.9},
    Box{"bilinear", "K2", "kN/mm", 0.35, 0.95},
    Box{"bilinear", "xy", "mm", 30.0, 80.0},
    Box{"jankowski", "a1", "N/m", 1e4, 1e6},
    Box{"jankowski", "a2", "N/m^3", 1e6, 9e6},
    Box{"jankowski", "a3", "N/m^5", 1e6, 9e6},
    Box{"jankowski", "a4", "N/m", 1000.0, 1e5},
    Box{"jankowski", "a5", "s/m", 1000.0, 1e4},
    Box{"jankowski", "a6", "N/m", 1e5, 3.5e6},
    Box{"jankowski", "a7", "s/m", 0.0, 10.0},
    Box{"jankowski", "a8", "1/m", 5.0, 20.0},
    Box{"jankowski", "a9", "N", 1e4, 1e5},
    Box{"jankowski", "a10", "N/m^2", 1e4, 1e5},
    Box{"jankowski", "a11", "m/s", 0.0, 10.0},
    Box{"vaiana", "Kb+", "N/m", 1e5, 6e5},
    Box{"vaiana", "Kb-", "N/m", 1e5, 6e5},
    Box{"vaiana", "f0+", "N", 1e4, 1e5},
    Box{"vaiana", "f0-", "N", 1e4, 1e5},
    Box{"vaiana", "alpha+", "1/m", 0.0, 50.0},
    Box{"vaiana", "alpha-", "1/m", 0.0, 50.0},
    Box{"vaiana", "beta1+", "N", 0.0, 0.9},
    Box{"vaiana", "beta1-", "N", -0.9, 0.0},
    Box{"vaiana", "beta2+", "1/m", 15.0, 50.0},
    Box{"vaiana", "beta2-", "1/m", -50.0, -15.0},
    Box{"bouc-wen", "alpha", "1", 0.1, std::nullopt},
    Box{"bouc-wen", "Ke", "kN/mm", 2.0, 4.0},
    Box{"bouc-wen", "A", "1", 1.0, 2.0},
    Box{"bouc-wen", "beta", "1/mm^n (printed 1/mm)", 0.025, 0.075},
    Box{"bouc-wen", "n", "1", 1.0, 1.25},
    Box{"bouc-wen", "gamma", "1/mm^n (printed 1/mm)", 0.025, 0.075},
    Box{"abe-y0", "K1", "kN/mm", 5.0, 10.0},
    Box{"abe-y0", "alpha", "mm", 0.0, 10.0},
    Box{"abe-y0", "beta", "1", 0.01, 1.0},
    Box{"abe-y0", "a", "kN", 0.5, 1.0},
    Box{"abe-y0", "b", "1/mm", 5.0, 10.0},
    Box{"abe-y0", "n", "1", 0.01, 0.5},
    Box{"abe-y0", "Y0", "kN", 10.0, 70.0},
    Box{"abe-y0", "Uh", "mm", 50.0, 150.0},
    Box{"abe-y0", "p", "1", 0.01, 2.0},
    Box{"abe-y0", "U0", "mm", 2.0, 6.0},
    Box{"abe-y0", "Us", "mm", 5.0, 50.0},
    Box{"abe-y0", "K2", "kN/mm", 0.01, 0.5},
    Box{"abe-y0", "r", "1", 0.01, 0.2},
    Box{"hwang-wu", "a1", "N/cm", 2800.0, std::nullopt},
    Box{"hwang-wu", "a2", "N/cm^3", -5.0, -0.04},
    Box{"hwang-wu", "a3", "N/cm^5", 0.0001, 0.01},
    Box{"hwang-wu", "a4", "N/cm", 20.75, 90.0},
    Box{"hwang-wu", "a5", "s/cm", 0.001, 0.9},
    Box{"hwang-wu", "a6", "N", 1e4, 1.5e5},
    Box{"hwang-wu", "a7", "N/cm^2", 1.0, 8.0},
    Box{"hwang-wu", "a8", "cm/s", 50.0, 150.0},
    Box{"hwang-wu", "a9", "1/(N cm)", -5e-6, -1e-9},
    Box{"hwang-wu", "a10", "1/(N cm)", -2.925e-5, 0.0},
};

inline std::optional<Box> box_of(std::string_view law, std::string_view parameter) {
  for (auto const& box : boxes)
    if (box.law == law && box.parameter == parameter) return box;
  return std::nullopt;
}

}  // namespace isolaw::table_4
