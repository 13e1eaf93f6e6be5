// A law on one device's record: computed forces and the objective of Eq. (27).
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

// A finer path that tells how far a result still moves when integrated more finely: this many times finer than its own.
inline constexpr int shift_refinement = 20;

// How far an objective, computed elsewhere from the same record and parameters, may differ, relative; and a force, of
// the peak force. Compilers and processors round differently, and bring their own elementary functions: 6e-14 and
// 1.2e-12 are the largest that `./isolaw.sh compilers` has shown (bouc-wen in x87 arithmetic; 9e-14 without it). The
// rest is room for mathematical libraries and processors that were not at hand.
inline constexpr double evaluation_tolerance = 1e-9;

// Blocks use their own elementary functions and fused multiply-adds: largest seen 1e-12 (hwang-wu), 3e-14 for the other
// laws. Larger only where an objective is beyond 1e6 or a Runge-Kutta step of `paper` too long to be stable.
inline constexpr double block_tolerance = 1e-11;

// A law on a displacement history, whose force may be unknown.
class LawOnMotion {
 public:
  // Throws Error when the law needs velocities and the history has no time, and for one without samples. The history
  // may be discarded afterwards. Every interval between samples is cut into `refinement` equal steps. A law that
  // remembers its path follows the displacement with the record's dead band.
  LawOnMotion(laws::LawEntry const& law, data::FitRecord const& motion, laws::Integration integration,
              laws::TurningPoints turning_points = laws::TurningPoints::as_sampled, int refinement = 1);
  // The same law and history integrated in finer steps; `refinement` counts from the samples, not from this one's.
  LawOnMotion refined(int refinement) const;

  laws::LawEntry const& law() const { return *law_; }
  laws::Integration integration() const { return integration_; }
  int refinement() const { return refinement_; }
  laws::Path const& path() const { return path_; }
  laws::Path path(int refinement) const;

  // The samples that show the loop's outline: all of those next to a reversal, and the fewer the farther from it.
  std::vector<std::size_t> outline() const;
  // The same law on these of the samples, in rising order. On a path that keeps its reversals a law that does not
  // depend on the rate gives the same forces.
  LawOnMotion at(std::span<std::size_t const> samples) const;

  // Computed force [kN] at every sample, into `force` of that length or as a new vector; not finite where the law gives
  // none. `parameters` in the law's order and units. Thread-safe.
  void force_kN(std::span<double const> parameters, std::span<double> force) const;
  std::vector<double> force_kN(std::span<double const> parameters) const;

 private:
  laws::LawEntry const* law_;
  laws::Integration integration_;
  laws::TurningPoints turning_points_;
  int refinement_ = 1;
  std::vector<double> time_s_, x_, v_;  // law's units of length
  laws::Path path_;
};

class LawOnRecord {
 public:
  // Throws Error when the law needs velocities and the record has no time, and for a record that Eq. (27) cannot judge
  // by: fewer than two samples, no duration, a constant force. The record may be discarded afterwards.
  // Every interval between samples is cut into `refinement` equal steps.
  LawOnRecord(laws::LawEntry const& law, data::FitRecord const& record, laws::Integration integration,
              laws::TurningPoints turning_points = laws::TurningPoints::as_sampled, int refinement = 1);
  // The same law and record integrated in finer steps; `refinement` counts from the samples, not from this one's.
  LawOnRecord refined(int refinement) const;
  // On the samples of the loop's outline, each with the weight of those it stands for; nullopt where that spares
  // little, and where the integration's steps are the samples. Its objective is about this one's.
  std::optional<LawOnRecord> outline() const;
  // Shares of the outline's samples where those of all samples are these.
  std::vector<double> on_outline(std::span<double const> shares) const;

  laws::LawEntry const& law() const { return motion_.law(); }
  int refinement() const { return motion_.refinement(); }

  // OF = mean over time of |measured - computed| / standard deviation of the measured force; +infinity when a computed
  // force is not finite. `parameters` in the law's order and units. Thread-safe; `work` is scratch, resized as needed.
  double objective(std::span<double const> parameters, std::vector<double>& work) const;

  // The same for many candidates, in blocks: `candidate(i, values)` writes the parameters of number i. Agrees with the
  // scalar objective within block_tolerance (relative, where that is above 1e-3), whatever the place in a block.
  void objectives(std::size_t count, std::function<void(std::size_t, std::span<double>)> const& candidate,
                  std::span<double> values, InstructionSet set = instruction_set()) const;

  // (measured - computed force) / standard deviation of the measured force at every sample, for many candidates, one
  // after another; not finite where a force is not. Agrees with the scalar path as `objectives` does.
  void residuals(std::size_t count, std::function<void(std::size_t, std::span<double>)> const& candidate,
                 std::span<double> values, InstructionSet set = instruction_set()) const;
  // The same side by side: of sample j and candidate i at rows[j * stride + i]. `stride` is num::padded(count) or more;
  // what stands beside the last candidate is anything.
  void residual_rows(std::size_t count, std::function<void(std::size_t, std::span<double>)> const& candidate,
                     std::size_t stride, std::span<double> rows, InstructionSet set = instruction_set()) const;

  // Share of each sample in the objective, which is the sum of weight * |residual|.
  std::span<double const> residual_weights() const { return share_; }
  std::size_t samples() const { return measured_.size(); }
  // Standard deviation of the measured force, which residuals are relative to.
  double spread_kN() const { return spread_ * law().info.force.in_record_units; }

  // Computed force [kN] at every sample.
  std::vector<double> force_kN(std::span<double const> parameters) const { return motion_.force_kN(parameters); }

  // |objective - objective of the converged integration on a path `shift_refinement` times finer than this one|.
  double integration_shift(std::span<double const> parameters) const;

 private:
  double misfit(std::vector<double> const& force) const;

  LawOnMotion motion_;
  std::vector<double> measured_;  // law's force unit
  std::vector<double> weight_;    // trapezoid in time / (duration * standard deviation)
  std::vector<double> share_;     // trapezoid in time / duration
  double spread_ = 1.0;           // standard deviation of the measured force, law's unit
};

// Eq. (27) over some of the samples, those where `scored` is not 0: of the forces that a law gives over the whole
// history. NaN where no two neighbours are among them or the force does not change there.
double objective_on(data::FitRecord const& record, std::span<double const> force_kN, std::vector<double> scored);

// The search of a law's free parameters on a record, in the unit box.
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
