#pragma once

#include <map>
#include <optional>
#include <vector>

#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/integration/approach.hpp"
#include "linkwork/integration/interpolant.hpp"

namespace linkwork {

/// Finds contacts and stops that come and go within a step, so that the states at its ends, and those of its stages,
/// know nothing of them: bodies in free flight take long steps.
///
/// Depths d, see Wrenches, are functions of the poses, and so of the time within a step. A step in which bodies cannot
/// come near enough, see Approach, is free of touches. Of the others an interval is where the value a and the rate a'
/// at its start say so, with those at its end, b and b', and a bound M of the second derivative: with s from 0 to 1,
///   d(s) <= a + a' s + M s^2 / 2  and  d(s) <= b - b' (1 - s) + M (1 - s)^2 / 2.
/// Where both parabolas meet above zero, d is looked at there, which is one end of two shorter intervals then. M is the
/// larger one of the second derivatives of the cubic with these values and rates at the ends, and a part of their size.
/// Where a limit is a function of time, the cubic is that of the same depths with the limit at rest, and the bound of the
/// second derivative of the limit is added: however often it comes and goes within the step.
///
/// d of spheres of radii R together passes a peak within the time they need for R, however long the step: what is
/// looked at is d (2 R - d) = R^2 - |p|^2, p from center to center, which is as smooth as the motion.
class TouchSearch {
 public:
  /// Depths up to `least` are as good as zero [m or rad].
  TouchSearch(const Dynamics& dynamics, double least);
  TouchSearch(const TouchSearch&) = delete;
  TouchSearch& operator=(const TouchSearch&) = delete;

  /// A step begins at y, where the switches are these, on these sides of zero; none: on the sides of their values.
  void begin(const VectorXd& y, const VectorXd& switches, const std::vector<char>& sides = {});
  /// Whether a depth may come to zero within the step from there, at the end of which, with these switches, it is not
  /// positive. What is positive from the start is left out.
  bool suspects(const StepEnds& step, const VectorXd& switches);

  /// Somewhere in an interval.
  struct Place {
    double at, value;
  };
  struct Touch {
    int which;     ///< switch
    double theta;  ///< a place in the step, 0 to 1, at which it is positive
  };
  /// Those of the step that was asked about last, ascending in theta. A StepSizeError, where a limit moves too fast to be
  /// followed through so long a step.
  std::vector<Touch> find(const Interpolant& step);

  /// Up to which place every contact and stop stays on the side of zero that it is on at the start, be it in contact or
  /// apart; 1: in all of the step.
  double clear_until(const Interpolant& step, const StepEnds& ends);

  /// Of a switch: its force element.
  int element(int which) const { return approach_.owner(which).element; }
  /// The values of the switches where the step begins.
  const VectorXd& at_begin() const { return at_begin_; }
  /// Rates of a switch in the state y at t, the start or the end of a step of h [1/s].
  double rate_at_start(double t, double h, const VectorXd& y, int which) { return rate({t, 0.0, h, y}, which); }
  double rate_at_end(double t, double h, const VectorXd& y, int which) { return rate({t, 1.0, h, y}, which); }

 private:
  /// A state at the place theta of a step of h that it was looked at in, with others beside it on the way of the
  /// motion.
  struct Look {
    double t, theta, h;
    VectorXd y, q_beside = {}, q_beyond = {};
    double beside = 0.0;  ///< [s]
  };
  struct Sample {
    double theta, value, rate;     ///< over theta
    double at_rest, rate_at_rest;  ///< the same with the limit where it is at the start of the step
  };
  /// That is not positive at the start; `free`: values up to this are as good as zero.
  struct Suspect {
    int which;
    double radii;  ///< of spheres, together, else 0
    double free;
    Sample from, to;
  };

  double value(const Suspect& of, double depth) const {
    return of.radii > 0.0 ? depth * (2.0 * of.radii - depth) : depth;
  }
  void look_beside(Look& look) const;
  VectorXd depths(double t, const VectorXd& y);
  bool clear_at(const Interpolant& step, double theta);
  double depth(double t, const ConstVector& q, const ConstVector& v, int which);
  void move_limit(const Look& look, const Approach::Limit& limit, Sample& sample) const;
  Place highest(const Suspect& of, const Sample& a, const Sample& b, double more) const;
  double bend_of_limit(const Suspect& of, const Sample& a, const Sample& b) const;
  bool may_come_and_go(const Suspect& of, const Sample& a, const Sample& b) const;
  Sample look_between(const Interpolant& step, const Suspect& of, const Sample& a, const Sample& b, double place);
  [[noreturn]] void refuse(const Suspect& of) const;
  Sample sample(const Look& look, const Suspect& of);
  double rate(Look look, int which);
  Look look_at(const Interpolant& step, double theta) const;
  std::optional<double> first_touch(const Interpolant& step, const Suspect& of, const Sample& a, const Sample& b);

  const Dynamics& dynamics_;
  double least_;
  Approach approach_;
  std::size_t count_;                     ///< of switches
  std::map<int, ForceElement> elements_;  ///< of those that were asked
  VectorXd at_begin_, y_;
  std::vector<char> sides_;
  double t_ = 0.0, h_ = 0.0;  ///< of the step that was asked about
  std::vector<Suspect> suspects_;
  int looks_left_ = 0;
};

}  // namespace linkwork
