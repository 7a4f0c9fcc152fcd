#pragma once

#include <vector>

#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/integration/interpolant.hpp"

namespace linkwork {

/// Finds contacts and stops that come and go within a step, so that the states at its ends, and those of its stages, know
/// nothing of them: bodies in free flight take long steps.
///
/// Depths d, see Wrenches, are functions of the poses. One that is negative at both ends of a step, rises at first and
/// falls at last, is below the tangents of both ends where it is concave in time, as that of spheres that pass each
/// other on straight ways, and of what is thrown at a wall: where the tangents meet below zero it has not been more.
/// Where they do not, d is looked at there, which is one of the ends of a shorter interval then.
class TouchSearch {
 public:
  /// Depths up to `least` are as good as zero [m or rad].
  TouchSearch(const Dynamics& dynamics, double least);

  /// A step begins at y, where `dynamics` is evaluated.
  void begin(const VectorXd& y) { begin(y, dynamics_.evaluation().switches); }
  /// The same where its switches are known.
  void begin(const VectorXd& y, const VectorXd& switches);
  /// It ends at (t + h, y_new), where `dynamics` is evaluated: whether it is worth a search.
  bool suspects(double t, double h, const VectorXd& y_new) {
    return suspects(t, h, y_new, dynamics_.evaluation().switches);
  }
  bool suspects(double t, double h, const VectorXd& y_new, const VectorXd& switches);

  /// The values of the switches there.
  const VectorXd& at_begin() const { return from_.values; }
  /// Of a suspect [1/s].
  double rate_at_begin(int which) const { return from_.rates[which]; }
  /// Of one, where `dynamics` is evaluated at (t + h, y_new), the end of that step [1/s].
  double rate_at_end(double t, double h, const VectorXd& y_new, int which);

  struct Touch {
    int which;     ///< switch
    double theta;  ///< a place in the step, 0 to 1, at which it is positive
  };
  /// Those of the step that was asked about last, ascending in theta.
  std::vector<Touch> find(const Interpolant& step, double t, double h);

 private:
  /// In a state: the values of the switches and their rates [1/s].
  struct Mark {
    VectorXd y, values, rates;
  };
  struct Sample {
    double theta, value, rate;  ///< over theta
  };

  void find_rates(double t, double seconds, Mark& mark);
  void look(const Interpolant& step, double t, double h, double theta, Mark& mark);
  static bool rises_and_falls(const Sample& a, const Sample& b) { return a.rate > 0.0 && b.rate < 0.0; }
  static Sample where_tangents_meet(const Sample& a, const Sample& b);
  bool may_touch(const Sample& a, const Sample& b) const;
  double touch_between(const Interpolant& step, double t, double h, int which, Sample a, Sample b);

  const Dynamics& dynamics_;
  double least_;
  Evaluation at_;
  Mark from_, to_, between_;
  std::vector<int> suspects_;
  VectorXd moved_, q_dot_;
};

}  // namespace linkwork
