#include <pybind11/typing.h>

#include <array>
#include <optional>

#include "bindings.hpp"
#include "linkwork/model/joint_coordinates.hpp"
#include "linkwork/model/model.hpp"

namespace linkwork::python {
namespace {

const std::string& name_of(const auto& info) { return info.name; }
std::string name_of(const FreeCoordinate* coordinate) { return std::string(coordinate->name); }

/// {name: info}
template <class Info>
py::typing::Dict<py::str, std::remove_pointer_t<Info>> by_name(const std::vector<Info>& infos) {
  py::typing::Dict<py::str, std::remove_pointer_t<Info>> out;
  for (const Info& info : infos) out[py::str(name_of(info))] = info;
  return out;
}

void bind_parameters(py::module_& module) {
  using Values = ParameterInfo::Values;
  const auto value = [](auto member) { return [member](const ParameterInfo& it) { return it.value.*member; }; };
  constexpr std::array takes = {"function", "differentiable", "number", "whole_number", "characteristic"};
  py::class_<ParameterInfo>(module, "ParameterInfo", "A parameter of a kind of joint or force.")
      .def_readonly("name", &ParameterInfo::name)
      .def_readonly("unit", &ParameterInfo::unit, "Such as \"N s/m\" or \"N/m^exponent\"; \"\" for a mere number.")
      .def_readonly("meaning", &ParameterInfo::meaning)
      .def_property_readonly(
          "takes", [takes](const ParameterInfo& it) { return takes[static_cast<std::size_t>(it.takes)]; },
          "\"function\" (of time), \"differentiable\", \"number\", \"whole_number\" or \"characteristic\".")
      .def_property_readonly("constant", &ParameterInfo::constant, "A number, no function.")
      .def_property_readonly("usual", value(&Values::usual), "Where it is not given; None: it must be.")
      .def_property_readonly("initial_distance", value(&Values::initial_distance),
                             "Where it is not given: that of the two points at the initial pose.")
      .def_property_readonly("example", value(&Values::example), "Of the usual size.")
      .def_property_readonly(
          "least",
          [](const ParameterInfo& it) {
            return it.value.bounds.any() ? std::optional(it.value.bounds.least) : std::nullopt;
          },
          "The least number, if there is one.")
      .def_property_readonly(
          "above", [](const ParameterInfo& it) { return it.value.bounds.above; }, "Numbers are above the bound.")
      .def_property_readonly("not_above", value(&Values::not_above), "Another parameter, or \"\".");
}

void bind_equations(py::module_& module) {
  py::class_<EquationInfo>(module, "EquationInfo", "A constraint equation of a kind of joint.")
      .def_readonly("name", &EquationInfo::name)
      .def_property_readonly(
          "quantity",
          [](const EquationInfo& it) {
            return std::array{"translation", "rotation", "distance", "velocity",
                              "relation"}[static_cast<std::size_t>(it.quantity)];
          },
          "\"translation\", \"rotation\", \"distance\", \"velocity\" (non-holonomic) or \"relation\".")
      .def_property_readonly(
          "axis",
          [](const EquationInfo& it) {
            return it.axis.empty() ? std::nullopt : std::optional(static_cast<int>(it.axis.front()));
          },
          "Of a translation or rotation that is held at zero: the axis of the joint along or about which, 0 to 2.")
      .def_property_readonly(
          "perpendicular",
          [](const EquationInfo& it) {
            std::vector<std::pair<int, int>> out;
            for (const auto& [of_a, of_b] : it.perpendicular)
              out.emplace_back(static_cast<int>(of_a), static_cast<int>(of_b));
            return out;
          },
          "Of such a rotation: axes of a and of b that are perpendicular; of two pairs the products are equal.");
}

}  // namespace

void bind_kinds(py::module_& module) {
  bind_parameters(module);
  bind_equations(module);
  py::class_<FreeCoordinate>(module, "CoordinateInfo", "A free coordinate of a kind of joint.")
      .def_property_readonly("name", [](const FreeCoordinate& it) { return it.name; })
      .def_property_readonly("unit", [](const FreeCoordinate& it) { return it.unit; });
  py::class_<KindInfo>(module, "KindInfo", "A registered kind of joint or force.")
      .def_readonly("name", &KindInfo::name)
      .def_readonly("rows", &KindInfo::rows)
      .def_readonly("placement", &KindInfo::placement)
      .def_property_readonly(
          "parameters", [](const KindInfo& kind) { return by_name(kind.parameters); }, "By name, in their order.")
      .def_property_readonly(
          "equations", [](const KindInfo& kind) { return by_name(kind.equations); },
          "By name, in the order of the rows.")
      .def_property_readonly(
          "coordinates", [](const KindInfo& kind) { return by_name(kind.coordinates); },
          "Those that are free, by name.")
      .def_property_readonly("velocity_rows", &KindInfo::velocity_rows, "How many of the last rows are of velocities.")
      .def_readonly("symmetric", &KindInfo::symmetric, "The same joint where a and b change places.")
      .def_readonly("driver", &KindInfo::driver, "It prescribes a motion, its parameter.")
      .def_readonly("documentation", &KindInfo::documentation);
  module.def("joint_kinds", [] {
    std::vector<KindInfo> out;
    for (const JointKind& kind : joint_kinds()) out.push_back(kind.info);
    return out;
  });
  module.def(
      "special_joint_kinds", &special_joint_kinds,
      "Of joints that a point and axes on two bodies do not describe; their numbers follow those of joint_kinds.");
  module.def("force_kinds", [] {
    std::vector<KindInfo> out;
    for (const ForceKind& kind : force_kinds()) out.push_back(kind.info);
    return out;
  });
}

}  // namespace linkwork::python
