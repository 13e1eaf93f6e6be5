// A law on a motion in two directions, and what tests in one direction leave open of it.
#pragma once

#include <string_view>
#include <vector>

#include "isolaw/laws/catalogue.hpp"
#include "isolaw/laws/in_plane.hpp"

namespace isolaw::fit {

// Of an isolator at rest at the origin, from where the first sample is reached on a straight line. Without time,
// velocities are empty.
struct PlaneMotion {
  std::vector<double> time_s;
  std::vector<laws::plane::Vector<double>> disp_mm, vel_mm_s;
};

// A law with its parameters, and how it is taken in two directions.
struct LawInPlane {
  laws::LawEntry const* law;
  std::vector<double> parameters;
  double dead_band_mm = 0.0;  // of springs
  int refinement = 1;         // of springs: steps per sample; coupled forms need none

  laws::InPlane made(laws::Bidirectional how, laws::plane::Softening softening) const;
};

// At every sample.
std::vector<laws::plane::Vector<double>> force_kN(laws::LawEntry const& law, laws::InPlane in_plane,
                                                  PlaneMotion const& motion);

// The second turn of a figure of eight, x = A sin p and y = A/2 sin 2p, at 200 samples a turn and `duration_s` a turn.
struct OnAnEight {
  std::string_view rule;
  double peak_kN, work_kN_mm;
};
// By every rule that goes with one direction and that the law has: coupled with either rule of softening, springs.
std::vector<OnAnEight> on_a_figure_of_eight(LawInPlane const& law, double size_mm, double duration_s);
// The largest difference between rules of either, relative to the first.
struct Spread {
  double peak = 0.0, work = 0.0;
};
Spread spread_of(std::vector<OnAnEight> const& rules);

// Work of the second cycle along one direction, of springs against the law itself: 1 where they were fitted as springs.
// The law must have a form online.
double work_of_springs_on_a_line(LawInPlane const& law, double size_mm, double duration_s);

}  // namespace isolaw::fit
