#include <doctest/doctest.h>

#include "dense_algebra.hpp"
#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/formulation/formulation.hpp"
#include "linkwork/math/error.hpp"
#include "support.hpp"

using namespace support;

namespace {

struct Named {
  std::string name;
  Model model;
};

/// Two hinges on the ground and two balls between: a closed loop without redundancy, two degrees of freedom.
Model four_bar(Random& random) {
  Model model;
  for (const char* name : {"crank", "coupler", "rocker"}) model.add_body(name, random_body(random));
  add_joint(model, random, "revolute", "A", ground, 0);
  add_joint(model, random, "spherical", "B", 0, 1);
  add_joint(model, random, "spherical", "C", 1, 2);
  add_joint(model, random, "revolute", "D", 2, ground);
  return model;
}

/// Small mechanisms of full rank, with time-dependent constraints too.
std::vector<Named> mechanisms() {
  Random random(130);
  std::vector<Named> all;
  for (const char* kind : {"spherical", "revolute", "universal"})
    all.push_back({std::string("chain of ") + kind, random_chain(random, 5, kind)});
  all.push_back({"tree", random_tree(random, 8)});
  all.push_back({"four-bar", four_bar(random)});
  Model driven = four_bar(random);
  const Attachment<double> ends = random_attachment(random);
  driven.add_joint("distance", "actuator", ground, 1, ends, {{0.0, driven.add_signal(harmonic(0.2, 3.0, 0.5, 1.0))}});
  all.push_back({"driven four-bar", driven});
  return all;
}

struct Solution {
  VectorXd v_dot, lambda;
};

Solution solve(Dynamics& dynamics) {
  Solution out{VectorXd(dynamics.system().v_size()), VectorXd(dynamics.system().row_count())};
  dynamics.evaluate(0.0, dynamics.initial_y());
  dynamics.accelerations(out.v_dot, out.lambda);
  return out;
}

Solution solve(const Model& model, const Options& options) {
  Dynamics dynamics(model, options);
  return solve(dynamics);
}

/// |M v_dot - D^T lambda - g| relative to |g|.
double equilibrium_error(const Model& model, const Solution& solution) {
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  const VectorXd g = at.g.head(system.v_size());
  return relative_error(dense_M(model) * solution.v_dot - dense_D(system, at).transpose() * solution.lambda, g);
}

}  // namespace

TEST_CASE("schur, kkt and the converged augmented Lagrangian agree on v_dot and lambda") {
  for (const auto& [name, model] : mechanisms()) {
    INFO(name);
    const Solution schur = solve(model, options_of("standard", "schur")),
                   kkt = solve(model, options_of("standard", "kkt"));
    const Solution augmented = solve(model, options_of("augmented_lagrangian"));
    CHECK(relative_error(kkt.v_dot, schur.v_dot) < 1e-10);
    CHECK(relative_error(kkt.lambda, schur.lambda) < 1e-10);
    CHECK(relative_error(augmented.v_dot, schur.v_dot) < 1e-10);
    CHECK(relative_error(augmented.lambda, schur.lambda) < 1e-10);
  }
}

TEST_CASE("every formulation gives the same v_dot with every linear solver it can use") {
  const Model model = mechanisms().back().model;
  const Solution reference = solve(model, options_of("standard", "schur", "dense"));
  for (const LinearSolverInfo& info : linear_solvers())
    for (const FormulationInfo& formulation : formulations())
      for (const std::string& form : formulation.forms) {
        if (!info.available() || !can_solve(form, info) || formulation.compliant) continue;
        INFO(formulation.name, " ", form, " ", info.name);
        CHECK(relative_error(solve(model, options_of(formulation.name, form, info.name)).v_dot, reference.v_dot) <
              1e-9);
      }
}

TEST_CASE("M v_dot - D^T lambda = g and D v_dot = gamma") {
  for (const auto& [name, model] : mechanisms())
    for (const auto& options :
         {options_of("standard", "schur"), options_of("standard", "kkt"), options_of("augmented_lagrangian")}) {
      INFO(name, " ", options.formulation, " ", options.matrix_form);
      const Solution solution = solve(model, options);
      const System system(model);
      const Evaluation at = evaluate_initially(system);
      CHECK(equilibrium_error(model, solution) < 1e-12);
      CHECK(relative_error(dense_D(system, at) * solution.v_dot, at.gamma) < 1e-11);
    }
}

TEST_CASE("M v_dot - D^T lambda = g by the penalty method, to roundoff times the penalty") {
  for (const auto& [name, model] : mechanisms()) {
    INFO(name);
    Options options = options_of("penalty");
    options.penalty_scale = 1e5;
    CHECK(equilibrium_error(model, solve(model, options)) < 1e-9);
  }
}

TEST_CASE("the error of the penalty method is inversely proportional to the penalty") {
  for (const auto& [name, model] : mechanisms()) {
    INFO(name);
    const Solution exact = solve(model, options_of("standard", "schur"));
    const auto error = [&](double scale) {
      Options options = options_of("penalty");
      options.penalty_scale = scale;
      return (solve(model, options).v_dot - exact.v_dot).norm();
    };
    CHECK(error(1e6) / error(1e7) == doctest::Approx(10.0).epsilon(0.05));
  }
}

TEST_CASE("the penalty method with one penalty for all rows is (M + a D^T D) v_dot = g + a D^T gamma") {
  for (const auto& [name, model] : mechanisms()) {
    INFO(name);
    Options options = options_of("penalty");
    options.penalty = 300.0;
    const Solution solution = solve(model, options);
    const System system(model);
    const Evaluation at = evaluate_initially(system);
    const MatrixXd D = dense_D(system, at), N = dense_M(model) + 300.0 * D.transpose() * D;
    const VectorXd right = at.g.head(system.v_size()) + 300.0 * D.transpose() * at.gamma;
    CHECK(relative_error(N * solution.v_dot, right) < 1e-11);
    CHECK(relative_error(solution.lambda, 300.0 * (at.gamma - D * solution.v_dot)) < 1e-9);
  }
}

TEST_CASE("the augmented Lagrangian counts its iterations and keeps its residual") {
  for (const auto& [name, model] : mechanisms()) {
    INFO(name);
    Dynamics dynamics(model, options_of("augmented_lagrangian"));
    const int solves = 3;
    for (int k = 0; k < solves; ++k) solve(dynamics);
    const IterationStatistics& iterations = dynamics.iterations();
    CHECK(dynamics.statistics().solves == solves);
    CHECK(iterations.most >= 2);
    CHECK(iterations.most <= 15);
    CHECK(iterations.iterations == solves * iterations.most);
    CHECK(iterations.last_change < 1e-11);
    CHECK(iterations.last_residual <= iterations.worst_residual);
    CHECK(iterations.worst_residual < 1e-8);
  }
}

TEST_CASE("the augmented Lagrangian needs fewer iterations with a larger penalty") {
  const Model model = mechanisms()[0].model;
  const auto iterations = [&](double scale) {
    Options options = options_of("augmented_lagrangian");
    options.penalty_scale = scale;
    Dynamics dynamics(model, options);
    solve(dynamics);
    return dynamics.iterations().most;
  };
  CHECK(iterations(1e2) > iterations(1e4));
  CHECK(iterations(1e4) > iterations(1e7));
}

TEST_CASE("an augmented Lagrangian that does not converge within its cap is an error that names a joint") {
  for (const auto& [name, model] : mechanisms()) {
    INFO(name);
    Options options = options_of("augmented_lagrangian");
    options.penalty_scale = 100.0;
    options.max_iterations = 2;
    Dynamics dynamics(model, options);
    try {
      solve(dynamics);
      FAIL_CHECK("no error");
    } catch (const NotConvergedError& error) {
      INFO(std::string(error.what()));
      REQUIRE(error.details.joints.size() == 1);
      CHECK(model.joint_names().find(error.details.joints.front()) >= 0);
      CHECK(error.details.residuals.front().second > 0.0);
      CHECK(std::string(error.what()).find("2 iterations") != std::string::npos);
      CHECK(std::string(error.what()).find("'" + error.details.joints.front() + "'") != std::string::npos);
    }
  }
}

TEST_CASE("mechanisms with redundant rows and with massless bodies are solved") {
  Random random(131);
  Model model = random_chain(random, 3, "revolute");
  const auto with = [&](const Attachment<double>& at, int i, int j) {
    Model doubled = model;
    doubled.add_joint("revolute", "again", i, j, at);
    return doubled;
  };
  const Solution single = solve(model, options_of("standard", "schur"));
  const Model doubled = with(model.joints()[1].at, 0, 1);
  const Solution twice = solve(doubled, options_of("augmented_lagrangian"));
  CHECK(relative_error(twice.v_dot, single.v_dot) < 1e-9);
  CHECK(equilibrium_error(doubled, twice) < 1e-9);
  Body ghost = random_body(random);
  ghost.mass = 0.0;
  ghost.inertia.setZero();
  Model carrying = model;
  carrying.add_body("ghost", ghost);
  add_joint(carrying, random, "fixed", "weld", 2, 3);
  for (const char* formulation : {"standard", "augmented_lagrangian"}) {
    INFO(formulation);
    const Solution carried = solve(carrying, options_of(formulation));
    CHECK(relative_error(carried.v_dot.head(18), single.v_dot) < 1e-9);
  }
}

TEST_CASE("every formulation and linear solver moves a mechanism with a joint twice as with it once") {
  Random random(132);
  Model once = random_chain(random, 3, "revolute"), twice = once;
  twice.add_joint("revolute", "again", 0, 1, once.joints()[1].at);
  const VectorXd expected = solve(once, options_of("standard", "schur")).v_dot;
  for (const FormulationInfo& formulation : formulations())
    for (const LinearSolverInfo& info : linear_solvers())
      for (const std::string& form : formulation.forms) {
        if (!info.available() || !can_solve(form, info)) continue;
        INFO(formulation.name, " ", form, " ", info.name);
        if (form == "kkt" && !info.make_saddle) {
          CHECK_THROWS_AS(solve(twice, options_of(formulation.name, form, info.name)), OptionError);
          continue;
        }
        const Solution found = solve(twice, options_of(formulation.name, form, info.name));
        CHECK(relative_error(found.v_dot, expected) < (formulation.compliant ? 1e-6 : 1e-9));
        CHECK(relative_error(found.lambda.segment<5>(5), found.lambda.tail<5>()) < 1e-6);  // equal shares
      }
}

TEST_CASE("every formulation refuses a massless body that joints leave free, by name") {
  Random random(133);
  Body ghost = random_body(random);
  ghost.mass = 0.0;
  ghost.inertia.setZero();
  for (const char* formulation : {"standard", "penalty", "augmented_lagrangian"}) {
    Model model;
    model.add_body("solid", random_body(random));
    model.add_body("ghost", ghost);
    add_joint(model, random, "spherical", "ball", 0, 1);
    try {
      Dynamics(model, options_of(formulation));
      FAIL("no error");
    } catch (const SingularSystemError& error) {
      CHECK(error.code() == "free_massless_body");
      CHECK(error.details.bodies == std::vector<std::string>{"ghost"});
    }
  }
}

TEST_CASE("a mechanism without joints accelerates by M^-1 g with every formulation and linear solver") {
  Random random(134);
  Model model;
  for (const char* name : {"a", "b"}) model.add_body(name, random_body(random));
  const VectorXd expected = dense_inverse(dense_M(model)) * evaluate_initially(System(model)).g.head(12);
  for (const FormulationInfo& formulation : formulations())
    for (const LinearSolverInfo& info : linear_solvers())
      for (const std::string& form : formulation.forms) {
        if (!info.available() || !can_solve(form, info)) continue;
        INFO(formulation.name, " ", form, " ", info.name);
        Solution solution;
        CHECK_NOTHROW(solution = solve(model, options_of(formulation.name, form, info.name)));
        CHECK(relative_error(solution.v_dot, expected) < 1e-12);
      }
}

TEST_CASE("a state that is not finite is a NotFiniteError with every formulation") {
  const Model model = mechanisms()[0].model;
  for (const FormulationInfo& formulation : formulations())
    for (const std::string& form : formulation.forms) {
      INFO(formulation.name, " ", form);
      Dynamics dynamics(model, options_of(formulation.name, form));
      VectorXd y = dynamics.initial_y();
      y[4] = NAN;
      VectorXd v_dot(dynamics.system().v_size()), lambda(dynamics.system().row_count());
      dynamics.evaluate(0.0, y);
      CHECK_THROWS_AS(dynamics.accelerations(v_dot, lambda), NotFiniteError);
    }
}

TEST_CASE("results do not change with units by the scaled penalty") {
  Random random(135);
  const Model model = random_chain(random, 4, "revolute");
  const double mass = 1e3, length = 1e3;  // g, mm
  Model other(length * model.gravity());
  for (int body = 0; body < 4; ++body) {
    Body b = model.bodies()[body];
    b.mass *= mass;
    b.inertia *= mass * length * length;
    b.position *= length;
    b.velocity *= length;
    other.add_body(model.body_name(body), b);
  }
  for (int joint = 0; joint < 4; ++joint) {
    Element element = model.joints()[joint];
    element.at.s_i *= length;
    element.at.s_j *= length;
    other.add_joint("revolute", model.joint_name(joint), element.i, element.j, element.at);
  }
  for (const char* formulation : {"standard", "penalty", "augmented_lagrangian"}) {
    INFO(std::string(formulation));
    const VectorXd a = solve(model, options_of(formulation)).v_dot, b = solve(other, options_of(formulation)).v_dot;
    for (int body = 0; body < 4; ++body) {
      CHECK(relative_error(b.segment<3>(6 * body), length * a.segment<3>(6 * body)) < 1e-9);
      CHECK(relative_error(b.segment<3>(6 * body + 3), a.segment<3>(6 * body + 3)) < 1e-9);
    }
  }
}
