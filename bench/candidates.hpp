// Draws candidates, which are sets of parameters, from a search box and lays them out in memory as the benchmarks need
// them.
#pragma once

#include <cstdint>
#include <vector>

#include "isolaw/fit/box.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::bench {

// Returns `count` candidates drawn uniformly from the box. All parameters of the first candidate come first, in the
// law's order, then all parameters of the second candidate, and so on.
inline std::vector<double> candidates(fit::SearchBox const& box, std::size_t count) {
  std::vector<double> values(count * box.parameters.size()), point(box.free_count());
  for (std::size_t i = 0; i < count; ++i) {
    num::Draws draws(num::Stream(1), 0, static_cast<std::uint32_t>(i));
    for (double& coordinate : point) coordinate = draws.uniform();
    box.expand(point, std::span(values).subspan(i * box.parameters.size(), box.parameters.size()));
  }
  return values;
}

// Copies `width` candidates, starting at candidate `first`, and transposes them: the first parameter of every candidate
// comes first, then the second parameter of every candidate, and so on.
inline std::vector<double> block(std::vector<double> const& candidates, std::size_t parameters, std::size_t first,
                                 std::size_t width) {
  std::vector<double> values(parameters * width);
  for (std::size_t lane = 0; lane < width; ++lane)
    for (std::size_t p = 0; p < parameters; ++p) values[p * width + lane] = candidates[(first + lane) * parameters + p];
  return values;
}

inline std::vector<double> divided(std::vector<double> values, double unit) {
  for (double& v : values) v /= unit;
  return values;
}

}  // namespace isolaw::bench
