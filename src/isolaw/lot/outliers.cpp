#include "isolaw/lot/outliers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::lot {
namespace {

void check(std::span<std::string const> names, std::span<std::vector<double> const> values) {
  if (names.size() != values.size())
    throw Error({"outliers", fmt::format("{} names of {} properties", names.size(), values.size()), "one each", {}});
  std::vector<Complaint> complaints;
  for (std::size_t p = 0; p < values.size(); ++p) {
    auto const where = "outliers, " + names[p];
    if (values[p].size() != values[0].size())
      complaints.push_back({where,
                            fmt::format("values of {} devices", values[p].size()),
                            fmt::format("{}, as of {}", values[0].size(), names[0]),
                            {}});
    if (std::ranges::any_of(values[p], [](double value) { return std::isinf(value); }))
      complaints.push_back({where, "an infinite value", "a finite value, or NaN where there is none", {}});
  }
  if (!complaints.empty()) throw Error(std::move(complaints));
}

}  // namespace

std::vector<Outlier> find_outliers(std::span<std::string const> names, std::span<std::vector<double> const> values) {
  check(names, values);
  std::vector<Outlier> outliers;
  for (std::size_t p = 0; p < values.size(); ++p) {
    std::vector<std::size_t> devices;
    std::vector<double> present;
    for (std::size_t d = 0; d < values[p].size(); ++d) {
      if (std::isnan(values[p][d])) continue;
      devices.push_back(d);
      present.push_back(values[p][d]);
    }
    if (present.size() < num::fewest_for_outliers) continue;
    auto const [median, scores] = num::modified_scores(present, least_scatter);
    for (std::size_t i = 0; i < present.size(); ++i)
      if (std::abs(scores[i]) > num::outlying_score)
        outliers.push_back({.device = devices[i],
                            .property = p,
                            .value = present[i],
                            .median = median,
                            .score = scores[i],
                            .percent = 100.0 * (present[i] - median) / std::abs(median)});
  }
  std::ranges::stable_sort(outliers, std::greater{}, [](Outlier const& outlier) { return std::abs(outlier.score); });
  return outliers;
}

}  // namespace isolaw::lot
