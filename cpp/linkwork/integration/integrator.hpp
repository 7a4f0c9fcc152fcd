#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/math/archive.hpp"

namespace linkwork {

/// The times of a step: t + c h, but none before `earliest` or after `latest`, where something jumps.
struct StepSpan {
  double t = 0.0, h = 0.0;
  double earliest = -std::numeric_limits<double>::infinity(), latest = std::numeric_limits<double>::infinity();

  double at(double c) const { return within(t + c * h); }
  double within(double time) const { return std::clamp(time, earliest, latest); }
  /// In two, the first of this share.
  std::array<StepSpan, 2> divided(double share) const {
    const double first = share * h;
    return {{{t, first, earliest, latest}, {t + first, h - first, earliest, latest}}};
  }
};

/// One step of an explicit method for y_dot = f(t, y).
class Integrator {
 public:
  virtual ~Integrator() = default;
  virtual const std::string& name() const = 0;
  virtual int order() const = 0;
  /// Of how many steps before a step its result depends on what was evaluated where they began.
  virtual int memory() const { return 0; }
  /// OptionError: a choice of the run that this method cannot honor.
  virtual void check_run(const Dynamics&) const {}
  /// Forgets earlier steps and sizes its storage.
  virtual void start(int y_size) = 0;
  /// What it knows of earlier steps.
  virtual void keep(Archive&) {}
  /// Advances y over a step. On entry `dynamics` is evaluated where it begins, at (t, y): that evaluation is the first
  /// stage.
  virtual void step(Dynamics& dynamics, const StepSpan& step, VectorXd& y) = 0;
};

/// By how much the weights of a method may miss the sum 1.
constexpr double consistency = 1e-12;

/// Coefficients of an explicit Runge-Kutta method (Butcher's tableau): A strictly lower triangular, s x s.
struct ButcherTableau {
  std::string name;
  int order = 0;
  MatrixXd A;
  VectorXd b, c;
};

/// Coefficients of a linear multistep method; newest value first.
///   predictor: y' = y + h (p_0 f_n + p_1 f_{n-1} + ...)
///   corrector (may be empty): y' = y + h (c_0 f(t', y'_predicted) + c_1 f_n + c_2 f_{n-1} + ...), PECE
/// `starter` makes the first steps.
struct MultistepCoefficients {
  std::string name;
  int order = 0;
  VectorXd predictor, corrector;
  ButcherTableau starter;
};

/// Coefficients of a half-explicit Runge-Kutta method of s stages: A strictly lower triangular leads to the stages,
/// A_bar lower triangular to the states that satisfy the velocity constraints, the last of which is the new state.
struct HalfExplicitTableau {
  std::string name;
  int order = 0;
  MatrixXd A, A_bar;
  bool explicit_first_stage = false;  ///< it uses D v_dot = gamma; row 0 of A_bar is then not used
};

std::unique_ptr<Integrator> make_half_explicit(const HalfExplicitTableau& tableau);
std::unique_ptr<Integrator> make_runge_kutta(const ButcherTableau& tableau);
std::unique_ptr<Integrator> make_multistep(const MultistepCoefficients& coefficients);
/// v' = v + h v_dot(q, v), q' = q + h N(q) v'.
std::unique_ptr<Integrator> make_semi_implicit_euler();

}  // namespace linkwork
