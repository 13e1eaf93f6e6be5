// Evaluates every law many times in one build and compares the results with another build's, which shows how much
// compilers, optimisation levels and processors change a result (tools/compilers.sh).
//   sweep write FILE     evaluates and writes record, candidates, forces and objectives
//   sweep compare FILE   evaluates the same candidates on the same record and prints a line per law; the exit code is 1
//                        if a relative difference exceeds fit::evaluation_tolerance, or if only one of the two builds
//                        finds the objective of a candidate finite
// ISOLAW_DRAWS is the number of candidates of each box and must be the same for both builds.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "isolaw/fit/objective.hpp"
#include "isolaw/num/random.hpp"
#include "laws/motion.hpp"
#include "laws/records.hpp"

namespace {

using namespace isolaw;
using Values = std::vector<double>;

constexpr double absurd = 1e6;  // no comparison of batches above this objective: such forces multiply rounding errors

constexpr std::array boxes{fit::BoxKind::published, fit::BoxKind::scaled};
constexpr std::array integrations{laws::Integration::converged, laws::Integration::paper};

// Stores doubles in a file in a fixed order, so that both builds compute with the same bits.
class File {
 public:
  File(char const* path, bool writing) : writing_(writing), file_(std::fopen(path, writing ? "wb" : "rb")) {
    if (!file_) throw std::runtime_error(fmt::format("cannot open {}", path));
  }
  // When writing, appends `values` to the file. When comparing, replaces `values` by those that the file has at this
  // place.
  void pass(Values& values) {
    auto const done = writing_ ? std::fwrite(values.data(), sizeof(double), values.size(), file_.get())
                               : std::fread(values.data(), sizeof(double), values.size(), file_.get());
    if (done != values.size()) throw std::runtime_error("the file has another length than expected");
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  bool writing_;
  std::unique_ptr<std::FILE, Close> file_;
};

struct Difference {
  double objective = 0.0;  // largest relative difference of the objective
  double force = 0.0;      // largest difference of the force, as a share of the peak force
  int compared = 0, flagged = 0;
  int flagged_once = 0;  // candidates without a finite objective in only one of the two builds
  // The largest relative difference between objectives that this build computes in batches and one by one.
  double lanes = 0.0;

  void add(double here, double there, Values const& force_here, Values const& force_there) {
    ++compared;
    if (!std::isfinite(here) || !std::isfinite(there)) {
      ++flagged;
      flagged_once += std::isfinite(here) != std::isfinite(there) ? 1 : 0;
      return;
    }
    objective = std::max(objective, std::abs(here - there) / there);
    force = std::max(
        force, law_tests::largest_difference(force_here, force_there) / law_tests::largest_magnitude(force_there));
  }
  bool within(double bound) const {
    return objective <= bound && force <= bound && lanes <= bound && flagged_once == 0;
  }
};

// Returns cycles with reversals at many samples, small loops within large ones and uneven peaks, at 100 samples a
// cycle.
data::FitRecord record(File& file) {
  auto cycles = law_tests::record_of(law_tests::irregular(1, 208.0, 3, 100), 0.02, 0.67, 45.0);
  for (auto* channel : {&cycles.time_s, &cycles.disp_mm, &cycles.vel_mm_s, &cycles.force_kN}) file.pass(*channel);
  return cycles;
}

Difference sweep(laws::LawEntry const& law, laws::Integration integration, data::FitRecord const& record, File& file) {
  Difference difference;
  fit::LawOnRecord const model(law, record, integration);
  Values work;
  std::vector<Values> candidates;
  Values objectives;
  for (auto const kind : boxes) {
    auto const box = fit::make_box(law, kind, fit::scales_of(record, law.info), {});
    for (std::uint32_t index = 0; index < law_tests::draws(250); ++index) {
      auto parameters = law_tests::candidate_in(box, index);
      file.pass(parameters);
      Values const here{model.objective(parameters, work)};
      auto const force_here = model.force_kN(parameters);
      auto there = here, force_there = force_here;
      file.pass(there);
      file.pass(force_there);
      difference.add(here[0], there[0], force_here, force_there);
      candidates.push_back(parameters);
      objectives.push_back(here[0]);
    }
  }
  // With the paper's integration, one step may amplify rounding errors, so this program does not compare batches with
  // the evaluation one by one. unit_fit compares them for candidates whose steps do not amplify errors.
  if (integration == laws::Integration::paper) return difference;
  for (auto const set : num::available_instruction_sets()) {
    Values lanes(candidates.size());
    model.objectives(
        candidates.size(), [&](std::size_t i, std::span<double> out) { std::ranges::copy(candidates[i], out.begin()); },
        lanes, set);
    for (std::size_t i = 0; i < lanes.size(); ++i)
      if (std::isfinite(objectives[i]) && objectives[i] < absurd)
        difference.lanes = std::max(difference.lanes, std::abs(lanes[i] - objectives[i]) / objectives[i]);
  }
  return difference;
}

int run(bool writing, char const* path) {
  File file(path, writing);
  auto const common = record(file);
  bool within = true;
  if (!writing)
    fmt::print("  {:21} {:>10} {:>8} {:>8}  {:>10} {:>8}  {:>7}  {}\n  {:21} {:>29} {:>19}\n", "law", "objective",
               "force", "lanes", "objective", "force", "flagged", "by one build only", "", "converged", "paper");
  for (auto const& law : laws::catalogue()) {
    std::array<Difference, integrations.size()> found;
    for (std::size_t i = 0; i < found.size(); ++i) found[i] = sweep(law, integrations[i], common, file);
    if (writing) continue;
    auto const& [converged, paper] = found;
    bool const holds = converged.within(fit::evaluation_tolerance) && paper.within(fit::evaluation_tolerance);
    within = within && holds;
    fmt::print("  {:21} {:10.1e} {:8.1e} {:8.1e}  {:10.1e} {:8.1e}  {:7}  {} of {}{}\n", law.info.id,
               converged.objective, converged.force, converged.lanes, paper.objective, paper.force,
               converged.flagged + paper.flagged, converged.flagged_once + paper.flagged_once,
               converged.compared + paper.compared, holds ? "" : "  BEYOND THE BOUND");
  }
  if (!writing) fmt::print("  bound {:.0e}: {}\n", fit::evaluation_tolerance, within ? "holds" : "BROKEN");
  return within ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  std::string_view const command = count == 3 ? arguments[1] : "";
  if (command != "write" && command != "compare") {
    std::fputs("usage: sweep write|compare FILE\n", stderr);
    return 2;
  }
  try {
    return run(command == "write", arguments[2]);
  } catch (std::exception const& error) {
    std::fprintf(stderr, "sweep: %s\n", error.what());
    return 2;
  }
}
