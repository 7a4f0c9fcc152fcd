#include "linkwork/integration/step_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace linkwork {
namespace {

/// From an end of a step, for a break to be there.
double near(double t, double h) { return 1e-9 * h + 64.0 * std::numeric_limits<double>::epsilon() * std::abs(t + h); }

}  // namespace

std::vector<StepSpan> StepParts::of(double t, double h) const {
  const StepSpan step = whole(t, h);
  const double end = t + h, side = near(t, h);
  const int times = share_ < 1.0 ? divisions_ : 0;
  std::vector<StepSpan> parts;
  StepSpan part{t, h, step.earliest};
  for (double at = breaks_.next(t + side); at < end - side; at = breaks_.next(at)) {
    if (at > part.t + side) {
      divide({part.t, at - part.t, part.earliest, breaks_.before(at)}, times, parts);
      part.t = at;
    }
    part.earliest = breaks_.after(at);
  }
  divide({part.t, part.t > t ? end - part.t : h, part.earliest, step.latest}, times, parts);
  return parts;
}

StepSpan StepParts::whole(double t, double h) const {
  StepSpan step{t, h};
  const double side = near(t, h);
  for (double at = breaks_.next(t - side); at <= t + side; at = breaks_.next(at)) step.earliest = breaks_.after(at);
  const double last = breaks_.next(t + h - side);
  if (last <= t + h + side) step.latest = std::max(breaks_.before(last), step.at(0.0));
  return step;
}

void StepParts::divide(const StepSpan& whole, int times, std::vector<StepSpan>& parts) const {
  if (times == 0) return parts.push_back(whole);
  const auto [part, rest] = whole.divided(share_);
  divide(part, times - 1, parts);
  divide(rest, times - 1, parts);
}

}  // namespace linkwork
