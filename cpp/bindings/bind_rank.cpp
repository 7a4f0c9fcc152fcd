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

/// Of the rows that are kept, with the joints of the equations that they nearly repeat.
std::pair<std::size_t, std::vector<std::string>> nearly_dependent_rows(const Dynamics& dynamics) {
  const System& system = dynamics.system();
  const RankReport& rank = dynamics.rank();
  std::pair<std::size_t, std::vector<std::string>> out;
  if (!(rank.least_part < rank.nearly)) return out;
  const py::gil_scoped_release release;
  const VectorXd q = system.model().initial_q();
  const PoseExamination found =
      examine_pose(system, {0.0, q, dynamics.initial_history()}, rank.redundant_rows, rank.nearly);
  out.first = found.rows.size();
  for (const int joint : found.joints) out.second.push_back(system.model().joint_name(joint));
  return out;
}

}  // namespace

void bind_rank_report(py::module_& module) {
  py::class_<RankReport>(module, "RankReport",
                         "Rank of the constraint matrix D: what is redundant in every pose, and what only in the "
                         "assembled one.")
      .def_readonly("rows", &RankReport::rows)
      .def_readonly("rank", &RankReport::rank, "Away from singular poses.")
      .def_readonly("degrees_of_freedom", &RankReport::degrees_of_freedom)
      .def_readonly(
          "least_part", &RankReport::least_part,
          "Of a row that is kept, what is independent of the others, where it is small in every pose; else 1.")
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
      .def(
          "nearly_dependent_rows", exclusive(&nearly_dependent_rows),
          "How many rows that are kept depend on the others but for what follows from digits of the geometry, in every "
          "pose, and the joints of the equations in that dependence.")
      .def("dependent_groups", &groups, py::arg("most"),
           "(row, rows that imply it, both in words) of the first redundant rows.");
}

}  // namespace linkwork::python
