// Recommends one law from all results of a campaign. docs/decision.md explains the rule.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

enum class Confidence { clear, tie, weak };
std::string_view name(Confidence confidence);

enum class Rank { taken, tied, behind, ruled_out };
std::string_view name(Rank rank);  // "taken", "ties", "behind", "ruled out"

struct Standing {
  std::size_t law = 0;  // index into Summary::laws
  Rank rank = Rank::behind;
  // Errors of the law, as means over the devices. `fits`: on the tests (or the part of them) to which it was fitted.
  // `new_device`: on devices to which it was not fitted. `predicts`: on larger swings, or on blocks of larger
  // amplitude, to which it was not fitted.
  std::optional<double> fits, new_device, predicts;
  // The error that decides which law is taken: the mean of `predicts` and of the error on devices, or whichever of them
  // is known. The error on devices is `new_device` if it is known and there are three devices or more, else `fits`.
  std::optional<double> error;
  std::size_t parameters = 0;        // parameters that were searched
  std::optional<Finding> reason;     // why the law is ruled out
  std::vector<Finding> doubts = {};  // doubts about a law that is not ruled out
};

// How far the laws of least error (at most five, none ruled out) differ in steady cycles at BeyondTests::asked_mm. This
// is the range of their values, not a confidence interval.
struct LawSpread {
  std::size_t count = 0;
  double disp_mm = 0.0, tested_mm = 0.0;  // amplitude of these cycles; largest displacement of the tests
  double K_low_kN_per_mm = 0.0, K_high_kN_per_mm = 0.0, energy_low_kN_mm = 0.0, energy_high_kN_mm = 0.0;
};

struct Recommendation {
  std::optional<std::size_t> law;            // index into Summary::laws; empty: no law can be recommended
  Confidence confidence = Confidence::weak;  // weak: there is a doubt about the law, which may also tie with others
  std::vector<Standing> standings;           // all laws in this order: taken, tied, others by error, ruled out
  std::vector<Finding> answer;               // recommends `law` and says how well it does, or recommends no law
  std::vector<Finding> reasons;
  std::vector<Finding> improvements;  // tests that would make the choice surer; empty if there are none
  std::optional<LawSpread> spread;    // empty if fewer than two laws that are not ruled out can be compared
  // Up to which displacement tests support the law, and how far laws differ beyond it.
  std::vector<Finding> range_findings;
  std::optional<double> valid_mm;   // largest displacement at which the law was shown to hold
  std::optional<Finding> programs;  // how to use the law in analysis programs that lack it

  std::vector<Finding> const& doubts() const { return standings.front().doubts; }  // doubts about the law that is taken
};

bool compares_laws(Summary const& summary);
// The command that writes the recommended law for an analysis program; "" if no law is recommended. `campaign` is the
// directory of the campaign.
std::string export_command(Summary const& summary, Recommendation const& advice, std::string_view campaign);
Finding finding_of(LawSpread const& spread);
// isolaw's recommendation; nullopt for an inspection, which fits no laws.
std::optional<Recommendation> recommendation(Summary const& summary);

inline constexpr double tie_share = 0.10;     // a law ties if its error is at most this share above the least error
inline constexpr double usable_error = 0.30;  // no law is recommended if the least error is larger
// Beyond any of these limits the confidence in the law is weak. Errors of stiffness, energy and damping are means over
// the devices of the magnitudes of DeviceFit::K_eff_error_percent, energy_error_percent and damping_error_percent.
inline constexpr double doubtful_error = 0.20;
inline constexpr double doubtful_times = 2.0;  // error on larger swings or other blocks / error of the fit
inline constexpr double doubtful_stiffness_percent = 15.0, doubtful_energy_percent = 30.0;
inline constexpr double small_damping_percent = 5.0, doubtful_damping_points = 2.0;
inline constexpr double low_stiffness_ratio = 0.5, low_damping_ratio = 0.4, high_ratio = 1.5;
inline constexpr double found_share = 0.5;  // least share of the law's runs that end near the least objective
inline constexpr double open_share = 0.5;   // largest share of undetermined parameters, if no prediction was tested

}  // namespace isolaw::study
