// Computes a law in cycles such as a building imposes on its isolators. These cycles show whether the law's forces stay
// plausible within and beyond the tested amplitudes.
#pragma once

#include <span>
#include <vector>

#include "isolaw/laws/catalogue.hpp"

namespace isolaw::analysis {

struct SteadyMotion {  // three cycles of a sine from rest; only the third is judged
  double amplitude_mm = 0.0;
  double period_s = 2.0;
};

struct SteadyCycle {   // the third cycle of a law with one set of parameters
  bool finite = true;  // whether every force of the three cycles is finite; if not, the numbers below mean nothing
  double K_kN_per_mm = 0.0;   // (force at the positive peak - force at the negative peak) / (2 amplitude)
  double energy_kN_mm = 0.0;  // area of the loop
  double damping = 0.0;       // energy / (2 pi K amplitude^2)
  double largest_kN = 0.0;    // the largest |force|
  double overshoot = 0.0;     // largest |force| / (|K| amplitude): 1 if the force is largest at the peaks
  // The largest change of force between neighbouring samples where |x| is below 0.8 of the amplitude, divided by |K|
  // times the amplitude. A cycle has 4,000 samples.
  double jump = 0.0;
};

// One cycle for each set of parameters, all in the law's order and units.
std::vector<SteadyCycle> steady_cycles(laws::LawEntry const& law, std::span<std::vector<double> const> parameters,
                                       SteadyMotion const& motion, laws::Integration integration);

}  // namespace isolaw::analysis
