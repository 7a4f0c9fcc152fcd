#pragma once

#include "linkwork/integration/integrator.hpp"

namespace linkwork {

/// OptionError: sizes that do not fit, coefficients that are not finite, an implicit or an inconsistent method.
void check(const ButcherTableau& tableau);

/// Fills the first columns of k with k_i = f(t + c_i h, y + h sum_j a_ij k_j) for the stages of a method, with the
/// sampled correction for the step. On entry `dynamics` is evaluated at (t, y). `stage` is workspace.
void evaluate_stages(const ButcherTableau& tableau, Dynamics& dynamics, const StepSpan& step, const VectorXd& y,
                     MatrixXd& k, VectorXd& stage);

/// Its two parts: the first stage, with the correction, then all others.
void evaluate_first_stage(const ButcherTableau& tableau, Dynamics& dynamics, const StepSpan& step, MatrixXd& k);
void evaluate_later_stages(const ButcherTableau& tableau, Dynamics& dynamics, const StepSpan& step, const VectorXd& y,
                           MatrixXd& k, VectorXd& stage);

/// The same with the correction as it is held, or none.
void evaluate_free_stages(const ButcherTableau& tableau, Dynamics& dynamics, const StepSpan& step, const VectorXd& y,
                          MatrixXd& k, VectorXd& stage);

/// y += h sum_i weights_i k_i
void add_combination(double h, const ConstVector& weights, const MatrixXd& k, VectorXd& y);

}  // namespace linkwork
