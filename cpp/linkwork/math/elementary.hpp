#pragma once

/// Elementary functions of our own: the same bits on every processor, which those of the C library, who choose their
/// code by what the processor has, do not promise. Right to one unit in the last place, `power` to two, the hyperbolic
/// tangent to three.
namespace linkwork::elementary {

double sine(double x);
double cosine(double x);
double arc_tangent(double y, double x);  ///< as std::atan2
double exponential(double x);
double logarithm(double x);
double power(double x, double y);
double hyperbolic_tangent(double x);

}  // namespace linkwork::elementary
