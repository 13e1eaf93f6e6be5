// Reads the input as a history of ground acceleration, as a displacement history and as a table of isolators.
#include <algorithm>
#include <cmath>

#include "harness.hpp"
#include "isolaw/data/channels/ground_motion.hpp"
#include "isolaw/data/read.hpp"
#include "isolaw/programs/layout.hpp"

namespace {

using namespace isolaw;

bool all_finite(std::vector<double> const& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  auto const bytes = fuzz::as_text(data, size);
  for (auto const& stated : {data::StatedMotion{}, data::StatedMotion{.step_s = 0.01, .unit = "g"}})
    fuzz::attempt([&] {
      auto const motion = data::read_ground_motion_text(bytes, "motion.at2", stated);
      fuzz::require(motion.acceleration_mm_s2.size() >= 2 && all_finite(motion.acceleration_mm_s2),
                    "values are finite");
      fuzz::require(motion.step_s > 0.0 && std::isfinite(motion.step_s), "the step is a time");
      fuzz::require(is_printable(motion.recognised), "a sentence is printable");
    });
  fuzz::attempt([&] {
    auto const motion = data::read_motion_text(bytes, "motion.csv");
    fuzz::require(all_finite(motion.disp_mm) && all_finite(motion.time_s), "values are finite");
  });
  fuzz::attempt([&] {
    auto const places = programs::read_layout_text(bytes, "layout.csv");
    fuzz::require(!places.empty() && places.size() <= programs::most_rows, "the number of isolators is bounded");
    for (auto const& place : places)
      fuzz::require(is_printable(place.name) && std::isfinite(place.x_mm + place.y_mm), "a place can be written");
  });
  return 0;
}
