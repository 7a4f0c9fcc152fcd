#pragma once

#include <memory>
#include <string>
#include <vector>

#include "linkwork/model/body_state.hpp"
#include "linkwork/model/history.hpp"
#include "linkwork/model/kind_info.hpp"

/// Joints that a point and axes on two bodies do not describe: one file each in special/, one line in
/// special_joints.def.
namespace linkwork {

/// Where one special joint writes: as Rows, with D block after block (rows x 6), one for each of its bodies.
struct SpecialRows {
  double* Phi;
  double* Phi_t;
  double* gamma;
  double* D;  ///< zero at the beginning, as are the others
};

/// History variables of one special joint, see HistoryVariable.
struct SpecialHistory {
  const double* last;  ///< NaN: the motion begins in this state
  double *next, *rate;
};

class SpecialJoint;
using SpecialJointPtr = std::shared_ptr<const SpecialJoint>;

/// A constraint among any number of bodies, with data of its own. Few of them: each is evaluated alone.
class SpecialJoint {
 public:
  virtual ~SpecialJoint() = default;
  /// Each once; the ground (-1) may be among them.
  virtual const std::vector<int>& bodies() const = 0;
  virtual HistoryKind history_kind() const = 0;
  virtual int history_size() const = 0;
  virtual void evaluate(const BodyState<double>* bodies, const Signal<double>* parameters,
                        const SpecialHistory& history, const SpecialRows& out) const = 0;
  /// The same whose points on the ground are counted from `origin`, as those of the bodies then are.
  virtual SpecialJointPtr seen_from(const Vec3<double>& origin) const = 0;
};

/// All registered special joints, in the order of special_joints.def.
const std::vector<KindInfo>& special_joint_kinds();

/// The kind with this name as joint_info takes it, or an OptionError that names those there are.
int special_joint_kind_index(const std::string& name);

/// Of the kind of a joint of a model: joint_kinds(), then special_joint_kinds().
const KindInfo& joint_info(int kind);

}  // namespace linkwork
