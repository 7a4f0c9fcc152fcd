#pragma once

#include <optional>
#include <vector>

#include "linkwork/formulation/projection.hpp"
#include "linkwork/integration/gauss_collocation.hpp"
#include "linkwork/integration/spinning_axes.hpp"

namespace linkwork {

/// A long step, with everything in between.
struct Leap {
  double t = 0.0, h = 0.0;
  double followed = 0.0;           ///< of h, by the run
  VectorXd y;                      ///< at t, on the constraints
  VectorXd y_new;                  ///< at t + followed; at t + h, on the constraints
  SpinningAxes axes;               ///< from which the polynomials are seen
  MatrixXd k;                      ///< y_dot at the nodes, seen from there
  MatrixXd lambda;                 ///< multipliers at the nodes
  std::vector<double> poses = {};  ///< singular ones, times from t

  double end() const { return t + h; }
  void keep(Archive& archive) { archive(t, h, followed, y, y_new, axes.Omega, k, lambda, poses); }
};

/// A step by Gauss collocation whose nodes stand on the constraints, Phi = 0 and D v + Phi_t = 0. All methods but
/// those of interpolation leave `dynamics` evaluated somewhere else.
class CollocationStep {
 public:
  static constexpr int stages = GaussCollocation::stages;
  static constexpr int none = -1;

  struct Quality {
    bool converged = false;
    bool departs = false;     ///< from a pose, which nothing else does better
    double correction = 0.0;  ///< of the nodes by the constraints [rad, or relative to the length]
    double off = 0.0;         ///< the same of the start, where it is not taken to the constraints
    double jump = 0.0;        ///< the same of their velocities, relative to them
    double resolution = 0.0;  ///< what the polynomials do not resolve of the velocities, relative to them
    double energy = 0.0;      ///< that is missing at the end, relative to the kinetic energy
    double unseen = 0.0;      ///< see `unseen`
    double roundoff = 0.0;    ///< in the node next to a singular pose, relative
    double blur = 0.0;        ///< roundoff of the positions, relative to the length
    bool good() const;
    bool fair() const;
    double error() const;  ///< of what comes after it
  };

  /// `length` of the mechanism [m]: velocities count relative to it.
  CollocationStep(Dynamics& dynamics, double length)
      : dynamics_(dynamics), projection_(dynamics), length_(length), rotors_(rotor_axes(dynamics.system())) {}

  /// Rotors turn no farther in a step than others do: somebody looks at how far they turn.
  void watch_rotors() { rotors_.setZero(); }
  const Eigen::Matrix3Xd& rotors() const { return rotors_; }  ///< see rotor_axes

  /// From (t, y): the state, its rates, its energy. It is taken to the constraints if wanted: beside a singular pose
  /// what it is off would become larger velocities by that, and the end of the step is a better place. False where it
  /// is too far from them, as in a run that diverges.
  bool begin(double t, const VectorXd& y, bool on_constraints);
  /// The same in or near a singular pose, where nothing can be projected, and it may be `off` [rad]; accelerations, for
  /// a beginning, are `v_dot`, or where that is empty what the watch makes of them.
  void begin_in_pose(double t, const VectorXd& y, double off, const VectorXd& v_dot = {});
  /// To t + h. A node that is `left_out`, in a singular pose, is where the others lead.
  Quality attempt(double h, int left_out = none);
  /// How far the motion is from the forces and constraints between the nodes, in velocities relative to them, looked at
  /// in such intervals: of forces and drivers that come and go between two nodes.
  double unseen(double interval);
  /// The end of the attempt where the polynomials say, as beside a singular pose.
  void end_as_it_is(Quality& quality);

  Leap& leap() { return step_; }
  int left_out() const { return left_out_; }
  /// Of the nodes from the start of the step, relative to it.
  const auto& nodes() const { return gauss_.c; }
  /// As they are seen.
  const VectorXd& start_accelerations() const { return v_dot_before_; }
  /// How far the motion would go from one time to another, in s from the start, with the accelerations there [rad].
  double way(double from, double to) const;
  /// How fast accelerations grow on the way to there, as the rate of growth of the motion [1/s]; 0: nobody knows.
  double growth_to(double time);
  /// Where it is taken to the constraints: as they are there.
  struct Forces {
    VectorXd v_dot, lambda;
  };
  const std::optional<Forces>& start_on_constraints() const { return start_; }

  /// At so many seconds from t, with unit Euler parameters.
  void state_at(double time, VectorXd& y) const;
  void accelerations_at(double time, MutableVector v_dot, MutableVector lambda) const;
  /// To Phi = 0 and D v + Phi_t = 0.
  void project(double t, VectorXd& y);

  double length() const { return length_; }
  /// Roundoff of the positions where the step begins, relative to the length.
  double blur() const { return blur_; }
  /// Of the motion of one body, or of the fastest [rad/s]; a rotor's own rotation is none.
  double rate(int body, const ConstVector& velocities) const;
  double size(const ConstVector& velocities) const;

 private:
  void allocate(double t, const VectorXd& y);
  bool can_project(double t, VectorXd& y);
  void guess();
  bool iterate();
  double node(int i);
  double extrapolated_node(int i);
  double changed(int i, double speed);
  void finish(Quality& quality);
  void note_missing_energy(Quality& quality);
  double kinetic_energy(const VectorXd& y) const;
  double energy(const VectorXd& y) const;
  void note_energy(const VectorXd& y);
  double displacement(const VectorXd& from, const VectorXd& to) const;
  VectorXd multipliers_at(double time) const;
  std::vector<int> nodes_beside_poses() const;
  void hold_rotors(double time, const VectorXd& y, const VectorXd& v_dot, MutableVector lambda) const;

  Dynamics& dynamics_;
  Projection projection_;
  double length_;
  Eigen::Matrix3Xd rotors_;
  double blur_ = 0.0;
  int left_out_ = none;
  GaussCollocation gauss_;
  Leap step_;
  bool departs_ = false;                  ///< from a pose in which accelerations are those of a branch
  double least_speed_ = 0.0;              ///< that changes of velocities are relative to
  double fastest_ = 0.0;                  ///< node of a sweep
  double correction_ = 0.0, jump_ = 0.0;  ///< of the last sweep, see Quality
  MatrixXd g_;                            ///< at the nodes
  std::optional<Forces> start_;
  double off_ = 0.0, energy_before_ = 0.0, kinetic_before_ = 0.0;
  VectorXd y_, v_dot_, v_dot_before_, rates_, rates_before_;
};

}  // namespace linkwork
