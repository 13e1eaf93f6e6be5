// Makes parameter sets for the tests of the laws, and computes their forces by laws::run in double precision.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "isolaw/laws/all_laws.hpp"
#include "isolaw/num/random.hpp"
#include "laws/motion.hpp"

namespace isolaw::law_tests {

template <class Law>
using Values = std::array<double, laws::parameter_count<Law>>;

inline constexpr std::array both_integrations{laws::Integration::converged, laws::Integration::paper};

inline std::string_view name_of(laws::Integration integration) {
  return integration == laws::Integration::paper ? "paper" : "converged";
}

// Converts a std::tuple of laws, such as AllLaws, to the testing::Types that typed tests need.
template <class Tuple>
struct AsTypes;
template <class... Law>
struct AsTypes<std::tuple<Law...>> {
  using type = ::testing::Types<Law...>;
};
using EveryLaw = AsTypes<laws::AllLaws>::type;

struct LawName {
  template <class Law>
  static std::string GetName(int) {
    std::string name(Law::info.id);
    std::ranges::replace(name, '-', '_');
    return name;
  }
};

// Returns the sizes of a device like those of Cucuzza et al. 2025, tested at 0.5 Hz and 208 mm, with a peak force of
// 140 kN.
template <class Law>
laws::RecordScales published_device() {
  double const force = 1.0 / Law::info.force.in_record_units, length = 1.0 / Law::info.length.in_record_units;
  return {.disp = 208.0 * length,
          .force = 140.0 * force,
          .stiffness = 0.67 * force / length,
          .strength = 45.0 * force,
          .velocity = 650.0 * length,
          .work = 1e5 * force * length};
}

// Returns the search box of Table 4 in Cucuzza et al. 2025. A parameter without an interval in that table (vaiana's
// sigmoid) gets the interval that isolaw chooses for an unknown device of the same size.
template <class Law>
std::array<laws::Interval, laws::parameter_count<Law>> box() {
  std::array<laws::Interval, laws::parameter_count<Law>> intervals{};
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    auto const& info = Law::template rows<double>[i].info;
    intervals[i] = info.published ? *info.published : info.scaled(published_device<Law>());
  }
  return intervals;
}

// Returns the random parameter set number `index`, uniform in the published box. The same index always gives the same
// set.
template <class Law>
Values<Law> candidate(std::uint32_t index) {
  num::Draws draws(num::Stream(20250108), 0, index);
  Values<Law> values{};
  auto const intervals = box<Law>();
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = intervals[i].lower + draws.uniform() * (intervals[i].upper - intervals[i].lower);
  return values;
}

// Returns the random parameter set number `index` from the box that isolaw chooses for an unknown device of the
// published size. Each parameter is uniform on the scale that it declares, linear or logarithmic. Parameters that are
// fixed by default keep their fixed values.
template <class Law>
Values<Law> scaled_candidate(std::uint32_t index) {
  num::Draws draws(num::Stream(20250109), 0, index);
  Values<Law> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    auto const& info = Law::template rows<double>[i].info;
    auto const [lower, upper] = info.scaled(published_device<Law>());
    double const share = draws.uniform();
    if (info.fixed_by_default)
      values[i] = *info.fixed_by_default;
    else if (info.scaled_search == laws::Scale::logarithmic)
      values[i] = lower * std::pow(upper / lower, share);
    else
      values[i] = lower + share * (upper - lower);
  }
  return values;
}

template <class Law>
std::size_t index_of(std::string_view name) {
  auto const& rows = Law::template rows<double>;
  auto const found = std::ranges::find_if(rows, [&](auto const& row) { return row.info.name == name; });
  if (found == rows.end()) throw std::invalid_argument(std::string(name));
  return static_cast<std::size_t>(found - rows.begin());
}

// Makes a parameter set from pairs of name and value. Parameters that are not named are 0.
template <class Law>
Values<Law> named(std::initializer_list<std::pair<std::string_view, double>> parameters) {
  Values<Law> values{};
  for (auto const& [name, value] : parameters) values[index_of<Law>(name)] = value;
  return values;
}

template <class Law>
std::vector<double> forces(Values<Law> const& values, laws::Path const& path,
                           laws::Integration integration = laws::Integration::converged) {
  std::vector<double> out(path.samples());
  laws::run<Law, double>(laws::unpack<Law, double>(values), path, integration,
                         [&](std::size_t i, double force) { out[i] = force; });
  return out;
}

template <class Law>
std::vector<double> forces(Values<Law> const& values, Motion const& motion, int refinement = 1,
                           laws::Integration integration = laws::Integration::converged) {
  return forces<Law>(values, path_of<Law>(motion, refinement), integration);
}

// Returns the parameters as text for failure messages, such as "K1 = 1.5, K2 = 0.4", with all digits.
template <class Law>
std::string describe(Values<Law> const& values) {
  std::ostringstream text;
  text.precision(17);
  for (std::size_t i = 0; i < values.size(); ++i)
    text << (i == 0 ? "" : ", ") << Law::template rows<double>[i].info.name << " = " << values[i];
  return text.str();
}

}  // namespace isolaw::law_tests
