#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "linkwork/integration/embedded_pair.hpp"
#include "linkwork/model/model.hpp"

namespace linkwork {

/// The times at which what acts on a mechanism is known to be not smooth: those of its functions of time, of its users'
/// forces, and others that are given.
///
/// At a break a function has two values, so it is never evaluated there: what ends at a break sees the time `before`
/// it, what begins there the time `after` it, which differ by some units in the last place. So a function may count the
/// break itself on either side, and be off by as much where it computes it otherwise.
///
/// Several functions may break at one time up to roundoff, such as 0.3 and 0.1 + 0.2. Whatever is from the first to the
/// last of these breaks is at one break: never after the one and before the other.
class BreakPoints {
 public:
  BreakPoints(const Model& model, const std::vector<double>& given);
  explicit BreakPoints(std::vector<double> times);

  /// Of steps h that are counted from `origin`, of a run that begins and ends at `ends`: where one of them ends at a
  /// break, up to roundoff or a billionth of the step, the break is where it ends, too.
  void meet_steps(double origin, double h, std::array<double, 2> ends);

  /// The first break after t at which a step ends in any case; infinite where there is none.
  double next(double t) const;
  bool at(double t) const { return find(t) != nullptr; }
  std::vector<double> times() const;  ///< of those at which steps end, ascending
  bool any() const { return !ends_.empty(); }
  /// What there is from t, where a step begins, up to just before the next such break, in whole steps h where that is
  /// not the end of one [s]; infinite where there is none.
  double room(double t, double h) const;
  /// Where functions are evaluated for what begins or ends at t.
  double after(double t) const;
  double before(double t) const;
  /// The same of a frame at t in a run that ends at t_end: after a break, but before it where the run ends at it.
  double clock(double t, double t_end) const { return t < before(t_end) ? after(t) : before(t); }
  /// The times of a step from t to t_new, between breaks at its ends.
  StepSpan span(double t, double t_new) const;

  /// The first of the other knots between t and t_new where it is the only one; else t_new. One knot in a step is
  /// cheaply its end; where there are several a step may go over them. One just after t counts as behind.
  double only_knot(double t, double t_new) const;
  /// The first of the other knots after t.
  double next_knot(double t) const;
  /// Whether a step of a method sees what tables with knots inside it do: their integrals over the step, and those of
  /// the integrals, are known, and the weights of the stages must give them as well as the estimate of the error lets
  /// expect, or to `relative` of what the table does in the step. A pulse between the stages is then not leapt over.
  bool seen(const EmbeddedPair& pair, const StepSpan& step, double relative) const;

 private:
  /// Breaks that are one up to roundoff.
  struct Cluster {
    double first, last;
  };
  const Cluster* find(double t) const;
  const Cluster* following(double t) const;
  void add_end(double t);
  void merge();
  void add_watched(const Model& model);
  static bool seen(const TimeFunction& function, const EmbeddedPair& pair, const StepSpan& step, double relative);

  std::vector<Cluster> ends_;  ///< a step lands on the first of each, what lies between begins after the last
  std::vector<double> knots_;
  std::vector<TimeFunctionPtr> watched_;
};

}  // namespace linkwork
