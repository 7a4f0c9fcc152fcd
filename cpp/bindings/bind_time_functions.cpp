#include "linkwork/model/time_function.hpp"
#include "python_function.hpp"

namespace linkwork::python {
namespace {

/// Function, first and second derivative: None where they are not known.
TimeFunctionPtr python_callback(py::object value, py::object rate, py::object acceleration, const std::string& what) {
  const auto wrapped = [&](py::object& function, const char* which) -> std::function<double(double)> {
    if (function.is_none()) return nullptr;
    return PythonFunction(std::move(function), what + which);
  };
  return callback(wrapped(value, ""), wrapped(rate, ", first derivative"),
                  wrapped(acceleration, ", second derivative"));
}

}  // namespace

// Long: one statement a function that Python may call.
void bind_time_functions(py::module_& module) {
  py::class_<TimeFunction, std::shared_ptr<TimeFunction>>(module, "TimeFunction",
                                                          "A quantity as a function of time [s], with two derivatives.")
      .def(
          "evaluate",
          [](const TimeFunction& f, double t) {
            const Signal<double> s = f.evaluate(t);
            return py::make_tuple(s.value, s.rate, s.acceleration);
          },
          py::arg("t"), "(value, rate, acceleration) at t.")
      .def_property_readonly("has_derivatives", &TimeFunction::has_derivatives)
      .def_property_readonly("of_time", &TimeFunction::of_time)
      .def_static(
          "characteristic",
          [](std::shared_ptr<TimeFunction> f, std::string of) {
            return std::const_pointer_cast<TimeFunction>(characteristic(std::move(f), std::move(of)));
          },
          py::arg("function"), py::arg("of"),
          "The same function of a coordinate or velocity of a force element; `of`: which, for messages.")
      .def_property_readonly(
          "breaks",
          [](const TimeFunction& f) {
            std::vector<Break> breaks;
            f.add_breaks(breaks);
            std::vector<std::pair<double, bool>> out;
            for (const Break& it : breaks) out.emplace_back(it.t, it.ends_step);
            return out;
          },
          "Times at which it is not smooth, and whether each ends a step whatever the tables say.")
      .def_static(
          "with_breaks",
          [](std::shared_ptr<TimeFunction> f, std::vector<double> times) {
            return std::const_pointer_cast<TimeFunction>(with_breaks(std::move(f), std::move(times)));
          },
          py::arg("function"), py::arg("times"), "The same function, not smooth at these times, either.")
      .def_static(
          "constant", [](double c) { return polynomial({c}); }, py::arg("value"))
      .def_static("polynomial", &polynomial, py::arg("coefficients"), "sum c_k t^k, ascending powers.")
      .def_static("cycloidal", &cycloidal, py::arg("rise"), py::arg("start"), py::arg("duration"),
                  "rise (s - sin(2 pi s) / 2 pi), s = (t - start) / duration between 0 and 1; constant beyond.")
      .def_static(
          "sum",
          [](const std::vector<std::shared_ptr<TimeFunction>>& terms) {
            return sum(std::vector<TimeFunctionPtr>(terms.begin(), terms.end()));
          },
          py::arg("terms"))
      .def_static("harmonic", &harmonic, py::arg("amplitude"), py::arg("frequency"), py::arg("phase") = 0.0,
                  py::arg("offset") = 0.0, "offset + amplitude sin(frequency t + phase); frequency in rad/s.")
      .def_static("piecewise_polynomial", &piecewise_polynomial, py::arg("breaks"), py::arg("coefficients"),
                  "Rows of ascending coefficients in t - breaks[i], flattened.")
      .def_static(
          "callback",
          [](py::object value, py::object rate, py::object acceleration, const std::string& what) {
            return std::const_pointer_cast<TimeFunction>(
                python_callback(std::move(value), std::move(rate), std::move(acceleration), what));
          },
          py::arg("value"), py::arg("rate") = py::none(), py::arg("acceleration") = py::none(),
          py::arg("what") = "function of time", "Python functions of t; `what` they are, in messages.");
}

}  // namespace linkwork::python
