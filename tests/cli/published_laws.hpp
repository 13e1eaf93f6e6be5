// published_laws() has the seven laws of Cucuzza et al. 2025 with the parameters and units that docs/laws.md states.
// Tests compare isolaw with this list, because users' scripts may rely on names and units. expected_laws() has all laws
// of isolaw's catalogue.
#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/laws/catalogue.hpp"

namespace isolaw::cli_test {

struct ExpectedLaw {
  std::string_view id;
  std::vector<std::pair<std::string_view, std::string_view>> parameters;  // name and unit
};

inline std::vector<ExpectedLaw> const& published_laws() {
  static std::vector<ExpectedLaw> const laws{
      {"bilinear", {{"K1", "kN/mm"}, {"K2", "kN/mm"}, {"xy", "mm"}}},
      {"jankowski",
       {{"a1", "N/m"},
        {"a2", "N/m^3"},
        {"a3", "N/m^5"},
        {"a4", "N/m"},
        {"a5", "s/m"},
        {"a6", "N/m"},
        {"a7", "s/m"},
        {"a8", "1/m"},
        {"a9", "N"},
        {"a10", "N/m^2"},
        {"a11", "m/s"}}},
      {"vaiana",
       {{"Kb+", "N/m"},
        {"Kb-", "N/m"},
        {"f0+", "N"},
        {"f0-", "N"},
        {"alpha+", "1/m"},
        {"alpha-", "1/m"},
        {"beta1+", "N"},
        {"beta1-", "N"},
        {"beta2+", "1/m"},
        {"beta2-", "1/m"},
        {"gamma1+", "N"},
        {"gamma1-", "N"},
        {"gamma2+", "1/m"},
        {"gamma2-", "1/m"},
        {"gamma3+", "m"},
        {"gamma3-", "m"}}},
      {"bouc-wen", {{"alpha", "1"}, {"Ke", "kN/mm"}, {"A", "1"}, {"beta", "1/mm^n"}, {"n", "1"}, {"gamma", "1/mm^n"}}},
      {"abe",
       {{"K1", "kN/mm"},
        {"alpha", "mm"},
        {"beta", "1"},
        {"a", "kN"},
        {"b", "1/mm"},
        {"n", "1"},
        {"Y0", "kN"},
        {"Uh", "mm"},
        {"p", "1"},
        {"U0", "mm"},
        {"Us", "mm"},
        {"K2", "kN/mm"},
        {"r", "1"}}},
      {"abe-y0",
       {{"K1", "kN/mm"},
        {"alpha", "mm"},
        {"beta", "1"},
        {"a", "kN"},
        {"b", "1/mm"},
        {"n", "1"},
        {"Y0", "kN"},
        {"Uh", "mm"},
        {"U0", "mm"},
        {"Us", "mm"},
        {"K2", "kN/mm"},
        {"r", "1"}}},
      {"hwang-wu",
       {{"a1", "N/cm"},
        {"a2", "N/cm^3"},
        {"a3", "N/cm^5"},
        {"a4", "N/cm"},
        {"a5", "s/cm"},
        {"a6", "N"},
        {"a7", "N/cm^2"},
        {"a8", "cm/s"},
        {"a9", "1/(N cm)"},
        {"a10", "1/(N cm)"}}}};
  return laws;
}

inline std::vector<ExpectedLaw> const& expected_laws() {
  static std::vector<ExpectedLaw> const listed = [] {
    std::vector<ExpectedLaw> expected;
    for (auto const& law : laws::catalogue()) {
      expected.push_back({.id = law.info.id, .parameters = {}});
      for (auto const& p : law.parameters) expected.back().parameters.emplace_back(p.name, p.unit);
    }
    return expected;
  }();
  return listed;
}

}  // namespace isolaw::cli_test
