// Cyclic properties of a force-displacement history, from raw values: formulas of EN 15129, ISO 22762-1 and NTC 2018
// (11.9.7). A shear test under constant vertical load does not give the vertical stiffness (vertical.hpp).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "isolaw/data/cycles.hpp"
#include "isolaw/data/record.hpp"
#include "isolaw/data/signal_faults.hpp"

namespace isolaw::data {

// A partial cycle holds what its samples give, and never counts.
struct Cycle : CycleCut {
  double amplitude_mm = 0.0;  // D = (largest - smallest displacement) / 2, of samples
  double d_plus_mm = 0.0;     // largest and smallest displacement, and the forces at these samples
  double d_minus_mm = 0.0;
  double F_plus_kN = 0.0;
  double F_minus_kN = 0.0;
  double K_eff_kN_per_mm = 0.0;   // peak to peak: (F+ - F-) / (d+ - d-)
  double K_plus_kN_per_mm = 0.0;  // per side, F / d (NTC 2018); 0 if the cycle hardly goes to that side
  double K_minus_kN_per_mm = 0.0;
  double energy_kN_mm = 0.0;            // trapezoid of F dd over the cycle, closed by a straight line
  double damping_percent = 0.0;         // energy / (2 pi K_eff D^2)
  double Q_d_kN = 0.0;                  // half the loop's height at the level of the cuts: (F rising - F falling) / 2
  double K_d_kN_per_mm = 0.0;           // K_eff - Q_d / D
  std::optional<double> D_y_mm;         // bilinear loop of the same energy: D - energy / (4 Q_d), if 0 < D_y < D
  std::optional<double> K_1_kN_per_mm;  // K_d + Q_d / D_y
  std::optional<double> period_s;       // from cut to cut, without the time in which the device stands still
  std::optional<double> still_s;        // the time in which the device stands still; both need time
  std::optional<double> v_max_mm_s;     // largest |slope| of a chord over a 25th of a cycle; needs time
  std::optional<double> N_mean_kN;      // vertical load; needs its channel
  std::optional<double> N_min_kN;
  std::optional<double> N_max_kN;
  double closure_mm = 0.0;  // end minus start, before the loop is closed
  double closure_kN = 0.0;

  bool counts() const { return number > 0; }
  // Not defined if the force has hardly any stiffness: less than a thousandth of the loop's mean half height.
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
struct Block {
  int number = 0;                      // from 1
  double amplitude_mm = 0.0;           // medians over the cycles that count
  std::optional<double> frequency_Hz;  // from the periods, which leave out rests and holds
  std::optional<double> v_max_mm_s;
  std::string waveform;       // "sine", "triangle" or "other"; empty without time
  std::vector<Cycle> cycles;  // in order, those that do not count included

  std::vector<Cycle const*> counted() const;
};

struct Properties {
  std::vector<Block> blocks;
  // Third counted cycle (the last if there are fewer) of the first block of largest amplitude; empty when refused.
  std::optional<Cycle> reported;
  // The reason for no reported cycle: a fault, not cyclic, under 20 samples per cycle, negative energy or stiffness.
  std::vector<Finding> refusal;
  bool is_false = false;                    // the refusal says that a signal or a cycle cannot be true
  std::vector<SignalFault> faults;          // only for a whole record; if there are any, no cycle counts
  std::optional<double> samples_per_cycle;  // median over the cycles that count, rests and holds left out
  double centre_mm = 0.0;                   // level of the cuts

  Cycle const* find(int block, int number) const;  // nullptr if there is none
  std::vector<Cycle const*> counted() const;       // from all blocks, in order
  std::vector<Cycle const*> complete() const;      // all but partial ones, even if the record is not cyclic
  bool is_reported(Cycle const& cycle) const;
};

// time_s and load_kN may be empty, else all are of one length.
struct CycleView {
  std::span<double const> disp_mm;
  std::span<double const> force_kN;
  std::span<double const> time_s;
  std::span<double const> load_kN;
};

Properties cyclic_properties(CycleView const& view);
// If a signal has a fault, no cycle counts.
Properties cyclic_properties(TestRecord const& record);
// Without time and load: periods are compared in samples.
Properties cyclic_properties(std::span<double const> disp_mm, std::span<double const> force_kN);

// The properties of another force on the same cycle (a law's computed force at the same samples).
Cycle properties_on(Cycle const& cycle, std::span<double const> disp_mm, std::span<double const> force_kN);

// How a property changes over the counted cycles of one block (EN 15129 8.2.1.2.6; scragging). Ratios to cycle 3 are
// empty where there is none. Extremes are over cycles 2 to 10 and 1 to 10, or as many as there are; least_to_largest is
// the smallest value of these cycles over the largest.
struct Stability {
  int cycles = 0;  // that count
  std::vector<double> ratio_to_third;
  std::optional<double> min_2_10, max_2_10, min_1_10, max_1_10;
  std::optional<double> least_to_largest_2_10, least_to_largest_1_10;
  std::optional<double> first_to_third;     // scragging ratio
  std::optional<double> first_to_mean_1_3;  // largest test factor of ASCE 7, if the property falls
  std::optional<double> last_to_mean_1_3;   // smallest such factor
};
// stability(block, &Cycle::K_eff_kN_per_mm), or energy_kN_mm, or damping_percent.
Stability stability(Block const& block, double Cycle::*property);

struct Strains {
  double shear_strain_percent = 0.0;  // 100 D / T_r
  double G_MPa = 0.0;                 // K_eff T_r / A_r
};

// The device has rubber of thickness T_r in mm and area A_r in mm2, both positive.
Strains strains(Cycle const& cycle, double rubber_thickness_mm, double rubber_area_mm2);

}  // namespace isolaw::data
