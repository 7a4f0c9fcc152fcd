#include "linkwork/ensemble/lane_watches.hpp"

#include <algorithm>

namespace linkwork {

LaneWatches::LaneWatches(const LaneStructure& structure, const InstructionSet& instructions, const LaneStepper& stepper,
                         const std::vector<Lane*>& lanes)
    : structure_(structure),
      kernels_(lane_speeds(instructions)),
      stepper_(stepper),
      layout_(stepper.layout()),
      states_(lanes.size(), VectorXd(structure.y_size())),
      before_(states_),
      known_(lanes.size(), 0),
      known_before_(known_) {
  layout_.size(in_loops_, structure_.bodies);
  layout_.size(rotors_, 3 * structure_.bodies);
  layout_.size(speeds_, 6);
  layout_.size(rates_, velocity_size * structure_.bodies);
  for (AlignedDoubles* one : {&squared_length_, &kinetic_}) layout_.size(*one, 1);
  layout_.size(found_, 2);
  for (int l = 0; l < static_cast<int>(lanes.size()); ++l) {
    const Lane& lane = *lanes[l];
    watched_ = watched_ || lane.watches();
    judged_ = judged_ || lane.judged();
    layout_.give(lane.rotors().data(), lane.rotors().size(), l, rotors_, 0);
    if (lane.watches())
      for (int body = 0; body < structure_.bodies; ++body)
        in_loops_[layout_.index(body, l)] = lane.in_loops()[static_cast<std::size_t>(body)] ? 1.0 : 0.0;
    if (!lane.judged()) continue;
    squared_length_[l] = lane.run()->sampling.squared_length();
    every_body_ = lane.run()->sampling.every_body();
  }
}

void LaneWatches::begin_step() {
  const double* y = stepper_.states().data();
  if (watched_) kernels_.speeds(structure_.bodies, in_loops_.data(), rotors_.data(), y, speeds_.data());
  if (judged_) kernels_.kinetic_energy(structure_.bodies, stepper_.mass().data(), y, kinetic_.data());
}

Speeds LaneWatches::speeds(int l) const {
  const auto number = [&](int k) { return speeds_[layout_.index(k, l)]; };
  return {number(0), number(1), {number(2), number(3)}, {number(4), number(5)}};
}

double LaneWatches::kinetic_energy(int l, const Evaluation& at, const VectorXd& y) const {
  if (structure_.inerters == 0) return kinetic_[l];
  const System& system = stepper_.mechanism(l).system();
  return system.kinetic_energy(at, y.segment(system.q_size(), system.v_size()));
}

void LaneWatches::end_step(double h) {
  if (judged_)
    kernels_.rates(structure_.bodies, every_body_, h, squared_length_.data(), stepper_.states_before_step().data(),
                   stepper_.states().data(), rates_.data(), found_.data());
  std::swap(states_, before_);
  std::swap(known_, known_before_);
  std::fill(known_.begin(), known_.end(), 0);
}

void LaneWatches::take_up(int l, Lane& lane) {
  if (!lane.judged()) return;
  const VectorXd& rates = lane.run()->sampling.rates();
  layout_.give(rates.data(), rates.size(), l, rates_, 0);
}

void LaneWatches::hand_on(int l, Lane& lane) const {
  if (lane.judged()) layout_.take(rates_, l, 0, lane.run()->sampling.rates());
}

const VectorXd& LaneWatches::state(int l) {
  if (!std::exchange(known_[l], 1)) stepper_.state(l, states_[l]);
  return states_[l];
}

const VectorXd& LaneWatches::state_before(int l) {
  if (!std::exchange(known_before_[l], 1)) stepper_.state_before_step(l, before_[l]);
  return before_[l];
}

void LaneWatches::set_state(int l, const VectorXd& y) {
  states_[l] = y;
  known_[l] = 1;
}

}  // namespace linkwork
