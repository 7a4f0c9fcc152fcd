#pragma once

#include <exception>

namespace linkwork {

/// Whoever runs this in a process of his own may want to end it: at a signal, say. Long work looks now and then, at
/// places where nothing is lost; `look` may throw, and what it throws goes through. Called from any thread that works.
using Interruption = void (*)();
/// Whether an exception is one, of `look` or of a function of the user's, and no failure of what threw it.
using InterruptionTest = bool (*)(const std::exception& thrown);
void set_interruption(Interruption look, InterruptionTest test = nullptr);
bool is_interruption(const std::exception& thrown);

/// Of work that takes some microseconds at least. Looks as often as every 50 ms, and only at the clock in between.
void look_for_interruption();

/// Of work that may be short: looks after so much of it, measured in evaluations of one body.
class InterruptionMeter {
 public:
  void add(int bodies) {
    done_ += bodies;
    if (done_ < enough) return;
    done_ = 0;
    look_for_interruption();
  }

 private:
  static constexpr int enough = 10000;
  int done_ = 0;
};

}  // namespace linkwork
