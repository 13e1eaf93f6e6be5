// Computes a law under a motion in two directions. A law has several two-dimensional forms, and tests in one direction
// cannot tell which is right, so this also computes how far they differ.
#pragma once

#include <string_view>
#include <vector>

#include "isolaw/laws/catalogue.hpp"
#include "isolaw/laws/in_plane.hpp"

namespace isolaw::fit {

// An isolator's motion from rest at the origin, straight to the first sample. Without time there are no velocities.
struct PlaneMotion {
  std::vector<double> time_s;
  std::vector<laws::plane::Vector<double>> disp_mm, vel_mm_s;
};

struct LawInPlane {
  laws::LawEntry const* law;
  std::vector<double> parameters;
  double dead_band_mm = 0.0;  // for springs only
  int refinement = 1;         // steps per sample, for springs only; coupled forms need no substeps

  laws::InPlane form(laws::Bidirectional how, laws::plane::Softening softening) const;
};

std::vector<laws::plane::Vector<double>> force_kN(laws::LawEntry const& law, laws::InPlane in_plane,
                                                  PlaneMotion const& motion);

// Results on the second turn of a figure of eight, x = size_mm sin p, y = size_mm / 2 sin 2p, with 200 samples a turn.
struct OnAnEight {
  std::string_view rule;  // the two-dimensional form: "coupled", "springs", ...
  double peak_kN, work_kN_mm;
};
// One result per form of the law: coupled, with either rule of softening, and springs. A turn takes `duration_s`.
std::vector<OnAnEight> on_a_figure_of_eight(LawInPlane const& law, double size_mm, double duration_s);
struct Spread {  // the largest differences between the forms, relative to the first
  double peak = 0.0, work = 0.0;
};
Spread spread_of(std::vector<OnAnEight> const& rules);
// The work of springs divided by the law's own, in the second cycle along one direction. The law needs an online form.
double work_of_springs_on_a_line(LawInPlane const& law, double size_mm, double duration_s);

}  // namespace isolaw::fit
