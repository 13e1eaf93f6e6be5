#include "isolaw/data/properties/device_kind.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace isolaw::data {
namespace {

constexpr double least_speed = 0.05;  // times the largest speed; slower samples are left out of the fit
constexpr double least_exponent = 0.05, largest_exponent = 3.0;
constexpr double most_left = 0.15;    // a fit is accepted if the rms of log(measured / fitted force) is below this
constexpr double hardly_stiff = 0.1;  // times the loop's mean half height; a smaller elastic force counts as zero
constexpr double opposed = 0.05;      // in at most this fraction of the samples, the force may act along the motion
constexpr double at_once = 0.97;      // least energy / (4 Q_d D) of a slider; it is 1 for a device that yields at once
constexpr double least_friction = 0.002, largest_friction = 0.25;

std::optional<ViscousSide> fitted_side(
    std::vector<std::pair<double, double>> const& samples) {  // speed; force against the motion
  constexpr std::size_t fewest = 8;
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0, count = 0.0, against = 0.0;
  for (auto const& [speed, force] : samples) {
    if (!(force > 0.0)) {
      ++against;
      continue;
    }
    double const u = std::log(speed), w = std::log(force);
    x += u, y += w, xx += u * u, xy += u * w, yy += w * w, ++count;
  }
  if (samples.size() < fewest || against > opposed * static_cast<double>(samples.size())) return std::nullopt;
  double const spread = xx - x * x / count, along = xy - x * y / count;
  if (!(spread > 0.0)) return std::nullopt;  // the speed is constant
  double const alpha = along / spread, left = (yy - y * y / count) - alpha * along;
  if (!(alpha >= least_exponent && alpha <= largest_exponent) || !(std::sqrt(std::max(0.0, left) / count) < most_left))
    return std::nullopt;
  return ViscousSide{.C = std::exp((y - alpha * x) / count), .alpha = alpha};
}

}  // namespace

std::optional<ViscousLaw> viscous_law(CycleView const& view, Cycle const& cycle) {
  double const height = std::abs(cycle.energy_kN_mm) / (4.0 * cycle.amplitude_mm);
  bool const stiff = !(std::abs(cycle.K_eff_kN_per_mm) * cycle.amplitude_mm < hardly_stiff * height);
  if (view.time_s.empty() || !cycle.v_max_mm_s || stiff) return std::nullopt;
  auto const first = static_cast<std::size_t>(std::ceil(cycle.first));
  auto const last = std::min(static_cast<std::size_t>(cycle.last), view.disp_mm.size() - 1);
  auto const reach =
      std::max<std::size_t>(1, (last - first) / 100);  // a central difference over 2 % of a cycle is exact enough
  double const F_0 = (cycle.F_plus_kN + cycle.F_minus_kN) / 2.0;
  std::vector<std::pair<double, double>> out, back;
  for (auto i = first + reach; i + reach <= last; ++i) {
    double const speed =
        (view.disp_mm[i + reach] - view.disp_mm[i - reach]) / (view.time_s[i + reach] - view.time_s[i - reach]);
    if (std::abs(speed) < least_speed * *cycle.v_max_mm_s) continue;
    (speed > 0.0 ? out : back).emplace_back(std::abs(speed), std::copysign(1.0, speed) * (view.force_kN[i] - F_0));
  }
  auto const rising = fitted_side(out), falling = fitted_side(back);
  if (!rising || !falling) return std::nullopt;
  return ViscousLaw{.rising = *rising, .falling = *falling, .F_0_kN = F_0, .v_max_mm_s = *cycle.v_max_mm_s};
}

std::optional<Slider> slider(Cycle const& cycle) {
  if (!cycle.N_mean_kN || !(cycle.Q_d_kN > 0.0)) return std::nullopt;
  double const N = std::abs(*cycle.N_mean_kN), mu = cycle.Q_d_kN / N;
  bool const slides = cycle.energy_kN_mm >= at_once * 4.0 * cycle.Q_d_kN * cycle.amplitude_mm;
  if (!slides || !(mu >= least_friction && mu <= largest_friction)) return std::nullopt;
  Slider found{.mu = mu, .N_kN = N};
  if (cycle.K_d_kN_per_mm * cycle.amplitude_mm > hardly_stiff * cycle.Q_d_kN) found.R_mm = N / cycle.K_d_kN_per_mm;
  return found;
}

}  // namespace isolaw::data
