#include "linkwork/formulation/options.hpp"

#include <initializer_list>

#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

void check_choice(const char* what, const std::string& given, std::initializer_list<const char*> known) {
  std::string names;
  for (const char* name : known) {
    if (given == name) return;
    names += (names.empty() ? "'" : ", '") + std::string(name) + "'";
  }
  throw OptionError("unknown_option", std::string(what) + " '" + given + "' does not exist; choose from " + names);
}

/// Infinite is a limit like others.
void check_number(const char* what, double value, bool positive, bool finite = true) {
  if (value >= 0.0 && !(positive && value == 0.0) && (!finite || std::isfinite(value))) return;
  throw OptionError(what, std::string(what) + " " + std::to_string(value) + " must be " +
                              (positive ? "positive" : "zero or positive") + (finite ? " and finite" : ""));
}

}  // namespace

void check_options(const Options& options) {
  check_choice("on_singular", options.on_singular, {"pass", "warn", "stop"});
  check_choice("on_violation", options.on_violation, {"record", "project", "stop"});
  check_number("tolerance", options.tolerance, true);
  if (options.baumgarte_alpha) check_number("baumgarte_alpha", *options.baumgarte_alpha, false);
  if (options.baumgarte_beta) check_number("baumgarte_beta", *options.baumgarte_beta, false);
  if (options.penalty) check_number("penalty", *options.penalty, true);
  if (options.penalty_scale) check_number("penalty_scale", *options.penalty_scale, true);
  for (const double limit : options.violation_limit) check_number("violation_limit", limit, true, false);
  if (options.max_iterations < 1)
    throw OptionError("max_iterations",
                      "max_iterations " + std::to_string(options.max_iterations) + " must be at least 1");
}

}  // namespace linkwork
