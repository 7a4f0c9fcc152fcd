#include <algorithm>

#include "exclusive.hpp"
#include "linkwork/formulation/dynamics.hpp"

namespace linkwork::python {
namespace {

constexpr std::size_t listed_joints = 16;

py::list crossings(const Dynamics& dynamics) {
  py::list out;
  for (const SingularityCrossing& it : dynamics.watch().crossings()) {
    std::vector<std::string> joints;
    for (std::size_t k = 0; k < std::min<std::size_t>(it.joints.size(), listed_joints); ++k)
      joints.push_back(dynamics.system().model().joint_name(it.joints[k]));
    py::dict one;
    one["t"] = it.t;
    one["pivot"] = it.pivot;
    one["joints"] = joints;
    one["rows_changed"] = it.rows_changed;
    one["fallback_evaluations"] = it.fallback_evaluations;
    out.append(one);
  }
  return out;
}

py::dict statistics(const Dynamics& dynamics) {
  const DynamicsStatistics& cost = dynamics.statistics();
  const IterationStatistics& iterations = dynamics.iterations();
  py::dict out;
  out["evaluations"] = cost.evaluations;
  out["factorizations"] = cost.factorizations;
  out["solves"] = cost.solves;
  out["evaluate_time"] = cost.evaluate_time;
  out["factorize_time"] = cost.factorize_time;
  out["assemble_time"] = dynamics.assemble_time();
  out["solve_time"] = cost.solve_time;
  out["smallest_pivot"] = cost.smallest_pivot;
  out["singular_poses"] = dynamics.watch().singular_poses();
  out["row_changes"] = dynamics.watch().row_changes();
  out["singularity_crossings"] = crossings(dynamics);
  out["factor_nonzeros"] = dynamics.factorization_cost().factor_nonzeros;
  out["iterations"] = iterations.iterations;
  out["most_iterations"] = iterations.most;
  out["accelerated_solves"] = iterations.accelerated;
  out["stagnations"] = iterations.stagnations;
  out["iteration_change"] = iterations.last_change;
  out["iteration_residual"] = iterations.last_residual;
  out["worst_iteration_residual"] = iterations.worst_residual;
  return out;
}

py::dict factorization_cost(const Dynamics& dynamics) {
  const FactorizationCost cost = dynamics.factorization_cost();
  py::dict out;
  out["matrix_nonzeros"] = cost.matrix_nonzeros;
  out["factor_nonzeros"] = cost.factor_nonzeros;
  out["flops"] = cost.flops;
  out["bytes"] = cost.bytes;
  return out;
}

}  // namespace

void bind_statistics(py::class_<Dynamics>& dynamics) {
  dynamics.def("statistics", exclusive(&statistics))
      .def_property_readonly(
          "passed",
          +[](const Dynamics& it) { return py::make_tuple(it.watch().singular_poses(), it.watch().row_changes()); },
          "How many singular poses were passed, and how often other rows became the redundant ones.")
      .def("factorization_cost", exclusive(&factorization_cost),
           "matrix_nonzeros (lower triangle), factor_nonzeros, flops, bytes of the last factorization; None: unknown.");
}

}  // namespace linkwork::python
