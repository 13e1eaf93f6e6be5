// The tables of Cucuzza et al. 2025, and what docs/source.md states about the laws of that paper. Tests that use the
// list PaperLaws run only for these laws.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "isolaw/laws/catalogue.hpp"
#include "isolaw/study/table_a5.hpp"
#include "laws/candidates.hpp"
#include "verification/table_4.hpp"

namespace isolaw::law_tests {

using OfThePaper =
    std::tuple<laws::Bilinear, laws::Jankowski, laws::Vaiana, laws::BoucWen, laws::Abe, laws::AbeY0, laws::HwangWu>;
using PaperLaws = AsTypes<OfThePaper>::type;

template <class Law, class List = OfThePaper>
inline constexpr bool of_the_paper = false;
template <class Law, class... Listed>
inline constexpr bool of_the_paper<Law, std::tuple<Listed...>> = (std::is_same_v<Law, Listed> || ...);

struct PaperFacts {
  std::string_view units;  // force and length unit in Table 4
  std::size_t parameters, free_by_default;
  laws::Traits traits;
};
inline std::map<std::string_view, PaperFacts> const paper_facts{
    {"bilinear", {"kN mm", 3, 3, {.rate_independent = true, .odd = true}}},
    {"jankowski", {"N m", 11, 11, {.odd = true}}},
    {"vaiana", {"N m", 16, 10, {.rate_independent = true}}},
    {"bouc-wen", {"kN mm", 6, 6, {.rate_independent = true, .odd = true, .path_integrated = true}}},
    {"abe", {"kN mm", 13, 13, {.rate_independent = true, .odd = true, .path_integrated = true}}},
    {"abe-y0", {"kN mm", 12, 12, {.rate_independent = true, .odd = true, .path_integrated = true}}},
    {"hwang-wu", {"N cm", 10, 10, {.odd = true, .path_integrated = true}}}};

// Returns the rows of Table A.5 for a law. The laws abe and abe-y0 have the same rows.
template <class Law>
table_a5::Law const& published() {
  std::string_view const id = Law::info.id == std::string_view("abe") ? "abe-y0" : Law::info.id;
  return *std::ranges::find_if(table_a5::laws, [&](auto const& law) { return law.id == id; });
}

// Returns the mean parameters that Table A.5 gives for a device (0 to 9). vaiana's sigmoid is not in the table, so the
// parameters of the sigmoid are zero. abe-y0 has no parameter p, so the column p is skipped for it.
template <class Law>
Values<Law> published_means(std::size_t device) {
  Values<Law> values{};
  for (std::size_t i = 0; i < values.size(); ++i)
    for (auto const& parameter : published<Law>().parameters)
      if (parameter.name == Law::template rows<double>[i].info.name) values[i] = parameter.mean[device];
  return values;
}

// Returns the parameters of device 0 to 9. A law of the paper has the means of Table A.5; any other law has a random
// set of its box.
template <class Law>
Values<Law> device(std::size_t number) {
  if constexpr (of_the_paper<Law>)
    return published_means<Law>(number);
  else
    return candidate<Law>(static_cast<std::uint32_t>(number));
}

// Returns the force at the first sample, before any motion: the hysteretic variables z, F2 and the work W are 0, and
// vaiana's branch starts at zero force. x and v are in the law's unit of length.
template <class Law>
double virgin_force(Values<Law> const& values, double x, double v) {
  std::string_view const id = Law::info.id;
  auto const p = [&](std::string_view name) { return values[index_of<Law>(name)]; };
  auto const square = [](double y) { return y * y; };
  if (id == "bilinear") return p("K2") * x;
  if (id == "vaiana") return 0.0;
  if (id == "bouc-wen") return p("alpha") * p("Ke") * x;
  if (id == "jankowski") {
    double const K = p("a1") + p("a2") * square(x) + p("a3") * square(square(x)) +
                     p("a4") / square(std::cosh(p("a5") * v)) +
                     p("a6") / (std::cosh(p("a7") * v) * std::cosh(p("a8") * x));
    double const C = (p("a9") + p("a10") * square(x)) / std::sqrt(square(p("a11")) + square(v));
    return K * x + C * v;
  }
  if (id == "hwang-wu") {
    double const K =
        p("a1") + p("a2") * square(x) + p("a3") * square(square(x)) + p("a4") / square(std::cosh(p("a5") * v));
    double const C = (p("a6") + p("a7") * square(x)) / std::sqrt(square(p("a8")) + square(v)) * 2.0;
    return K * x + C * v;
  }
  double const sign = x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0, size = std::abs(x);
  return p("K1") * (p("beta") + (1.0 - p("beta")) * std::exp(-size / p("alpha"))) * x +
         p("a") * (1.0 - std::exp(-p("b") * size)) * sign + p("K2") * std::pow(size / p("Uh"), p("r")) * x;
}

}  // namespace isolaw::law_tests
