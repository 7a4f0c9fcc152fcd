#pragma once

#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

#include "bindings.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork::python {

inline std::string at_time(double t) {
  char text[48];
  std::snprintf(text, sizeof text, " at t = %.6g s", t);
  return text;
}

/// A value in a message.
inline std::string shown(const py::handle& value) {
  constexpr std::size_t longest = 80;
  const auto text = py::repr(value).cast<std::string>();
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

/// Real numbers, or objects that may be such: of complex ones a part would be lost, and of times their unit.
inline bool is_real(const py::array& found) { return found && std::strchr("biufO", found.dtype().kind()); }

/// A Python function of numbers that returns a number; `what` it is for, in messages.
class PythonFunction {
 public:
  PythonFunction(py::object function, std::string what)
      : function_(new py::object(std::move(function)), &release), what_(std::move(what)) {}

  template <class... Numbers>
  double operator()(double t, Numbers... rest) const {
    const py::gil_scoped_acquire gil;
    const py::object given = (*function_)(t, rest...);
    if (PyFloat_Check(given.ptr())) return PyFloat_AS_DOUBLE(given.ptr());  // numpy.float64 is one
    if (is_real(py::array::ensure(given))) {
      const double value = PyFloat_AsDouble(given.ptr());
      if (!PyErr_Occurred()) return value;
    }
    PyErr_Clear();
    throw ModelError("not_a_number", what_ + ": returned " + shown(given) + at_time(t) + ", not a number");
  }

 private:
  static void release(const py::object* function) {
    const py::gil_scoped_acquire gil;
    delete function;
  }
  std::shared_ptr<const py::object> function_;
  std::string what_;
};

}  // namespace linkwork::python
