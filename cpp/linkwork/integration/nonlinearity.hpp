#pragma once

#include <vector>

#include "linkwork/integration/moving_axes.hpp"

namespace linkwork {

/// How far from linear the equations of motion of each of ConnectedParts are about the mean of the states of these
/// steps, at most 1: by about that a period, and how energy goes from one motion to another, depend on the energy. It
/// is 8 (odd + even), of one degree of freedom 8 (odd + even^2): x'' = -x - a x^2 - b x^3 has odd = 3/4 b A^2 and
/// even = a A at the amplitude A, and a frequency that goes with the energy to the power of 3/8 b A^2 - 5/12 a^2 A^2
/// (Lindstedt's method, Nayfeh and Mook (1979), Nonlinear Oscillations, section 2.3); of several, internal resonances
/// exchange energy at a pace of the first order. At least the square of the largest rotation.
///
/// 1 where errors may grow though all is linear, or a few states do not tell: where anything does work, as drivers,
/// dampers and functions of time do, or has a memory, where wheels roll, and where forces do not drive the states back
/// to the mean.
///
/// Takes five evaluations for each of some of the steps, at states that the run did not have. `axes`: in which states
/// are seen; `lengths`: sizes of the parts [m]; `redundant`: rows that others imply.
VectorXd find_nonlinearity(Dynamics& dynamics, const std::vector<const KeptStep*>& steps, const MovingAxes& axes,
                           const VectorXd& lengths, const std::vector<int>& redundant);

}  // namespace linkwork
