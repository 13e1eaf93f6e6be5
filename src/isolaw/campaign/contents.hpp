// What a campaign holds, in memory: the plain image of the store.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "isolaw/analysis/determination.hpp"
#include "isolaw/analysis/intervals.hpp"
#include "isolaw/analysis/one_law.hpp"
#include "isolaw/campaign/settings.hpp"
#include "isolaw/data/record.hpp"
#include "isolaw/data/vertical.hpp"
#include "isolaw/fit/as_springs.hpp"
#include "isolaw/fit/box.hpp"

namespace isolaw::campaign {

// The program that computed a part of a campaign.
struct Maker {
  std::string version;          // of isolaw
  std::string build;            // a hash of the sources that decide numbers; empty: not known
  std::string instruction_set;  // of the search; empty: not known

  bool operator==(Maker const&) const = default;
};

// What the lot file says about a device beside its record.
struct DeviceInfo {
  std::string serial, lot, test_date;
  std::optional<double> temperature_C, rubber_thickness_mm, rubber_area_mm2;

  bool operator==(DeviceInfo const&) const = default;
};

struct Device {
  std::string name;
  std::string file;  // as given, relative to the lot file
  DeviceInfo info;
  std::string refusal = {};  // why the device takes no part; empty for a usable one
  data::TestRecord raw = {};
  data::FitRecord record = {};       // what the laws are fitted to
  data::VerticalTest vertical = {};  // no law depends on it, so it may change before a campaign is continued

  bool usable() const { return refusal.empty(); }
};

// One law's search on one device: its box, or why it was not searched.
struct Search {
  std::size_t device = 0;
  std::string law;
  std::string refusal = {};
  fit::SearchBox box = {};
};

// confirmed, budget_spent: of the method `best`; all_generations, stagnated: of the genetic algorithm.
using opt::Outcome;  // an interrupted run is not kept
std::string_view name(Outcome outcome);

// Steps per sample, a power of four: what a search may end on.
inline constexpr int finest_refinement = 64;

struct Run {
  std::size_t device = 0;
  std::string law;
  int number = 0;  // from 1
  Outcome outcome = Outcome::no_finite_value;
  double objective = 0.0;          // NaN when no parameter set gave a finite force
  double integration_shift = 0.0;  // of the objective, against a much finer path
  int refinement = 1;              // steps per sample of the path that the law was integrated on in the end
  int evaluations = 0;
  int failed_evaluations = 0;           // parameter sets tried that gave no finite force
  std::string failure = {};             // why the run is not usable; empty for a usable one
  std::vector<double> parameters = {};  // all of the law's; empty when not usable
  std::vector<double> history = {};     // best objective after each generation, or start
  std::size_t maker = 0;                // place in Contents::makers; the store sets it

  bool usable() const { return !parameters.empty(); }
};

// What the test of one device determines of a law, about its least objective.
struct DeviceAnalysis {
  std::size_t device = 0;
  std::string law;
  int refinement = 1;  // as of the run it starts from
  analysis::Determination determination;
  analysis::Intervals intervals;
  std::optional<fit::AsSprings> springs = {};  // where they were asked for and its optimum has no coupled form
  std::size_t maker = 0;
};

// One parameter vector for all devices that have a DeviceAnalysis of the law.
struct LotAnalysis {
  std::string law;
  int refinement = 1;                          // the finest of the devices'
  std::vector<std::size_t> devices;            // those that took part, rising
  analysis::OneLaw mean = {};                  // least mean objective; objectives in the order of `devices`
  analysis::LeastWorst worst = {};             // least objective of the worst device
  std::optional<fit::AsSprings> springs = {};  // of the mean, as of a device
  std::size_t maker = 0;
};

// The law of the lot without one device, judged by it.
struct LeftOutAnalysis {
  std::size_t device = 0;
  std::string law;
  analysis::LeftOut left_out = {};
  std::size_t maker = 0;
};

// The order of results, but for the number of a run.
inline constexpr auto by_device_and_law = [](auto const& item) {
  return std::tuple(item.device, std::string_view(item.law));
};

// Analyses of a campaign of fewer runs. One of a device holds where the best run is among those; one of the lot where
// all of its devices' do.
struct HeldOver {
  int runs = 0;  // per device and law
  std::vector<DeviceAnalysis> devices = {};
  std::vector<LotAnalysis> lots = {};
  std::vector<LeftOutAnalysis> left_out = {};
};

// What the tests are held to. No law depends on it, so it may change before a campaign is continued or reported.
struct Acceptance {
  std::string rules;            // text of a rule set; empty: none
  std::string rules_file;       // its name
  std::string design;           // "K_eff=1.2,damping=15"; empty: no design values
  std::optional<int> lot_size;  // devices of the production lot, tested or not

  bool operator==(Acceptance const&) const = default;
};

// A share of a campaign's runs, for a machine of its own: number `number` of `of`. It decides which runs are computed,
// and none of their numbers.
struct Part {
  int number = 1, of = 1;

  bool operator==(Part const&) const = default;
};
inline constexpr int most_parts = 100'000;
Part parse_part(std::string_view text);  // "3/40"; throws Error
std::string text(Part const& part);      // and back

// What the law of the lot goes by where a device may be named.
inline constexpr std::string_view whole_lot = "lot";

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
  std::vector<Maker> makers = {};                    // the first read the records; empty: nobody but this program
  std::optional<Part> part = {};                     // which alone is computed, and stored here; nullopt: all
  HeldOver held_over = {};                           // of a campaign that grows; in no store

  std::size_t expected_runs() const;  // of every search that was not refused
  std::size_t expected_here() const;  // those of them that are of this part
  // Analyses that are to be made, given the runs there are; 0 without analysis. A part makes none, but they are
  // expected of the whole.
  std::size_t expected_analyses() const;
  std::size_t analyses() const { return device_analyses.size() + lot_analyses.size() + left_out.size(); }
  // Nothing is left to compute here.
  bool complete() const { return runs.size() == expected_here() && (part || analyses() >= expected_analyses()); }

  // The usable run of least objective, the first of equals; nullptr: none.
  Run const* best_run(std::size_t device, std::string_view law) const;
  DeviceAnalysis const* analysis_of(std::size_t device, std::string_view law) const;
  // The device of that name; nullopt: `whole_lot`, where no device is called so. Throws Error: neither.
  std::optional<std::size_t> device_or_lot(std::string_view name) const;
};

}  // namespace isolaw::campaign
