#include "bindings.hpp"
#include "linkwork/constraints/initial_conditions.hpp"
#include "linkwork/constraints/length_scale.hpp"

namespace linkwork::python {
namespace {

/// A system with the correction of its initial conditions.
class Assembler {
 public:
  Assembler(const Model& model, const ConstVector& weights, std::vector<int> held)
      : system_(model), conditions_(system_, weights, std::move(held)) {}

  py::tuple positions(const ConstVector& given, const ConstVector& start) {
    check_size(given, system_.q_size(), "given");
    check_size(start, system_.q_size(), "start");
    return corrected(start, [&](VectorXd& q) { return conditions_.positions(given, q); });
  }

  py::tuple velocities(const ConstVector& q, const ConstVector& given) {
    check_size(q, system_.q_size(), "q");
    check_size(given, system_.v_size(), "given");
    return corrected(given, [&](VectorXd& v) { return conditions_.velocities(q, v); });
  }

  VectorXd row_lengths(const ConstVector& q) const {
    check_size(q, system_.q_size(), "q");
    Evaluation at = system_.make_evaluation();
    system_.evaluate_constraints(0.0, q, VectorXd::Zero(system_.v_size()), system_.initial_history(), at);
    return linkwork::row_lengths(system_, at);
  }

  py::tuple residuals(const ConstVector& q, const ConstVector& v) const {
    check_size(q, system_.q_size(), "q");
    check_size(v, system_.v_size(), "v");
    Evaluation at = system_.make_evaluation();
    system_.evaluate_constraints(0.0, q, v, system_.initial_history(), at);
    return py::make_tuple(at.Phi, at.Phi_dot);
  }

  double distance(const ConstVector& given, const ConstVector& q) const { return conditions_.distance(given, q); }
  int iterations() const { return conditions_.iterations(); }

 private:
  /// What `correct` makes of x, and whether it got there.
  template <class Correct>
  static py::tuple corrected(VectorXd x, Correct correct) {
    bool reached = false;
    {
      const py::gil_scoped_release release;
      reached = correct(x);
    }
    return py::make_tuple(x, reached);
  }

  System system_;
  InitialConditions conditions_;
};

}  // namespace

void bind_assembler(py::module_& module) {
  py::class_<Assembler>(module, "Assembler", "Takes initial positions and velocities to the constraints at t = 0.")
      .def(py::init<const Model&, const ConstVector&, std::vector<int>>(), py::arg("model"), py::arg("weights"),
           py::arg("held"), py::call_guard<py::gil_scoped_release>(),
           "Weights of the bodies' masses, none for 1; indices of bodies that keep what they have.")
      .def("positions", &Assembler::positions, py::arg("given"), py::arg("start"),
           "(q, whether it is on the constraints): from `start`, near to `given`.")
      .def("velocities", &Assembler::velocities, py::arg("q"), py::arg("given"), "(v, whether it is consistent at q).")
      .def("residuals", &Assembler::residuals, py::arg("q"), py::arg("v"), "(Phi, Phi_dot).")
      .def("row_lengths", &Assembler::row_lengths, py::arg("q"),
           "What residuals are relative to: Phi [m or 1] / row length is part of the size of the mechanism.")
      .def("distance", &Assembler::distance, py::arg("given"), py::arg("q"),
           "Displacement of the mass, squared: integral |x - x_given|^2 w dm [kg m2].")
      .def_property_readonly("iterations", &Assembler::iterations);
}

}  // namespace linkwork::python
