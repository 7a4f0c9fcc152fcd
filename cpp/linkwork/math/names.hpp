#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "linkwork/math/error.hpp"

namespace linkwork {

/// Such as "a, b, c".
inline std::string joined(const std::vector<std::string>& names, const std::string& between = ", ") {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : between) + name;
  return out;
}

/// Such as "'a', 'b'"; of more names than `most` "'a', 'b' and 4 more".
inline std::string quoted(std::vector<std::string> names, const std::string& between = ", ",
                          std::size_t most = std::numeric_limits<std::size_t>::max()) {
  const std::size_t more = names.size() - std::min(names.size(), most);
  names.resize(names.size() - more);
  for (std::string& name : names) name = "'" + name + "'";
  return joined(names, between) + (more ? " and " + std::to_string(more) + " more" : "");
}

template <class Info>
std::vector<std::string> names_of(const std::vector<Info>& infos) {
  std::vector<std::string> out;
  for (const Info& info : infos) out.emplace_back(info.name);
  return out;
}

/// The one with this name among what is registered. OptionError `code`: there is none, and these there are.
template <class Info>
const Info& find_named(const std::vector<Info>& all, const std::string& name, const std::string& what,
                       const std::string& code) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Info& info) { return info.name == name; });
  if (found != all.end()) return *found;
  throw OptionError(code, what + " '" + name + "' does not exist; there are: " + joined(names_of(all)));
}

}  // namespace linkwork
