#pragma once

#include <vector>

#include "linkwork/integration/moving_axes.hpp"

namespace linkwork {

/// How far from linear the equations of motion of each of ConnectedParts are about the mean of the states of these
/// steps, at most 1. The motion of a linear system only turns what a state is off by, and its periods depend on no
/// energy. It is 4 (odd + even^2): x'' = -x - a x^2 - b x^3 has odd = 3/4 b A^2 and even = a A at the amplitude A, and
/// a frequency that goes with the energy to the power of 3/8 b A^2 - 5/12 a^2 A^2 (Lindstedt's method, Nayfeh and Mook
/// (1979), Nonlinear Oscillations, section 2.3). At least the square of the largest rotation; 1 where somebody else's
/// functions, contacts, stops or memory act, of which a few states do not tell.
///
/// Takes five evaluations for each of some of the steps. `axes`: in which states are seen.
VectorXd find_nonlinearity(Dynamics& dynamics, const std::vector<const KeptStep*>& steps, const MovingAxes& axes);

}  // namespace linkwork
