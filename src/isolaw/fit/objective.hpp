// A law on one device's record: its forces, its residuals, and the objective of Eq. (27) of Cucuzza et al. 2025.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "isolaw/data/record.hpp"
#include "isolaw/fit/box.hpp"
#include "isolaw/fit/kernels.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::fit {

inline constexpr int shift_refinement = 20;  // integration_shift() compares with a path this many times finer
// The relative difference that another machine's objective may have for the same record and parameters, and its forces
// relative to the peak force. Compilers and processors round differently and bring their own elementary functions. The
// largest differences that `./isolaw.sh compilers` has shown are 6e-14 and 1.2e-12 (bouc-wen in x87 arithmetic; 9e-14
// without it). The rest is room for mathematical libraries and processors that were not at hand.
inline constexpr double evaluation_tolerance = 1e-9;
// The relative difference between a block's objective and the scalar one. Blocks use their own elementary functions and
// fused multiply-adds; the largest difference seen is 1e-12 (hwang-wu), 3e-14 for the other laws. It may be larger for
// an objective beyond 1e6, or if a Runge-Kutta step of `paper` is too long to be stable.
inline constexpr double block_tolerance = 1e-11;

class LawOnMotion {  // a law on a displacement history, whose force may be unknown
 public:
  // Every interval between samples is cut into `refinement` equal steps. A law that remembers its path follows the
  // displacement with the record's dead band. The history may be discarded afterwards. Throws Error for a history
  // without samples, or without time if the law needs velocities.
  LawOnMotion(laws::LawEntry const& law, data::FitRecord const& motion, laws::Integration integration,
              laws::TurningPoints turning_points = laws::TurningPoints::as_sampled, int refinement = 1);
  LawOnMotion refined(int refinement) const;  // with this many steps between samples

  laws::LawEntry const& law() const { return *law_; }
  laws::Integration integration() const { return integration_; }
  int refinement() const { return refinement_; }
  laws::Path const& path() const { return path_; }
  laws::Path path(int refinement) const;

  std::vector<std::size_t> outline() const;  // indices of samples: all next to a reversal, fewer farther from one
  // The same law on samples in rising order. If they include the reversals, a rate-independent law gives equal forces.
  LawOnMotion at(std::span<std::size_t const> samples) const;
  // Computed force [kN] at every sample; not finite if the law gives none. `parameters` are in the law's order and
  // units; `force` has as many elements as there are samples. Thread-safe.
  void force_kN(std::span<double const> parameters, std::span<double> force) const;
  std::vector<double> force_kN(std::span<double const> parameters) const;

 private:
  laws::LawEntry const* law_;
  laws::Integration integration_;
  laws::TurningPoints turning_points_;
  int refinement_ = 1;
  std::vector<double> time_s_, x_, v_;  // x_ and v_ in the law's unit of length
  laws::Path path_;
};

class LawOnRecord {
 public:
  // Every interval between samples is cut into `refinement` equal steps. The record may be discarded afterwards. Throws
  // Error if the law needs velocities and the record has no time, and if Eq. (27) is not defined for the record: fewer
  // than two samples, no duration, a constant force.
  LawOnRecord(laws::LawEntry const& law, data::FitRecord const& record, laws::Integration integration,
              laws::TurningPoints turning_points = laws::TurningPoints::as_sampled, int refinement = 1);
  LawOnRecord refined(int refinement) const;  // with this many steps between samples
  // The same law on the samples of the loop's outline only, each with the weight of the samples that it represents; its
  // objective is close to this one's. nullopt if more than 3/4 of the samples remain or samples are integration steps.
  std::optional<LawOnRecord> outline() const;
  std::vector<double> on_outline(std::span<double const> shares) const;  // spreads shares over the outline

  laws::LawEntry const& law() const { return motion_.law(); }
  int refinement() const { return motion_.refinement(); }

  // OF = mean over time of |measured - computed| / standard deviation of the measured force; +infinity if a computed
  // force is not finite. `parameters` are in the law's order and units; `work` is scratch space. Thread-safe.
  double objective(std::span<double const> parameters, std::vector<double>& work) const;
  // The same for `count` candidates, computed in blocks; candidate(i, values) writes the parameters of candidate i.
  // Agrees with the scalar objective within block_tolerance at every place in a block, for objectives above 1e-3.
  void objectives(std::size_t count, std::function<void(std::size_t, std::span<double>)> const& candidate,
                  std::span<double> values, InstructionSet set = instruction_set()) const;
  // (measured - computed force) / standard deviation of the measured force, for sample j and candidate i in
  // values[i * samples() + j]. Not finite if the force is not. Agrees with the scalar path as closely as objectives().
  void residuals(std::size_t count, std::function<void(std::size_t, std::span<double>)> const& candidate,
                 std::span<double> values, InstructionSet set = instruction_set()) const;
  // The same with the candidates side by side: sample j of candidate i is rows[j * stride + i]. `stride` is at least
  // num::padded(count); columns beyond the last candidate may hold any numbers.
  void residual_rows(std::size_t count, std::function<void(std::size_t, std::span<double>)> const& candidate,
                     std::size_t stride, std::span<double> rows, InstructionSet set = instruction_set()) const;

  std::span<double const> residual_weights() const { return share_; }  // objective = sum of weight * |residual|
  std::size_t samples() const { return measured_.size(); }
  double spread_kN() const { return spread_ * law().info.force.in_record_units; }  // measured standard deviation

  std::vector<double> force_kN(std::span<double const> parameters) const { return motion_.force_kN(parameters); }

  // Distance of the objective from its value with converged integration on a path `shift_refinement` times finer.
  double integration_shift(std::span<double const> parameters) const;

 private:
  double misfit(std::vector<double> const& force) const;

  LawOnMotion motion_;
  std::vector<double> measured_;  // law's force unit
  std::vector<double> weight_;    // trapezoid in time / (duration * standard deviation)
  std::vector<double> share_;     // trapezoid in time / duration
  double spread_ = 1.0;           // standard deviation of the measured force, law's unit
};

// Eq. (27) over the samples where `scored` is not 0, for forces that a law gave over the whole history. NaN if no two
// neighbours are scored or the measured force is the same at all scored samples.
double objective_on(data::FitRecord const& record, std::span<double const> force_kN, std::vector<double> scored);

// The search for a law's free parameters on a record as a problem in the unit box. Keeps references to both arguments.
class IdentificationProblem final : public opt::DeviationProblem {
 public:
  IdentificationProblem(LawOnRecord const& model, SearchBox const& box);
  IdentificationProblem(IdentificationProblem const&) = delete;
  IdentificationProblem& operator=(IdentificationProblem const&) = delete;

  std::size_t dimension() const override { return box_.free_count(); }
  void evaluate(opt::Points const& points, std::span<double> values) const override;
  std::span<double const> weights() const override { return model_.residual_weights(); }
  void residuals(opt::Points const& points, std::span<double> values) const override;
  void residual_rows(opt::Points const& points, std::size_t stride, std::span<double> rows) const override;
  DeviationProblem const* outline() const override { return outline_.get(); }
  std::vector<double> on_outline(std::span<double const> weights) const override { return model_.on_outline(weights); }

 private:
  struct WithoutOutline {};
  IdentificationProblem(LawOnRecord const& model, SearchBox const& box, WithoutOutline) : model_(model), box_(box) {}

  LawOnRecord const& model_;
  SearchBox const& box_;
  std::optional<LawOnRecord> fewer_;
  std::unique_ptr<IdentificationProblem> outline_;
};

}  // namespace isolaw::fit
