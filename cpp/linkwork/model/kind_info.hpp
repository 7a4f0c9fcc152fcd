#pragma once

#include <string>
#include <vector>

namespace linkwork {

/// What a user says about where a joint or force element sits.
///   point       one point                       axis        a point and an axis
///   two_axes    a point and one axis per body   two_points  one point per body
///   frame       a point and full axes on both bodies
struct KindInfo {
  std::string name = "";
  int rows = 0;  ///< constraint equations (0 for forces)
  std::string placement = "";
  std::vector<std::string> parameters = {};      ///< numbers or functions of time
  std::vector<std::string> differentiated = {};  ///< those of the parameters whose time derivatives enter
  std::vector<std::string> equations = {};       ///< one name per row
  std::string documentation = "";
};

}  // namespace linkwork
