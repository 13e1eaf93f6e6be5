// Computes a law in cycles such as a building imposes on its isolators. These cycles show whether the law's forces stay
// plausible within and beyond the tested amplitudes.
#pragma once

#include <span>
#include <vector>

#include "isolaw/laws/catalogue.hpp"

namespace isolaw::analysis {

// Three cycles of a sine, which starts from rest at 0. Only the third is judged.
struct SteadyMotion {
  double amplitude_mm = 0.0;
  double period_s = 2.0;
};

// Properties of the third cycle of a law with one set of parameters.
struct SteadyCycle {
  bool finite = true;  // whether every force of the three cycles is finite; if not, the numbers below mean nothing
  double K_kN_per_mm = 0.0;   // effective stiffness: difference of the forces at the two peaks / (2 amplitude)
  double energy_kN_mm = 0.0;  // dissipated energy, the area of the loop
  double damping = 0.0;       // equivalent damping ratio, energy / (2 pi K amplitude^2)
  double largest_kN = 0.0;    // the largest |force|
  double overshoot = 0.0;     // largest |force| / (|K| amplitude): 1 if the force is largest at the peaks
  // The largest change of force between neighbouring samples where |x| is below 0.8 of the amplitude, divided by |K|
  // times the amplitude. A cycle has 4,000 samples.
  double jump = 0.0;
};

// Returns one cycle for each set of parameters. The parameters are in the law's order and units.
std::vector<SteadyCycle> steady_cycles(laws::LawEntry const& law, std::span<std::vector<double> const> parameters,
                                       SteadyMotion const& motion, laws::Integration integration);

}  // namespace isolaw::analysis
