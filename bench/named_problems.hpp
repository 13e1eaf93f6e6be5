// Makes a problem with a name and a key for each law on each device of a lot, and reads and writes the file that holds
// the smallest known objective of each problem.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "best_known.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/campaign/lot_file.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/fit/objective.hpp"

namespace isolaw::bench {

// A run succeeds if its objective is larger than the best known one by at most this share.
inline constexpr double success_tolerance = 1e-3;

struct NamedProblem {
  std::string device;
  fit::SearchBox box;
  fit::LawOnRecord model;
  fit::IdentificationProblem problem{model, box};
  BestKnown entry;  // found() adds objective, parameters and found_by
  num::Stream stream;

  NamedProblem(campaign::Contents const& contents, campaign::Search const& search, std::string const& name)
      : device(contents.devices[search.device].name),
        box(search.box),
        model(laws::find_law(search.law), contents.devices[search.device].record, contents.settings.integration,
              contents.settings.turning_points) {
    auto const& settings = contents.settings;
    auto const& record = contents.devices[search.device].record;
    stream = num::Stream(settings.seed).split(stable_hash(device)).split(stable_hash(search.law));
    entry.record = fmt::format("{}, {}", name, device);
    auto const word = [&](char const* key) { return text_of(campaign::find_setting(key)->get(settings)); };
    entry.settings = fmt::format("box {}, integration {}", word("box"), word("integration"));
    if (settings.turning_points != laws::TurningPoints::as_sampled)
      entry.settings += fmt::format(", turning points {}", word("turning-points"));
    if (!record.weights.empty()) entry.settings += fmt::format(", weights {}", word("weights"));
    entry.law = search.law;
    entry.key = problem_key(model.law(), settings.integration, settings.turning_points, record, box);
  }
  NamedProblem(NamedProblem const&) = delete;
  NamedProblem& operator=(NamedProblem const&) = delete;

  // Makes the entry of best_known.toml for a point of the unit box: each coordinate runs from 0 to 1 over the interval
  // of a free parameter. Scalar code computes the objective, as it does for reports.
  BestKnown found(std::span<double const> point, std::string const& found_by) const {
    auto result = entry;
    std::vector<double> work;
    result.parameters.resize(box.parameters.size());
    box.expand(point, result.parameters);
    result.objective = model.objective(result.parameters, work);
    result.found_by = found_by;
    return result;
  }
};

struct Choice {
  std::vector<std::string> laws, devices;  // if a list is empty, all laws or devices of the lot file are taken
};

// Prepares all chosen problems of a lot. The records may lie outside the lot file's folder.
struct NamedProblems {
  campaign::Contents contents;
  std::vector<std::unique_ptr<NamedProblem>> all;

  NamedProblems(std::filesystem::path const& lot_file, std::string const& name, Choice const& choice) {
    auto lot = campaign::read_lot_file(lot_file, {.allow_outside = true});
    lot.settings.method = campaign::Method::best;
    if (!choice.laws.empty()) lot.settings.laws = choice.laws;
    contents = campaign::prepare(lot);
    for (auto const& search : contents.searches) {
      auto const& device = contents.devices[search.device].name;
      bool const chosen = choice.devices.empty() || std::ranges::find(choice.devices, device) != choice.devices.end();
      if (search.refusal.empty() && chosen) all.push_back(std::make_unique<NamedProblem>(contents, search, name));
    }
  }
};

// Holds the smallest known objectives from a file, which write() brings up to date. Without a file name the objectives
// come from the project's own best_known.toml, and write() does nothing.
class BestFile {
 public:
  explicit BestFile(std::string file) : file_(std::move(file)) {
    auto const source = file_.empty() ? std::string(ISOLAW_BEST_KNOWN) : file_;
    if (std::filesystem::exists(source)) entries_ = load_best_known(source);
  }

  double objective(std::string const& key) const {
    auto const found = std::ranges::find(entries_, key, &BestKnown::key);
    return found == entries_.end() ? std::numeric_limits<double>::infinity() : found->objective;
  }
  Change lower(BestKnown const& found) { return bench::lower(entries_, found); }
  void write() const {
    if (file_.empty()) return;
    auto const unfinished = file_ + ".new";
    std::ofstream out(unfinished, std::ios::binary);
    out << best_known_text(entries_);
    out.close();
    if (!out) throw Error({.where = unfinished, .found = "cannot be written"});
    std::filesystem::rename(unfinished, file_);
  }

 private:
  std::string file_;
  std::vector<BestKnown> entries_;
};

}  // namespace isolaw::bench
