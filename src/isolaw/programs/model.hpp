// A building on isolators, for the targets opensees-model and openseespy-model. All values are in kN, mm and s.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/base/option.hpp"
#include "isolaw/campaign/contents.hpp"
#include "isolaw/data/channels/ground_motion.hpp"
#include "isolaw/programs/layout.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::programs {

struct ModelOptions {
  std::optional<std::string> layout, mass, gyration, axial, ground_motion, ground_motion_y;
  data::StatedMotion stated = {.how_step = "--ground-motion-dt SECONDS", .how_unit = "--ground-motion-unit UNIT"};
  double scale = 1.0;
  int draws = 0;  // number of draws of the bearings' laws; 0 for analyses with the bounds of the law
};
std::vector<Option<ModelOptions>> const& model_table();

struct ModelBearing {
  std::string name;
  double x_mm = 0.0, y_mm = 0.0, angle_deg = 0.0, load_kN = 0.0, K_v_kN_per_mm = 0.0;
};

struct Model {
  std::string layout;  // path of the layout file
  std::vector<ModelBearing> bearings;
  // The weight that the isolators carry, the centre of its mass and the radius of gyration.
  double weight_kN = 0.0, x_mm = 0.0, y_mm = 0.0, gyration_mm = 0.0;
  std::string weight_from, centre_from, gyration_from, K_v_from;  // sources of weight, centre, gyration and K_v
  std::vector<data::GroundMotion> motions;                        // motion along x, and a second one along y if given
  double scale = 1.0;
  // The parameters drawn for each bearing, as draws[draw][bearing]. If empty, the analyses use the bounds of the law.
  std::vector<std::vector<std::vector<double>>> draws;
  std::uint64_t seed = 0;
  std::vector<std::string> draws_said;  // study::sentences() about the draws
};

// Largest number of drawn parameter sets in one file. Each set adds a material and its self-check to the file.
inline constexpr int most_drawn_sets = 2000;

// `device` is a name or "lot". K_v may come from compression tests of the device. Throws one Error with all faults.
Model make_model(ModelOptions const& options, campaign::Contents const& contents, study::Summary const& summary,
                 std::string_view law, std::string_view device, std::uint64_t seed);

}  // namespace isolaw::programs
