// Computes a law under a motion in two directions. A law can be extended to two directions in several ways, and tests
// in one direction cannot tell which is right. This file therefore also computes how far the extensions differ.
#pragma once

#include <string_view>
#include <vector>

#include "isolaw/laws/catalogue.hpp"
#include "isolaw/laws/plane/in_plane.hpp"

namespace isolaw::fit {

// A motion that starts at rest at the origin and goes straight to its first sample. If there are no times, vel_mm_s is
// empty.
struct PlaneMotion {
  std::vector<double> time_s;
  std::vector<laws::plane::Vector<double>> disp_mm, vel_mm_s;
};

struct LawInPlane {
  laws::LawEntry const* law;
  std::vector<double> parameters;
  // Only springs use these two members: a spring ignores reversals smaller than the dead band, and makes `refinement`
  // integration steps from sample to sample.
  double dead_band_mm = 0.0;
  int refinement = 1;

  laws::InPlane form(laws::Bidirectional how, laws::plane::Softening softening) const;
};

std::vector<laws::plane::Vector<double>> force_kN(laws::LawEntry const& law, laws::InPlane in_plane,
                                                  PlaneMotion const& motion);

// A law's results on the second turn of a figure of eight (200 samples): x = size_mm sin p, y = size_mm / 2 sin 2p.
struct FigureOfEightResult {
  std::string_view rule;       // the extension to two directions: "coupled", "springs", ...
  double peak_kN, work_kN_mm;  // the largest force, and the dissipated energy
};
// Returns one result for each extension that the law has: coupled and springs. A law that softens with the largest
// displacement so far has a second coupled extension, which keeps a largest displacement for each axis.
std::vector<FigureOfEightResult> on_a_figure_of_eight(LawInPlane const& law, double size_mm, double duration_s);
// The largest difference between the results of two extensions, divided by the first extension's result.
struct LargestDifference {
  double peak = 0.0, work = 0.0;
};
LargestDifference largest_difference_of(std::vector<FigureOfEightResult> const& rules);
// The energy that the law dissipates as springs, divided by the energy that the law itself dissipates, in the second
// cycle of a motion along one direction.
double work_of_springs_on_a_line(LawInPlane const& law, double size_mm, double duration_s);

}  // namespace isolaw::fit
