// Measures the time that `isolaw building` needs for one draw, which is a building whose bearings have randomly drawn
// parameters. The building has five floors on 28 bearings of the law bouc-wen. It is shaken in two directions for 20 s
// with steps of 0.005 s. The program first times all draws in SIMD lanes with explicit integration, then a few draws in
// scalar code, then one draw with implicit integration. bench/building writes the output to bench/results.
//   building_bench [DRAWS] [MOTIONS] [THREADS] [N] [--json]      defaults: 1000, 11, 2, 1.2; N: parameter n of bouc-wen
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "isolaw/base/processor_time.hpp"
#include "isolaw/building/lanes.hpp"
#include "isolaw/building/synthetic_motion.hpp"
#include "isolaw/campaign/parallel.hpp"
#include "isolaw/num/random.hpp"

int main(int count, char** arguments) {
  bool const json = count > 1 && std::string_view(arguments[count - 1]) == "--json";
  count -= json;
  using namespace isolaw;
  using namespace isolaw::building;
  auto const argument = [&](int i, std::size_t otherwise) {
    return count > i ? static_cast<std::size_t>(std::strtoul(arguments[i], nullptr, 10)) : otherwise;
  };
  std::size_t const draws = argument(1, 1000), motions = argument(2, 11), threads = argument(3, 2);
  double const exponent = count > 4 ? std::strtod(arguments[4], nullptr) : 1.2;
  Diaphragm const slab{.mass_Mg = 700.0, .gyration_mm = 9000.0};
  Plan plan;
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 4; ++j) plan.bearings.push_back({6000.0 * i - 18000.0, 6000.0 * j - 9000.0});
  Model const model(Structure({.base = slab, .floors = equal_floors(5, slab, 0.5, 0.5), .damping = {0.02}}), plan);
  std::vector<Motion> ground;
  for (std::size_t i = 0; i < motions; ++i) ground.push_back(synthetic_motion(1, static_cast<std::uint32_t>(i)));
  double const after = 0.15 * 6.3, strength = 0.06 * 0.15 * 9806.65, Ke = after + strength / 15.0;
  std::vector<double> values;
  for (std::size_t draw = 0; draw < draws; ++draw)
    for (std::size_t j = 0; j < plan.bearings.size(); ++j) {
      num::Draws numbers(num::Stream(2), static_cast<std::uint32_t>(draw), static_cast<std::uint32_t>(j));
      double const both = std::pow(15.0, -exponent);
      for (double const v : {after / Ke, Ke * (1.0 + 0.07 * numbers.normal()), 1.0, 0.6 * both, exponent, 0.4 * both})
        values.push_back(v);
    }
  auto const seconds = [](auto&& work) {
    auto const start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  // Returns the processor time that this thread takes for `work`. Other programs on the machine do not lengthen it.
  auto const own_seconds = [](auto&& work) {
    double const start = thread_time_s();
    work();
    return thread_time_s() - start;
  };
  std::size_t const each = plan.bearings.size() * 6, block = 8 * lane_width, blocks = (draws + block - 1) / block;
  double const cpu_before = process_time_s();
  double const lanes = seconds([&] {
    campaign::for_each_in_parallel(blocks * motions, threads, [&](std::size_t task) {
      std::size_t const first = task % blocks * block, last = std::min(draws, first + block);
      auto const part = std::span(values).subspan(first * each, (last - first) * each);
      respond(model, "bouc-wen", part, ground[task / blocks], {});
    });
  });
  double const lanes_cpu = process_time_s() - cpu_before;
  // With the instruction set `scalar` isolaw computes the draws one after another, each in about the same time, so a
  // few draws suffice for a timing.
  std::size_t const scalar_draws = std::min<std::size_t>(draws, 8);
  double const scalar = own_seconds([&] {
                          respond(model, "bouc-wen", std::span(values).first(scalar_draws * each), ground[0], {},
                                  Coupling::coupled, num::InstructionSet::scalar);
                        }) /
                        static_cast<double>(scalar_draws);
  auto const one = std::span(values).first(each);
  std::vector<std::unique_ptr<Bearing>> bearings;
  for (std::size_t j = 0; j < plan.bearings.size(); ++j)
    bearings.push_back(make_bearing("bouc-wen", one.subspan(6 * j, 6), Coupling::coupled));
  double const implicit = own_seconds([&] { integrate(model, bearings, ground[0]); });
  auto const set = num::name(num::instruction_set());
  if (json) {
    fmt::print(
        "{{\"instruction_set\": \"{}\", \"lanes_wall_s\": {}, \"lanes_cpu_s\": {}, \"scalar_draws\": {}, \"scalar_s\": {}, \"implicit_s\": {}}}\n",
        set, lanes, lanes_cpu, scalar_draws, scalar, implicit);
    return 0;
  }
  double const each_cpu = lanes_cpu / static_cast<double>(draws * motions);
  fmt::print("{} draws x {} motions, {} threads, {}: {:.2f} s, {:.2f} ms of one thread a draw and motion\n", draws,
             motions, threads, set, lanes, 1e3 * each_cpu);
  fmt::print("one draw and motion: explicit scalar {:.2f} ms ({:.1f} times that), implicit {:.2f} ms\n", 1e3 * scalar,
             scalar / each_cpu, 1e3 * implicit);
}
