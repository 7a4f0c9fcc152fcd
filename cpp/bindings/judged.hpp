#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "bindings.hpp"
#include "linkwork/integration/accumulated_error.hpp"

/// What the kept steps of a run say of it, by names that linkwork.accuracy reads.
namespace linkwork::python {

/// (from, until, of each connected part)
inline py::list to_list(const std::vector<Peaks>& peaks) {
  py::list out;
  for (const Peaks& it : peaks) out.append(py::make_tuple(it.t, it.end, it.accelerations));
  return out;
}

/// Of each body what is of its connected part.
inline void add_parts(const AccumulatedError& found, const System& system, py::dict& out) {
  const ConnectedParts& parts = ConnectedParts::of(system);
  const int n = system.body_count();
  VectorXd length(n), speed(n), largest_speed(n);
  Eigen::VectorXi part(n);
  for (int body = 0; body < n; ++body) {
    length[body] = found.rest[parts.of_body(body)].length;
    speed[body] = found.rest[parts.of_body(body)].speed;
    largest_speed[body] = found.speeds[parts.of_body(body)];
    part[body] = parts.of_body(body);
  }
  out["rest_length"] = length;
  out["rest_speed"] = speed;
  out["largest_speed"] = largest_speed;
  out["connected_part"] = part;
  out["peaks"] = to_list(found.peaks);
}

/// With `steps` one by one, or none of them.
inline py::dict to_dict(const AccumulatedError& found, const System& system, bool steps_too) {
  py::list steps;
  for (const JudgedStep& it : steps_too ? std::span<const JudgedStep>(found.steps) : std::span<const JudgedStep>())
    steps.append(py::make_tuple(it.t, it.h, it.state,
                                std::isnan(it.reactions) ? py::object(py::none()) : py::float_(it.reactions)));
  py::dict out;
  out["steps"] = steps;
  out["taken"] = found.steps.size();
  out["failed"] = found.failed;
  out["state"] = found.state;
  out["growth"] = std::isnan(found.growth) ? py::object(py::none()) : py::float_(found.growth);
  out["unstable"] = found.unstable;
  out["lost"] = std::isnan(found.lost) ? py::object(py::none()) : py::float_(found.lost);
  out["at_most"] = found.at_most;
  out["grows"] = found.grows;
  out["local_error"] = found.local_error;
  out["reactions_by_state"] = found.reactions_by_state;
  out["yielding"] = std::isnan(found.yielding) ? 0.0 : found.yielding;
  out["contacts_begin"] = found.contacts_begin;
  out["onset"] = found.onset;
  out["rounding"] = found.rounding;
  out["violation"] = found.violation;
  out["rate"] = found.rate;
  out["slowness"] = found.slowness;
  out["suddenness"] = found.suddenness;
  out["seconds"] = found.seconds;
  out["kinetic_share"] = found.kinetic_share;
  out["carried"] = found.carried;
  out["body"] = found.body;
  add_parts(found, system, out);
  out["rest_energy"] = found.rest_energy;
  py::list energies;
  for (const EnergyOfPart& it : found.energies)
    energies.append(py::make_tuple(it.body, it.error, it.lasting, it.rate, it.slowness, it.suddenness));
  out["energies"] = energies;
  return out;
}

}  // namespace linkwork::python
