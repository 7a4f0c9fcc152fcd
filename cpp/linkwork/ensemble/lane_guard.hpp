#pragma once

#include <exception>
#include <new>
#include <string>
#include <utility>

#include "linkwork/math/interruption.hpp"

namespace linkwork {

/// Equations with a smaller pivot are singular, whatever the run has seen before.
constexpr double singular_pivot = 1e-15;

/// Who takes the steps of lanes, and hears of each what a run by itself would watch.
class LaneGuard {
 public:
  virtual ~LaneGuard() = default;

  /// What lane l makes is of interest.
  virtual bool steps(int l) const = 0;
  /// The first stage of the step that comes was looked at ahead, and is factorized there already.
  virtual bool looked(int l) const = 0;
  /// The smallest pivot of a stage at t.
  virtual void note(int l, double t, double pivot, bool first_stage) = 0;
  /// The same of so many lanes, where they step.
  virtual void note_all(int count, const double* t, const double* pivots, bool first_stage) {
    for (int l = 0; l < count; ++l)
      if (steps(l)) note(l, t[l], pivots[l], first_stage);
  }
  /// It meets what lanes cannot do.
  virtual void leave(int l, double t, std::string reason) = 0;
  /// What lanes have made of it so far may be wrong.
  virtual void refuse(int l, double t, std::string reason) { leave(l, t, std::move(reason)); }
};

/// Does something of one lane. What goes wrong there, functions of the user's included, is told to `fail` in words and
/// concerns no other lane; not so interruptions, and where there is no memory.
template <class Action, class Fail>
void do_apart(const Action& action, const Fail& fail) {
  try {
    action();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& thrown) {
    if (is_interruption(thrown)) throw;
    const std::string words = thrown.what();
    fail(words.substr(0, words.find('\n')));
  }
}

}  // namespace linkwork
