// Makes random records of cyclic tests whose truth is known, drawn from a seed: devices, waveforms, sampling, noise and
// digitisers as in laboratories, and faults of the channels. With these records tests/unit/data_signals_test.cpp counts
// how often a fault is found, and how often one is reported where there is none.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/data/properties/properties.hpp"

namespace isolaw::data::testing {

enum class Waveform { sine, triangle, stages, trapezoid, dwell, one_sided };
enum class Device { rubber, lead, friction, relaxing, viscous, bouc_wen };  // draw() chooses among all but the last

struct Recording {
  std::string text;  // a description of what was drawn
  double amplitude_mm = 0.0, force_kN = 0.0;
  std::vector<double> time_s, disp_mm, force_kN_;
  CycleView view() const { return {disp_mm, force_kN_, time_s, {}}; }
};

class Drawn {
 public:
  explicit Drawn(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return low + (high - low) * uniform(); }
  double on_logs(double low, double high) { return low * std::pow(high / low, uniform()); }
  int whole(int low, int high) { return low + static_cast<int>(between(0.0, high - low + 1.0 - 1e-9)); }
  bool chance(double p) { return uniform() < p; }
  // Marsaglia's polar method gives two numbers at a time. The distributions of standard libraries differ, so they are
  // not used.
  double normal() {
    if (next_normal_) return *std::exchange(next_normal_, std::nullopt);
    double x = 0.0, y = 0.0, square = 0.0;
    do {
      x = 2.0 * uniform() - 1.0;
      y = 2.0 * uniform() - 1.0;
      square = x * x + y * y;
    } while (square > 1.0 || square == 0.0);
    double const size = std::sqrt(-2.0 * std::log(square) / square);
    next_normal_ = x * size;
    return y * size;
  }

 private:
  // Returns a number from 0 to below 1, from 64 random bits.
  double uniform() {
    auto const low = static_cast<double>(random_()), high = static_cast<double>(random_());
    return std::min((low + 0x1p32 * high) * 0x1p-64, std::nextafter(1.0, 0.0));
  }
  std::mt19937 random_;
  std::optional<double> next_normal_;
};

struct Bounds {
  double most_disp_noise = 0.002, most_force_noise = 0.005;  // as shares of the amplitudes
  int fewest_samples = 60, most_samples = 1000;              // per cycle
  int fewest_bits = 12;
};

struct Plan {
  Waveform waveform = Waveform::sine;
  Device device = Device::rubber;
  int samples = 200, cycles = 3, bits = 0;
  double amplitude_mm = 100.0, frequency_Hz = 0.5, disp_noise = 0.0, force_noise = 0.0;
  // Used for Bouc-Wen loops only: yield displacement over amplitude, first over second stiffness, and the exponent.
  double yields_at = 0.02, stiffness_ratio = 20.0;
  int exponent = 1;
  // Used for trapezoids only: height of the triangle whose tips are cut off, over the amplitude.
  double overdriven = 1.4;
};

inline Plan draw(Drawn& random, Bounds const& bounds, bool holds) {
  Plan plan;
  plan.waveform = static_cast<Waveform>(random.whole(0, holds ? 5 : 2));
  plan.device = static_cast<Device>(random.whole(0, 4));
  plan.samples = static_cast<int>(random.on_logs(bounds.fewest_samples, bounds.most_samples));
  plan.cycles = random.whole(3, 8);
  plan.bits = random.chance(0.3) ? random.whole(bounds.fewest_bits, 16) : 0;
  plan.amplitude_mm = random.on_logs(15.0, 400.0);
  plan.frequency_Hz = random.on_logs(0.003, 2.0);
  plan.disp_noise = random.chance(0.2) ? 0.0 : random.on_logs(1e-5, bounds.most_disp_noise);
  plan.force_noise = random.chance(0.2) ? 0.0 : random.on_logs(1e-5, bounds.most_force_noise);
  return plan;
}

// Returns the displacement divided by the amplitude. `phase` counts cycles from the start.
inline double shape_of(Plan const& plan, double phase) {
  double const part = phase - std::floor(phase);
  auto const triangle = [](double p) { return p < 0.25 ? 4.0 * p : p < 0.75 ? 2.0 - 4.0 * p : 4.0 * p - 4.0; };
  double const sine = std::sin(2.0 * std::numbers::pi * part);
  switch (plan.waveform) {
    case Waveform::triangle:
      return triangle(part);
    case Waveform::stages:
      return sine * (phase < plan.cycles / 2 ? 0.5 : 1.0);
    case Waveform::trapezoid:
      return std::clamp(plan.overdriven * triangle(part), -1.0, 1.0);
    case Waveform::dwell: {  // half cosines between holds at the peaks and at zero
      double const p = 8.0 * part;
      auto const rise = [](double u) { return 0.5 - 0.5 * std::cos(std::numbers::pi * std::clamp(u, 0.0, 1.0)); };
      return p < 3.0 ? rise(p) : p < 4.0 ? 1.0 - rise(p - 3.0) : p < 7.0 ? -rise(p - 4.0) : -1.0 + rise(p - 7.0);
    }
    case Waveform::one_sided:
      return 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * part);
    default:
      return sine;
  }
}

// Returns the force in kN along a finely sampled history. Distances are in proportion to the amplitude and stiffnesses
// to its inverse. The force therefore does not depend on the amplitude.
inline std::vector<double> force_of(Device device, std::vector<double> const& x, double dt, Plan const& plan) {
  double const D = plan.amplitude_mm, K = 100.0 / D, period = 1.0 / plan.frequency_Hz;
  // The parts of the force (elastic, plastic Q, relaxing `maxwell`, viscous `damper`) are in units of 100 kN. The
  // difference between the plastic part and its strength Q falls by a factor e over each travel of `way` times the
  // amplitude.
  double elastic = 0.6, Q = 0.4, way = 0.1, maxwell = 0.0, damper = 0.0;
  if (device == Device::lead) elastic = 0.35, Q = 0.65, way = 0.02;
  if (device == Device::friction) elastic = 0.2, Q = 0.8, way = 0.001;
  if (device == Device::relaxing) elastic = 0.5, Q = 0.25, way = 0.1, maxwell = 0.5;
  if (device == Device::viscous) elastic = 0.8, Q = 0.1, way = 0.1, damper = 0.3;
  double z = 0.0, m = 0.0, before = x.front();
  std::vector<double> F;
  if (device == Device::bouc_wen) {
    double const uy = plan.yields_at * D, share = 1.0 / plan.stiffness_ratio;
    for (double const now : x) {
      double const step = (now - before) / uy;
      auto const rate = [&](double at) { return at * step > 0.0 ? 1.0 - std::pow(std::abs(at), plan.exponent) : 1.0; };
      z += step * rate(z + step / 2.0 * rate(z));  // midpoint rule
      F.push_back(100.0 * (share * now / uy + (1.0 - share) * z));
      before = now;
    }
    return F;
  }
  for (double const now : x) {
    double const dx = now - before;
    if (dx != 0.0) z += (std::copysign(1.0, dx) - z) * (1.0 - std::exp(-std::abs(dx) / (way * D)));
    m = (m + maxwell * dx / D) * std::exp(-dt / (0.1 * period));
    F.push_back(K * D * (elastic * now / D + Q * z + m) + 100.0 * damper * dx / dt * period / (6.28 * D));
    before = now;
  }
  return F;
}

inline void add_noise(Drawn& random, std::vector<double>& x, double deviation) {
  if (deviation > 0.0)
    for (double& value : x) value += deviation * random.normal();
}
inline void digitise(std::vector<double>& x, int bits, double full_scale) {
  // Without a digitiser (bits = 0), values are rounded to four decimals as in a text file.
  double const step = bits > 0 ? 2.0 * full_scale / std::pow(2.0, bits) : 1e-4;
  for (double& value : x) value = step * std::round(value / step);
}

struct Clean {
  std::vector<double> time_s, disp_mm, force_kN;
};

// Returns the motion without noise: first rest, then the cycles, then rest.
inline Clean true_motion(Plan const& plan) {
  constexpr int finer = 8;
  int const n = plan.samples * plan.cycles * finer;
  double const dt = 1.0 / (plan.frequency_Hz * plan.samples * finer);
  int const rest = plan.samples / 4 * finer;
  std::vector<double> x;
  for (int i = -rest; i <= n + rest; ++i)
    x.push_back(i < 0 || i > n ? 0.0
                               : plan.amplitude_mm * shape_of(plan, static_cast<double>(i) / (plan.samples * finer)));
  auto const F = force_of(plan.device, x, dt, plan);
  Clean clean;
  for (std::size_t i = 0; i < x.size(); i += finer) {
    clean.time_s.push_back(static_cast<double>(i) * dt);
    clean.disp_mm.push_back(x[i]);
    clean.force_kN.push_back(F[i]);
  }
  return clean;
}

inline Recording finish(Drawn& random, Plan const& plan, Clean clean) {
  Recording record;
  record.amplitude_mm = plan.amplitude_mm;
  auto const [low, high] = std::ranges::minmax(clean.force_kN);
  record.force_kN = (high - low) / 2.0;
  add_noise(random, clean.disp_mm, plan.disp_noise * plan.amplitude_mm);
  add_noise(random, clean.force_kN, plan.force_noise * record.force_kN);
  digitise(clean.disp_mm, plan.bits, 1.25 * plan.amplitude_mm);
  digitise(clean.force_kN, plan.bits, 1.25 * record.force_kN);
  record.time_s = clean.time_s;
  record.disp_mm = clean.disp_mm;
  record.force_kN_ = clean.force_kN;
  static char const* const waveforms[]{"sine", "triangle", "stages", "trapezoid", "dwell", "one-sided"};
  static char const* const devices[]{"rubber", "lead", "friction", "relaxing", "viscous", "bouc-wen"};
  record.text = std::string(waveforms[static_cast<int>(plan.waveform)]) + " " + devices[static_cast<int>(plan.device)] +
                " N=" + std::to_string(plan.samples) + " cycles=" + std::to_string(plan.cycles) +
                " bits=" + std::to_string(plan.bits) + " noise=" + std::to_string(plan.disp_noise) + "," +
                std::to_string(plan.force_noise) + " f=" + std::to_string(plan.frequency_Hz) +
                " D=" + std::to_string(plan.amplitude_mm);
  return record;
}

}  // namespace isolaw::data::testing
