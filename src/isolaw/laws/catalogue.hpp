// The laws by name, for everything that is decided while running: command line, campaign, reports.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/laws/canonical.hpp"
#include "isolaw/laws/law.hpp"

namespace isolaw::laws {

struct JointLimitEntry {
  std::string_view statement;
  std::vector<std::size_t> parameters;  // those that it names
  bool (*holds)(std::span<double const> parameters);
};

struct LawEntry {
  LawInfo info;
  std::size_t index = 0;  // in the catalogue
  std::vector<ParameterInfo> parameters;
  // Force [law's unit] at every sample of the path into `force` (path.samples() values). `parameters` in order.
  // Values that overflow come out infinite or NaN, and so do all for a parameter that is not finite; nothing is thrown.
  void (*evaluate)(std::span<double const> parameters, Path const& path, Integration integration,
                   std::span<double> force);

  // The law as analysis programs know it, its parameters in its own units.
  Canonical (*canonical)(std::span<double const> parameters) = nullptr;

  // What parameters must meet together, and the first of it that these do not: "K1 = 1, K2 = 2" with the statement.
  std::vector<JointLimitEntry> joint_limits = {};
  struct Unmet {
    std::string found;
    std::string_view statement;
  };
  std::optional<Unmet> unmet(std::span<double const> parameters) const;

  // Where parameters are redundant by the law's form: the name of the one that can be fixed without loss, those it
  // trades off with, and the change to parameters of the same forces in which it has its fixed value. Empty and null
  // elsewhere.
  std::string_view redundant = {};
  std::vector<std::string_view> redundant_with = {};
  double redundant_value = 0.0;
  void (*reduce)(std::span<double> parameters) = nullptr;

  // Index of a parameter; throws Error that lists the law's parameters.
  std::size_t index_of(std::string_view parameter) const;
};

std::span<LawEntry const> catalogue();

// The words for several laws: the least of them that has a law is its own.
inline constexpr std::pair<std::string_view, LawSet> law_sets[]{
    {"paper", LawSet::paper}, {"usual", LawSet::usual}, {"all", LawSet::further}};
inline std::string_view name(LawSet set) {
  return law_sets[static_cast<std::size_t>(set)].first;
}

// What a law remembers of its path, in words.
std::string_view memory_of(LawInfo const& law);

// Throws Error that lists the laws.
LawEntry const& find_law(std::string_view id);

// Its name among people; the id itself of a law that is not there.
std::string_view called(std::string_view id);

}  // namespace isolaw::laws
