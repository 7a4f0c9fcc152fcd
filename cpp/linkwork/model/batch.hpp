#pragma once

#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

#include "linkwork/model/body_state.hpp"

namespace linkwork {

/// A parameter of a joint or force: a constant, or the signal (function of time) with this index.
struct Parameter {
  double constant = 0.0;
  int signal = -1;
};

/// The current value of a parameter.
inline Signal<double> current(const Parameter& parameter, const Signal<double>* signals) {
  if (parameter.signal < 0) return {parameter.constant, 0.0, 0.0};
  return signals[parameter.signal];
}

/// Force elements of one kind, as plain arrays: what is compiled for several instruction sets reads nothing else.
struct ForceElements {
  std::size_t count;
  const int *body_i, *body_j;
  const double* attachments;  ///< numbers of Attachment
  const Parameter* parameters;
  int parameter_count;  ///< of each
  const std::ptrdiff_t *history, *switches;
};

/// Those of one kind in several mechanisms of one structure at once, each mechanism in a lane; see JointLanes.
struct ForceLanes {
  int count;
  const int *body_i, *body_j;
  const double *attachment, *parameters;
  int parameter_count;
  const std::ptrdiff_t *history, *switches;
  const double* states;
};

/// All forces of one kind in one system: what evaluation reads.
/// Bodies are indices into an array of states whose last entry is the ground.
struct Batch {
  std::vector<int> body_i, body_j;
  std::vector<Attachment<double>> attachment;
  std::vector<Parameter> parameters;     ///< as many per element as the kind has
  std::vector<std::ptrdiff_t> history;   ///< places of history variables
  std::vector<std::ptrdiff_t> switches;  ///< places of the first switch

  std::size_t size() const { return body_i.size(); }
  /// Of a batch that is not empty.
  ForceElements elements() const {
    return {size(),
            body_i.data(),
            body_j.data(),
            attachment.front().s_i.data(),
            parameters.data(),
            static_cast<int>(parameters.size() / size()),
            history.data(),
            switches.data()};
  }
};

/// Numbers of s_i, s_j, C_i and C_j, the parts of an Attachment, and of all.
constexpr int attachment_parts[] = {3, 3, 9, 9};
constexpr int attachment_size = 24;

/// One part of the attachments of joints that are evaluated `width` at a time: for these number after number, of those
/// from joint k on at from[step k]. Where all joints have the same, as many in large models do, it stands there for
/// `width` of them, and the step is 0.
struct AttachmentPart {
  const double* from = nullptr;
  std::ptrdiff_t step = 0;
};

/// The same for the joints of one kind, which are evaluated `width` at a time: plain arrays, of which bodies,
/// attachments and parameters are filled up to a multiple of the width with copies of the last joint.
struct JointArrays {
  int count;
  const int *body_i, *body_j;        ///< -1 for the ground
  const AttachmentPart* attachment;  ///< the four parts
  int first;                         ///< joint in these
  const Parameter* parameters;       ///< `parameter_count` per joint
  int parameter_count;
  bool streamed;            ///< D is larger than caches: it is written past them
  bool time_dependent;      ///< else Phi_t is zero and is left alone
  const int* number;        ///< of the joint in the model
  const int* row;           ///< first constraint row
  const std::ptrdiff_t* D;  ///< place of D_i; D_j follows
};

/// The joints of one kind in several mechanisms of one structure at once, each mechanism in a lane: what is said of a
/// joint or body holds for `width` numbers, one of each mechanism.
struct JointLanes {
  int count;
  const int *body_i, *body_j;  ///< places in the states
  const double* attachment;    ///< numbers of Attachment of each joint (24 x width)
  const double* parameters;    ///< value, rate, acceleration of `parameter_count` parameters of each joint
  int parameter_count;
  const int* row;           ///< first constraint row
  const std::ptrdiff_t* D;  ///< place of D_i; D_j follows
  const double* states;     ///< of each body numbers of BodyState (18 x width), of the ground behind them
};

struct JointBatch {
  std::vector<int> body_i, body_j, number, row;
  std::vector<std::ptrdiff_t> D;
  std::vector<Parameter> parameters;
  bool time_dependent = false, streamed = false;

  JointBatch() = default;
  JointBatch(JointBatch&&) = default;  // whose numbers stay where they are
  JointBatch& operator=(JointBatch&&) = default;

  /// For `count` joints, evaluated `width` at a time.
  void reserve(std::size_t count, std::size_t parameters_each, int width);
  /// Of the joint with this number; they come one after the other.
  void attach(std::size_t joint, const Attachment<double>& at);
  /// When all are there.
  void fill_up();
  JointArrays arrays() const { return arrays(0, static_cast<int>(row.size())); }
  /// Of a part of the joints; `first` is a multiple of the width.
  JointArrays arrays(int first, int last) const;

 private:
  struct Part {
    std::vector<double> numbers;
    bool varies = false;
  };
  void attach(std::size_t joint, const double* numbers, int count, Part& part) const;

  std::array<Part, std::size(attachment_parts)> parts_;
  std::array<AttachmentPart, std::size(attachment_parts)> attachments_;  ///< in these, when all joints are there
  std::size_t width_ = 1, padded_ = 0;
};

}  // namespace linkwork
