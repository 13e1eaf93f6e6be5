// Rows of the tables that stand as CSV and as LaTeX.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/render/results.hpp"
#include "isolaw/study/front_view.hpp"

namespace isolaw::render {

// One of Table A.5 on all devices; n: of the parameters, none for the objective.
struct Quantity {
  std::string name, unit;
  bool free = true;
  std::optional<std::size_t> n;
  std::string paper_name = {};  // in the paper's tables, where it is another one
};
std::vector<Quantity> quantities_of(LawResult const& law);

// All empty where there is none.
Statistic statistic_of(DeviceFit const& fit, Quantity const& quantity);
Statistic statistic_of(LawResult const& law, std::string const& device, Quantity const& quantity);

// Of Fig. 14, by rising objective.
std::vector<FrontPoint> by_accuracy(Summary const& summary, FrontView view);

}  // namespace isolaw::render
