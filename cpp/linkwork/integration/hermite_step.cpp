#include "linkwork/integration/hermite_step.hpp"

namespace linkwork {

HermiteStep::HermiteStep(const System& system, const VectorXd& y, const VectorXd& y_new, double h)
    : y_(y), y_new_(y_new), h_(h), rates_(system.q_size()), rates_new_(system.q_size()) {
  const int nq = system.q_size(), nv = system.v_size();
  system.position_rates(y.head(nq), y.segment(nq, nv), rates_);
  system.position_rates(y_new.head(nq), y_new.segment(nq, nv), rates_new_);
}

void HermiteStep::interpolate(const System& system, double theta, VectorXd& y) const {
  const int nq = system.q_size();
  const double s = theta;
  y = (1 - s) * y_ + s * y_new_;
  y.head(nq) = (1 + 2 * s) * (1 - s) * (1 - s) * y_.head(nq) + s * s * (3 - 2 * s) * y_new_.head(nq) +
               h_ * (s * (1 - s) * (1 - s) * rates_ - s * s * (1 - s) * rates_new_);
  system.normalize(y.head(nq));
}

}  // namespace linkwork
