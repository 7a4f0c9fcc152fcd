#include "linkwork/constraints/conjugate_residuals.hpp"

#include "dense_algebra.hpp"
#include "mechanisms.hpp"

using namespace support;

namespace {

constexpr double enough = 1e-12;

/// A chain on balls, heavy and light in turns, whose first and last bodies are heavy; penalties of its inertias. There
/// may be several side by side.
struct Chain {
  Model model;
  System system;
  Evaluation at;
  MatrixXd M, D;
  VectorXd a, b, x, lambda, e;

  explicit Chain(double ratio, double stiffness = 1e8, int count = 1)
      : model(made(ratio, count)), system(model), at(evaluate_initially(system)) {
    Random random(51);
    M = dense_M(model);
    D = dense_D(system, at);
    e = dense_delassus(M, D).diagonal() / stiffness;
    a = M * random.vector(system.v_size());
    b = random.vector(system.row_count());
    find_solution();
  }
  void find_solution() {
    x.resize(a.size());
    lambda.resize(b.size());
    solve(VectorXd::Zero(b.size()), a, b, x, lambda);
  }

  static constexpr int links = 5;

  static Model made(double ratio, int count) {
    Model model;
    for (int n = 0; n < links * count; ++n) {
      const int k = n % links;
      Body body = body_at({1.0 * k, 0.3 * (k % 2), 0.1 * k});
      const double factor = k % 2 == 0 ? ratio : 1.0;
      body.mass *= factor;
      body.inertia *= factor;
      model.add_body("body " + std::to_string(n), body);
      if (k > 0) join(model, "spherical", "ball " + std::to_string(n), n - 1, n, {k - 0.5, 0.1, 0.1 * k});
    }
    return model;
  }
  /// Of rows and columns that are scaled: what is small beside others counts.
  void solve(const VectorXd& compliance, const VectorXd& r_1, const VectorXd& r_2, MutableVector dx,
             MutableVector dlambda) const {
    VectorXd scale(r_1.size() + r_2.size()), right(scale.size());
    scale << M.diagonal().cwiseSqrt().cwiseInverse(),
        dense_delassus(M, D).diagonal().cwiseMax(1e-3).cwiseSqrt().cwiseInverse();
    right << r_1, r_2;
    const MatrixXd K = scale.asDiagonal() * dense_kkt(M, D, compliance) * scale.asDiagonal();
    const VectorXd out = scale.cwiseProduct(accurate_solution(K, scale.cwiseProduct(right)));
    dx = out.head(r_1.size());
    dlambda = -out.tail(r_2.size());
  }
  Refinement::Nearby with_penalties() const {
    return [this](const ConstVector& r_1, const ConstVector& r_2, MutableVector dx, MutableVector dlambda) {
      solve(e, r_1, r_2, dx, dlambda);
    };
  }
};

}  // namespace

TEST_CASE("errors that penalties do not show vanish in a few steps, whatever the masses") {
  for (const double ratio : {1e4, 1e8, 1e12}) {
    INFO(ratio);
    const Chain chain(ratio);
    const auto nearby = chain.with_penalties();
    VectorXd x(chain.x.size()), lambda(chain.lambda.size());
    nearby(chain.a, chain.b, x, lambda);
    if (ratio > 1e7) CHECK(relative_error(lambda, chain.lambda) > 1e-2);
    ConjugateResiduals residuals(chain.system);
    residuals.measure_rows(chain.at);
    CHECK(residuals.solve(chain.at, chain.a, chain.b, x, lambda, nearby, enough, 20));
    CHECK(residuals.steps() >= 1);
    const double roundoff = 1e-10 + 1e-17 * ratio;  // of forces between heavy bodies, in the motion of light ones
    CHECK(relative_error(x, chain.x) < roundoff);
    CHECK(relative_error(lambda, chain.lambda) < roundoff);
  }
}

TEST_CASE("what is quick hides nothing slow that it is not connected with") {
  Chain chains(1e6, 1e8, 2);
  const Eigen::Index n = chains.a.size() / 2, rows = chains.b.size() / 2;
  for (auto half : {chains.a.tail(n), chains.b.tail(rows)}) half *= 1e9;
  chains.find_solution();
  const auto nearby = chains.with_penalties();
  VectorXd x(2 * n), lambda(2 * rows);
  nearby(chains.a, chains.b, x, lambda);
  CHECK(relative_error(x.head(n), chains.x.head(n)) > 1e-6);
  ConjugateResiduals residuals(chains.system);
  residuals.measure_rows(chains.at);
  CHECK(residuals.solve(chains.at, chains.a, chains.b, x, lambda, nearby, 1e-10, 30));
  CHECK(relative_error(x.head(n), chains.x.head(n)) < 1e-9);
  CHECK(relative_error(lambda.head(rows), chains.lambda.head(rows)) < 1e-9);
  CHECK(relative_error(x.tail(n), chains.x.tail(n)) < 1e-9);
}

TEST_CASE("what is exact stays so, and too few steps are told") {
  const Chain chain(1e6, 1.0);
  const auto nearby = chain.with_penalties();
  ConjugateResiduals residuals(chain.system);
  residuals.measure_rows(chain.at);
  VectorXd x = chain.x, lambda = chain.lambda;
  CHECK(residuals.solve(chain.at, chain.a, chain.b, x, lambda, nearby, 1e-6, 20));
  CHECK(residuals.steps() <= 1);
  CHECK(relative_error(x, chain.x) < 1e-10);
  nearby(chain.a, chain.b, x, lambda);
  CHECK_FALSE(residuals.solve(chain.at, chain.a, chain.b, x, lambda, nearby, enough, 1));
}

TEST_CASE("constraints that no motion satisfies, as in a singular pose, are no reason to go on") {
  Chain chain(1.0);
  for (const ConstraintBlock& block : chain.system.blocks())
    if (block.row == 0)
      for (int k = 0; k < velocity_size; ++k) chain.at.D[block.offset + k] = 0.0;
  chain.D = dense_D(chain.system, chain.at);
  const auto nearby = chain.with_penalties();
  VectorXd x(chain.x.size()), lambda(chain.lambda.size());
  nearby(chain.a, chain.b, x, lambda);
  const VectorXd before = lambda, exact = x;
  ConjugateResiduals residuals(chain.system);
  residuals.measure_rows(chain.at);
  CHECK(residuals.solve(chain.at, chain.a, chain.b, x, lambda, nearby, 1e-6, 20));
  CHECK(relative_error(lambda.tail(lambda.size() - 1), before.tail(lambda.size() - 1)) < 1e-6);
  CHECK(relative_error(x, exact) < 1e-6);
}
