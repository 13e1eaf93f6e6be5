// The data of a campaign in memory, as the store holds them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "isolaw/analysis/determination.hpp"
#include "isolaw/analysis/intervals.hpp"
#include "isolaw/analysis/one_law.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/campaign/settings.hpp"
#include "isolaw/data/channels/record.hpp"
#include "isolaw/data/properties/vertical.hpp"
#include "isolaw/fit/as_springs.hpp"
#include "isolaw/fit/box.hpp"

namespace isolaw::campaign {

struct Maker {  // the program that computed a part of a campaign
  std::string version;
  std::string build;            // a hash of the sources that determine numbers; empty if not known
  std::string instruction_set;  // the search's; empty if not known

  bool operator==(Maker const&) const = default;
};

struct DeviceInfo {  // as the lot file states it, besides the record
  std::string serial, lot, test_date;
  std::optional<double> temperature_C, rubber_thickness_mm, rubber_area_mm2;

  bool operator==(DeviceInfo const&) const = default;
};

struct Device {
  std::string name;
  std::string file;  // as given, relative to the lot file
  DeviceInfo info;
  std::string refusal = {};                // why the device is left out; empty for a usable one
  std::vector<Complaint> complaints = {};  // the refusal in parts, as reading the records gave them; not stored
  data::TestRecord raw = {};
  data::FitRecord record = {};       // the cleaned record that laws are fitted to
  data::VerticalTest vertical = {};  // no law depends on it, so it may change before a campaign is continued

  bool usable() const { return refusal.empty(); }
};

struct Search {  // a law on a device: its box, or the reason why there is none
  std::size_t device = 0;
  std::string law;
  std::string refusal = {};
  fit::SearchBox box = {};
};

// `best` ends with confirmed or budget_spent, the genetic algorithm with all_generations or stagnated, both also with
// no_finite_value. Interrupted runs are not kept.
using opt::Outcome;
std::string_view name(Outcome outcome);
// The most integration steps per sample that a run may end with. The number of steps is a power of four.
inline constexpr int finest_refinement = 64;

struct Run {
  std::size_t device = 0;
  std::string law;
  int number = 0;  // from 1
  Outcome outcome = Outcome::no_finite_value;
  double objective = 0.0;          // NaN if no parameter set gave a finite force
  double integration_shift = 0.0;  // how far the objective moves on a much finer path
  int refinement = 1;              // the number of integration steps per sample that the run ended with
  int evaluations = 0;
  int failed_evaluations = 0;           // how many of them gave no finite force
  std::string failure = {};             // why the run is not usable; empty for a usable one
  std::vector<double> parameters = {};  // all of the law's; empty for a run that is not usable
  std::vector<double> history = {};     // best objective after each generation or descent
  std::size_t maker = 0;                // index in Contents::makers; the store sets it

  bool usable() const { return !parameters.empty(); }
};

struct DeviceAnalysis {  // a law on one device, at its least objective: what the test determines
  std::size_t device = 0;
  std::string law;
  int refinement = 1;  // the refinement of the run that it starts from
  analysis::Determination determination;
  analysis::Intervals intervals;
  std::optional<fit::AsSprings> springs = {};  // if they were asked for and the optimum has no coupled form
  std::size_t maker = 0;
};

struct LotAnalysis {  // one parameter vector for all devices that have a DeviceAnalysis of the law
  std::string law;
  int refinement = 1;                          // the largest refinement of the devices
  std::vector<std::size_t> devices;            // the devices that took part, in rising order
  analysis::OneLaw mean = {};                  // the law of least mean objective; its objectives follow `devices`
  analysis::LeastWorst worst = {};             // the law with the least objective of the worst device
  std::optional<fit::AsSprings> springs = {};  // fitted from `mean`, under the same conditions as for a device
  std::size_t maker = 0;
};

struct LeftOutAnalysis {  // the law of the lot without one device, judged on that device
  std::size_t device = 0;
  std::string law;
  analysis::LeftOut left_out = {};
  std::size_t maker = 0;
};

inline constexpr auto by_device_and_law = [](auto const& item) {
  return std::tuple(item.device, std::string_view(item.law));
};

// Analyses from when the campaign had fewer runs. An analysis stays valid if the best runs it starts from are the same.
struct EarlierAnalyses {
  int runs = 0;  // the number of runs per device and law at that time
  std::vector<DeviceAnalysis> devices = {};
  std::vector<LotAnalysis> lots = {};
  std::vector<LeftOutAnalysis> left_out = {};
};

// The requirements for the tests. No law depends on them: they may change before a campaign is continued or reported.
struct Acceptance {
  std::string rules;            // text of a rule set; empty if there is none
  std::string rules_file;       // name or path of the rule set
  std::string design;           // "K_eff=1.2,damping=15"; empty if there are no design values
  std::optional<int> lot_size;  // number of devices in the production lot, tested or not

  bool operator==(Acceptance const&) const = default;
};

// A share of a campaign's runs for one of several machines: part `number` of `of`. It changes no result.
struct Part {
  int number = 1, of = 1;

  bool operator==(Part const&) const = default;
};
inline constexpr int most_parts = 100'000;
Part parse_part(std::string_view text);  // "3/40"; throws Error
std::string text(Part const& part);      // the inverse

inline constexpr std::string_view whole_lot = "lot";  // named in place of a device for the law of the lot

struct Contents {
  std::string title;
  Acceptance acceptance;
  Settings settings;
  std::vector<Device> devices = {};
  std::vector<Search> searches = {};                 // by device, then in the order of the settings' laws
  std::vector<Run> runs = {};                        // by device, law, number
  std::vector<DeviceAnalysis> device_analyses = {};  // by device, law
  std::vector<LotAnalysis> lot_analyses = {};        // by law
  std::vector<LeftOutAnalysis> left_out = {};        // by device, law
  std::vector<Maker> makers = {};                    // the first read the records; empty: only this program
  std::optional<Part> part = {};                     // the only part computed and stored here; nullopt: all
  EarlierAnalyses held_over = {};                    // from before the campaign grew; not stored

  std::size_t expected_runs() const;  // over all parts and the searches that were not refused
  std::size_t expected_here() const;  // the runs of this part
  // Analyses of the whole campaign, given the present runs; 0 if none are asked for. A part makes none itself.
  std::size_t expected_analyses() const;
  std::size_t analyses() const { return device_analyses.size() + lot_analyses.size() + left_out.size(); }
  bool complete() const { return runs.size() == expected_here() && (part || analyses() >= expected_analyses()); }

  Run const* best_run(std::size_t device, std::string_view law) const;  // the usable run of least objective, or nullptr
  DeviceAnalysis const* analysis_of(std::size_t device, std::string_view law) const;
  // The index of the named device; nullopt for `whole_lot`, unless a device is called so. Throws Error for other names.
  std::optional<std::size_t> device_or_lot(std::string_view name) const;
};

}  // namespace isolaw::campaign
