#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace linkwork {

/// Of the largest |Phi|, |Phi_dot|, |D v_dot - gamma|.
using Limits = std::array<double, 3>;
constexpr Limits no_limits = {INFINITY, INFINITY, INFINITY};

/// The choices of a run; options.def says what each is. An option of some methods only is empty where it is not given.
struct Options {
#define LINKWORK_OPTION(TYPE, NAME, DEFAULT, VALUES, UNIT, HELP) TYPE NAME = DEFAULT;
#define LINKWORK_METHOD_OPTION(TYPE, NAME, DEFAULT, VALUES, UNIT, HELP) std::optional<TYPE> NAME;
#include "linkwork/formulation/options.def"
#undef LINKWORK_OPTION
#undef LINKWORK_METHOD_OPTION
};

/// What an option can be.
struct OptionInfo {
  std::string name;
  std::string type;                       ///< "name", "number", "whole", "limits" or "switch"
  std::vector<std::string> choices = {};  ///< of a name
  bool positive = false;                  ///< a number: not zero
  std::optional<double> usual = {};       ///< a number: where it is not given
  std::string unit = "";
  std::string documentation = "";
  std::vector<std::string> methods = {};  ///< formulations or stabilizations that have it; empty: it is of all
};

/// All of options.def, in that order.
const std::vector<OptionInfo>& option_infos();

/// The options as a run has them: numbers that were not given filled in where the methods have them, damping_ratio and
/// frequency as the gains that they are. OptionError: a name or number that no run can have, what the methods cannot
/// honor, or a conflict.
Options resolve(Options options);

}  // namespace linkwork
