#include "linkwork/formulation/options.hpp"

#include <set>

#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/math/error.hpp"
#include "support.hpp"

using namespace support;

namespace {

std::string code(const Options& options) {
  return error_code([&] { resolve(options); });
}

}  // namespace

TEST_CASE("an option that does not exist or cannot be honoured is refused with a code") {
  Random random(136);
  const Model model = random_chain(random, 2, "revolute");
  const auto code = [&](const Options& options) { return error_code([&] { Dynamics(model, options); }); };
  CHECK(code(options_of("standard")) == "none");
  CHECK(code(options_of("standart")) == "unknown_formulation");
  CHECK(code(options_of("standard", "lkk")) == "unknown_option");
  CHECK(code(options_of("penalty", "kkt")) == "matrix_form");
  CHECK(code(options_of("standard", "auto", "cholmud")) == "unknown_linear_solver");
  CHECK(code(options_of("standard", "kkt", "eigen_ldlt")) == "linear_solver");
  Options options;
  options.stabilization = "baumgart";
  CHECK(code(options) == "unknown_stabilization");
}

TEST_CASE("the gains of (12.14) are alpha = mu omega, beta = omega, one of the two with its textbook value") {
  Options options = options_of("penalty");
  options.stabilization = "baumgarte";
  options.damping_ratio = 0.7;
  options.frequency = 20.0;
  CHECK(*resolve(options).baumgarte_alpha == doctest::Approx(14.0).epsilon(1e-15));
  CHECK(*resolve(options).baumgarte_beta == 20.0);
  options.frequency = std::nullopt;
  CHECK(*resolve(options).baumgarte_alpha == doctest::Approx(7.0).epsilon(1e-15));
  CHECK(*resolve(options).baumgarte_beta == 10.0);
  options.baumgarte_alpha = options.baumgarte_beta = 5.0;
  CHECK(code(options) == "conflict");
}

TEST_CASE("one gain of Baumgarte's alone is refused, and so is any that the stabilization does not use") {
  Options options;
  options.stabilization = "baumgarte";
  options.baumgarte_alpha = 5.0;
  CHECK(code(options) == "conflict");
  options.baumgarte_beta = 5.0;
  CHECK(code(options) == "none");
  options.stabilization = "none";
  CHECK(code(options) == "conflict");
}

TEST_CASE("options of some methods are filled in where the method has them, and refused elsewhere") {
  CHECK(!resolve(options_of("standard")).tolerance);
  CHECK(*resolve(options_of("augmented_lagrangian")).tolerance == 1e-12);
  CHECK(*resolve(options_of("augmented_lagrangian")).max_iterations == 100);
  Options options = options_of("standard");
  options.max_iterations = 5;
  CHECK(code(options) == "conflict");
}

TEST_CASE("numbers out of bounds are refused by the name of the option") {
  for (const double value : {0.0, -1.0, double(NAN), double(INFINITY)}) {
    Options options = options_of("penalty");
    options.penalty = value;
    CHECK(code(options) == "penalty");
  }
  Options options;
  options.violation_limit = {1e-3, -1.0, INFINITY};
  CHECK(code(options) == "violation_limit");
}

TEST_CASE("a policy without a limit, or a projection of accelerations alone, is a conflict") {
  Options options;
  options.on_violation = "stop";
  CHECK(code(options) == "conflict");
  options.violation_limit = {INFINITY, INFINITY, 1.0};
  CHECK(code(options) == "none");
  options.on_violation = "project";
  CHECK(code(options) == "conflict");
}

TEST_CASE("every option has a name of its own, a line of help, and choices if it is a name") {
  std::set<std::string> names;
  for (const OptionInfo& info : option_infos()) {
    INFO(info.name);
    CHECK(names.insert(info.name).second);
    CHECK(info.documentation.size() > 10);
    CHECK((info.type == "name") == !info.choices.empty());
  }
}
