#pragma once

/// Elementary functions of our own: the same bits on every processor, which those of the C library, who choose their
/// code by what the processor has, do not promise. Right to one unit in the last place, `power` to two, the hyperbolic
/// tangent to three. What is not needed of them is not computed: `const` to compilers.
namespace linkwork::elementary {

[[gnu::const]] double sine(double x);
[[gnu::const]] double cosine(double x);
struct SineAndCosine {
  double sine, cosine;
};
[[gnu::const]] SineAndCosine sine_and_cosine(double x);  ///< the same bits, sooner than one after the other
[[gnu::const]] double arc_tangent(double y, double x);   ///< as std::atan2
[[gnu::const]] double exponential(double x);
[[gnu::const]] double logarithm(double x);
[[gnu::const]] double power(double x, double y);
[[gnu::const]] double hyperbolic_tangent(double x);

}  // namespace linkwork::elementary
