// Cyclic properties of a force-displacement history from raw values, by EN 15129, ISO 22762-1 and NTC 2018 (11.9.7).
// The vertical stiffness needs another test (vertical.hpp).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/data/channels/record.hpp"
#include "isolaw/data/cycles/cycles.hpp"
#include "isolaw/data/signals/signal_faults.hpp"

namespace isolaw::data {

// A cycle with its properties. A partial cycle has the values that follow from its samples, and never counts. The loop
// of a half cycle is closed by the chord between its ends; its energy is twice the area of this loop, and its period
// twice its duration.
struct Cycle : CycleCut {
  double amplitude_mm = 0.0;  // D = (largest - smallest displacement) / 2
  double d_plus_mm = 0.0;     // largest and smallest displacement of a sample, and the forces there
  double d_minus_mm = 0.0;
  double F_plus_kN = 0.0;
  double F_minus_kN = 0.0;
  double K_eff_kN_per_mm = 0.0;   // peak to peak: (F+ - F-) / (d+ - d-)
  double K_plus_kN_per_mm = 0.0;  // F / d of one side (NTC 2018); 0 if the cycle hardly goes to that side
  double K_minus_kN_per_mm = 0.0;
  double energy_kN_mm = 0.0;     // integral of F over d (trapezoidal rule), closed by a straight line
  double damping_percent = 0.0;  // energy / (2 pi K_eff D^2)
  double closure_mm = 0.0;       // displacement at the end minus displacement at the start of the cycle
  double closure_kN = 0.0;
  double Q_d_kN = 0.0;                  // half the loop's height where cycles are cut: (F rising - F falling) / 2
  double K_d_kN_per_mm = 0.0;           // K_eff - Q_d / D
  std::optional<double> D_y_mm;         // yield displacement of the bilinear loop: D - energy / (4 Q_d) if in (0, D)
  std::optional<double> K_1_kN_per_mm;  // first stiffness of the bilinear loop: K_d + Q_d / D_y
  // Displacement at which the force first comes to zero after the largest and after the smallest displacement; nullopt
  // if it does not come to zero before the next peak or the end of the cycle.
  std::optional<double> residual_plus_mm, residual_minus_mm;
  // The values from here on describe the record, whatever the force. So properties_on(), which takes the force of a
  // law, leaves them as they are.
  double work_kN_mm = 0.0;           // work of the force from the first sample of the record to the end of the cycle
  std::optional<double> period_s;    // from start to end, without the time in which the device stands still
  std::optional<double> still_s;     // time in which the device stands still; nullopt without time
  std::optional<double> v_max_mm_s;  // largest |slope| over 1/25 of a cycle; nullopt without time
  std::optional<double> N_mean_kN;   // mean vertical load; nullopt without that channel
  std::optional<double> N_min_kN;
  std::optional<double> N_max_kN;
  bool counts() const { return number > 0; }
  std::optional<double> F_y_kN() const {  // force at which the bilinear loop yields: K_1 D_y
    return D_y_mm ? std::optional(*K_1_kN_per_mm * *D_y_mm) : std::nullopt;
  }
  // nullopt if K_eff is almost zero, that is, if K_eff D is less than a thousandth of the loop's mean half height.
  std::optional<double> damping() const {
    constexpr double least_stiffness = 1e-3;
    double const stiff = K_eff_kN_per_mm * amplitude_mm, height = energy_kN_mm / (4.0 * amplitude_mm);
    return std::abs(stiff) > least_stiffness * std::abs(height) ? std::optional(damping_percent) : std::nullopt;
  }
  std::optional<double> K_plus() const {
    return K_plus_kN_per_mm == 0.0 ? std::nullopt : std::optional(K_plus_kN_per_mm);
  }
  std::optional<double> K_minus() const {
    return K_minus_kN_per_mm == 0.0 ? std::nullopt : std::optional(K_minus_kN_per_mm);
  }
};
// Two amplitudes count as equal if they differ by at most this fraction of the amplitude. When the block nearest to the
// design displacement is chosen, the fraction is of the design displacement.
inline constexpr double same_nominal = 0.02;

struct Block {
  int number = 0;                      // from 1
  double amplitude_mm = 0.0;           // amplitude, frequency and v_max are medians over the counted cycles
  std::optional<double> frequency_Hz;  // 1 / period, without rests and holds; nullopt in a sweep
  // First and last frequency, if the block belongs to a sweep, in which the frequency changes from cycle to cycle.
  std::optional<std::pair<double, double>> sweep_Hz;
  std::optional<double> v_max_mm_s;
  std::string waveform;       // "sine", "triangle" or "other"; empty without time
  std::string fault;          // why no cycle of the block counts, if a signal or loop in it cannot be true
  std::vector<Cycle> cycles;  // in order, including cycles that do not count

  std::vector<Cycle const*> counted() const;
  std::vector<Cycle const*> whole() const;  // the counted cycles or, if none counts, all complete ones
};

// F = F_0 + C |v|^alpha in one direction of motion, F = F_0 - C |v|^alpha in the other, with C in kN (s/mm)^alpha. F_0
// is the force at the turns of the motion, such as the preload of a gas spring.
struct ViscousSide {
  double C = 0.0, alpha = 0.0;
};
struct ViscousLaw {             // data/properties/device_kind.hpp
  ViscousSide rising, falling;  // for rising and for falling displacement
  double F_0_kN = 0.0, v_max_mm_s = 0.0;
};
struct Slider {  // data/properties/device_kind.hpp
  double mu = 0.0, N_kN = 0.0;
  std::optional<double> R_mm = {};
};

struct Properties {
  std::vector<Block> blocks = {};
  // The third counted cycle of the block of largest amplitude, or its last counted cycle if there are fewer. If the
  // amplitudes of two blocks differ by at most 2 %, the earlier block is taken. Empty if there is a refusal.
  std::optional<Cycle> reported = {};
  // Why there is no reported cycle: faulty signal, motion not cyclic, few samples, negative energy or stiffness.
  std::vector<Finding> refusal = {};
  bool refusal_is_of_fault = false;  // the refusal is about a signal or a cycle that cannot be true
  // Set only for a TestRecord. A fault that lies outside all blocks has the word "outside" in its finding.
  std::vector<SignalFault> faults = {};
  // Faults because of which no cycle of some blocks counts, while cycles of other blocks count. Empty if there is a
  // refusal.
  std::vector<Finding> block_faults = {};
  std::optional<ViscousLaw> viscous = {};  // set for a device without stiffness: its K_eff and damping mean nothing
  std::optional<Slider> slider = {};
  std::optional<Finding> failure = {};  // force_lost: the cycle in which the force is suddenly lost
  // Ranges of samples (first, last) in which the device has lost its force. The last sample is infinity if the force
  // does not come back.
  std::vector<std::pair<double, double>> samples_without_force = {};
  std::optional<double> samples_per_cycle = {};  // median over the counted cycles, without rests and holds
  double centre_mm = 0.0;                        // displacement at which cycles are cut

  Cycle const* find(int block, int number) const;  // nullptr if there is none
  std::vector<Cycle const*> counted() const;       // counted cycles of all blocks, in order
  std::vector<Cycle const*> complete() const;      // all cycles except partial ones, also if the record is not cyclic
  bool is_reported(Cycle const& cycle) const;
};

// All channels have the same length, but time_s, load_kN and logged_cycle may be empty.
struct CycleView {
  std::span<double const> disp_mm;
  std::span<double const> force_kN;
  std::span<double const> time_s;
  std::span<double const> load_kN;
  std::span<std::size_t const> starts = {};  // as in TestRecord
  std::span<double const> logged_cycle = {};
  bool half_cycles = false;  // as in FurtherChannels
};
CycleView view_of(TestRecord const& record);

Properties cyclic_properties(CycleView const& view);
// The result also has the faults of the record's signals. Cycles in blocks that a fault makes unusable do not count.
// Throws Error for a motion without force.
Properties cyclic_properties(TestRecord const& record);
// A record without time has periods in samples.
Properties cyclic_properties(std::span<double const> disp_mm, std::span<double const> force_kN);

// The properties of `cycle` with another force, such as the force that a law computes at the same samples.
Cycle properties_on(Cycle const& cycle, std::span<double const> disp_mm, std::span<double const> force_kN);

// How a property changes over the counted cycles of one block (EN 15129 8.2.1.2.6; scragging). Ratios to cycle 3 are
// empty if no counted cycle has the number 3, or if the property is nearly zero in it. Names that end in 2_10 or 1_10
// are about cycles 2 to 10 or 1 to 10, or fewer if the block has fewer. least_to_largest is the smallest value divided
// by the largest.
struct Stability {
  int cycles = 0;  // number of counted cycles
  std::vector<double> ratio_to_third;
  std::optional<double> min_2_10, max_2_10, min_1_10, max_1_10;
  std::optional<double> least_to_largest_2_10, least_to_largest_1_10;
  std::optional<double> first_to_third;     // the scragging ratio
  std::optional<double> first_to_mean_1_3;  // if the property falls, the largest test factor of ASCE 7
  std::optional<double> last_to_mean_1_3;   // if the property falls, the smallest test factor of ASCE 7
};
// `property` is &Cycle::K_eff_kN_per_mm, energy_kN_mm or damping_percent.
Stability stability(Block const& block, double Cycle::*property);

struct Strains {
  double shear_strain_percent = 0.0;  // 100 D / T_r
  double G_MPa = 0.0;                 // K_eff T_r / A_r
};

// T_r is rubber_thickness_mm, A_r is rubber_area_mm2; both are positive.
Strains strains(Cycle const& cycle, double rubber_thickness_mm, double rubber_area_mm2);

}  // namespace isolaw::data
