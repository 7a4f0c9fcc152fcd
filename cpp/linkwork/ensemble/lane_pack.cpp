#include "linkwork/ensemble/lane_pack.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace linkwork {
namespace {

constexpr double restless = 1.0;  // way or angle of a step in which a lane is looked at more closely

class FactorsOfPack final : public StageFactors {
 public:
  FactorsOfPack(const LaneStructure& structure, LaneStepper& stepper, int l)
      : structure_(structure), stepper_(stepper), l_(l) {}

  double smallest_pivot() override {
    const double pivot = stepper_.smallest_pivot_ahead(l_);
    return structure_.keeps_order(stepper_.mechanism(l_), pivot) ? pivot : 0.0;
  }
  void solve(const ConstVector& b, MutableVector x, MutableVector lambda) override {
    stepper_.solve_ahead(l_, b, x, lambda);
  }

 private:
  const LaneStructure& structure_;
  LaneStepper& stepper_;
  int l_;
};

std::vector<Dynamics*> mechanisms_of(const std::vector<Lane*>& lanes) {
  std::vector<Dynamics*> out;
  for (Lane* lane : lanes) out.push_back(&lane->dynamics());
  return out;
}

}  // namespace

LanePack::LanePack(const LaneStructure& structure, const InstructionSet& instructions, std::vector<Lane*> lanes,
                   const ButcherTableau& tableau, const FixedSteps& steps)
    : structure_(structure),
      lanes_(std::move(lanes)),
      steps_(steps),
      stepper_(structure, instructions, mechanisms_of(lanes_), tableau),
      projection_(stepper_, mechanisms_of(lanes_)),
      spans_(stepper_.width()),
      shares_(stepper_.width(), 1.0),
      ends_(stepper_.width(), 0.0),
      watches_(structure, instructions, stepper_, lanes_),
      pivots_(lanes_.size()),
      state_(structure.y_size()),
      Phi_(structure.rows),
      Phi_dot_(structure.rows) {
  for (const Lane* it : lanes_) {
    limited_ = limited_ || it->limited();
    breaks_ = breaks_ || it->breaks().any();
  }
}

template <class Action>
void LanePack::each_lane(Action action) {
  for (int l = 0; l < static_cast<int>(lanes_.size()); ++l)
    if (lanes_[l]->alive()) action(l, *lanes_[l]);
}

/// But for those that leap, or wait.
template <class Action>
void LanePack::each_stepping(Action action) {
  for (int l = 0; l < static_cast<int>(lanes_.size()); ++l)
    if (lanes_[l]->stepping()) action(l, *lanes_[l]);
}

bool LanePack::any_lane() const {
  return std::any_of(lanes_.begin(), lanes_.end(), [](const Lane* lane) { return lane->alive(); });
}

void LanePack::run(const std::function<void()>& look) {
  for (std::int64_t step = first_step(); any_lane(); ++step) {
    begin_step(step);
    if (step == steps_.count()) break;
    stepper_.step(spans_, *this);
    finish_step(step);
    look();
  }
}

std::int64_t LanePack::first_step() const {
  const auto starts = [](const Lane* lane) { return std::max<std::int64_t>(lane->joins_at(), 0); };
  std::int64_t first = starts(lanes_.front());
  for (const Lane* lane : lanes_) first = std::min(first, starts(lane));
  return first;
}

void LanePack::evaluate_start(int times) {
  for (int l = 0; l < stepper_.width(); ++l) spans_.set(l, {});
  for (int k = 0; k < times; ++k) {
    stepper_.evaluate_rates(spans_, *this);
    each_lane([&](int l, Lane&) { hear(l); });
  }
}

/// Larger ones than ever are usual once there have been some.
void LanePack::note_all(int count, const double* t, const double* pivots, bool first) {
  for (int l = 0; l < count; ++l) {
    Pivots& its = pivots_[l];
    if (!(pivots[l] >= its.usual.least && pivots[l] < INFINITY && its.usual.most > 0.0)) {
      if (steps(l)) note(l, t[l], pivots[l], first);
    } else if (!first || !looked(l)) its.unheard.emplace_back(t[l], pivots[l]);
  }
}

void LanePack::note(int l, double t, double pivot, bool first) {
  Lane& lane = *lanes_[l];
  hear(l);
  if (structure_.keeps_order(lane.dynamics(), pivot)) lane.note(t, pivot, first);
  else lane.leave(t, "a small pivot changes the order of elimination");
  take_usual_pivots(l);
}

void LanePack::hear(int l) {
  lanes_[l]->hear(pivots_[l].unheard);
  pivots_[l].unheard.clear();
}

/// None where there is more to look at than the pivots, or nothing.
void LanePack::take_usual_pivots(int l) {
  const bool alone = structure_.symbolic.hubs.empty() && steps(l);
  pivots_[l].usual = alone ? lanes_[l]->usual_pivots() : SingularWatch::Range();
}

// --- one step ---

void LanePack::begin_step(std::int64_t step) {
  const double t = steps_.time(step);
  each_lane([&](int l, Lane&) { continue_lane(l, step); });
  const double h = step < steps_.count() ? steps_.size(step) : 0.0;
  for (int l = 0; l < stepper_.width(); ++l) spans_.set(l, {t, h});
  if (h == 0.0) each_lane([&](int l, Lane&) { spans_.set(l, {clock(l, step), 0.0}); });
  else if (breaks_) each_lane([&](int l, Lane& lane) { spans_.set(l, lane.breaks().span(t, steps_.time(step + 1))); });
  stepper_.evaluate(spans_, *this);
  if (h > 0.0) hold(step);
  watches_.begin_step();
  records_ = steps_.records(step);
  const bool needs_state =
      records_ || watches_.watched() || watches_.judged() || limited_ || !structure_.dropped.empty();
  each_lane([&](int l, Lane& lane) {
    if (lane.waits() || lane.joins_at() == step) return;
    lane.accept(t, step > 0 ? steps_.size(step - 1) : 0.0);
    if (lane.turns() && lane.alive()) lane.pass(t, watches_.state(l));
    if (needs_state && lane.alive()) begin_lane(l, step);
  });
  for (int l = 0; l < static_cast<int>(lanes_.size()); ++l) take_usual_pivots(l);
}

void LanePack::hold(std::int64_t step) {
  const double length = steps_.correction_length(step);
  std::fill(shares_.begin(), shares_.end(), share_of_correction(steps_.size(step), length));
  stepper_.hold(spans_, shares_.data());
  each_lane([&](int, Lane& lane) { lane.dynamics().correct_over(length); });
}

/// Those that join, or leap, have a state that is not the pack's.
void LanePack::continue_lane(int l, std::int64_t step) {
  Lane& lane = *lanes_[l];
  if (lane.waits()) {
    if (lane.joins_at() != step) return;
    lane.join();
    watches_.take_up(l, lane);
    set_state(l, lane.joining_state());
    return;
  }
  lane.expect_nothing();
  if (!lane.leaping()) return;
  lane.follow_leap(steps_.frame_time(step), steps_.step(), state_);
  set_state(l, state_);
  if (lane.has_jumps()) cross_breaks(l, step, state_);
}

/// In the step that ends there with the state y_new.
void LanePack::cross_breaks(int l, std::int64_t step, const VectorXd& y_new) {
  const double work = lanes_[l]->work_at_breaks(clock(l, step - 1), clock(l, step), watches_.state_before(l), y_new);
  if (work == 0.0) return;
  VectorXd y = y_new;
  y[y.size() - 1] += work;
  set_state(l, y);
}

void LanePack::set_state(int l, const VectorXd& y) {
  stepper_.set_state(l, y);
  watches_.set_state(l, y);
}

/// Where functions are evaluated for what begins there.
double LanePack::clock(int l, std::int64_t step) const {
  return lanes_[l]->breaks().clock(steps_.time(step), steps_.t_end());
}

bool LanePack::usual_in_redundant_rows(int l) const {
  return std::all_of(structure_.dropped.begin(), structure_.dropped.end(), [&](int row) {
    return lanes_[l]->usual_in_redundant_row(stepper_.position_violation(l, row), stepper_.velocity_violation(l, row));
  });
}

void LanePack::begin_lane(int l, std::int64_t step) {
  Lane& lane = *lanes_[l];
  const double t = clock(l, step);
  const bool last = step == steps_.count();
  const VectorXd& y = watches_.state(l);
  if (!lane.leaping() && (lane.changed() || !usual_in_redundant_rows(l))) {
    Evaluation& at = lane.begin(t, y);
    stepper_.violations(l, at.Phi, at.Phi_dot);
    lane.watch_redundant_rows(t, y);
  }
  if (structure_.inerters > 0 && !lane.leaping()) stepper_.inerters(l, lane.begin(t, y));
  if (lane.limited() && !lane.leaping()) {
    stepper_.violations(l, Phi_, Phi_dot_);
    lane.watch_limits(t, Phi_, Phi_dot_);
  }
  if (lane.alive() && records_) lane.record(t, steps_.frame_time(step), y, last);
  if (lane.judged() && step == 0) lane.look_for_touches(t, 0.0, y, y, stepper_.switches(l));
  else if (lane.judged()) look_for_touches(l, step);
  const double potential = stepper_.potential(l);
  if (lane.alive()) lane.balance(step, y, potential);
  if (!lane.stepping()) return;
  const double kinetic = watches_.kinetic_energy(l, lane.dynamics().evaluation(), y);
  if (last) {
    lane.sample(y, kinetic, potential, stepper_.switches(l));
    lane.end(steps_.t_end(), y);
    return;
  }
  FactorsOfPack factors(structure_, stepper_, l);
  if (lane.watches())
    lane.look_ahead(step, steps_, watches_.speeds(l), y, structure_.inerters == 0 ? &factors : nullptr);
  lane.finish_record(t, step == 0);
  if (lane.stepping() || (lane.moves() && !lane.leaping())) lane.sample(y, kinetic, potential, stepper_.switches(l));
  if (!lane.moves()) return;
  lane.move(step, y);
  watches_.hand_on(l, lane);
}

/// Of the step before.
void LanePack::look_for_touches(int l, std::int64_t step) {
  const double t = steps_.time(step - 1), h = steps_.size(step - 1);
  lanes_[l]->look_for_touches(t, h, watches_.state_before(l), watches_.state(l), stepper_.switches(l));
}

void LanePack::finish_step(std::int64_t step) {
  check_size(step);
  stepper_.normalize();
  std::fill(ends_.begin(), ends_.end(), steps_.time(step + 1));
  if (breaks_) each_lane([&](int l, Lane&) { ends_[l] = clock(l, step + 1); });
  projection_.stabilize(ends_, *this);
  each_lane([&](int l, Lane&) { hear(l); });
  const double t = steps_.time(step), h = steps_.size(step);
  watches_.end_step(h);
  each_stepping([&](int l, Lane& lane) {
    if (lane.has_jumps()) cross_breaks(l, step + 1, watches_.state(l));
  });
  if (!watches_.watched() && !watches_.judged()) return;
  each_stepping([&](int l, Lane& lane) {
    const VectorXd& y = watches_.state_before(l);
    if (lane.judged()) lane.sample_step(t, h, y, watches_.state(l), watches_.rates(l));
    if (lane.watches()) lane.look_back(t, h, y);
  });
}

/// Lanes that diverge, or whose numbers are none, leave, and stay where they are no burden.
void LanePack::check_size(std::int64_t step) {
  const double t = steps_.time(step + 1), h = steps_.size(step);
  const double* largest = stepper_.largest_number();
  each_stepping([&](int l, Lane& lane) {
    if (!std::isfinite(largest[l])) lane.leave(t, "a number is not finite");
  });
  largest = stepper_.largest_velocity();
  each_stepping([&](int l, Lane& lane) {
    if (largest[l] * h < restless) return;
    stepper_.state(l, state_);
    lane.check(t, h, state_);
  });
  for (int l = 0; l < static_cast<int>(lanes_.size()); ++l)
    if (!lanes_[l]->alive()) stepper_.set_state(l, lanes_[l]->dynamics().initial_y());
}

}  // namespace linkwork
