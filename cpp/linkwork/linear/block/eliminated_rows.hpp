#pragma once

#include <vector>

#include "linkwork/assembly/system.hpp"
#include "linkwork/model/joint_kind.hpp"

namespace linkwork::block {

/// Which rows of D are eliminated, and with which joint.
///
/// A joint with compliance may stand beside another one between the same bodies, as an inerter does along the hinge
/// that it turns with. By itself it would make a loop of the two; together they are one joint with more rows.
class EliminatedRows {
 public:
  /// `compliant_from`: joints whose rows come from there on have compliance, and are attached to others where these
  /// have room for them.
  EliminatedRows(const System& system, const std::vector<int>& dropped, int compliant_from);

  bool is_dropped(int row) const { return dropped_[row] != 0; }
  /// Without the dropped ones: of a joint and of those attached to it; none of an attached one.
  int count(int joint) const { return count_[joint]; }
  /// The joint that it is attached to, or itself.
  int host(int joint) const { return host_[joint]; }
  bool is_attached(int joint) const { return host_[joint] != joint; }
  /// Of a joint, the one attached to the same host that comes behind it, or -1; it begins with the host.
  int next(int joint) const { return next_[joint]; }

  /// Whether a joint holds a point and two or three rotations: its rows have the form of turning_kernels.hpp.
  bool turning(int joint) const;
  /// Whether two shifts and all rotations: see SliderOnGround.
  bool slides(int joint) const;

  /// Calls f with the blocks of D, on a body, of a joint and of those attached to it.
  template <class Function>
  void for_blocks_on(int body, int joint, const Function& f) const {
    for (int it = joint; it >= 0; it = next_[it])
      for (const int index : system_.joint_blocks(it))
        if (system_.blocks()[index].body == body) f(system_.blocks()[index]);
  }

 private:
  const JointKind* kind(int joint) const;
  void attach(int joint);
  int find_host(int joint) const;
  bool same_bodies(int joint, int other) const;

  const System& system_;
  std::vector<char> dropped_;  ///< per row
  std::vector<int> count_, host_, next_, all_rows_;
};

}  // namespace linkwork::block
