#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "bindings.hpp"
#include "linkwork/model/model.hpp"
#include "linkwork/model/special/coupler.hpp"
#include "linkwork/model/special/point_on_curve.hpp"
#include "python_function.hpp"

namespace linkwork::python {
namespace {

using GivenNames = std::variant<std::string, std::vector<std::string>>;  // a prefix, or one for each

Names read_names(const GivenNames& given) {
  return std::visit([](const auto& names) { return Names(names); }, given);
}
using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// Refuses an array whose shape is not (count, ...).
template <class Array>
void check_shape(const Array& array, std::vector<py::ssize_t> shape, const char* name) {
  bool same = array.ndim() == static_cast<py::ssize_t>(shape.size());
  for (std::size_t k = 0; same && k < shape.size(); ++k) same = array.shape(static_cast<py::ssize_t>(k)) == shape[k];
  if (same) return;
  std::string wanted, given;
  for (const py::ssize_t extent : shape) wanted += (wanted.empty() ? "" : ", ") + std::to_string(extent);
  for (py::ssize_t k = 0; k < array.ndim(); ++k) given += (k ? ", " : "") + std::to_string(array.shape(k));
  throw ModelError("shape", std::string(name) + " has shape (" + given + "), not (" + wanted + ")");
}

/// Of any strides: numbers that are the same for all bodies are not written out.
using Strided = py::array_t<double, py::array::forcecast>;

template <int size>
Eigen::Matrix<double, size, 1> vector_at(const Strided& array, py::ssize_t k) {
  const auto values = array.unchecked<2>();
  Eigen::Matrix<double, size, 1> out;
  for (int c = 0; c < size; ++c) out[c] = values(k, c);
  return out;
}

Mat3<double> matrix_at(const Strided& array, py::ssize_t k) {
  const auto values = array.unchecked<3>();
  Mat3<double> out;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) out(row, column) = values(k, row, column);
  return out;
}

int add_bodies(Model& model, const GivenNames& names, const Strided& mass, const Strided& inertia,
               const Strided& position, const Strided& orientation, const Strided& velocity, const Strided& omega,
               const std::vector<bool>& inertia_as_is) {
  const py::ssize_t count = mass.size();
  check_shape(mass, {count}, "mass");
  check_shape(inertia, {count, 3, 3}, "inertia");
  check_shape(position, {count, 3}, "position");
  check_shape(orientation, {count, 4}, "orientation");
  check_shape(velocity, {count, 3}, "velocity");
  check_shape(omega, {count, 3}, "omega");
  const auto masses = mass.unchecked<1>();
  std::vector<Body> bodies;
  bodies.reserve(static_cast<std::size_t>(count));
  for (py::ssize_t k = 0; k < count; ++k)
    bodies.push_back({masses(k), matrix_at(inertia, k), vector_at<3>(position, k), vector_at<4>(orientation, k),
                      vector_at<3>(velocity, k), vector_at<3>(omega, k),
                      !inertia_as_is.empty() && inertia_as_is.at(static_cast<std::size_t>(k))});
  return model.add_bodies(read_names(names), std::move(bodies));
}

struct Elements {
  std::vector<Element> elements;
  std::vector<Parameter> parameters;
};

Elements read_elements(const Integers& bodies, const Doubles& origin, const Doubles& frame, const Doubles& parameters,
                       const Integers& signals) {
  const py::ssize_t count = bodies.ndim() > 0 ? bodies.shape(0) : 0;
  const py::ssize_t width = parameters.ndim() > 1 ? parameters.shape(1) : 0;
  check_shape(bodies, {count, 2}, "bodies");
  check_shape(origin, {count, 2, 3}, "origin");
  check_shape(frame, {count, 2, 3, 3}, "frame");
  check_shape(parameters, {count, width}, "parameters");
  check_shape(signals, {count, width}, "signals");
  Elements out;
  out.elements.reserve(static_cast<std::size_t>(count));
  out.parameters.reserve(static_cast<std::size_t>(count * width));
  for (py::ssize_t k = 0; k < count; ++k) {
    const double* s = origin.data() + 6 * k;
    const double* C = frame.data() + 18 * k;
    using Vector = Eigen::Map<const Vec3<double>>;
    using Matrix = Eigen::Map<const RowMajor3>;
    out.elements.push_back(
        {0, bodies.data()[2 * k], bodies.data()[2 * k + 1], {Vector(s), Vector(s + 3), Matrix(C), Matrix(C + 9)}, 0});
    for (py::ssize_t p = 0; p < width; ++p)
      out.parameters.push_back({parameters.data()[k * width + p], signals.data()[k * width + p]});
  }
  return out;
}

int add_coupler(Model& model, const std::string& name, const std::vector<CoupledCoordinate>& coordinates, double offset,
                int signal) {
  const auto coupler = std::make_shared<Coupler>(model, coordinates);
  const Element& first = model.joints()[coordinates.front().joint];
  return model.add_special_joint("coupler", name, first.i, first.j, first.at, coupler, {{offset, signal}});
}

std::vector<std::array<Vec3<double>, 4>> read_pieces(const Doubles& coefficients, const char* name) {
  const py::ssize_t count = coefficients.ndim() > 0 ? coefficients.shape(0) : 0;
  check_shape(coefficients, {count, 4, 3}, name);
  std::vector<std::array<Vec3<double>, 4>> out(count);
  for (std::size_t k = 0; k < out.size(); ++k)
    for (std::size_t m = 0; m < 4; ++m)
      out[k][m] = Eigen::Map<const Vec3<double>>(coefficients.data() + 12 * k + 3 * m);
  return out;
}

int add_point_on_curve(Model& model, const std::string& name, const Integers& bodies, const Doubles& origin,
                       const Doubles& frame, const std::vector<double>& knots, const Doubles& curve,
                       const Doubles& direction, bool closed) {
  const Doubles no_parameters(std::vector<py::ssize_t>{1, 0});
  const Integers no_signals(std::vector<py::ssize_t>{1, 0});
  const Element place = read_elements(bodies, origin, frame, no_parameters, no_signals).elements.at(0);
  const Curve pieces{knots, read_pieces(curve, "curve"), read_pieces(direction, "direction"), closed};
  return model.add_special_joint("point_on_curve", name, place.i, place.j, place.at,
                                 std::make_shared<PointOnCurve>(place.i, place.j, place.at, pieces));
}

py::dict element_arrays(const std::vector<Element>& elements, const std::vector<Parameter>& parameters) {
  const auto count = static_cast<py::ssize_t>(elements.size());
  py::array_t<int> kind(count), bodies({count, py::ssize_t{2}});
  py::array_t<double> origin({count, py::ssize_t{2}, py::ssize_t{3}});
  py::array_t<double> frame({count, py::ssize_t{2}, py::ssize_t{3}, py::ssize_t{3}});
  py::array_t<std::int64_t> first_parameter(count);
  for (py::ssize_t k = 0; k < count; ++k) {
    const Element& element = elements[k];
    kind.mutable_data()[k] = element.kind;
    bodies.mutable_data()[2 * k] = element.i;
    bodies.mutable_data()[2 * k + 1] = element.j;
    Eigen::Map<Vec3<double>>(origin.mutable_data() + 6 * k) = element.at.s_i;
    Eigen::Map<Vec3<double>>(origin.mutable_data() + 6 * k + 3) = element.at.s_j;
    Eigen::Map<RowMajor3>(frame.mutable_data() + 18 * k) = element.at.C_i;
    Eigen::Map<RowMajor3>(frame.mutable_data() + 18 * k + 9) = element.at.C_j;
    first_parameter.mutable_data()[k] = static_cast<std::int64_t>(element.first_parameter);
  }
  const auto total = static_cast<py::ssize_t>(parameters.size());
  py::array_t<double> constant(total);
  py::array_t<int> signal(total);
  for (py::ssize_t p = 0; p < total; ++p) {
    constant.mutable_data()[p] = parameters[p].constant;
    signal.mutable_data()[p] = parameters[p].signal;
  }
  py::dict out;
  out["kind"] = kind;
  out["bodies"] = bodies;
  out["origin"] = origin;
  out["frame"] = frame;
  out["first_parameter"] = first_parameter;
  out["parameters"] = constant;
  out["signals"] = signal;
  return out;
}

py::array_t<double> masses(const Model& model) {
  py::array_t<double> out(static_cast<py::ssize_t>(model.bodies().size()));
  for (std::size_t b = 0; b < model.bodies().size(); ++b) out.mutable_data()[b] = model.bodies()[b].mass;
  return out;
}

py::array_t<double> inertias(const Model& model) {
  const auto count = static_cast<py::ssize_t>(model.bodies().size());
  py::array_t<double> out({count, py::ssize_t{3}, py::ssize_t{3}});
  for (py::ssize_t b = 0; b < count; ++b) Eigen::Map<RowMajor3>(out.mutable_data() + 9 * b) = model.bodies()[b].inertia;
  return out;
}

/// Indices of the bodies whose inertia may be that of no real body.
std::vector<int> taken_as_they_are(const Model& model) {
  std::vector<int> found;
  for (std::size_t b = 0; b < model.bodies().size(); ++b)
    if (model.bodies()[b].inertia_as_is) found.push_back(static_cast<int>(b));
  return found;
}

/// (k, 7): position and Euler parameters, of the ground (-1) too.
py::array_t<double> poses(const Model& model, const Integers& bodies) {
  py::array_t<double> out({bodies.size(), py::ssize_t{position_size}});
  for (py::ssize_t k = 0; k < bodies.size(); ++k) {
    const int index = bodies.data()[k];
    const Body body = index == ground ? Body{} : model.bodies().at(index);
    Eigen::Map<Vec3<double>>(out.mutable_data(k)) = body.position;
    Eigen::Map<Vec4<double>>(out.mutable_data(k) + 3) = body.orientation;
  }
  return out;
}

/// (t, x, x_dot) -> force or torque.
class PythonLaw final : public CoordinateLaw {
 public:
  PythonLaw(py::object function, const std::string& name)
      : function_(std::move(function), "joint force '" + name + "'") {}
  double effort(double t, double x, double x_dot) const override { return function_(t, x, x_dot); }

 private:
  PythonFunction function_;
};

/// (t, q (n, 7), v (n, 6)) -> (n, 6); of several mechanisms (t (k,), q (k, n, 7), v (k, n, 6)) -> (k, n, 6).
class PythonForce final : public UserForce {
 public:
  /// `origin`: the user's function and its bodies, where it takes several mechanisms.
  PythonForce(py::function function, std::string name, const py::object& origin)
      : function_(std::make_shared<py::function>(std::move(function))), name_(std::move(name)) {
    if (origin.is_none()) return;
    const auto given = origin.cast<std::pair<py::object, std::vector<int>>>();
    origin_ = std::make_shared<py::object>(given.first);
    bodies_ = given.second;
  }
  PythonForce(const PythonForce&) = delete;
  PythonForce& operator=(const PythonForce&) = delete;
  ~PythonForce() override {
    const py::gil_scoped_acquire gil;
    function_.reset();
    origin_.reset();
  }

  void add(double t, int bodies, const double* q, const double* v, double* g) const override {
    if (origin_) return add_to_all(1, &t, bodies, q, v, g);
    const py::gil_scoped_acquire gil;
    ask({}, py::float_(t), t, bodies, q, v, g);
  }

  void add_to_all(int count, const double* t, int bodies, const double* q, const double* v, double* g) const override {
    if (!origin_) return UserForce::add_to_all(count, t, bodies, q, v, g);
    const py::gil_scoped_acquire gil;
    ask({py::ssize_t{count}}, py::array_t<double>(count, t), *t, bodies, q, v, g);
  }

  bool goes_with(const UserForce& other) const override {
    const auto* it = dynamic_cast<const PythonForce*>(&other);
    return it && origin_ && it->origin_ && bodies_ == it->bodies_ && same_function(origin_->ptr(), it->origin_->ptr());
  }

 private:
  /// `first` axes before those of the bodies.
  void ask(const std::vector<py::ssize_t>& first, const py::object& times, double t, int bodies, const double* q,
           const double* v, double* g) const {
    const auto shape = [&](int size) {
      std::vector<py::ssize_t> all = first;
      all.insert(all.end(), {py::ssize_t{bodies}, py::ssize_t{size}});
      return all;
    };
    const py::array_t<double> positions(shape(position_size), q), velocities(shape(velocity_size), v);
    const py::object given = (*function_)(times, positions, velocities);
    const Doubles result = numbers(given, t);
    check_shape(result, shape(velocity_size), ("what user force '" + name_ + "' returns").c_str());
    for (py::ssize_t k = 0; k < result.size(); ++k) g[k] += result.data()[k];
  }

  /// Methods of an object are made anew wherever they are named.
  static bool same_function(PyObject* a, PyObject* b) {
    if (a == b) return true;
    return PyMethod_Check(a) && PyMethod_Check(b) && PyMethod_GET_SELF(a) == PyMethod_GET_SELF(b) &&
           PyMethod_GET_FUNCTION(a) == PyMethod_GET_FUNCTION(b);
  }

  Doubles numbers(const py::object& given, double t) const {
    if (!given.is_none()) {
      const bool masked = py::hasattr(given, "mask") && py::hasattr(given, "filled");  // what is masked is no number
      const py::array found = py::array::ensure(masked ? given.attr("astype")("f8").attr("filled")(NAN) : given);
      if (is_real(found))
        if (Doubles out = Doubles::ensure(found)) return out;
      PyErr_Clear();
    }
    throw ModelError("not_a_number", "user force '" + name_ + "': returned " + shown(given) + at_time(t) +
                                         ", not an array of numbers " + (origin_ ? "(k, n, 6)" : "(n, 6)"));
  }

  std::shared_ptr<py::function> function_;
  std::string name_;
  std::shared_ptr<py::object> origin_;
  std::vector<int> bodies_;
};

/// void f(double t, int64_t n, const double* q, const double* v, double* g, void* data): runs without Python.
class CompiledForce final : public UserForce {
 public:
  using Function = void (*)(double, std::int64_t, const double*, const double*, double*, void*);
  CompiledForce(std::uintptr_t function, std::uintptr_t data)
      : function_(reinterpret_cast<Function>(function)), data_(reinterpret_cast<void*>(data)) {}
  void add(double t, int bodies, const double* q, const double* v, double* g) const override {
    function_(t, bodies, q, v, g, data_);
  }

 private:
  Function function_;
  void* data_;
};

void bind_bodies_and_elements(py::class_<Model>& model) {
  model.def(py::init<const Vec3<double>&>(), py::arg("gravity") = Vec3<double>(0.0, 0.0, -9.81))
      .def("add_bodies", &add_bodies, py::arg("names"), py::arg("mass"), py::arg("inertia"), py::arg("position"),
           py::arg("orientation"), py::arg("velocity"), py::arg("omega"),
           py::arg("inertia_as_is") = std::vector<bool>(),
           "Adds bodies under a prefix (str) or names (list); returns the first index. `inertia_as_is`: for each body "
           "whether its inertia may violate the triangle inequality; without, none may.")
      .def(
          "add_joints",
          [](Model& model, const std::string& kind, const GivenNames& names, const Integers& bodies,
             const Doubles& origin, const Doubles& frame, const Doubles& parameters, const Integers& signals) {
            Elements list = read_elements(bodies, origin, frame, parameters, signals);
            return model.add_joints(kind, read_names(names), std::move(list.elements), list.parameters);
          },
          py::arg("kind"), py::arg("names"), py::arg("bodies"), py::arg("origin"), py::arg("frame"),
          py::arg("parameters"), py::arg("signals"), "Adds joints; returns the first index.")
      .def("add_coupler", &add_coupler, py::arg("name"), py::arg("coordinates"), py::arg("offset"), py::arg("signal"),
           "Adds a linear relation of coordinates (joint, name, factor); returns its index.")
      .def("add_point_on_curve", &add_point_on_curve, py::arg("name"), py::arg("bodies"), py::arg("origin"),
           py::arg("frame"), py::arg("knots"), py::arg("curve"), py::arg("direction"), py::arg("closed"),
           "Adds a point of b on a spline of a, ascending coefficients (k, 4, 3); returns its index.")
      .def(
          "add_forces",
          [](Model& model, const std::string& kind, const GivenNames& names, const Integers& bodies,
             const Doubles& origin, const Doubles& frame, const Doubles& parameters, const Integers& signals) {
            Elements list = read_elements(bodies, origin, frame, parameters, signals);
            return model.add_forces(kind, read_names(names), std::move(list.elements), list.parameters);
          },
          py::arg("kind"), py::arg("names"), py::arg("bodies"), py::arg("origin"), py::arg("frame"),
          py::arg("parameters"), py::arg("signals"), "Adds force elements; returns the first index.");
}

void bind_functions(py::class_<Model>& model) {
  model
      .def(
          "add_signal", [](Model& model, std::shared_ptr<TimeFunction> f) { return model.add_signal(std::move(f)); },
          py::arg("function"))
      .def("add_breaks", &Model::add_breaks, py::arg("times"), "Times at which users' forces are not smooth.")
      .def_property_readonly("breaks", &Model::breaks)
      .def(
          "add_user_force",
          [](Model& model, const std::string& name, py::function function, const py::object& origin) {
            model.add_user_force(name, std::make_shared<PythonForce>(std::move(function), name, origin));
          },
          py::arg("name"), py::arg("function"), py::arg("origin") = py::none(),
          "A function of (t, q (n, 7), v (n, 6)) that returns forces (n, 6). `origin`: the user's function and its "
          "bodies; `function` is then one of (t (k,), q (k, n, 7), v (k, n, 6)) that returns (k, n, 6).")
      .def(
          "add_compiled_force",
          [](Model& model, const std::string& name, std::uintptr_t function, std::uintptr_t data) {
            model.add_user_force(name, std::make_shared<CompiledForce>(function, data));
          },
          py::arg("name"), py::arg("address"), py::arg("data"), "The address of a C function; see linkwork.Model.")
      .def(
          "add_joint_force",
          [](Model& model, const std::string& name, int joint, const std::string& coordinate, const py::object& law) {
            CoordinateLawPtr compiled = py::isinstance<TimeFunction>(law)
                                            ? law_of_time(law.cast<std::shared_ptr<TimeFunction>>())
                                            : std::make_shared<PythonLaw>(law, name);
            model.add_joint_force(name, joint, coordinate, std::move(compiled));
          },
          py::arg("name"), py::arg("joint"), py::arg("coordinate"), py::arg("law"),
          "A function of (t, x, x_dot), or of time alone, along a free coordinate of a joint.");
}

void bind_contents(py::class_<Model>& model) {
  model
      .def_property_readonly(
          "joint_forces",
          [](const Model& model) {
            std::vector<std::pair<std::string, std::string>> out;
            for (const JointForce& force : model.joint_forces()) out.emplace_back(force.name, force.coordinate->name);
            return out;
          },
          "(name, coordinate) of the laws along coordinates.")
      .def_property_readonly(
          "joint_force_bodies",
          [](const Model& model) {
            std::vector<std::pair<int, int>> out;
            for (const JointForce& force : model.joint_forces()) out.emplace_back(force.i, force.j);
            return out;
          },
          "The two bodies of each law along a coordinate, -1 for the ground.")
      .def(
          "limited",
          [](const Model& model) {
            std::vector<std::tuple<std::string, int, double, int, double, std::string>> out;
            for (const Limited& it : model.limited())
              out.emplace_back(it.what, it.value.signal, it.value.constant, it.least.signal, it.least.constant,
                               it.than);
            return out;
          },
          "Functions of time that must not pass a bound: (what, its signal or -1, its number, signal and number of the "
          "bound, what that is).")
      .def_property_readonly("gravity", [](const Model& model) { return VectorXd(model.gravity()); })
      .def_property_readonly("body_count", [](const Model& model) { return model.bodies().size(); })
      .def_property_readonly("joint_count", [](const Model& model) { return model.joints().size(); })
      .def_property_readonly("force_count", [](const Model& model) { return model.forces().size(); })
      .def_property_readonly("row_count", &Model::row_count);
}

void bind_names(py::class_<Model>& model) {
  model.def("body_name", &Model::body_name, py::arg("body"))
      .def("joint_name", &Model::joint_name, py::arg("joint"))
      .def(
          "force_name", [](const Model& model, int force) { return model.force_names().name(force); }, py::arg("force"))
      .def(
          "joint_kind", [](const Model& model, int joint) { return joint_info(model.joints().at(joint).kind).name; },
          py::arg("joint"))
      .def(
          "joint_bodies",
          [](const Model& model, int joint) {
            const Element& element = model.joints().at(joint);
            const SpecialJoint* special = model.special_joint(joint);
            return special ? special->bodies() : std::vector<int>{element.i, element.j};
          },
          py::arg("joint"), "Indices of the bodies of a joint, two or, of a coupler, any number; -1 is the ground.")
      .def(
          "find_body", [](const Model& model, const std::string& name) { return model.body_names().find(name); },
          py::arg("name"), "Index of a name, -1 where there is none.")
      .def(
          "find_joint", [](const Model& model, const std::string& name) { return model.joint_names().find(name); },
          py::arg("name"), "Index of a name, -1 where there is none.")
      .def(
          "find_force", [](const Model& model, const std::string& name) { return model.force_names().find(name); },
          py::arg("name"), "Index of a name, -1 where there is none.")
      .def(
          "find_user_force",
          [](const Model& model, const std::string& name) { return model.own_force_names().find(name); },
          py::arg("name"), "Index of the name of one of the user's own forces, -1 where there is none.")
      .def("describe_row", &Model::describe_row, py::arg("row"))
      .def_property_readonly("longest_arm", &Model::longest_arm, "From a center of mass to a joint [m]; 0: none.")
      .def_property_readonly("joint_rows", [](const Model& model) {
        return py::array_t<int>(static_cast<py::ssize_t>(model.joint_rows().size()), model.joint_rows().data());
      });
}

void bind_state(py::class_<Model>& model) {
  model.def_property_readonly("mass", &masses)
      .def_property_readonly("inertia", &inertias)
      .def_property_readonly("inertia_as_is", &taken_as_they_are,
                             "Indices of the bodies whose inertia may be that of no real body.")
      .def("poses", &poses, py::arg("bodies"), "(k, 7) at t = 0, of bodies by index; -1 is the ground.")
      .def_property_readonly("q0", &Model::initial_q)
      .def_property_readonly("v0", &Model::initial_v)
      .def("with_initial_state", &Model::with_initial_state, py::arg("q"), py::arg("v"),
           py::arg("history") = std::vector<double>(),
           "A copy whose bodies are elsewhere at t = 0; joints stay where they are on the bodies.")
      .def_property_readonly("initial_history", &Model::initial_history, "See with_initial_state.")
      .def("with_weights", &Model::with_weights, py::arg("gravity"), py::arg("bodies"), py::arg("masses"),
           py::arg("inertias"), "A copy with another gravity, and other masses and inertias (3, 3) of some bodies.")
      .def(
          "joint_arrays", [](const Model& model) { return element_arrays(model.joints(), model.joint_parameters()); },
          "kind, bodies, origin, frame, first_parameter, parameters, signals: what add_joints took.")
      .def(
          "force_arrays", [](const Model& model) { return element_arrays(model.forces(), model.force_parameters()); },
          "kind, bodies, origin, frame, first_parameter, parameters, signals: what add_forces took.");
}

}  // namespace

void bind_model(py::module_& module) {
  py::class_<CoupledCoordinate>(module, "CoupledCoordinate", "A free coordinate of a joint, as it enters a coupler.")
      .def(py::init<int, std::string, double>(), py::arg("joint"), py::arg("name"), py::arg("factor"));
  py::class_<Model> model(module, "Model", "The constant description of a mechanism; see linkwork.Model.");
  bind_bodies_and_elements(model);
  bind_functions(model);
  bind_contents(model);
  bind_names(model);
  bind_state(model);
}

}  // namespace linkwork::python
