#include "linkwork/formulation/options.hpp"

#include <algorithm>

#include "linkwork/formulation/formulation.hpp"
#include "linkwork/formulation/stabilization.hpp"
#include "linkwork/math/names.hpp"

namespace linkwork {
namespace {

// Flores (2015), section 12.4
constexpr double textbook_damping_ratio = 1.0, textbook_frequency = 10.0;

constexpr int most_threads = 1024;  // each of them has memory of its own

// What the column `values` of the table is made of: names, or bounds of a number.
using Words = std::vector<std::string>;

template <class... Name>
Words names(Name... name) {
  return {name...};
}
Words auto_or(Words others) {
  others.insert(others.begin(), "auto");
  return others;
}

template <class Type>
constexpr const char* type_name = "number";
template <>
constexpr const char* type_name<std::string> = "name";
template <>
constexpr const char* type_name<int> = "whole";
template <>
constexpr const char* type_name<std::optional<int>> = "whole";
template <>
constexpr const char* type_name<Limits> = "limits";
template <>
constexpr const char* type_name<bool> = "switch";

struct OnOrOff {};
constexpr OnOrOff on_or_off;

[[noreturn]] void conflict(const std::string& message) { throw OptionError("conflict", message); }

void check(const char* what, const std::string& given, const Words& names) {
  if (std::find(names.begin(), names.end(), given) == names.end())
    throw OptionError("unknown_option",
                      std::string(what) + " '" + given + "' does not exist; choose from " + quoted(names));
}

/// Infinite is a limit like others.
void check(const char* what, double given, const Bounds& bounds, bool finite = true) {
  if (bounds.hold(given) && (!finite || std::isfinite(given))) return;
  const char* wanted = bounds.above ? "positive" : bounds.least > 0.0 ? "at least 1" : "zero or positive";
  throw OptionError(
      what, std::string(what) + " " + std::to_string(given) + " must be " + wanted + (finite ? " and finite" : ""));
}

void check(const char* what, const Limits& given, const Bounds& bounds) {
  for (const double limit : given) check(what, limit, bounds, false);
}

void check(const char* what, const std::optional<int>& given, const Bounds& bounds) {
  if (!given) return;
  check(what, static_cast<double>(*given), bounds);
  if (*given > most_threads)
    throw OptionError(what, std::string(what) + " " + std::to_string(*given) + " is more than " +
                                std::to_string(most_threads) + "; give no more than there are processors");
}

void check(const char*, bool, OnOrOff) {}

Words choices_of(const Words& names) { return names; }
Words choices_of(const Bounds&) { return {}; }
Words choices_of(OnOrOff) { return {}; }
bool excludes_zero(const Words&) { return false; }
bool excludes_zero(OnOrOff) { return false; }
bool excludes_zero(const Bounds& bounds) { return bounds.above; }

bool lists(const Words& options, const std::string& name) {
  return std::find(options.begin(), options.end(), name) != options.end();
}

bool honors(const Options& options, const std::string& name) {
  return lists(formulation_info(options.formulation).options, name) ||
         lists(stabilization_info(options.stabilization).options, name);
}

template <class Info>
Words methods_with(const std::vector<Info>& infos, const std::string& name) {
  Words out;
  for (const Info& info : infos)
    if (lists(info.options, name)) out.emplace_back(info.name);
  return out;
}

Words methods_with(const std::string& name) {
  const Words found = methods_with(formulations(), name);
  return found.empty() ? methods_with(stabilizations(), name) : found;
}

void check_honored(const Options& options, const std::string& name) {
  if (honors(options, name)) return;
  const bool of_formulations = !methods_with(formulations(), name).empty();
  const std::string axis = of_formulations ? "formulation" : "stabilization";
  conflict(name + " has no meaning for " + axis + " '" +
           (of_formulations ? options.formulation : options.stabilization) + "'; use " + axis + " " +
           quoted(methods_with(name), " or "));
}

/// Those of (12.14) are alpha = mu omega, beta = omega.
void resolve_gains(Options& options) {
  const bool alpha = options.baumgarte_alpha.has_value(), beta = options.baumgarte_beta.has_value();
  if (options.damping_ratio || options.frequency) {
    const std::string given = options.damping_ratio ? "damping_ratio" : "frequency";
    if (alpha || beta) conflict(given + " and baumgarte_alpha are gains of the same term: give one pair");
    if (options.stabilization != "baumgarte")
      conflict(given + " is a gain of stabilization 'baumgarte', in conflict with '" + options.stabilization +
               "'; use stabilization 'baumgarte', or leave it out");
    const double omega = options.frequency.value_or(textbook_frequency);
    options.baumgarte_alpha = options.damping_ratio.value_or(textbook_damping_ratio) * omega;
    options.baumgarte_beta = omega;
    options.damping_ratio = options.frequency = std::nullopt;
  } else if (alpha != beta) {
    conflict(std::string(alpha ? "baumgarte_alpha" : "baumgarte_beta") +
             " is given alone: give baumgarte_alpha and baumgarte_beta");
  } else if (!alpha && stabilization_info(options.stabilization).kind == StabilizationKind::baumgarte) {
    options.baumgarte_alpha = textbook_gains.alpha;
    options.baumgarte_beta = textbook_gains.beta;
  }
}

void check_limits(const Options& options) {
  const auto& [position, velocity, acceleration] = options.violation_limit;
  if (options.on_violation != "record" && options.violation_limit == no_limits)
    conflict("on_violation needs a violation_limit: give one, or leave on_violation at 'record'");
  if (options.on_violation == "project" && std::isinf(position) && std::isinf(velocity))
    conflict(
        "on_violation 'project' has no meaning for accelerations alone: a projection changes positions and velocities; "
        "give their limits, or on_violation 'record' or 'stop'");
}

}  // namespace

const std::vector<OptionInfo>& option_infos() {
  static const std::vector<OptionInfo> infos = {
  // clang-format off: it has no fixed point here
#define LINKWORK_OPTION(TYPE, NAME, DEFAULT, VALUES, UNIT, HELP) \
  {#NAME, type_name<TYPE>, choices_of(VALUES), excludes_zero(VALUES), {}, UNIT, HELP, {}},
#define LINKWORK_METHOD_OPTION(TYPE, NAME, DEFAULT, VALUES, UNIT, HELP) \
  {#NAME, type_name<TYPE>, choices_of(VALUES), excludes_zero(VALUES), DEFAULT, UNIT, HELP, methods_with(#NAME)},
#include "linkwork/formulation/options.def"
#undef LINKWORK_OPTION
#undef LINKWORK_METHOD_OPTION
    // clang-format on
  };
  return infos;
}

Options resolve(Options options) {
  formulation_info(options.formulation);
  stabilization_info(options.stabilization);
  if (options.linear_solver != "auto") linear_solver_info(options.linear_solver);
#define LINKWORK_OPTION(TYPE, NAME, DEFAULT, VALUES, UNIT, HELP) check(#NAME, options.NAME, VALUES);
#define LINKWORK_METHOD_OPTION(TYPE, NAME, DEFAULT, VALUES, UNIT, HELP) \
  if (options.NAME) check(#NAME, *options.NAME, VALUES), check_honored(options, #NAME);
#include "linkwork/formulation/options.def"
#undef LINKWORK_OPTION
#undef LINKWORK_METHOD_OPTION
  if (options.penalty && options.penalty_scale)
    conflict("penalty and penalty_scale both say how stiff the equations are: give one");
  resolve_gains(options);
  check_limits(options);
#define LINKWORK_OPTION(TYPE, NAME, DEFAULT, VALUES, UNIT, HELP)
#define LINKWORK_METHOD_OPTION(TYPE, NAME, DEFAULT, VALUES, UNIT, HELP) \
  if (!options.NAME && honors(options, #NAME)) options.NAME = DEFAULT;
#include "linkwork/formulation/options.def"
#undef LINKWORK_OPTION
#undef LINKWORK_METHOD_OPTION
  return options;
}

}  // namespace linkwork
