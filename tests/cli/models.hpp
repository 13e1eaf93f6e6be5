// Some targets of `export` write a model of a whole building. The functions below write the files that such an export
// needs.
#pragma once

#include <cmath>

#include "cli/run.hpp"
#include "isolaw/programs/exports.hpp"

namespace isolaw::cli_test {

// Returns two seconds of ground motion as a CSV text with units in its header.
inline std::string ground_motion(double amplitude_m_s2 = 1.0, double step_s = 0.02, int samples = 101) {
  std::string text = "time [s],acceleration [m/s2]\n";
  for (int i = 0; i < samples; ++i)
    text += fmt::format("{:.3f},{:.6f}\n", i * step_s,
                        amplitude_m_s2 * std::sin(5.0 * i * step_s) * std::min(1.0, i * step_s));
  return text;
}

// Writes the files that this target needs into `folder`, and returns the options that name the files. Most targets need
// no files and no options.
inline Words needed_by(programs::Target const& target, fs::path const& folder) {
  if (!target.needs_building) return {};
  write_file(folder / "layout.csv", "name,x [m],y [m]\nA,0,0\nB,6,0\nC,0,4\nD,6,4\n");
  write_file(folder / "ground.csv", ground_motion());
  return {"--layout", "layout.csv", "--mass", "240t", "--axial", "500kN/mm", "--ground-motion", "ground.csv"};
}

}  // namespace isolaw::cli_test
