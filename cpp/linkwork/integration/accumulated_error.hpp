#pragma once

#include <vector>

#include "linkwork/integration/run_judge.hpp"

namespace linkwork {

/// A step that was taken again; errors are relative, see AccumulatedError.
struct JudgedStep {
  double t, h;       ///< [s]
  double state;      ///< at its end
  double reactions;  ///< NaN: not looked at
};

/// Rest of a connected part, as errors in it are weighed.
struct RestScales {
  double length = 0.0, speed = 0.0;  ///< [m, m/s]; zero: it moves
};

/// Energy that the run made or lost in a connected part of which that is known, see EnergyMade; or, where there are laws
/// of the user's own but no driver and no function of time, that its steps made.
struct EnergyOfPart {
  int body = 0;                       ///< the first of it; -1: all are one part
  double error = 0.0;                 ///< relative to its kinetic energy and to what it exchanged
  double lasting = 1.0;               ///< see EnergyMade
  double rate, slowness, suddenness;  ///< see AccumulatedError
};

/// The largest accelerations of bodies of each connected part [m/s^2] in a part of the run, from t to `end` [s].
struct Peaks {
  double t = 0.0, end = 0.0;
  VectorXd accelerations;
};

/// What the local errors of a run come to over it, in the connected part where that is most. Poses are relative to L,
/// half of the box in which centers of mass of the part move or its size, or to the path where that is shorter;
/// velocities to V, its largest speed; reactions to its largest. Box, path and speeds are those in MovingAxes. Where
/// there is no motion, what moved is the error, relative to the size of the part and the speed of Rest.
struct AccumulatedError {
  std::size_t failed = 0;         ///< steps that could not be taken again; where all could not, the rest is zero
  std::vector<JudgedStep> steps;  ///< the others, by time
  int body = -1;                  ///< the first of that part; -1: there is but one
  double state = 0.0;             ///< over the run
  double growth = std::numeric_limits<double>::quiet_NaN();  ///< see ErrorGrowth, the largest; NaN: not known
  double unstable = 1.0;                                     ///< the largest that is more than that of regular motion
  bool grows = false;                                        ///< that is most of the state's
  double lost = std::numeric_limits<double>::quiet_NaN();    ///< when errors were lost first [s], see ErrorGrowth
  /// Of the state: all errors of steps added up as they have grown, which is more than they come to where it is known
  /// of all of the run, and of all parts, how they grow; NaN: not known.
  double at_most = std::numeric_limits<double>::quiet_NaN();
  double local_error = 0.0;         ///< of the state, the mean over the run [1/s]
  double reactions_by_state = 0.0;  ///< largest of those of any part, by the state of this; NaN: not known
  double yielding = 0.0;        ///< largest of what reactions lose as constraints yield, of any part; NaN: not known
  bool contacts_begin = false;  ///< of any part
  double onset = 0.0;      ///< of the speeds at which contacts began, added up, relative to V, the largest of any part
  double rounding = 0.0;   ///< of positions, relative to the path in space or the size where that is more, and of
                           ///< velocities that miss the constraints by it, relative to V, the largest
  double violation = 0.0;  ///< largest at the ends of these steps, see RelativeViolation
  double rate = 0.0;       ///< V / L of the part with the largest kinetic energy [1/s]
  double slowness = 1.0;   ///< of that part, 1 / kinetic energy in the mean over the run, relative to the largest; less
                           ///< where forces took that energy away
  double suddenness = 0.0;  ///< the same times the largest acceleration that comes later, by V^2 / L; less where motion
                            ///< turns often, as a vibration does; none where that comes at times of its own
  double seconds = 0.0;     ///< that the parts of the run took
  double kinetic_share = 1.0;    ///< see StepJudge
  double carried = 0.0;          ///< speed of the part as a whole, relative to V
  std::vector<double> speeds;    ///< V of each connected part [m/s]
  std::vector<Peaks> peaks;      ///< by time
  double rest_energy = 0.0;      ///< that of Rest, where all parts rest [J]
  std::vector<RestScales> rest;  ///< of each connected part
  std::vector<EnergyOfPart> energies;
};

/// Each of the connected parts is judged as if it were alone.
///
/// Between the two steps that are known of a part of the run errors go with the change of accelerations, of which the
/// mean is known; the sum over a part is at least what they say. An error of a velocity is also one of positions later:
/// it grows with time, as far as V t / L = 5; beyond, motions of a mechanism turn rather than part. An error of a pose
/// is a delay, too: what is late by dt is off by y_dot dt, which is more where the motion is faster than where it
/// arose, and is one of the velocity in an impact: by the largest acceleration of each part. Beside, frames inside of
/// steps are off by what the interpolant is there, states by what they are off the constraints until Baumgarte's terms
/// take that back, if they soon do, and by what leaps over singular poses and projections corrected. What does grow on
/// is the error of the energy, as that of the speed along the path: it is the caller's.
AccumulatedError accumulate(const RunErrors& errors);

}  // namespace linkwork
