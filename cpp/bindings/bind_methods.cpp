#include "linkwork/integration/embedded_pair.hpp"
#include "linkwork/math/error.hpp"
#include "methods.hpp"

namespace linkwork::python {
namespace {

/// Data that a driver runs, without a Python call in its loop.
struct SemiImplicitEulerTag {
  ButcherTableau other;  ///< see of_staggered_velocities
};

}  // namespace

std::unique_ptr<Integrator> make_integrator(const py::object& method) {
  if (method.is_none()) return nullptr;
  if (py::isinstance<ButcherTableau>(method)) return make_runge_kutta(method.cast<ButcherTableau>());
  if (py::isinstance<MultistepCoefficients>(method)) return make_multistep(method.cast<MultistepCoefficients>());
  if (py::isinstance<HalfExplicitTableau>(method)) return make_half_explicit(method.cast<HalfExplicitTableau>());
  if (py::isinstance<SemiImplicitEulerTag>(method)) return make_semi_implicit_euler();
  throw OptionError("integrator",
                    "integrator must be a Tableau, a Multistep, a HalfExplicit, a SemiImplicitEuler or None");
}

SecondTake second_take(const py::object& method, bool other, bool inside) {
  if (py::isinstance<MultistepCoefficients>(method))
    return by_one_step_method(method.cast<MultistepCoefficients>().starter);
  if (other) return by_one_step_method(method.cast<ButcherTableau>());
  if (py::isinstance<EmbeddedPair>(method)) {
    auto pair = method.cast<EmbeddedPair>();
    SecondTake take = in_parts(make_runge_kutta(pair.method));
    if (inside) take.pair = std::move(pair);
    return take;
  }
  if (py::isinstance<SemiImplicitEulerTag>(method))
    return of_staggered_velocities(method.cast<SemiImplicitEulerTag>().other);
  return in_parts(make_integrator(method));
}

void bind_methods(py::module_& module) {
  py::class_<ButcherTableau>(module, "Tableau", "An explicit Runge-Kutta method.")
      .def(py::init([](std::string name, int order, const MatrixXd& A, const VectorXd& b, const VectorXd& c) {
             return ButcherTableau{std::move(name), order, A, b, c};
           }),
           py::arg("name"), py::arg("order"), py::arg("A"), py::arg("b"), py::arg("c"));
  py::class_<MultistepCoefficients>(module, "Multistep", "An Adams method; coefficients of the newest value first.")
      .def(py::init([](std::string name, int order, const VectorXd& predictor, const VectorXd& corrector,
                       const ButcherTableau& starter) {
             return MultistepCoefficients{std::move(name), order, predictor, corrector, starter};
           }),
           py::arg("name"), py::arg("order"), py::arg("predictor"), py::arg("corrector"), py::arg("starter"));
  py::class_<HalfExplicitTableau>(module, "HalfExplicit", "A half-explicit Runge-Kutta method.")
      .def(py::init([](std::string name, int order, const MatrixXd& A, const MatrixXd& A_bar, bool explicit_first) {
             return HalfExplicitTableau{std::move(name), order, A, A_bar, explicit_first};
           }),
           py::arg("name"), py::arg("order"), py::arg("A"), py::arg("A_bar"), py::arg("explicit_first_stage"));
  py::class_<SemiImplicitEulerTag>(module, "SemiImplicitEuler",
                                   "v' = v + h v_dot, q' = q + h N(q) v'; its steps are judged by the method `other`.")
      .def(py::init([](ButcherTableau other) { return SemiImplicitEulerTag{std::move(other)}; }), py::arg("other"));
  py::class_<EmbeddedPair>(module, "EmbeddedPair",
                           "An explicit Runge-Kutta method with error estimate and interpolant.")
      .def(py::init([](const ButcherTableau& method, int error_order, const VectorXd& error,
                       const VectorXd& second_error, const MatrixXd& extra_A, const VectorXd& extra_c,
                       const MatrixXd& interpolant) {
             return EmbeddedPair{method, error_order, error, second_error, extra_A, extra_c, interpolant};
           }),
           py::arg("method"), py::arg("error_order"), py::arg("error"), py::arg("second_error"), py::arg("extra_A"),
           py::arg("extra_c"), py::arg("interpolant"));
}

}  // namespace linkwork::python
