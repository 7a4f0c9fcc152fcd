#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace linkwork {

/// The choices of a run, one per axis; see README for the table of methods.
struct Options {
  std::string formulation = "standard";
  std::string system = "auto";         ///< of `standard`: "kkt", "schur" or "auto"
  std::string linear_solver = "auto";  ///< a name in solvers.def or "auto"
  std::string stabilization = "sampled_baumgarte";
  std::optional<double> baumgarte_alpha, baumgarte_beta;  ///< [1/s]
  std::optional<double> penalty;        ///< the same for all rows; without it penalty_scale / (D M^-1 D^T)_ii
  std::optional<double> penalty_scale;  ///< without it the formulation chooses
  double tolerance = 1e-12;             ///< of augmented_lagrangian: |d v_dot| <= tolerance (|v_dot| + |M^-1 g|)
  int max_iterations = 100;
  std::string on_singular = "pass";  ///< at a singular pose: "pass", "warn" or "stop"
  /// Of the largest |Phi|, |Phi_dot|, |D v_dot - gamma| at the ends of steps, and what to do beyond: "record",
  /// "project" or "stop".
  std::array<double, 3> violation_limit = {INFINITY, INFINITY, INFINITY};
  std::string on_violation = "record";
};

/// OptionError: a policy or a number that no run can have. Names of methods are looked at where they are looked up.
void check_options(const Options& options);

}  // namespace linkwork
