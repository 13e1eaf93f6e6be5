// Measures the time and the error of the objective for several ways to integrate bouc-wen and abe-y0: Runge-Kutta with
// sub-steps, and the exact solution of the differential equation over each step (the exact flow). The reference is the
// exact flow on a path 100 times finer. The program prints three errors. The first two are the median and the largest
// error over candidates from the published box. The third is the largest error at the best points of several genetic
// searches that use the integration under test. It can be larger than the others, because a search prefers points where
// the error lowers the objective.
// Usage: integration_cost RECORD [REPETITIONS]
// Prints CSV. ISOLAW_SIMD chooses the instruction set.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "candidates.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/data/clean.hpp"
#include "isolaw/data/read.hpp"
#include "isolaw/fit/kernels.hpp"
#include "isolaw/num/statistics.hpp"
#include "isolaw/opt/genetic.hpp"

namespace {

using namespace isolaw;

constexpr std::size_t drawn = 8 * fit::wide_block;
constexpr int finer = 100, searches = 3;

struct Route {
  char const* name;
  laws::Integration integration;
  int refinement;
};
constexpr std::array routes{
    Route{"rk4", laws::Integration::paper, 1},          Route{"rk4 x4", laws::Integration::paper, 4},
    Route{"rk4 x8", laws::Integration::paper, 8},       Route{"rk4 x32", laws::Integration::paper, 32},
    Route{"rk4 x100", laws::Integration::paper, finer}, Route{"exact flow", laws::Integration::converged, 1}};

// Computes the objectives of a law on a record, with any number of sub-steps per sample.
class Subject {
 public:
  Subject(laws::LawEntry const& law, data::FitRecord const& record)
      : law_(law),
        kernel_(fit::kernel(fit::instruction_set(), law.index)),
        disp_(bench::divided(record.disp_mm, law.info.length.in_record_units)),
        measured_(bench::divided(record.force_kN, law.info.force.in_record_units)),
        weight_(record.size(), 1.0 / (static_cast<double>(record.size()) * num::population_std(measured_))) {}

  laws::Path path(int refinement) const { return laws::make_path(disp_, {}, refinement); }
  std::size_t samples() const { return disp_.size(); }

  // Takes candidates in the order of bench::candidates(): first all parameters of the first candidate, then all of the
  // second.
  std::vector<double> objectives(laws::Path const& path, laws::Integration integration,
                                 std::vector<double> const& candidates) const {
    std::size_t const parameters = law_.parameters.size(), width = fit::wide_block;
    std::size_t const count = candidates.size() / parameters;
    auto padded = candidates;
    for (std::size_t i = count; i % width != 0; ++i)
      padded.insert(padded.end(), candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(parameters));
    std::vector<double> values(padded.size() / parameters);
    for (std::size_t first = 0; first < values.size(); first += width)
      kernel_.wide(bench::block(padded, parameters, first, width).data(), {path, measured_, weight_}, integration,
                   values.data() + first);
    values.resize(count);
    return values;
  }

 private:
  laws::LawEntry const& law_;
  fit::Kernel kernel_;
  std::vector<double> disp_, measured_, weight_;
};

class Search final : public opt::Problem {
 public:
  Search(Subject const& subject, fit::SearchBox const& box, Route const& route)
      : subject_(subject), box_(box), path_(subject.path(route.refinement)), integration_(route.integration) {}
  std::size_t dimension() const override { return box_.free_count(); }
  void evaluate(opt::Points const& points, std::span<double> values) const override {
    std::size_t const parameters = box_.parameters.size();
    std::vector<double> candidates(points.size() * parameters);
    for (std::size_t i = 0; i < points.size(); ++i)
      box_.expand(points[i], std::span(candidates).subspan(i * parameters, parameters));
    std::ranges::copy(subject_.objectives(path_, integration_, candidates), values.begin());
  }

 private:
  Subject const& subject_;
  fit::SearchBox const& box_;
  laws::Path path_;
  laws::Integration integration_;
};

std::vector<double> errors(Subject const& subject, Route const& route, std::vector<double> const& candidates) {
  auto values = subject.objectives(subject.path(route.refinement), route.integration, candidates);
  auto const reference = subject.objectives(subject.path(finer), laws::Integration::converged, candidates);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = std::isfinite(values[i]) ? std::abs(values[i] - reference[i]) : std::numeric_limits<double>::infinity();
  std::ranges::sort(values);
  return values;
}

// Returns the shortest time of all repetitions, because other work on the machine can only lengthen a time.
double ns_per_sample(Subject const& subject, Route const& route, std::vector<double> const& candidates,
                     int repetitions) {
  using Clock = std::chrono::steady_clock;
  auto const path = subject.path(route.refinement);
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repetitions; ++i) {
    auto const start = Clock::now();
    (void)subject.objectives(path, route.integration, candidates);
    best = std::min(best, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return 1e9 * best / static_cast<double>(subject.samples() * drawn);
}

double error_at_optimum(Subject const& subject, fit::SearchBox const& box, Route const& route) {
  double largest = 0.0;
  for (std::uint64_t seed = 1; seed <= searches; ++seed) {
    auto const found = opt::minimise_genetic(Search(subject, box, route), num::Stream(seed));
    if (!found.usable()) continue;
    std::vector<double> candidate(box.parameters.size());
    box.expand(found.best, candidate);
    largest = std::max(largest, errors(subject, route, candidate).front());
  }
  return largest;
}

void measure(std::string const& file, int repetitions) {
  if (fit::instruction_set() == fit::InstructionSet::scalar)
    throw Error({.where = "ISOLAW_SIMD", .found = "scalar", .allowed = "an instruction set with blocks"});
  auto const raw = data::read_record(file, {});
  std::puts("law,route,samples_per_cycle,isa,ns_per_sample,error_median,error_largest,error_at_optimum");
  for (auto const* id : {"bouc-wen", "abe-y0"})
    for (int const samples_per_cycle : {200, 100}) {
      auto const record = data::clean(raw, {.smooth = 5, .samples_per_cycle = samples_per_cycle, .center = false});
      auto const& law = laws::find_law(id);
      Subject const subject(law, record);
      auto const box = fit::make_box(law, fit::BoxKind::published, fit::scales_of(record, law.info), {});
      auto const candidates = bench::candidates(box, drawn);
      for (auto const& route : routes) {
        auto const sorted = errors(subject, route, candidates);
        std::printf("%s,%s,%d,%s,%.2f,%.1e,%.1e,%.1e\n", id, route.name, samples_per_cycle,
                    std::string(fit::name(fit::instruction_set())).c_str(),
                    ns_per_sample(subject, route, candidates, repetitions), sorted[sorted.size() / 2], sorted.back(),
                    error_at_optimum(subject, box, route));
        std::fflush(stdout);
      }
    }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 2 || argc > 3) throw Error({.where = "integration_cost", .found = "expects RECORD [REPETITIONS]"});
    measure(argv[1], argc == 3 ? std::max(1, std::atoi(argv[2])) : 20);
  } catch (std::exception const& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
