#include "linkwork/model/joint_force.hpp"

#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {
namespace {

class LawOfTime final : public CoordinateLaw {
 public:
  explicit LawOfTime(TimeFunctionPtr function) : function_(std::move(function)) {}
  double effort(double t, double, double) const override { return function_->evaluate(t).value; }
  bool of_time() const override { return true; }

 private:
  TimeFunctionPtr function_;
};

}  // namespace

CoordinateLawPtr law_of_time(TimeFunctionPtr function) { return std::make_shared<LawOfTime>(std::move(function)); }

void JointForce::evaluate(double t, const BodyState<double>& body_i, const BodyState<double>& body_j,
                          HistoryVariable<double>& history, Wrenches<double>& out) const {
  Equation<double> row;
  coordinate->evaluate(at, body_i, body_j, row);
  const double rate = row.rate(body_i, body_j);
  if (coordinate->angle()) {
    row.Phi = history.next = continued(row.Phi, history.last);
    history.rate = rate;
  }
  const double effort = law->effort(t, row.Phi, rate);
  act(row, effort, out);
  out.power = effort * rate;
}

}  // namespace linkwork
