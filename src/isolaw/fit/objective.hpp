// A law on the record of one device: forces, residuals and the objective, Eq. (27) of Cucuzza et al. 2025.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "isolaw/data/channels/record.hpp"
#include "isolaw/fit/box.hpp"
#include "isolaw/fit/kernels.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::fit {

// integration_shift() makes this many integration steps in place of each step of the fit.
inline constexpr int shift_refinement = 20;
// The largest relative difference between the objectives that two machines compute for the same record and parameters.
// Forces may differ by the same share of the peak force. Compilers, mathematical libraries and processors round
// differently: `./isolaw.sh compilers` found 6e-14 for objectives and 1.2e-12 for forces (bouc-wen in x87 arithmetic;
// otherwise 9e-14). The limit is wider, for libraries and processors that we could not try.
inline constexpr double evaluation_tolerance = 1e-9;
// The largest relative difference between the objective from a block of candidates and the scalar one. Blocks use other
// elementary functions and fused multiply-adds. The largest difference seen is 1e-12 for hwang-wu and 3e-14 for other
// laws. Objectives above 1e6 may differ more, and so may integrations of the kind `paper` with unstably long steps.
inline constexpr double block_tolerance = 1e-11;

// A law on a displacement history. No measured force is needed.
class LawOnMotion {
 public:
  // The law makes `refinement` equal steps from sample to sample. A law that remembers its path ignores motions within
  // the record's dead band. The object keeps no reference to the history. Throws Error for a history without samples,
  // and for a history without time if the law needs velocities.
  LawOnMotion(laws::LawEntry const& law, data::FitRecord const& motion, laws::Integration integration,
              laws::TurningPoints turning_points = laws::TurningPoints::as_sampled, int refinement = 1);
  LawOnMotion refined(int refinement) const;  // a copy with `refinement` steps from sample to sample

  laws::LawEntry const& law() const { return *law_; }
  laws::Integration integration() const { return integration_; }
  int refinement() const { return refinement_; }
  // The motion of one test, in which the law starts at rest. Most records have one test.
  struct Test {
    data::TestRange samples;
    laws::Path path;
  };
  std::span<Test const> tests() const { return tests_; }

  // Chooses samples for a faster, less exact evaluation and returns their indices: all samples just after a reversal of
  // the motion, fewer elsewhere.
  std::vector<std::size_t> outline() const;
  // Returns the law on only those samples whose indices `samples` holds in rising order. If they include all reversals
  // of the motion, a rate-independent law gives the same forces at them.
  LawOnMotion at(std::span<std::size_t const> samples) const;
  // Computes the force [kN] at every sample; not finite where the law has no finite force. `parameters` are in the
  // law's order and units; `force` has one element per sample. Thread-safe.
  void force_kN(std::span<double const> parameters, std::span<double> force) const;
  std::vector<double> force_kN(std::span<double const> parameters) const;
  // Like force_kN(), but in the law's unit of force.
  void evaluate(std::span<double const> parameters, std::span<double> force) const;

 private:
  void make_tests(std::span<data::TestRange const> ranges);

  laws::LawEntry const* law_;
  laws::Integration integration_;
  laws::TurningPoints turning_points_;
  int refinement_ = 1;
  std::vector<double> time_s_, x_, v_;  // time, displacement and velocity; the last two in the law's unit of length
  std::vector<Test> tests_;
};

class LawOnRecord {
 public:
  // The law makes `refinement` equal steps from sample to sample. The object keeps no reference to the record. Throws
  // Error if the law needs velocities and the record has no time, or if the objective is undefined: fewer than two
  // samples, no duration, no scored sample with a weight above 0, a constant force. If the record has several tests,
  // those without a scored sample of weight above 0 take no part in the mean.
  LawOnRecord(laws::LawEntry const& law, data::FitRecord const& record, laws::Integration integration,
              laws::TurningPoints turning_points = laws::TurningPoints::as_sampled, int refinement = 1);
  LawOnRecord refined(int refinement) const;  // a copy with `refinement` steps from sample to sample
  // Returns the law on only the samples of LawOnMotion::outline(). Each of them takes over weight from the dropped
  // samples beside it, so the objective changes little. nullopt if over 3/4 of the samples would remain, or if the law
  // is integrated by the paper's method, whose error depends on the distance between samples.
  std::optional<LawOnRecord> outline() const;
  // Moves the weights `shares` of all samples to the samples of outline(), as outline() moves the record's weights.
  std::vector<double> on_outline(std::span<double const> shares) const;

  laws::LawEntry const& law() const { return motion_.law(); }
  int refinement() const { return motion_.refinement(); }

  // Eq. (27): mean over time, or with the record's weights, of |measured - computed| force / standard deviation of the
  // measured force; +infinity if a computed force is not finite. If the device has several tests, it is the mean of
  // their values. `parameters` are in the law's order and units; `work` is scratch space. Thread-safe.
  double objective(std::span<double const> parameters, std::vector<double>& work) const;
  // Computes the objectives of `count` candidates in blocks; candidate(i, values) writes the parameters of candidate i.
  // Objectives above 1e-3 agree with objective() within block_tolerance, whatever a candidate's place in its block.
  void objectives(std::size_t count, std::function<void(std::size_t, std::span<double>)> const& candidate,
                  std::span<double> values, InstructionSet set = instruction_set()) const;
  // Writes (measured - computed force) / standard deviation of the measured force, for sample j of candidate i, to
  // values[i * samples() + j]; not finite if the force is not. Agrees with the scalar path as closely as objectives().
  void residuals(std::size_t count, std::function<void(std::size_t, std::span<double>)> const& candidate,
                 std::span<double> values, InstructionSet set = instruction_set()) const;
  // Writes the residuals side by side: sample j of candidate i is rows[j * stride + i]. `stride` is at least
  // num::padded(count); columns after the last candidate may hold any numbers.
  void residual_rows(std::size_t count, std::function<void(std::size_t, std::span<double>)> const& candidate,
                     std::size_t stride, std::span<double> rows, InstructionSet set = instruction_set()) const;

  // One weight for each sample, such that the objective is the sum of weight * |residual|. Their sum is 1.
  std::span<double const> residual_weights() const { return share_; }
  std::size_t samples() const { return measured_.size(); }
  // For each sample the standard deviation of the measured force in the test that it belongs to.
  std::vector<double> spreads_kN() const;

  std::vector<double> force_kN(std::span<double const> parameters) const { return motion_.force_kN(parameters); }

  // How far the objective is from its value with converged integration in steps `shift_refinement` times finer.
  double integration_shift(std::span<double const> parameters) const;

 private:
  void weigh();  // sets weight_ from share_ and spread_
  double misfit(std::vector<double> const& force) const;

  LawOnMotion motion_;
  std::vector<double> measured_;  // measured force of each sample, in the law's unit of force
  std::vector<double> weight_;    // for each sample share_ / standard deviation of the measured force in its test
  std::vector<double> share_;     // weight of each sample by time, swing or travel; the sum over all tests is 1
  std::vector<double> spread_;    // for each test the standard deviation of the measured force, in the law's unit
};

// The objective of given forces, `force_kN` with one value for each sample, over the samples whose `scored` is not 0.
// For several tests it is the mean over the tests that have such samples. NaN if no scored sample has a weight or if
// the measured force is the same at all scored samples of a test.
double objective_on(data::FitRecord const& record, std::span<double const> force_kN, std::vector<double> scored);

// The search for a law's free parameters on a record, as a problem for the searches in opt/: each free parameter is a
// coordinate in [0, 1]. Keeps references to both arguments.
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
  std::optional<LawOnRecord> thinned_model_;
  std::unique_ptr<IdentificationProblem> outline_;
};

}  // namespace isolaw::fit
