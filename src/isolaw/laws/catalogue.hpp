// The laws by name, without their types, for code that chooses a law at run time (command line, campaign, reports).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/parts/canonical.hpp"

namespace isolaw::laws {

struct JointLimitEntry {
  std::string_view statement;
  std::vector<std::size_t> parameters;  // indices of the parameters that the statement names
  bool (*holds)(std::span<double const> parameters);
};

struct LawEntry {
  LawInfo info;
  std::size_t index = 0;  // position of the law in catalogue()
  std::vector<ParameterInfo> parameters;
  // Writes the force [law's unit] at each of path.samples() samples into `force`, for `parameters` in the law's order
  // and units. A force that overflows is infinite or NaN. If a parameter is not finite, all forces are NaN. Throws
  // nothing.
  void (*evaluate)(std::span<double const> parameters, Path const& path, Integration integration,
                   std::span<double> force);
  // Returns the law of analysis programs that equals this one (parts/canonical.hpp), for parameters in the law's order
  // and units.
  Canonical (*canonical)(std::span<double const> parameters) = nullptr;
  // Conditions between several parameters. unmet() gives the first one that `parameters` do not meet, for example found
  // "K1 = 1, K2 = 2" and statement "K1 >= K2", or nullopt if they meet all.
  std::vector<JointLimitEntry> joint_limits = {};
  struct Unmet {
    std::string found;
    std::string_view statement;
  };
  std::optional<Unmet> unmet(std::span<double const> parameters) const;
  // If a law has a redundant parameter, the parameters in `redundant_with` can make up for any change of it. `reduce`
  // sets the parameter that `redundant` names to `redundant_value`, and changes the others so that the forces stay the
  // same. For other laws the names are empty and `reduce` is null.
  std::string_view redundant = {};
  std::vector<std::string_view> redundant_with = {};
  double redundant_value = 0.0;
  void (*reduce)(std::span<double> parameters) = nullptr;
  // Changes `parameters` so that the elastic part of the force is a times, and the hysteretic or viscous part b times
  // as large; a and b are above 0. For hwang-wu this is exact only if a = b. If `one_factor` is true, no parameters
  // tell the two parts apart, and the whole force becomes a times as large.
  void (*with_factors)(std::span<double> parameters, double a, double b) = nullptr;
  bool one_factor = false;

  std::size_t index_of(std::string_view parameter) const;  // throws an Error that lists the law's parameters
};

std::span<LawEntry const> catalogue();
// Words that name several laws at once. The sets nest: "all" contains "usual", which contains "paper".
inline constexpr std::pair<std::string_view, LawSet> law_sets[]{
    {"paper", LawSet::paper}, {"usual", LawSet::usual}, {"all", LawSet::further}};
inline std::string_view name(LawSet set) {
  return law_sets[static_cast<std::size_t>(set)].first;
}
std::string_view memory_of(LawInfo const& law);      // what the law remembers of its path: "turning points", ...
LawEntry const& find_law(std::string_view id);       // throws an Error that lists the laws
std::string_view display_name(std::string_view id);  // "Bouc-Wen" for "bouc-wen"; the id itself if no law has it

}  // namespace isolaw::laws
