#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "linkwork/formulation/dynamics.hpp"

namespace linkwork {

/// A time on the way, and the least singular value there.
struct SingularValueAt {
  double at = INFINITY, value = 0.0;
};

/// Where in a bracket, b lower than a and c, the value is least: in a singular pose it comes down to zero like |t|.
/// Ends early where it does not.
SingularValueAt least_value(SingularValueAt a, SingularValueAt b, SingularValueAt c,
                            const std::function<double(double)>& value_at);
/// Whether that is a zero.
bool vanishes(const SingularValueAt& a, const SingularValueAt& least, const SingularValueAt& c);

/// A zero, and others on the ways from it to both ends: where a motion turns round beside the pose, or loops that do not
/// know of each other pass theirs. Ascending.
std::vector<SingularValueAt> zeros_around(const SingularValueAt& zero, const SingularValueAt& before,
                                          const SingularValueAt& after, const std::function<double(double)>& value_at);

/// Lists the singular poses that a motion passes, each once.
///
/// Where the least singular value of the constraint matrix, which goes linearly to zero and up again, has been less
/// than before and after, its least is searched between the states of the motion; one that vanishes is a pose, if the
/// rank says so, too. Far from poses the value of the smallest pivot, which is no less, does as well.
class SingularPoseSearch {
 public:
  explicit SingularPoseSearch(Dynamics& dynamics) : dynamics_(dynamics) {}

  /// The motion begins anew; `away`: not in a pose that is listed already, however near.
  void restart(bool away = false);
  /// A state of the motion with its least singular value; on the way to it as many parts are looked at. True where
  /// `dynamics` was evaluated somewhere else.
  bool pass(double t, double value, const VectorXd& y, int parts = 1);
  /// The last one before a leap: its least singular value. Leaves `dynamics` evaluated somewhere else.
  double look_to(double t, const VectorXd& y, int parts = 1);
  /// The last one of all, which may be singular itself. Leaves `dynamics` evaluated somewhere else.
  void finish(double t, const VectorXd& y, int parts = 1);
  /// A pose that was found otherwise: the motion begins anew there. Leaves `dynamics` evaluated there.
  void list(double t, const VectorXd& y);

  /// Time of the last state, -infinity where there is none.
  double last() const { return count_ > 0 ? marks_[2].t : -INFINITY; }
  double last_listed() const { return last_listed_; }  ///< time of the last pose, or -infinity
  /// The least singular value. Leaves `dynamics` evaluated there.
  double value_at(double t, const VectorXd& y);

  void keep(Archive& archive) { archive(earlier_, marks_, count_, highest_, away_, last_listed_); }

 private:
  struct Mark {
    double t = 0.0, value = 0.0;
    VectorXd y;
    void keep(Archive& archive) { archive(t, value, y); }
  };

  bool mark(double t, double value, const VectorXd& y);
  bool worth_a_search(double value) const;
  SingularValueAt sample(const Mark& mark);
  void search_around();
  void search_next();
  SingularValueAt sample_between(const SingularValueAt& a, const SingularValueAt& c, double part);
  bool search_single(const SingularValueAt& a, const SingularValueAt& c);
  bool search_between(const Mark& before, const Mark& after);
  bool search(SingularValueAt a, SingularValueAt b, SingularValueAt c);
  bool list_zero(const SingularValueAt& zero);
  void interpolate(double t, VectorXd& y) const;
  void interpolate(const Mark& from, const Mark& to, double t, VectorXd& y) const;

  Dynamics& dynamics_;
  std::array<Mark, 3> marks_;  ///< the last ones
  Mark earlier_;               ///< the one before them
  int count_ = 0;              ///< of all four
  double highest_ = 0.0;       ///< value since the last pose that was listed
  bool away_ = false;          ///< the motion begins anew outside of the last pose
  double last_listed_ = -INFINITY;
  VectorXd y_;
};

}  // namespace linkwork
