#pragma once

#include "linkwork/integration/integrator.hpp"
#include "linkwork/integration/interpolant.hpp"
#include "linkwork/integration/tolerances.hpp"

namespace linkwork {

/// An explicit Runge-Kutta method of s stages with an error estimate and an interpolant. Stage s (counted from 0) is
/// f(t + h, y'), the first stage of the next step; `extra` stages after it serve the interpolant alone.
struct EmbeddedPair {
  ButcherTableau method;
  int error_order = 0;    ///< of the embedded method: the estimate is O(h^(error_order + 1))
  VectorXd error;         ///< s + 1: the estimate is h sum_i error_i k_i
  VectorXd second_error;  ///< empty, or s + 1: with this one e_2 the estimate is e^2 / sqrt(e^2 + 0.01 e_2^2)
  MatrixXd extra_A;       ///< extra x (s + 1 + extra), strictly lower triangular from column s + 1 on
  VectorXd extra_c;
  MatrixXd interpolant;  ///< (s + 1 + extra) x d: y(t + theta h) = y + h sum_i sum_k interpolant_ik theta^(k+1) k_i
};

/// Takes trial steps of an EmbeddedPair, each from a state where `dynamics` is evaluated.
class PairStepper final : public Interpolant {
 public:
  /// OptionError: sizes that do not fit, an estimate whose weights do not add up to zero, an interpolant that does not
  /// end in the new state.
  explicit PairStepper(const EmbeddedPair& pair);
  void start(int y_size);

  const EmbeddedPair& pair() const { return pair_; }

  /// A step from (t, y) to (t + h, y_new()), evaluated at the times of the span; the estimate of its error in units of
  /// the tolerances, infinite where the new state is not finite. Leaves `dynamics` at the new state, with the
  /// correction of this step held.
  BodyMaximum trial(Dynamics& dynamics, const ErrorMeasure& measure, const StepSpan& step, const VectorXd& y);
  /// The same without the estimate. False where the new state is not finite.
  bool take(Dynamics& dynamics, const StepSpan& step, const VectorXd& y);
  const VectorXd& y_new() const { return y_new_; }
  /// The estimate of the last trial, by that of all of it, of each of ConnectedParts.
  VectorXd errors_of_parts(const ErrorMeasure& measure, double error);

  /// Ahead of `trial` or `take` of the same step, for somebody who evaluates the later stages: the first one.
  void begin(Dynamics& dynamics, const StepSpan& step);
  ConstVector first_stage() const { return k_.col(0); }
  /// y_dot at the new state.
  ConstVector last_stage() const { return k_.col(stages_); }
  /// The others, of which `fill(i, k_i)` gives number i.
  template <class Fill>
  void supply(const Fill& fill) {
    for (Eigen::Index i = 1; i < stages_; ++i) fill(static_cast<int>(i), k_.col(i));
    supplied_ = true;
  }
  void take_back() { supplied_ = false; }

  /// Evaluates what the interpolant still needs. True where `dynamics` is no longer at the new state.
  bool prepare_interpolation(Dynamics& dynamics);
  void interpolate(const System& system, double theta, VectorXd& y) const override;

 private:
  BodyMaximum estimate(const ErrorMeasure& measure, const VectorXd& y);

  EmbeddedPair pair_;
  Eigen::Index stages_;
  StepSpan step_;
  double h_ = 0.0;
  bool begun_ = false, supplied_ = false;  ///< stages of the step that comes are there: the first; the others
  bool prepared_ = false;
  VectorXd y_, y_new_, workspace_;
  mutable VectorXd weights_;
  MatrixXd k_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> extra_A_;
};

}  // namespace linkwork
