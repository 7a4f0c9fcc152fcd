#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "dense_algebra.hpp"
#include "linkwork/linear/block/block_solver.hpp"
#include "support.hpp"

/// What block solvers are asked for.
namespace support {

/// Runs a check with the kernels of every instruction set that this processor has.
template <class Check>
void for_every_instruction_set(Check check) {
  for (int level = 0; level < instruction_set_count(); ++level) {
    INFO("kernels of ", std::string(instruction_set(level).name));
    const auto solver = block::make_block_solver(instruction_set(level));
    check(*solver);
  }
}

/// The same mechanism with masses spread over so many decades.
inline Model spread(const Model& model, Random& random, double decades) {
  Model out;
  for (std::size_t k = 0; k < model.bodies().size(); ++k) {
    Body body = model.bodies()[k];
    const double factor = std::pow(10.0, random.number(-0.5 * decades, 0.5 * decades));
    body.mass *= factor;
    body.inertia *= factor;
    out.add_body(model.body_name(static_cast<int>(k)), body);
  }
  for (std::size_t k = 0; k < model.joints().size(); ++k) {
    const Element& joint = model.joints()[k];
    const auto first = model.joint_parameters().begin() + static_cast<std::ptrdiff_t>(joint.first_parameter);
    const KindInfo& info = joint_kinds()[joint.kind].info;
    out.add_joint(info.name, model.joint_name(static_cast<int>(k)), joint.i, joint.j, joint.at,
                  {first, first + static_cast<std::ptrdiff_t>(info.parameters.size())});
  }
  return out;
}

/// Largest residuals of the two block rows, each relative to its largest term.
inline std::pair<double, double> residuals(const System& system, const Evaluation& at, const VectorXd& e,
                                           const VectorXd& a, const VectorXd& b, const VectorXd& x,
                                           const VectorXd& lambda) {
  VectorXd Mx(a.size()), Dx(b.size()), Dl = VectorXd::Zero(a.size());
  system.multiply_mass(at, x, Mx);
  system.multiply_D(at, x, Dx);
  system.add_D_transposed(at, lambda, Dl);
  const double first = (Mx - Dl - a).cwiseAbs().maxCoeff();
  const double second = b.size() ? (Dx + e.cwiseProduct(lambda) - b).cwiseAbs().maxCoeff() : 0.0;
  const double size = std::max({Mx.cwiseAbs().maxCoeff(), Dl.cwiseAbs().maxCoeff(), a.cwiseAbs().maxCoeff()});
  return {first / size, second / std::max(b.size() ? b.cwiseAbs().maxCoeff() : 1.0, x.cwiseAbs().maxCoeff())};
}

inline void check_solves(SaddleSolver& solver, const System& system, Random& random, bool compliant) {
  const Evaluation at = evaluate_initially(system);
  const VectorXd e = compliant ? VectorXd(1e-3 * (random.vector(system.row_count()).array() + 1.5))
                               : VectorXd(VectorXd::Zero(system.row_count()));
  const VectorXd a = random.vector(system.v_size()), b = random.vector(system.row_count());
  VectorXd x(a.size()), lambda(b.size()), x_again(a.size()), lambda_again(b.size());
  solver.analyze(system, at);
  solver.factorize_and_solve(at, e, a, b, x, lambda);
  const auto [first, second] = residuals(system, at, e, a, b, x, lambda);
  CHECK(first < 1e-11);
  CHECK(second < 1e-11);
  solver.solve(2.0 * a, 2.0 * b, x_again, lambda_again);  // the separate forward substitution
  CHECK(relative_error(x_again, 2.0 * x) < 1e-10);
  CHECK(relative_error(lambda_again, 2.0 * lambda) < 1e-9);
  solver.factorize(at, e);
  solver.solve(a, b, x_again, lambda_again);
  CHECK(relative_error(x_again, x) < 1e-10);
}

}  // namespace support
