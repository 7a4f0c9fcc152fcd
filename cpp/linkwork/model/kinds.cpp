#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "linkwork/math/names.hpp"
#include "linkwork/model/force_kind.hpp"
#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/special_joint.hpp"

namespace linkwork {

#define LINKWORK_JOINT(NAME) JointKind NAME##_joint();
#include "linkwork/model/joints.def"
#undef LINKWORK_JOINT

#define LINKWORK_FORCE(NAME) ForceKind NAME##_force();
#include "linkwork/model/forces.def"
#undef LINKWORK_FORCE

#define LINKWORK_SPECIAL_JOINT(NAME) KindInfo NAME##_joint();
#include "linkwork/model/special_joints.def"
#undef LINKWORK_SPECIAL_JOINT

namespace {

const KindInfo& info_of(const KindInfo& info) { return info; }
template <class Kind>
const KindInfo& info_of(const Kind& kind) {
  return kind.info;
}

/// Index of the kind with this name; the error lists those there are.
template <class Kind>
int find_kind(const std::vector<Kind>& kinds, const std::string& name, const char* what) {
  const auto same = [&](const Kind& kind) { return info_of(kind).name == name; };
  const auto found = std::find_if(kinds.begin(), kinds.end(), same);
  if (found != kinds.end()) return static_cast<int>(found - kinds.begin());
  std::vector<std::string> known;
  for (const Kind& kind : kinds) known.push_back(info_of(kind).name);
  throw OptionError("unknown_kind", std::string(what) + " '" + name + "' does not exist; there are: " + joined(known));
}

}  // namespace

JointKind checked(JointKind kind) {
  if (kind.info.parameters.size() > max_joint_parameters)
    throw std::logic_error("joint kind '" + kind.info.name + "' has " + std::to_string(kind.info.parameters.size()) +
                           " parameters, more than max_joint_parameters = " + std::to_string(max_joint_parameters));
  if (kind.info.rows < 1 || kind.info.rows > 6)
    throw std::logic_error("joint kind '" + kind.info.name + "' has " + std::to_string(kind.info.rows) +
                           " rows, but two bodies have 1 to 6 that can differ");
  return kind;
}

const std::vector<JointKind>& joint_kinds() {
  static const std::vector<JointKind> kinds = {
#define LINKWORK_JOINT(NAME) NAME##_joint(),
#include "linkwork/model/joints.def"
#undef LINKWORK_JOINT
  };
  return kinds;
}

const std::vector<ForceKind>& force_kinds() {
  static const std::vector<ForceKind> kinds = {
#define LINKWORK_FORCE(NAME) NAME##_force(),
#include "linkwork/model/forces.def"
#undef LINKWORK_FORCE
  };
  return kinds;
}

const std::vector<KindInfo>& special_joint_kinds() {
  static const std::vector<KindInfo> kinds = {
#define LINKWORK_SPECIAL_JOINT(NAME) NAME##_joint(),
#include "linkwork/model/special_joints.def"
#undef LINKWORK_SPECIAL_JOINT
  };
  return kinds;
}

const KindInfo& joint_info(int kind) {
  const auto index = static_cast<std::size_t>(kind);
  return index < joint_kinds().size() ? joint_kinds()[index].info : special_joint_kinds()[index - joint_kinds().size()];
}

int special_joint_kind_index(const std::string& name) {
  return static_cast<int>(joint_kinds().size()) + find_kind(special_joint_kinds(), name, "special joint kind");
}

int joint_kind_index(const std::string& name) { return find_kind(joint_kinds(), name, "joint kind"); }
int force_kind_index(const std::string& name) { return find_kind(force_kinds(), name, "force kind"); }

}  // namespace linkwork
