// The subject of an export: one law of a campaign with its parameters for a device or for the lot.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/unit_system.hpp"
#include "isolaw/campaign/contents.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/programs/model.hpp"
#include "isolaw/study/doubts.hpp"
#include "isolaw/study/ranges.hpp"
#include "isolaw/study/summary.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::programs {

// A motion, point by point, and its forces. It begins at zero displacement, because materials of analysis programs do.
struct History {
  std::string device;  // empty for the self-check's protocol
  std::vector<double> time_s, disp_mm, vel_mm_s;
  std::vector<double> measured_kN;  // empty for a protocol; NaN at points that are not samples of the record
  std::vector<double> law_kN;       // force of the law, which is virgin at the first point
  bool timed = true;                // false if time_s only counts samples
  int refinement = 1;               // integration steps of the law between two points
  double dead_band_mm = 0.0;
};

// Ranges of the tests. A value is empty if neither the records nor the lot file state it.
struct TestedRange : study::Range {
  std::optional<double> strain_percent;
  std::optional<double> lowest_Hz, highest_Hz;
  std::optional<double> load_min_kN, load_max_kN;
  std::optional<double> load_mean_kN;  // mean load in the reported cycle; for a lot the mean over the devices
  std::optional<double> temperature_min_C, temperature_max_C;
};

struct FittedRange : study::Range {
  std::string part;  // part of the record used for the fit: "block 1", ...; empty for all blocks
};

// The factors by which a bound differs from the law: `stiffness` multiplies the part of the force that grows with the
// displacement (K_d), `strength` the hysteretic part (Q_d).
struct BoundFactors {
  double stiffness = 1.0, strength = 1.0;
  double overall = 1.0;               // factor on the whole force, for programs that cannot scale the parts
  std::optional<double> energy = {};  // factor on the energy at the bound; if empty, this is `overall`
  bool separate = false;              // false: `stiffness` and `strength` are both the factor on the whole force
  // The law's own parameters at the bound, in its order and units. Empty for bounds of the scatter between devices.
  std::vector<double> parameters = {};
};

struct Bounds {
  std::optional<BoundFactors> lower = {}, upper = {};
  std::string source;  // where the factors come from, or why there are none
  // The tolerance factor k (num/tolerance_factor.hpp), if all factors were computed with it. The bounds then hold 95 %
  // of the devices with a confidence of 95 %.
  std::optional<double> tolerance_factor = {};
};

struct Subject {
  std::string version;  // version of isolaw that writes the export
  std::string makers;   // versions and builds of isolaw that computed the campaign
  std::string title;
  laws::LawEntry const* law = nullptr;
  bool lot = false;
  std::string device;  // name of the device, or "lot"
  std::string name;    // the export's name if the user chose one; else identifier() (text.hpp) makes it
  // Number of the device in the campaign, from 1, if plain_name() gives another device the same name. Otherwise 0.
  std::size_t number_among_alike = 0;
  std::vector<double> parameters;  // in the law's order and units
  // Parameters with which springs around a circle fit the tests best, if the campaign fitted them.
  std::optional<std::vector<double>> springs;
  // One history for each test of the device, or of the lot's devices. The one of largest amplitude is first.
  std::vector<History> histories;
  History protocol;           // the path of check_path(), with the law's force
  double frequency_Hz = 0.0;  // frequency of the protocol
  std::optional<double> objective;
  TestedRange tested;
  FittedRange fitted;
  study::Doubts doubts;
  Bounds bounds;
  std::uint64_t seed = 1;
  int refinement = 1;
  double dead_band_mm = 0.0;  // dead band of the device's record; for a lot the largest dead band of its records
  std::optional<double> K_eff_kN_per_mm, damping_percent;  // measured on the device; for a lot the mean
  double design_disp_mm = 0.0;                             // amplitude of the reported cycle; for a lot the largest
  std::vector<std::string> beyond_tests;                   // what beyond_the_tests() says about the law
  std::vector<std::string> notes;
  std::optional<Model> model;               // only for targets that write a whole building
  std::vector<data::GroundMotion> motions;  // to compare a re-fit with the law (response.hpp)
};

// Makes two sine cycles, without forces. The first has the amplitude first_mm, the second has second_mm. The velocity
// is 0 at the first point, where materials of analysis programs start at rest, and that of the sine at the others.
inline constexpr int protocol_steps = 80;
History two_cycles(double first_mm, double second_mm, double frequency_Hz, int steps_per_cycle = protocol_steps);

struct Subject;
// Two cycles, at half and at the whole tested amplitude, with the force of the subject's law.
History tested_cycles(Subject const& subject);

// Makes the path of every self-check, without forces: from rest through two growing cycles up to `tested_mm` and
// through smaller loops within them, so that turning points, peaks, travel and the dead band act on the force. Each
// swing is half a cosine and no faster than a sine of amplitude `tested_mm` and frequency `frequency_Hz`. The time
// between samples is the period of this sine divided by protocol_steps.
History check_path(double tested_mm, double frequency_Hz, double dead_band_mm);

// Makes a name that programs accept: letters, digits, and `_` for each run of other characters; at most `longest` long.
inline constexpr std::size_t longest_name = 40;
std::string plain_name(std::string_view name, std::size_t longest = longest_name);

// Throws Error if the campaign has no such law, device or result. Bounds::source and Subject::beyond_tests use `units`.
Subject make_subject(campaign::Contents const& contents, study::Summary const& summary, std::string_view law,
                     std::string_view device, UnitSystem const& units = unit_systems[0]);

// Returns the force in kN at the history's points.
std::vector<double> law_force(laws::LawEntry const& law, std::span<double const> parameters, History const& history);

}  // namespace isolaw::programs
