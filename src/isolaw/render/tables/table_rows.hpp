// Declares the rows of those tables that exist both as CSV and as LaTeX.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/render/results.hpp"
#include "isolaw/study/front_view.hpp"

namespace isolaw::render {

struct Quantity {
  std::string name, unit;
  bool free = true;
  std::optional<std::size_t> n;  // index among the parameters; empty for the objective
  std::string paper_name = {};   // the name in the paper's tables, if it differs
};
std::vector<Quantity> quantities_of(LawResult const& law);
// Returns empty values if there is no result.
Statistic statistic_of(DeviceFit const& fit, Quantity const& quantity);
Statistic statistic_of(LawResult const& law, std::string const& device, Quantity const& quantity);
// Returns the laws, sorted by rising objective, as points of a plot like Fig. 14 of Cucuzza et al. 2025.
std::vector<FrontPoint> by_accuracy(Summary const& summary, FrontView view);

}  // namespace isolaw::render
