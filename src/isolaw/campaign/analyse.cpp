#include "isolaw/campaign/analyse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "isolaw/base/hash.hpp"
#include "isolaw/campaign/parallel.hpp"
#include "isolaw/campaign/part_assignment.hpp"
#include "isolaw/laws/plane/in_plane.hpp"
#include "isolaw/opt/multistart.hpp"

namespace isolaw::campaign {
namespace {

struct LawOnLot {  // a law and the devices that have an analysis of it: the input for its fit to the lot
  std::string_view law;
  int refinement = 1;
  std::vector<std::size_t> devices = {};
  std::vector<fit::LawOnRecord> models = {};
  std::vector<std::vector<double>> optima = {};
  fit::SearchBox box = {};

  std::vector<fit::LawOnRecord const*> pointers() const {
    std::vector<fit::LawOnRecord const*> addresses;
    for (auto const& model : models) addresses.push_back(&model);
    return addresses;
  }
};

int evaluations_of(LotAnalysis const& result) {
  return result.mean.evaluations + result.worst.law.evaluations;
}
int evaluations_of(LeftOutAnalysis const& result) {
  return result.left_out.evaluations;
}

class Analysis {
 public:
  Analysis(Contents& contents, Store& store, AnalyseOptions const& options)
      : contents_(contents), store_(store), options_(options), total_(contents.expected_analyses()) {}

  std::size_t run() {
    take_earlier_analyses();
    examine_devices();
    if (interrupted() || (options_.share && !every_device_examined(contents_))) return threads_;
    Meter own(options_.profile);
    auto const lots = laws_on_lot();
    own.lap(Phase::lot);
    fit_lots(lots);
    if (interrupted()) return threads_;
    leave_each_out(lots);
    return threads_;
  }

 private:
  bool interrupted() const { return options_.interrupted && options_.interrupted(); }

  // An analysis starts from the best run of a device and law. If a campaign was continued with more runs, an earlier
  // analysis stays valid unless a new run is better. Keeps the valid analyses and drops the others.
  void take_earlier_analyses() {
    auto& earlier = contents_.held_over;
    auto const best_is_earlier = [&](std::size_t device, std::string const& law) {
      auto const* best = contents_.best_run(device, law);
      return best != nullptr && best->number <= earlier.runs;
    };
    auto const take = [&](auto& from, auto& to, auto const& is_valid) {
      for (auto& analysis : from) {
        if (!is_valid(analysis)) continue;
        store_.add(analysis);
        to.push_back(std::move(analysis));
      }
      from.clear();
    };
    auto const device_is_valid = [&](auto const& analysis) { return best_is_earlier(analysis.device, analysis.law); };
    // The law may now have a usable run on a device that had none. The fit to the lot must then include this device.
    auto const lot_is_valid = [&](LotAnalysis const& analysis) {
      std::vector<std::size_t> usable;
      for (auto const& search : contents_.searches)
        if (search.law == analysis.law && contents_.devices[search.device].counts() &&
            contents_.best_run(search.device, search.law) != nullptr)
          usable.push_back(search.device);
      return usable == analysis.devices &&
             std::ranges::all_of(usable, [&](std::size_t device) { return best_is_earlier(device, analysis.law); });
    };
    take(earlier.devices, contents_.device_analyses, device_is_valid);
    take(earlier.lots, contents_.lot_analyses, lot_is_valid);
    take(earlier.left_out, contents_.left_out,
         [&](LeftOutAnalysis const& analysis) { return lot_analysis_of(analysis.law) != nullptr; });
  }

  void examine_devices() {
    std::vector<Search const*> tasks;
    auto const shares = options_.share ? assign_analyses(contents_, options_.share->total) : std::vector<int>();
    auto const is_of_share = [&](Search const& search) {
      return shares.empty() ||
             shares[static_cast<std::size_t>(&search - contents_.searches.data())] == options_.share->number;
    };
    for (auto const& search : contents_.searches)
      if (is_of_share(search) && contents_.best_run(search.device, search.law) != nullptr &&
          contents_.analysis_of(search.device, search.law) == nullptr)
        tasks.push_back(&search);
    each(
        tasks.size(), contents_.device_analyses, {Phase::intervals, TaskKind::device},
        [&](std::size_t i) { return std::string_view(tasks[i]->law); },
        [&](std::size_t i, Meter& meter) { return examined(*tasks[i], meter); });
    std::ranges::sort(contents_.device_analyses, {}, by_device_and_law);
    mark({Phase::determination, Phase::intervals, Phase::larger_swings});
  }

  std::optional<DeviceAnalysis> examined(Search const& search, Meter& meter) const {  // nullopt if interrupted
    auto const& best = *contents_.best_run(search.device, search.law);
    auto const model = law_on_device(contents_, search.device, search.law, best.refinement);
    auto const box = examined_box(search);
    auto const stream = num::Stream(contents_.settings.seed)
                            .split(stable_hash(contents_.devices[search.device].name))
                            .split(stable_hash(search.law))
                            .split(stable_hash("analysis"));
    auto optimum = best.parameters;
    int evaluations = 0;
    if (contents_.settings.method == Method::genetic && box.free_count() > 0) {
      // The analysis must start at the least objective, which the paper's genetic algorithm may not have reached.
      fit::IdentificationProblem const problem(model, box);
      auto const found = opt::minimise_multistart(problem, stream, contents_.settings.multistart, options_.interrupted);
      if (found.outcome == Outcome::interrupted) return std::nullopt;
      evaluations = found.evaluations;
      if (found.usable() && found.best_value < best.objective) box.expand(found.best, optimum);
    }
    auto determination = analysis::determine(model, box, optimum, options_.interrupted);
    if (!determination) return std::nullopt;
    determination->evaluations += evaluations;
    meter.lap(Phase::determination);
    auto intervals = analysis::intervals(model, box, determination->optimum, stream.split(1),
                                         {.replicates = contents_.settings.replicates}, options_.interrupted);
    if (!intervals) return std::nullopt;
    meter.count_evaluations(Phase::determination, determination->evaluations);
    meter.count_evaluations(Phase::intervals, intervals->evaluations);
    meter.lap(Phase::intervals);
    std::optional<analysis::LargerSwings> larger_swings;
    if (auto const models = law_on_swings(contents_, search.device, search.law, best.refinement)) {
      larger_swings = analysis::predict_larger_swings(*models, box, stream.split(2), options_.interrupted);
      if (interrupted()) return std::nullopt;
      if (larger_swings) meter.count_evaluations(Phase::larger_swings, larger_swings->evaluations);
    }
    meter.lap(Phase::larger_swings);
    auto springs = as_springs(search.law, std::array{search.device}, box, determination->optimum, best.refinement);
    return DeviceAnalysis{.device = search.device,
                          .law = search.law,
                          .refinement = best.refinement,
                          .determination = std::move(*determination),
                          .intervals = std::move(*intervals),
                          .springs = std::move(springs),
                          .larger_swings = std::move(larger_swings)};
  }

  // Fits the law as a set of springs around a circle (fit/as_springs.hpp) to the records of these devices. Returns
  // nullopt if the settings do not ask for it, or if the law with these parameters has a coupled two-dimensional form.
  std::optional<fit::SpringsFit> as_springs(std::string_view law, std::span<std::size_t const> devices,
                                            fit::SearchBox const& box, std::vector<double> const& parameters,
                                            int refinement) const {
    if (!contents_.settings.springs || !laws::no_coupled_form(law, parameters)) return {};
    std::vector<data::FitRecord const*> records;
    for (auto const device : devices) records.push_back(&contents_.devices[device].record);
    return fit::fitted_as_springs(laws::find_law(law), records, box, parameters, refinement);
  }

  std::vector<LawOnLot> laws_on_lot() const {
    std::vector<LawOnLot> lots;
    auto const& laws = contents_.settings.laws;
    auto const shares = options_.share ? assign_laws(contents_, options_.share->total) : std::vector<int>();
    for (std::size_t i = 0; i < laws.size(); ++i) {
      if (options_.share && shares[i] != options_.share->number) continue;
      auto const& law = laws[i];
      LawOnLot lot{.law = law};
      for (auto const& search : contents_.searches) {
        if (search.law != law || !contents_.devices[search.device].counts()) continue;
        auto const* on_device = contents_.analysis_of(search.device, law);
        if (on_device == nullptr) continue;
        lot.devices.push_back(search.device);
        lot.optima.push_back(on_device->determination.optimum);
        lot.refinement = std::max(lot.refinement, on_device->refinement);
      }
      if (lot.devices.size() < 2) continue;
      for (auto const device : lot.devices) lot.models.push_back(law_on_device(contents_, device, law, lot.refinement));
      lot.box = box_of_lot(contents_, law);
      lots.push_back(std::move(lot));
    }
    return lots;
  }

  void fit_lots(std::vector<LawOnLot> const& lots) {
    std::vector<LawOnLot const*> tasks;
    for (auto const& lot : lots)
      if (lot_analysis_of(lot.law) == nullptr) tasks.push_back(&lot);
    auto const law_of = [&](std::size_t i) { return tasks[i]->law; };
    each(tasks.size(), contents_.lot_analyses, {Phase::lot, TaskKind::lot}, law_of, [&](std::size_t i, Meter& meter) {
      auto result = fitted(*tasks[i]);
      if (result) meter.count_evaluations(Phase::lot, evaluations_of(*result));
      return result;
    });
    std::ranges::sort(contents_.lot_analyses, {}, &LotAnalysis::law);
    mark({Phase::lot});
  }

  // Returns nullopt if interrupted, and a result without parameters if the law has no finite forces at any start.
  std::optional<LotAnalysis> fitted(LawOnLot const& lot) const {
    LotAnalysis result{.law = std::string(lot.law), .refinement = lot.refinement, .devices = lot.devices};
    auto const models = lot.pointers();
    auto mean = analysis::least_mean(models, lot.box, lot.optima, options_.interrupted);
    if (interrupted()) return std::nullopt;
    if (!mean) return result;
    result.mean = std::move(*mean);
    auto worst = analysis::least_worst(models, lot.box, result.mean, options_.interrupted);
    if (!worst) return std::nullopt;
    result.worst = std::move(*worst);
    result.springs = as_springs(lot.law, lot.devices, lot.box, result.mean.parameters, lot.refinement);
    return result;
  }

  void leave_each_out(std::vector<LawOnLot> const& lots) {
    std::vector<std::pair<LawOnLot const*, std::size_t>> tasks;
    for (auto const& lot : lots)
      for (std::size_t i = 0; i < lot.devices.size(); ++i) {
        bool const done = std::ranges::any_of(contents_.left_out, [&](auto const& other) {
          return other.device == lot.devices[i] && other.law == lot.law;
        });
        if (!done) tasks.emplace_back(&lot, i);
      }
    auto const law_of = [&](std::size_t i) { return tasks[i].first->law; };
    each(tasks.size(), contents_.left_out, {Phase::left_out, TaskKind::left_out}, law_of,
         [&](std::size_t i, Meter& meter) {
           auto const& [lot, place] = tasks[i];
           LeftOutAnalysis result{.device = lot->devices[place], .law = std::string(lot->law)};
           result.left_out.objective = std::nan("");
           auto const* on_lot = lot_analysis_of(lot->law);
           auto left_out =
               on_lot == nullptr || on_lot->mean.parameters.empty()
                   ? std::nullopt
                   : analysis::leave_out(lot->pointers(), lot->box, on_lot->mean.parameters, lot->optima, place);
           if (left_out) result.left_out = std::move(*left_out);
           meter.count_evaluations(Phase::left_out, evaluations_of(result));
           return std::optional(std::move(result));
         });
    std::ranges::sort(contents_.left_out, {}, by_device_and_law);
    mark({Phase::left_out});
  }

  LotAnalysis const* lot_analysis_of(std::string_view law) const {
    auto const found = std::ranges::find(contents_.lot_analyses, law, &LotAnalysis::law);
    return found == contents_.lot_analyses.end() ? nullptr : &*found;
  }

  void mark(std::initializer_list<Phase> ended) {
    if (options_.profile != nullptr) options_.profile->mark(ended);
  }

  // Calls work(i, meter) for every i below `count` from several threads. Puts each result into the store and appends it
  // to `results`. work() must not read `results`, since other threads append to it meanwhile. Computing time that
  // work() does not assign to a phase by meter.lap() counts for `part.phase`.
  struct Part {
    Phase phase;
    TaskKind kind;
  };
  template <class Result, class LawOf, class Work>
  void each(std::size_t count, std::vector<Result>& results, Part part, LawOf&& law_of, Work&& work) {
    if (options_.estimate != nullptr) {
      options_.estimate->expect_none(part.kind);
      for (std::size_t i = 0; i < count; ++i) options_.estimate->expect(part.kind, law_of(i));
    }
    if (count == 0) return;
    results.reserve(results.size() + count);
    auto const worked = for_each_in_parallel(count, options_.threads, [&](std::size_t i) {
      if (interrupted()) return;
      Meter meter(options_.profile);
      auto result = work(i, meter);
      if (!result) return;
      {
        std::scoped_lock const lock(one_writer_);
        store_.add(*result);
        if (options_.estimate != nullptr) options_.estimate->done(part.kind, result->law);
        results.push_back(std::move(*result));
        AnalysisProgress now{
            .done = contents_.analyses(), .total = total_, .law = results.back().law, .device = std::nullopt};
        if constexpr (requires { results.back().device; }) now.device = results.back().device;
        if (options_.progress) options_.progress(now);
      }
      meter.lap(part.phase);
    });
    if (worked < std::min(options_.threads, count)) threads_ = std::min(threads_, worked);
  }

  Contents& contents_;
  Store& store_;
  AnalyseOptions const& options_;
  std::size_t total_;
  std::size_t threads_ = options_.threads;
  std::mutex one_writer_;
};

}  // namespace

fit::SearchBox examined_box(Search const& search) {
  return fit::on_logarithmic_scales(search.box, laws::find_law(search.law));
}

fit::SearchBox box_of_lot(Contents const& contents, std::string_view law) {
  std::vector<fit::SearchBox> boxes;
  for (auto const& search : contents.searches)
    if (search.law == law && contents.devices[search.device].counts() &&
        contents.analysis_of(search.device, law) != nullptr)
      boxes.push_back(examined_box(search));
  std::vector<fit::SearchBox const*> pointers;
  for (auto const& box : boxes) pointers.push_back(&box);
  return analysis::common_box(pointers);
}

fit::LawOnRecord law_on_device(Contents const& contents, std::size_t device, std::string_view law, int refinement) {
  auto const& settings = contents.settings;
  return fit::LawOnRecord(laws::find_law(law), contents.devices[device].record, settings.integration,
                          settings.turning_points, refinement);
}

std::optional<analysis::SwingModels> law_on_swings(Contents const& contents, std::size_t device, std::string_view law,
                                                   int refinement) {
  auto const& settings = contents.settings;
  auto const tests = data::tests_of(contents.devices[device].record);
  auto const sizes = data::swing_sizes(tests, settings.clean.weights.value_or(data::Weighting::swing));
  if (!sizes.shows_larger_swings) return std::nullopt;
  auto models = analysis::swing_models(laws::find_law(law), tests, sizes, settings.integration, settings.turning_points,
                                       refinement);
  return models.small.empty() || models.large.empty() ? std::nullopt : std::optional(std::move(models));
}

bool every_device_examined(Contents const& contents) {
  return std::ranges::all_of(contents.searches, [&](Search const& search) {
    return contents.best_run(search.device, search.law) == nullptr ||
           contents.analysis_of(search.device, search.law) != nullptr;
  });
}

std::size_t analyse(Contents& contents, Store& store, AnalyseOptions const& options) {
  return Analysis(contents, store, options).run();
}

}  // namespace isolaw::campaign
