// Runs pagmo's simple genetic algorithm on isolaw's scalar objective: one search on one record, by default with 5,000
// evaluations.
// Usage: peer_pagmo RECORD LAW paper|converged [EVALUATIONS]; prints one JSON object.
#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/sga.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/data/clean.hpp"
#include "isolaw/data/read.hpp"
#include "isolaw/fit/objective.hpp"

namespace {

using namespace isolaw;
constexpr unsigned population = 100;

struct Identification {
  fit::LawOnRecord const* model = nullptr;
  fit::SearchBox const* box = nullptr;

  std::vector<double> fitness(std::vector<double> const& point) const {
    thread_local std::vector<double> parameters, work;
    parameters.resize(box->parameters.size());
    box->expand(point, parameters);
    return {model->objective(parameters, work)};
  }
  std::pair<std::vector<double>, std::vector<double>> get_bounds() const {
    return {std::vector<double>(box->free_count(), 0.0), std::vector<double>(box->free_count(), 1.0)};
  }
};

void search(std::string const& file, std::string const& id, std::string const& integration, unsigned evaluations) {
  if (integration != "paper" && integration != "converged")
    throw std::invalid_argument("integration: paper, converged");
  auto const record =
      data::clean(data::read_record(file, {}), {.smooth = 1, .samples_per_cycle = std::nullopt, .center = false});
  auto const& law = laws::find_law(id);
  auto const box = fit::make_box(law, fit::BoxKind::published, fit::scales_of(record, law.info), {});
  fit::LawOnRecord const model(law, record,
                               integration == "paper" ? laws::Integration::paper : laws::Integration::converged);
  Identification const identification{&model, &box};
  double const middle = identification.fitness(std::vector<double>(box.free_count(), 0.5)).front();
  pagmo::problem const problem(identification);

  auto const start = std::chrono::steady_clock::now();
  auto const start_cpu = std::clock();
  pagmo::population const initial(problem, population, 1u);
  pagmo::algorithm const algorithm(pagmo::sga(evaluations / population - 1));
  auto const last = algorithm.evolve(initial);
  double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  double const cpu = static_cast<double>(std::clock() - start_cpu) / CLOCKS_PER_SEC;
  std::printf(
      "{\"seconds\": %.6f, \"cpu\": %.6f, \"evaluations\": %llu, \"samples\": %zu, \"best\": %.17g, \"objective\": %.17g}\n",
      seconds, cpu, last.get_problem().get_fevals(), record.size(), last.champion_f().front(), middle);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 4 || argc > 5) throw std::invalid_argument("peer_pagmo RECORD LAW paper|converged [EVALUATIONS]");
    search(argv[1], argv[2], argv[3], argc == 5 ? static_cast<unsigned>(std::stoul(argv[4])) : 5000u);
  } catch (std::exception const& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
