#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "exclusive.hpp"
#include "linkwork/formulation/dynamics.hpp"

namespace linkwork::python {
namespace {

std::vector<std::tuple<int, std::vector<int>, std::string>> groups(const Dynamics& dynamics, std::size_t most) {
  const py::gil_scoped_release release;
  std::vector<std::tuple<int, std::vector<int>, std::string>> out;
  for (const DependentGroup& group : dependent_groups(dynamics.system(), dynamics.rank(), most))
    out.emplace_back(group.row, group.others, describe(dynamics.system().model(), group));
  return out;
}

/// Of the equations of which some depend on the others but for digits. What is independent in the least of them is not the
/// same number where redundant ones are left out.
std::vector<std::string> nearly_dependent_joints(const System& system, const RankReport& rank,
                                                 const VectorXd& history) {
  std::vector<std::string> out;
  const VectorXd q = system.model().initial_q();
  const TimedPose start{0.0, q, history};
  for (double near = std::max(1.01 * rank.near, rank_tolerance); out.empty() && near < 1.0; near *= 2.0)
    for (const int joint : examine_pose(system, start, rank.redundant_rows, near).joints)
      out.push_back(system.model().joint_name(joint));
  return out;
}

std::vector<std::string> joints_that_nearly_depend(const Dynamics& dynamics) {
  const RankReport& rank = dynamics.rank();
  if (rank.nearly_dependent == 0) return {};
  const py::gil_scoped_release release;
  if (!rank.beside_drivers) return nearly_dependent_joints(dynamics.system(), rank, dynamics.initial_history());
  const System system(dynamics.system().model().without_drivers());
  return nearly_dependent_joints(system, examine_rank(system), system.initial_history());
}

}  // namespace

void bind_rank_report(py::module_& module) {
  py::class_<RankReport>(module, "RankReport",
                         "Rank of the constraint matrix D: what is redundant in every pose, and what only in the "
                         "assembled one.")
      .def_readonly("rows", &RankReport::rows)
      .def_readonly("rank", &RankReport::rank, "Away from singular poses.")
      .def_readonly("degrees_of_freedom", &RankReport::degrees_of_freedom)
      .def_readonly("nearly_dependent", &RankReport::nearly_dependent,
                    "How many rows that are kept depend on the others but for digits of the geometry, in every pose.")
      .def_readonly("least_part", &RankReport::least_part, "What is independent in the least of them; 1: none.")
      .def_readonly("beside_drivers", &RankReport::beside_drivers,
                    "These are those of the mechanism without its drivers.")
      .def_readonly("redundant_rows", &RankReport::redundant_rows, "Implied by the others in every pose.")
      .def_readonly("singular_rows", &RankReport::singular_rows,
                    "Of the others, those that depend on the rest in the assembled pose.")
      .def_property_readonly(
          "unique",
          [](const RankReport& report) { return std::vector<bool>(report.unique.begin(), report.unique.end()); },
          "Per joint: its multipliers follow from the motion.");
}

void bind_rank(py::class_<Dynamics>& dynamics) {
  dynamics.def("rank", &Dynamics::rank, py::return_value_policy::copy)
      .def("nearly_dependent_joints", exclusive(&joints_that_nearly_depend),
           "Of the equations of which some depend on the others but for digits.")
      .def("dependent_groups", &groups, py::arg("most"),
           "(row, rows that imply it, both in words) of the first redundant rows.");
}

}  // namespace linkwork::python
