#include <cmath>
#include <cstdio>

#include "bindings.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork::python {
namespace {

py::object number_or_none(double value) { return std::isnan(value) ? py::object(py::none()) : py::float_(value); }

/// The end of a message about a moment of a run.
std::string when(double time) {
  if (std::isnan(time)) return "";
  char text[48];
  std::snprintf(text, sizeof text, " (t = %.6g s)", time);
  return text;
}

/// Raises the class of linkwork.errors that has the error's name.
void raise(const Error& error) {
  const py::object type = py::module_::import("linkwork.errors").attr(error.kind());
  py::dict residuals;
  for (const auto& [name, value] : error.details.residuals) residuals[py::str(name)] = value;
  const py::object instance =
      type(py::str(error.what() + when(error.details.time)), py::arg("code") = error.code(),
           py::arg("bodies") = error.details.bodies, py::arg("joints") = error.details.joints,
           py::arg("time") = number_or_none(error.details.time), py::arg("step") = number_or_none(error.details.step),
           py::arg("residuals") = residuals, py::arg("forces") = error.details.forces,
           py::arg("subject") = error.details.subject, py::arg("field") = error.details.field,
           py::arg("stage") = error.details.stage > 0 ? py::object(py::int_(error.details.stage)) : py::none());
  PyErr_SetObject(type.ptr(), instance.ptr());
}

}  // namespace

void check_size(const ConstVector& vector, Eigen::Index size, const char* name) {
  if (vector.size() != size)
    throw OptionError(
        "shape", std::string(name) + " has " + std::to_string(vector.size()) + " entries, not " + std::to_string(size));
}

void bind_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const Error& error) {
      raise(error);
    }
  });
}

}  // namespace linkwork::python
