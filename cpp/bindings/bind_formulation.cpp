#include <cmath>
#include <utility>

#include "exclusive.hpp"
#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/assembly/force_elements.hpp"
#include "linkwork/constraints/length_scale.hpp"
#include "linkwork/constraints/residuals.hpp"
#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/formulation/formulation.hpp"
#include "linkwork/formulation/not_finite.hpp"
#include "linkwork/formulation/right_hand_side_times.hpp"
#include "linkwork/integration/relative_violation.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork::python {
namespace {

/// OptionError: a time that is none. NotFiniteError: what is no state.
void check_moment(const System& system, double t, const ConstVector& q, const ConstVector& v) {
  if (!std::isfinite(t)) throw OptionError("not_finite", "t = " + std::to_string(t) + " is not finite");
  if (q.allFinite() && v.allFinite()) return;
  int body = 0;
  while (q.segment<7>(7 * body).allFinite() && v.segment<6>(6 * body).allFinite()) ++body;
  ErrorDetails details;
  details.bodies = {system.model().body_name(body)};
  throw NotFiniteError("not_finite", "body '" + details.bodies.front() + "': its state in q and v is not finite",
                       details);
}

/// y = (q, v, 0) of the drivers from y = (q, v) of Python.
VectorXd with_work(const Dynamics& dynamics, const ConstVector& y) {
  check_size(y, dynamics.y_size() - 1, "y");
  VectorXd out(dynamics.y_size());
  out << y, 0.0;
  return out;
}

VectorXd state(const Dynamics& dynamics, double t, const ConstVector& q, const ConstVector& v) {
  check_size(q, dynamics.system().q_size(), "q");
  check_size(v, dynamics.system().v_size(), "v");
  check_moment(dynamics.system(), t, q, v);
  VectorXd out(dynamics.y_size());
  out << q, v, 0.0;
  return out;
}

py::dict compressed_rows(const std::vector<double>& data, const std::vector<std::int64_t>& indices,
                         const std::vector<std::int64_t>& begin) {
  const auto array = [](const auto& list) { return py::array(static_cast<py::ssize_t>(list.size()), list.data()); };
  py::dict out;
  out["data"] = array(data);
  out["indices"] = array(indices);
  out["indptr"] = array(begin);
  return out;
}

/// D in compressed rows.
py::dict sparse_D(const System& system, const Evaluation& at) {
  std::vector<std::int64_t> begin(system.row_count() + 1, 0);
  for (const ConstraintBlock& block : system.blocks())
    for (int k = 0; k < block.rows; ++k) begin[block.row + k + 1] += 6;
  for (std::size_t r = 1; r < begin.size(); ++r) begin[r] += begin[r - 1];
  std::vector<double> data(static_cast<std::size_t>(begin.back()));
  std::vector<std::int64_t> indices(data.size());
  std::vector<std::int64_t> next(begin.begin(), begin.end() - 1);
  for (const ConstraintBlock& block : system.blocks())
    for (int k = 0; k < block.rows; ++k)
      for (int c = 0; c < 6; ++c) {
        const std::int64_t place = next[block.row + k]++;
        data[place] = at.D[block.offset + 6 * k + c];
        indices[place] = 6 * block.body + c;
      }
  return compressed_rows(data, indices, begin);
}

py::array_t<double> mass_blocks(const System& system) {
  const auto count = static_cast<py::ssize_t>(system.body_count());
  py::array_t<double> out({count, py::ssize_t{6}, py::ssize_t{6}});
  using Block = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
  for (int body = 0; body < system.body_count(); ++body) {
    Eigen::Map<Block> block(out.mutable_data() + 36 * body);
    block.setZero();
    block.topLeftCorner<3, 3>().diagonal().setConstant(system.mass(body));
    block.bottomRightCorner<3, 3>() = system.inertia(body);
  }
  return out;
}

/// d of each inerter, x_dot = d v, as compressed rows.
py::dict inerter_rows(const System& system, const Evaluation& at) {
  std::vector<double> data;
  std::vector<std::int64_t> indices, begin{0};
  for (std::size_t k = 0; k < system.inerters().count(); ++k) {
    for (const Inerters::Part& part : system.inerters().row(k, at.D.data()))
      for (int c = 0; c < velocity_size && part.body != ground; ++c) {
        data.push_back(part.d[c]);
        indices.push_back(std::int64_t{velocity_size} * part.body + c);
      }
    begin.push_back(static_cast<std::int64_t>(data.size()));
  }
  return compressed_rows(data, indices, begin);
}

VectorXd inertances(const System& system) {
  VectorXd out(static_cast<Eigen::Index>(system.inerters().count()));
  for (Eigen::Index k = 0; k < out.size(); ++k) out[k] = system.inerters().inertance(static_cast<std::size_t>(k));
  return out;
}

/// Of many states.
VectorXd kinetic_energies(const Dynamics& dynamics, const Doubles& q, const Doubles& v) {
  const System& system = dynamics.system();
  const py::ssize_t frames = system.q_size() > 0 ? q.size() / system.q_size() : 0;
  if (q.size() != frames * system.q_size() || v.size() != frames * system.v_size())
    throw OptionError("shape", "q and v need " + std::to_string(system.q_size()) + " and " +
                                   std::to_string(system.v_size()) + " entries for each state");
  Evaluation at = system.make_evaluation();
  VectorXd out(frames);
  using Vector = Eigen::Map<const VectorXd>;
  for (py::ssize_t k = 0; k < frames; ++k) {
    const Vector positions(q.data() + k * system.q_size(), system.q_size()),
        velocities(v.data() + k * system.v_size(), system.v_size());
    system.evaluate_coordinates(positions, velocities, at);
    out[k] = system.kinetic_energy(at, velocities);
  }
  return out;
}

/// Evaluations with another history than that of the run under way, if any; that is left as it was.
class WithHistory {
 public:
  WithHistory(Dynamics& dynamics, const std::optional<VectorXd>& history)
      : dynamics_(dynamics), kept_(history ? dynamics.history() : VectorXd()), changed_(history) {
    if (history) dynamics.set_history(*history);
  }
  ~WithHistory() {
    if (changed_) dynamics_.set_history(kept_);
  }
  WithHistory(const WithHistory&) = delete;
  WithHistory& operator=(const WithHistory&) = delete;

 private:
  Dynamics& dynamics_;
  VectorXd kept_;
  bool changed_;
};

using History = std::optional<VectorXd>;

const VectorXd& history_or_own(const Dynamics& dynamics, const History& history) {
  if (history) check_size(*history, dynamics.system().history_size(), "history");
  return history ? *history : dynamics.history();
}

py::dict evaluate(const Dynamics& dynamics, double t, const ConstVector& q, const ConstVector& v,
                  const History& history) {
  check_size(q, dynamics.system().q_size(), "q");
  check_size(v, dynamics.system().v_size(), "v");
  check_moment(dynamics.system(), t, q, v);
  const System& system = dynamics.system();
  Evaluation at = system.make_evaluation();
  system.evaluate(t, q, v, history_or_own(dynamics, history), at);
  py::dict out;
  out["M"] = mass_blocks(system);
  out["D"] = sparse_D(system, at);
  out["inerters"] = inerter_rows(system, at);
  out["inertance"] = inertances(system);
  out["Phi"] = at.Phi;
  out["Phi_t"] = at.Phi_t;
  out["Phi_dot"] = at.Phi_dot;
  out["gamma"] = at.gamma;
  out["g"] = VectorXd(at.g.head(system.v_size()));
  out["potential"] = at.potential;
  out["force_power"] = at.power;
  out["history"] = at.history;
  return out;
}

py::tuple accelerations(Dynamics& dynamics, double t, const ConstVector& q, const ConstVector& v,
                        const History& history) {
  const WithHistory held(dynamics, history);
  VectorXd v_dot(dynamics.system().v_size()), lambda(dynamics.system().row_count());
  const VectorXd y = state(dynamics, t, q, v);
  {
    const py::gil_scoped_release release;
    dynamics.evaluate(t, y);
    dynamics.accelerations(v_dot, lambda);
    if (!v_dot.allFinite() || !lambda.allFinite()) throw_not_finite(dynamics.system(), y, t);
  }
  return py::make_tuple(v_dot, lambda);
}

VectorXd derivative(Dynamics& dynamics, double t, const ConstVector& y, const History& history) {
  const WithHistory held(dynamics, history);
  const VectorXd full = with_work(dynamics, y);
  check_moment(dynamics.system(), t, full.head(dynamics.system().q_size()),
               full.segment(dynamics.system().q_size(), dynamics.system().v_size()));
  VectorXd y_dot(dynamics.y_size());
  {
    const py::gil_scoped_release release;
    dynamics.evaluate(t, full);
    dynamics.rates(y_dot);
    if (!y_dot.allFinite()) throw_not_finite(dynamics.system(), full, t);
  }
  return y_dot.head(y.size());
}

/// Reactions of one frame or, with a leading axis, of many.
py::tuple reactions(const Dynamics& dynamics, const Doubles& t, const Doubles& q, const Doubles& multipliers,
                    const std::optional<Doubles>& history) {
  const System& system = dynamics.system();
  const py::ssize_t frames = t.size(), joints = system.joint_count();
  if (q.size() != frames * system.q_size() || multipliers.size() != frames * system.row_count())
    throw OptionError("shape", "q and multipliers need " + std::to_string(system.q_size()) + " and " +
                                   std::to_string(system.row_count()) + " entries for each of the " +
                                   std::to_string(frames) + " times");
  std::vector<py::ssize_t> shape = {joints, 3};
  if (t.ndim() > 0) shape.insert(shape.begin(), frames);
  py::array_t<double> force(shape), torque(shape);
  Evaluation at = system.make_evaluation();
  const VectorXd rest = VectorXd::Zero(system.v_size());
  using Vector = Eigen::Map<const VectorXd>;
  using Columns = Eigen::Map<Eigen::Matrix3Xd>;
  const py::ssize_t variables = system.history_size();
  if (history && history->size() != frames * variables)
    throw OptionError("shape", "history needs " + std::to_string(variables) + " numbers for each of the " +
                                   std::to_string(frames) + " times");
  InterruptionMeter meter;
  meter.add(system.body_count());  // for the evaluation
  for (py::ssize_t k = 0; k < frames; ++k) {
    const Vector position(q.data() + k * system.q_size(), system.q_size());
    if (history)
      system.evaluate_constraints(t.data()[k], position, rest, Vector(history->data() + k * variables, variables), at);
    else system.evaluate_constraints(t.data()[k], position, rest, system.initial_history(), at);
    meter.add(system.body_count());
    system.reactions(at, position, Vector(multipliers.data() + k * system.row_count(), system.row_count()),
                     Columns(force.mutable_data() + 3 * k * joints, 3, joints),
                     Columns(torque.mutable_data() + 3 * k * joints, 3, joints));
  }
  return py::make_tuple(force, torque);
}

/// What a force element does at each of many states: force, torque, power, potential; and what its history becomes.
py::tuple force_element(const Dynamics& dynamics, int element, const Doubles& t, const Doubles& q, const Doubles& v,
                        const Doubles& v_dot, const Doubles& history) {
  const System& system = dynamics.system();
  const py::ssize_t frames = t.size(), variables = system.history_size();
  if (element < 0 || element >= static_cast<int>(system.model().forces().size()) ||
      q.size() != frames * system.q_size() || v.size() != frames * system.v_size() ||
      v_dot.size() != frames * system.v_size() || history.size() != frames * variables)
    throw OptionError("shape", "these are no frames of this model, or it has no such force element");
  py::array_t<double> force({frames, py::ssize_t{3}}), torque({frames, py::ssize_t{3}}), power(frames),
      potential(frames), next(frames);
  ForceElement one(system, element);
  using Vector = Eigen::Map<const VectorXd>;
  for (py::ssize_t k = 0; k < frames; ++k) {
    const ForceOnBody found = one.evaluate(t.data()[k], Vector(q.data() + k * system.q_size(), system.q_size()),
                                           Vector(v.data() + k * system.v_size(), system.v_size()),
                                           Vector(v_dot.data() + k * system.v_size(), system.v_size()),
                                           Vector(history.data() + k * variables, variables));
    Eigen::Map<Vec3<double>>(force.mutable_data() + 3 * k) = found.force;
    Eigen::Map<Vec3<double>>(torque.mutable_data() + 3 * k) = found.torque;
    power.mutable_data()[k] = found.power;
    potential.mutable_data()[k] = found.potential;
    next.mutable_data()[k] = found.history;
  }
  return py::make_tuple(force, torque, power, potential, next);
}

/// Phi_t of some rows at each of many states.
py::array_t<double> constraint_rates(const Dynamics& dynamics, const Doubles& t, const Doubles& q, const Doubles& v,
                                     const std::vector<int>& rows) {
  const System& system = dynamics.system();
  const py::ssize_t frames = t.size();
  if (q.size() != frames * system.q_size() || v.size() != frames * system.v_size())
    throw OptionError("shape", "q and v need " + std::to_string(system.q_size()) + " and " +
                                   std::to_string(system.v_size()) + " entries for each of the " +
                                   std::to_string(frames) + " times");
  py::array_t<double> out({frames, static_cast<py::ssize_t>(rows.size())});
  double* next = out.mutable_data();
  Evaluation at = system.make_evaluation();
  using Vector = Eigen::Map<const VectorXd>;
  for (py::ssize_t k = 0; k < frames; ++k) {
    system.evaluate_constraints(t.data()[k], Vector(q.data() + k * system.q_size(), system.q_size()),
                                Vector(v.data() + k * system.v_size(), system.v_size()), dynamics.history(), at);
    for (const int row : rows) *next++ = at.Phi_t[row];
  }
  return out;
}

py::array_t<double> joint_frames(const Dynamics& dynamics, const ConstVector& q) {
  const System& system = dynamics.system();
  check_size(q, system.q_size(), "q");
  const auto count = static_cast<py::ssize_t>(system.joint_count());
  py::array_t<double> out({count, py::ssize_t{3}, py::ssize_t{3}});
  for (int joint = 0; joint < system.joint_count(); ++joint)
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(out.mutable_data() + 9 * joint) =
        system.joint_frame(joint, q);
  return out;
}

py::dict right_hand_side_times(Dynamics& dynamics, double t, const ConstVector& y, int repeats) {
  const VectorXd full = with_work(dynamics, y);
  RightHandSideTimes times;
  {
    const py::gil_scoped_release release;
    times = time_right_hand_sides(dynamics, t, full, repeats);
  }
  py::dict out;
  out["evaluate"] = times.evaluate;
  out["assemble"] = times.assemble;
  out["factorize"] = times.factorize;
  out["solve"] = times.solve;
  out["reactions"] = times.reactions;
  out["whole"] = times.whole;
  return out;
}

double residual_at_start(const Dynamics& dynamics) {
  const Model& model = dynamics.system().model();
  Residuals found;
  {
    const py::gil_scoped_release release;
    found = residuals_at(dynamics.system(), 0.0, model.initial_q(), model.initial_v(), dynamics.history());
  }
  return found.largest();
}

py::tuple residuals(const Dynamics& dynamics, double t, const ConstVector& q, const ConstVector& v) {
  const System& system = dynamics.system();
  check_size(q, system.q_size(), "q");
  check_size(v, system.v_size(), "v");
  check_moment(system, t, q, v);
  Residuals found;
  {
    const py::gil_scoped_release release;
    found = residuals_at(system, t, q, v, dynamics.history());
  }
  return py::make_tuple(std::move(found.Phi), std::move(found.Phi_dot), std::move(found.lengths),
                        std::move(found.rates), std::move(found.roundoff));
}

/// Of each body.
py::tuple scales(const Dynamics& dynamics, double t, const ConstVector& q, const ConstVector& v) {
  const System& system = dynamics.system();
  check_size(q, system.q_size(), "q");
  check_size(v, system.v_size(), "v");
  check_moment(system, t, q, v);
  Evaluation at = system.make_evaluation();
  system.evaluate(t, q, v, dynamics.history(), at);
  const VectorXd of_parts = characteristic_rates(system, at, v);
  VectorXd rates(system.body_count());
  Eigen::VectorXi parts(system.body_count());
  for (int body = 0; body < system.body_count(); ++body) {
    parts[body] = ConnectedParts::of(system).of_body(body);
    rates[body] = of_parts[parts[body]];
  }
  return py::make_tuple(characteristic_lengths(system), std::move(rates), std::move(parts));
}

/// Of each body that of its connected part.
VectorXd part_sizes(const Dynamics& dynamics) {
  const System& system = dynamics.system();
  const VectorXd of_parts = RelativeViolation::lengths_of(system);
  VectorXd sizes(system.body_count());
  for (int body = 0; body < system.body_count(); ++body)
    sizes[body] = of_parts[ConnectedParts::of(system).of_body(body)];
  return sizes;
}

void bind_measurements(py::class_<Dynamics>& dynamics) {
  dynamics
      .def_property_readonly("residual_at_start", exclusive(&residual_at_start),
                             "The largest part of the size or of the speed of a connected part that a residual of the "
                             "initial state is, above roundoff.")
      .def("force_element", &force_element, py::arg("element"), py::arg("t"), py::arg("q"), py::arg("v"),
           py::arg("v_dot"), py::arg("history"),
           "(force, torque (k, 3) on the second body, power that goes into the motion, potential, what its history "
           "variable becomes (k,)) of a force element at k times and states, each with its history variables.")
      .def("kinetic_energies", &kinetic_energies, py::arg("q"), py::arg("v"), "(k,) [J] at k states.")
      .def("constraint_rates", &constraint_rates, py::arg("t"), py::arg("q"), py::arg("v"), py::arg("rows"),
           "Phi_t (k, rows) of some equations at k times and states.");
}

void bind_times(py::class_<Dynamics>& dynamics) {
  dynamics
      .def("right_hand_side_times", exclusive(&right_hand_side_times), py::arg("t"), py::arg("y"), py::arg("repeats"),
           "Times of so many right-hand sides at y = (q, v), together [s]: evaluate, assemble, factorize, solve, "
           "reactions, and the whole, which may be less than their sum.")
      .def("repeat_right_hand_side", exclusive(+[](Dynamics& self, double t, const ConstVector& y, int repeats) {
             const VectorXd full = with_work(self, y);
             const py::gil_scoped_release release;
             repeat_right_hand_side(self, t, full, repeats);
           }),
           py::arg("t"), py::arg("y"), py::arg("repeats"),
           "So many right-hand sides at y = (q, v), reactions included, for others to time.")
      .def("least_time_ahead", exclusive(+[](Dynamics& self, double t, const ConstVector& y, double seconds) {
             const VectorXd full = with_work(self, y);
             const py::gil_scoped_release release;
             return least_time_ahead(self, t, full, seconds);
           }),
           py::arg("t"), py::arg("y"), py::arg("seconds"),
           "Least time of a right-hand side at y = (q, v) [s], of those in so many seconds, two at least; a run that "
           "sets out from there goes on as it would have without.")
      .def("redundancy_watch_time", exclusive(+[](Dynamics& self, double t, const ConstVector& y, int repeats) {
             const VectorXd full = with_work(self, y);
             const py::gil_scoped_release release;
             return time_redundancy_watch(self, t, full, repeats);
           }),
           py::arg("t"), py::arg("y"), py::arg("repeats"),
           "Time of so many looks at the redundant rows at y = (q, v), one of which a run takes a step [s].")
      .def("analysis_time", exclusive(+[](Dynamics& self) {
             const py::gil_scoped_release release;
             return time_analysis(self);
           }),
           "Time of one symbolic analysis, by a solver like the one in use [s].");
}

py::array_t<int> history_owners(const Dynamics& dynamics) {
  const std::vector<HistoryOwner>& owners = dynamics.system().history_owners();
  py::array_t<int> out({std::ssize(owners), std::ptrdiff_t{2}});
  int* to = out.mutable_data();
  for (const HistoryOwner& it : owners) {
    *to++ = it.joint;
    *to++ = it.element;
  }
  return out;
}

void bind_history(py::class_<Dynamics>& dynamics) {
  dynamics
      .def_property_readonly("initial_history", &Dynamics::initial_history,
                             "History variables of the initial state: full turns, speeds at which contacts began.")
      .def_property_readonly("history_owners", &history_owners,
                             "Of each history variable (h, 2): 1 of a joint and its index, or 0 and that of a force "
                             "element or, counted on from these, a law of a joint's force.")
      .def_property("history", exclusive(+[](const Dynamics& d) { return VectorXd(d.history()); }),
                    exclusive(+[](Dynamics& d, const ConstVector& history) { d.set_history(history); }),
                    "Those of the last accepted state, which evaluations take where none are given.")
      .def("beginning_history", exclusive(+[](const Dynamics& d, double t, const ConstVector& q, const ConstVector& v) {
             check_size(q, d.system().q_size(), "q");
             check_size(v, d.system().v_size(), "v");
             return d.system().beginning_history(t, q, v);
           }),
           py::arg("t"), py::arg("q"), py::arg("v"), "Of a motion that begins in this state.")
      .def("begins_contact", exclusive(+[](const Dynamics& d, const VectorXd& before, const VectorXd& after) {
             for (const VectorXd* history : {&before, &after})
               check_size(*history, d.system().history_size(), "history");
             return d.system().begins_contact(before, after);
           }),
           py::arg("history_before"), py::arg("history_after"),
           "Whether one is under way after a step that was not before it.")
      .def("advanced_history",
           exclusive(
               +[](const Dynamics& d, double t, const ConstVector& q, const ConstVector& v, const History& history) {
                 check_size(q, d.system().q_size(), "q");
                 check_size(v, d.system().v_size(), "v");
                 Evaluation at = d.system().make_evaluation();
                 d.system().evaluate(t, q, v, history_or_own(d, history), at);
                 return at.history;
               }),
           py::arg("t"), py::arg("q"), py::arg("v"), py::arg("history") = py::none(),
           "What the history becomes where this state is accepted.");
}

}  // namespace

// Long: one statement a property or method of Dynamics.
void bind_formulation(py::module_& module) {
  bind_rank_report(module);
  py::class_<Dynamics> dynamics(module, "Dynamics", "A model with a formulation, a stabilization and a linear solver.");
  dynamics
      .def(py::init<const Model&, const Options&, const Dynamics*>(), py::arg("model"), py::arg("options"),
           py::arg("like") = py::none(), py::call_guard<py::gil_scoped_release>(),
           "`like`: another one, whose rank is taken where it has the same joints and pose.")
      .def_property_readonly("body_count", [](const Dynamics& d) { return d.system().body_count(); })
      .def_property_readonly("joint_count", [](const Dynamics& d) { return d.system().joint_count(); })
      .def_property_readonly("row_count", [](const Dynamics& d) { return d.system().row_count(); })
      .def_property_readonly("matrix_form", [](const Dynamics& d) { return d.options().matrix_form; })
      .def_property_readonly("linear_solver", [](const Dynamics& d) { return d.options().linear_solver; })
      .def_property_readonly("options", &Dynamics::options)
      .def(
          "initial_state", [](const Dynamics& d) { return VectorXd(d.initial_y().head(d.y_size() - 1)); },
          "y = (q, v), 13 per body.")
      .def("evaluate", exclusive(&evaluate), py::arg("t"), py::arg("q"), py::arg("v"), py::arg("history") = py::none(),
           "M (n, 6, 6), D (compressed rows), inerters (rows), inertance, Phi, Phi_t, Phi_dot, gamma, g, potential, "
           "force_power, history.")
      .def("residuals", exclusive(&residuals), py::arg("t"), py::arg("q"), py::arg("v"),
           "(Phi, Phi_dot, row lengths, row rates [1/s], roundoff), all of each row: Phi / length and Phi_dot / length "
           "/ rate are parts of the size and speed of the connected part, known to the roundoff of its positions.")
      .def("scales", exclusive(&scales), py::arg("t"), py::arg("q"), py::arg("v"),
           "Of each body a length [m] and a rate [1/s], those of its connected part, and which part that is.")
      .def_property_readonly("part_sizes", exclusive(&part_sizes),
                             "Of each body the size of its connected part, by which verdicts weigh errors [m].")
      .def("accelerations", exclusive(&accelerations), py::arg("t"), py::arg("q"), py::arg("v"),
           py::arg("history") = py::none(), "(v_dot, multipliers) of the mechanism itself, without stabilization.")
      .def("derivative", exclusive(&derivative), py::arg("t"), py::arg("y"), py::arg("history") = py::none(),
           "y_dot for y = (q, v).")
      .def("reactions", &reactions, py::arg("t"), py::arg("q"), py::arg("multipliers"), py::arg("history") = py::none(),
           "Force and torque (joints, 3) that each joint exerts on its second body at the joint's point, inertial "
           "axes; (k, joints, 3) for k times, states and multipliers.")
      .def("joint_frames", &joint_frames, py::arg("q"), "Inertial axes of the joint frames, fixed in the first body.");
  bind_history(dynamics);
  bind_measurements(dynamics);
  bind_rank(dynamics);
  bind_statistics(dynamics);
  bind_times(dynamics);
}

}  // namespace linkwork::python
