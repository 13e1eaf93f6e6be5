// Lets the searches of other programs minimise isolaw's objective, for bench/optimum. Every search evaluates its points
// with isolaw's own vector kernels.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "isolaw/num/random.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::bench {

// Wraps a problem, counts its evaluations and remembers the best point. A search is judged by the best point that it
// ever evaluated, even if it returns another one.
class Watched final : public opt::DeviationProblem {
 public:
  explicit Watched(opt::DeviationProblem const& problem) : problem_(problem) {}
  std::size_t dimension() const override { return problem_.dimension(); }
  std::span<double const> weights() const override { return problem_.weights(); }
  void evaluate(opt::Points const& points, std::span<double> values) const override;
  void residuals(opt::Points const& points, std::span<double> values) const override;

  std::vector<double> const& best() const { return best_; }  // empty if no value was finite
  double best_value() const { return best_value_; }
  int evaluations() const { return evaluations_; }

 private:
  void see(std::span<double const> point, double value) const;

  opt::DeviationProblem const& problem_;
  mutable std::vector<double> best_;
  mutable double best_value_ = std::numeric_limits<double>::infinity();
  mutable int evaluations_ = 0;
};

struct Peer {
  std::string name;
  // Stops after about `budget` evaluations.
  std::function<void(Watched const& problem, std::uint64_t seed, int budget)> search;
};

// Returns the searches of those programs that are installed, and names the missing programs on standard error. `script`
// is the path of bench/peers/optimum.py.
std::vector<Peer> peers(std::string const& script);

// Defined in peer_ceres.cpp, which is compiled only if Ceres is installed.
void search_by_ceres(Watched const& problem, std::uint64_t seed, int budget);

}  // namespace isolaw::bench
