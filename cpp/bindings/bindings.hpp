#pragma once

#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "linkwork/math/types.hpp"

namespace linkwork {

class Dynamics;
class System;
struct Frames;

}  // namespace linkwork

namespace linkwork::python {

namespace py = pybind11;

/// C-contiguous float64 and int32 arrays, converted where needed.
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<int, py::array::c_style | py::array::forcecast>;

void bind_errors(py::module_& module);
void bind_time_functions(py::module_& module);
void bind_kinds(py::module_& module);
void bind_model(py::module_& module);
void bind_assembler(py::module_& module);
void bind_options(py::module_& module);
void bind_formulation(py::module_& module);
void bind_rank_report(py::module_& module);
void bind_rank(py::class_<Dynamics>& dynamics);
void bind_statistics(py::class_<Dynamics>& dynamics);
void bind_integration(py::module_& module);
void bind_driven_motion(py::module_& module);
void bind_ensemble(py::module_& module);

/// Hands a vector over to numpy without a copy.
py::array_t<double> to_numpy(std::vector<double>&& values, std::vector<py::ssize_t> shape);

/// Frames of a run by name, each an array (frames, ...).
py::dict frames_to_dict(Frames&& frames, const System& system);

/// OptionError: a vector of another size.
void check_size(const ConstVector& vector, Eigen::Index size, const char* name);

}  // namespace linkwork::python
