// A program that a user of the library might write. It computes the force of a bilinear bearing under a sine and asks
// for a law that does not exist, which must be an error.
#include <cmath>
#include <cstdio>
#include <isolaw/api/isolaw.hpp>
#include <vector>

int main() {
  std::vector<double> x_mm;
  for (int i = 0; i <= 200; ++i) x_mm.push_back(100.0 * std::sin(0.0314159265358979 * i));
  auto const path = isolaw::laws::make_path(x_mm, {});
  std::vector<double> force_kN(path.samples());
  std::vector<double> const K1_K2_xy{2.0, 0.5, 20.0};
  isolaw::laws::find_law("bilinear").evaluate(K1_K2_xy, path, isolaw::laws::Integration::converged, force_kN);
  // On the branch after yielding the force is K2 x + (K1 - K2) xy; this is its value at the peak of 100 mm.
  double const expected = 0.5 * 100.0 + (2.0 - 0.5) * 20.0;
  std::printf("force at the first peak: %.3f kN\n", force_kN[50]);
  bool refused = false;
  try {
    isolaw::laws::find_law("no-such-law");
  } catch (isolaw::Error const& error) {
    refused = error.complaints().size() == 1;
  }
  return std::abs(force_kN[50] - expected) < 1e-9 && refused ? 0 : 1;
}
