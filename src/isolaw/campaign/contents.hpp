// The data of a campaign in memory, as the store holds them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "isolaw/analysis/determination.hpp"
#include "isolaw/analysis/intervals.hpp"
#include "isolaw/analysis/larger_swings.hpp"
#include "isolaw/analysis/one_law.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/unit_system.hpp"
#include "isolaw/campaign/observed_tests.hpp"
#include "isolaw/campaign/settings.hpp"
#include "isolaw/data/channels/record.hpp"
#include "isolaw/data/properties/vertical.hpp"
#include "isolaw/fit/as_springs.hpp"
#include "isolaw/fit/box.hpp"

namespace isolaw::campaign {

struct Maker {  // the program that computed a part of a campaign
  std::string version;
  std::string build;            // a hash of the sources that determine numbers; empty if not known
  std::string instruction_set;  // the instruction set of the searches; empty if not known

  bool operator==(Maker const&) const = default;
};

struct DeviceInfo {  // what the lot file states about a device besides its record
  std::string serial, lot, test_date;
  std::optional<double> temperature_C, rubber_thickness_mm, rubber_area_mm2;

  bool operator==(DeviceInfo const&) const = default;
};

struct Device {
  std::string name;
  std::string file;  // path as given, relative to the lot file
  DeviceInfo info;
  std::string refusal = {};                // why the device is left out; empty if it is usable
  std::vector<Complaint> complaints = {};  // the single faults that make up the refusal; not stored
  data::TestRecord raw = {};
  data::TestRecord uncorrected = {};  // `raw` without the corrections that the user asked for; empty if there are none
  data::FitRecord record = {};        // the cleaned record that laws are fitted to
  data::VerticalTest vertical = {};   // compression test; no law depends on it, so a continued campaign may change it
  // If this device is a copy of another device, the name of that device. A copy has the same record, or its record was
  // made from the record of the other device. Statistics over devices leave out copies. Empty if this device is no
  // copy. Not stored: Contents::find_copies() sets it.
  std::string copy_of = {};

  bool usable() const { return refusal.empty(); }
  bool counts() const { return copy_of.empty(); }
};

struct Search {  // a law that is fitted to a device: its box, or the reason why there is none
  std::size_t device = 0;
  std::string law;
  std::string refusal = {};
  fit::SearchBox first_box = {};  // the box in which every run begins
  fit::SearchBox box = {};        // the box of the best run, which may be wider; first_box if there is no usable run
};

// A run of Method::best ends with confirmed, budget_spent or no_finite_value, and a run of Method::genetic with
// all_generations, stagnated or no_finite_value. Interrupted runs are not kept.
using opt::Outcome;
std::string_view name(Outcome outcome);
// The most integration steps per sample to which a run is refined. A run ends with 1, 4, 16 or 64 steps per sample.
inline constexpr int finest_refinement = 64;

struct Run {
  std::size_t device = 0;
  std::string law;
  int number = 0;  // counted from 1
  Outcome outcome = Outcome::no_finite_value;
  double objective = 0.0;          // NaN if no parameter set gave a finite force
  double integration_shift = 0.0;  // by how much 20 times finer integration steps change the objective
  int refinement = 1;              // the number of integration steps per sample that the run ended with
  int evaluations = 0;
  int failed_evaluations = 0;           // evaluations that gave no finite force
  std::string failure = {};             // why the run is not usable; empty for a usable one
  std::vector<double> parameters = {};  // all parameters of the law; empty for a run that is not usable
  std::vector<double> history = {};     // best objective after each generation or descent
  std::vector<double> box = {};         // lower and upper bound of each parameter; empty: those of the first box
  std::size_t maker = 0;                // index in Contents::makers; the store sets it

  bool usable() const { return !parameters.empty(); }
};

struct DeviceAnalysis {  // how well one device's tests determine a law's parameters, examined at the least objective
  std::size_t device = 0;
  std::string law;
  int refinement = 1;  // refinement of the run at which the analysis starts
  analysis::Determination determination;
  analysis::Intervals intervals;
  // The law fitted as springs around a circle (fit/as_springs.hpp). Present only if the settings ask for it and the law
  // has no coupled two-dimensional form with the parameters of the optimum.
  std::optional<fit::SpringsFit> springs = {};
  std::optional<analysis::LargerSwings> larger_swings =
      {};  // empty if the test shows nothing about larger swings, or if no force is finite
  std::size_t maker = 0;
};

struct LotAnalysis {  // one parameter vector for all devices that are no copies and have an analysis
  std::string law;
  int refinement = 1;                           // integration steps per sample: the largest number of any device's run
  std::vector<std::size_t> devices;             // the devices that took part, in rising order
  analysis::OneLaw mean = {};                   // law of least mean objective; its objectives[i] belongs to devices[i]
  analysis::LeastWorst worst = {};              // the law whose largest objective on any device is least
  std::optional<fit::SpringsFit> springs = {};  // as in DeviceAnalysis, but fitted to all devices, starting from `mean`
  std::size_t maker = 0;
};

struct LeftOutAnalysis {  // the law fitted to the lot without one device, judged on that device
  std::size_t device = 0;
  std::string law;
  analysis::LeftOutFit left_out = {};
  std::size_t maker = 0;
};

fit::SearchBox box_of(Search const& search, Run const& run);  // the box in which this run ended

inline constexpr auto by_device_and_law = [](auto const& item) {
  return std::tuple(item.device, std::string_view(item.law));
};

// The analyses that a campaign had before it was continued with more runs. An analysis stays valid if the best runs
// from which it starts are still the best.
struct EarlierAnalyses {
  int runs = 0;  // the number of runs per device and law at that time
  std::vector<DeviceAnalysis> devices = {};
  std::vector<LotAnalysis> lots = {};
  std::vector<LeftOutAnalysis> left_out = {};
};

// How far the tests of devices may differ and still count as made under one condition. A percentage is relative to the
// largest of the compared values.
struct Alike {
  // isolaw's own tolerances, where neither the rule set nor the user states one
  static constexpr double own_temperature_C = 2.0, own_frequency_percent = 10.0, own_load_percent = 10.0,
                          own_amplitude_percent = 5.0, own_earlier_cycles = 1.0;
  std::optional<double> temperature_C = {}, frequency_percent = {}, load_percent = {}, amplitude_percent = {},
                        earlier_cycles = {};

  bool operator==(Alike const&) const = default;
};

// The requirements for the tests, and how reports show values. No law depends on them, so a campaign that is continued
// or reported may change them.
struct Acceptance {
  std::string rules;                 // text of a rule set; empty if there is none
  std::string rules_file;            // name or path of the rule set
  std::string design;                // "K_eff=1.2,damping=15"; empty if there are no design values
  std::optional<int> lot_size;       // number of devices in the production lot, tested or not
  std::string letterhead = {};       // a picture as a data: address, or lines of text; empty if there is none
  std::string letterhead_file = {};  // name or path of the file that `letterhead` was read from
  Alike alike = {};                  // tolerances that the user gives where the rule set states none
  std::string_view report_units = record_units.id;  // id of the unit system in which reports show values

  bool operator==(Acceptance const&) const = default;
};

// One of the `total` parts into which the runs of a campaign are divided, so that several machines can compute them.
// `number` counts from 1. No result depends on how the runs are divided.
struct Part {
  int number = 1, total = 1;

  bool operator==(Part const&) const = default;
};
inline constexpr int most_parts = 100'000;
Part parse_part(std::string_view text);  // "3/40"; throws Error
std::string text(Part const& part);      // the inverse of parse_part()

inline constexpr std::string_view whole_lot = "lot";  // given in place of a device's name, it means the lot

struct Contents {
  std::string title;
  Acceptance acceptance;
  Settings settings;
  std::vector<Device> devices = {};
  std::optional<ObservedTests> observed = {};        // if the lot file has a table [conditions]
  std::vector<Search> searches = {};                 // sorted by device, then in the order of settings.laws
  std::vector<Run> runs = {};                        // sorted by device, law, number
  std::vector<DeviceAnalysis> device_analyses = {};  // sorted by device, law
  std::vector<LotAnalysis> lot_analyses = {};        // sorted by law
  std::vector<LeftOutAnalysis> left_out = {};        // sorted by device, law
  std::vector<Maker> makers = {};                    // makers[0] read the records; empty: this program did all
  std::optional<Part> part = {};                     // the part computed and stored here; nullopt: the whole campaign
  EarlierAnalyses held_over = {};                    // analyses made before the campaign grew; not stored

  std::size_t expected_runs() const;  // the runs of all parts together; a refused search has none
  std::size_t expected_here() const;  // the runs of this part
  // The number of analyses that the whole campaign makes from the present runs; 0 if the settings ask for none. A part
  // has no analyses: they need the best of all runs and are made after the merge.
  std::size_t expected_analyses() const;
  std::size_t analyses() const { return device_analyses.size() + lot_analyses.size() + left_out.size(); }
  bool complete() const { return runs.size() == expected_here() && (part || analyses() >= expected_analyses()); }

  Run const* best_run(std::size_t device, std::string_view law) const;  // the usable run of least objective, or nullptr
  void take_boxes_of_best_runs();                                       // sets Search::box; needed after runs are added
  // Sets Device::copy_of; needed after devices are added. Among devices with the same record, the first that has cyclic
  // properties counts, and the others are its copies. If none has any, the first usable one counts.
  void find_copies();
  DeviceAnalysis const* analysis_of(std::size_t device, std::string_view law) const;
  // The index of the named device, or nullopt for `whole_lot` if no device has that name. Throws Error for other names.
  std::optional<std::size_t> device_or_lot(std::string_view name) const;
};

}  // namespace isolaw::campaign
