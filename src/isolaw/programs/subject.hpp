// The subject of an export: one law of a campaign with the parameters of a device or of the lot.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/programs/model.hpp"
#include "isolaw/programs/unit_system.hpp"
#include "isolaw/study/doubts.hpp"
#include "isolaw/study/ranges.hpp"
#include "isolaw/study/summary.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::programs {

// A motion, point by point, with its forces. The first point is at zero displacement, where programs start.
struct History {
  std::string device;  // empty: the protocol of the self-check
  std::vector<double> time_s, disp_mm, vel_mm_s;
  std::vector<double> measured_kN;  // empty for a protocol; NaN at points that are not samples
  std::vector<double> law_kN;       // the law from the virgin state at the first point
  bool timed = true;                // false: time_s counts samples
  int refinement = 1;               // steps of the law in each interval
  double dead_band_mm = 0.0;        // FitRecord::dead_band_mm
};

// Empty values are stated neither by the records nor by the lot file.
struct Tested : study::Range {
  std::optional<double> strain_percent;
  std::optional<double> lowest_Hz, highest_Hz;
  std::optional<double> load_min_kN, load_max_kN;
  std::optional<double> temperature_min_C, temperature_max_C;
};

struct Fitted : study::Range {
  std::string part;  // "block 1", ...; empty: all blocks
};

// Factors on the part of the force that grows with displacement (K_d) and on the hysteretic part (Q_d). They are equal
// if only one is known.
struct BoundFactors {
  double stiffness = 1.0, strength = 1.0;
  double overall = 1.0;  // on the whole force, for laws and programs that cannot separate the parts
  bool separate = false;
};

struct Bounds {
  std::optional<BoundFactors> lower, upper;
  std::string source;  // where the factors come from, or why there are none
};

struct Subject {
  std::string version;  // version of the program that exports
  std::string makers;   // versions and builds of isolaw that calibrated
  std::string title;
  laws::LawEntry const* law = nullptr;
  bool lot = false;
  std::string device;  // the device's name; "lot" for the law of the lot
  // Number of the device in the campaign, from 1, if another device has the same plain_name(); else 0.
  std::size_t number_among_alike = 0;
  std::vector<double> parameters;  // in the law's units and order
  // One history for a device; for a lot one for each device that takes part, the largest amplitude first.
  std::vector<History> histories;
  History protocol;           // two cycles, at half and at the whole tested amplitude
  double frequency_Hz = 0.0;  // frequency of the protocol
  std::optional<double> objective;
  Tested tested;
  Fitted fitted;
  study::Doubts doubts;
  Bounds bounds;
  std::uint64_t seed = 1;
  int refinement = 1;
  double dead_band_mm = 0.0;                               // from the device's record; for a lot the largest
  std::optional<double> K_eff_kN_per_mm, damping_percent;  // measured: of the device, or the mean of the lot
  double design_disp_mm = 0.0;                             // amplitude of the reported cycle
  std::vector<std::string> beyond;  // sentences about the law beyond the tests (away.hpp), in the units asked for
  std::vector<std::string> notes;
  std::optional<Model> model;  // empty unless the target writes a whole building
};

// Two sine cycles from rest, without forces. The second begins at the middle point.
inline constexpr int protocol_steps = 80;
History two_cycles(double first_mm, double second_mm, double frequency_Hz, int steps_per_cycle = protocol_steps);

// A name that programs accept: at most 40 characters. One underscore replaces each run of other characters.
std::string plain_name(std::string_view name);

// Throws Error if the campaign lacks such a law, device or result. `units` are for Bounds::source and `beyond`.
Subject make_subject(campaign::Contents const& contents, study::Summary const& summary, std::string_view law,
                     std::string_view device, UnitSystem const& units = unit_systems[0]);

// Returns the force in kN at the history's points.
std::vector<double> law_force(laws::LawEntry const& law, std::span<double const> parameters, History const& history);

}  // namespace isolaw::programs
