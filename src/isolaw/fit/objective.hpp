// A law on one device's record: computed forces and the objective of Eq. (27).
#pragma once

#include <span>
#include <vector>

#include "isolaw/data/record.hpp"
#include "isolaw/fit/box.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::fit {

// A finer path that tells how far a result still moves when integrated more finely.
inline constexpr int shift_refinement = 20;

class LawOnRecord {
 public:
  // Throws Error when the law needs velocities and the record has no time. The record may be discarded afterwards.
  LawOnRecord(laws::LawEntry const& law, data::FitRecord const& record, laws::Integration integration);

  laws::LawEntry const& law() const { return *law_; }

  // OF = mean over time of |measured - computed| / standard deviation of the measured force; +infinity when a computed
  // force is not finite. `parameters` in the law's order and units. Thread-safe; `work` is scratch, resized as needed.
  double objective(std::span<double const> parameters, std::vector<double>& work) const;

  // Computed force [kN] at every sample.
  std::vector<double> force_kN(std::span<double const> parameters) const;

  // |objective - objective of the converged integration on a path `shift_refinement` times finer|.
  double integration_shift(std::span<double const> parameters) const;

 private:
  double misfit(std::vector<double> const& force) const;

  laws::LawEntry const* law_;
  laws::Integration integration_;
  std::vector<double> x_, v_;  // law's units
  laws::Path path_;
  std::vector<double> measured_;  // law's force unit
  std::vector<double> weight_;    // trapezoid in time / (duration * standard deviation)
};

// The search of a law's free parameters on a record, in the unit box.
class IdentificationProblem final : public opt::Problem {
 public:
  IdentificationProblem(LawOnRecord const& model, SearchBox const& box) : model_(model), box_(box) {}
  std::size_t dimension() const override { return box_.free_count(); }
  void evaluate(opt::Points const& points, std::span<double> values) const override;

 private:
  LawOnRecord const& model_;
  SearchBox const& box_;
};

}  // namespace isolaw::fit
