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

/// Force elements of one kind in several mechanisms of one structure at once, each mechanism in a lane; see JointLanes.
struct ForceLanes {
  int count;
  const int *body_i, *body_j;
  const double *attachment, *parameters;
  int parameter_count;
  const std::ptrdiff_t *history, *switches;
  const double* states;
};

/// Those that lie along coordinates that are evaluated once for several.
struct LawLanes : ForceLanes {
  const int* row;           ///< of the coordinate
  const std::ptrdiff_t* D;  ///< place of D_i; D_j follows
};

/// Numbers of s_i, s_j, C_i and C_j, the parts of an Attachment, and of all.
constexpr int attachment_parts[] = {3, 3, 9, 9};
constexpr int attachment_size = 24;

/// One part of the attachments of elements that are evaluated `width` at a time: for these number after number, of those
/// from element k on at from[step k]. Where all have the same, as many in large models do, it stands there for `width`
/// of them, and the step is 0.
struct AttachmentPart {
  const double* from = nullptr;
  std::ptrdiff_t step = 0;
};

/// Joints or force elements of one kind, which are evaluated `width` at a time: plain arrays, of which bodies, attachments
/// and parameters are filled up to a multiple of the width with copies of the last. What is compiled for several
/// instruction sets reads nothing else.
struct ElementArrays {
  int count;
  const int *body_i, *body_j;        ///< -1 for the ground
  const AttachmentPart* attachment;  ///< the four parts
  int first;                         ///< element in these
  const Parameter* parameters;       ///< `parameter_count` per element
  int parameter_count;
  bool time_dependent;  ///< some parameters are functions of time
};

struct JointArrays : ElementArrays {
  bool streamed;            ///< D is larger than caches: it is written past them
  const int* number;        ///< of the joint in the model
  const int* row;           ///< first constraint row
  const std::ptrdiff_t* D;  ///< place of D_i; D_j follows
};

struct ForceElements : ElementArrays {
  const std::ptrdiff_t *history, *switches;  ///< places of the variable, and of the first switch
};

/// The joints of one kind in several mechanisms of one structure at once, each mechanism in a lane: what is said of a
/// joint or body holds for `width` numbers, one of each mechanism.
struct JointLanes {
  int count;
  const int *body_i, *body_j;  ///< places in the states; ~ of that of one whose D nobody reads, as of the ground
  const double* attachment;    ///< numbers of Attachment of each joint (24 x width)
  const double* parameters;    ///< value, rate, acceleration of `parameter_count` parameters of each joint
  int parameter_count;
  const int* row;           ///< first constraint row
  const std::ptrdiff_t* D;  ///< place of D_i; D_j follows
  const double* states;     ///< of each body numbers of BodyState (18 x width), of the ground behind them
};

/// Those that lie along coordinates that are evaluated once for several.
struct LawElements : ForceElements {
  const int* row;           ///< of the coordinate
  const std::ptrdiff_t* D;  ///< place of D_i; D_j follows
};

/// All joints or force elements of one kind in one system.
class ElementBatch {
 public:
  std::vector<int> body_i, body_j;
  std::vector<int> number;  ///< in the model
  std::vector<Parameter> parameters;
  bool time_dependent = false;

  ElementBatch() = default;
  ElementBatch(ElementBatch&&) = default;  // whose numbers stay where they are
  ElementBatch& operator=(ElementBatch&&) = default;

  std::size_t size() const { return number.size(); }
  std::size_t parameters_each() const { return each_; }
  /// For `count` elements, evaluated `width` at a time.
  void reserve(std::size_t count, std::size_t parameters_each, int width);
  /// One more, with as many parameters as all have, from bodies i to j (-1 for the ground).
  void append(int number, int i, int j, const Parameter* first_parameter, std::size_t parameter_count);
  /// The attachment of the last one.
  void attach(const Attachment<double>& at);
  /// When all are there.
  void fill_up();

 protected:
  /// Of a part of the elements; `first` is a multiple of the width.
  ElementArrays arrays(int first, int last) const;

 private:
  struct Part {
    std::vector<double> numbers;
    bool varies = false;
  };
  void attach(std::size_t element, const double* numbers, int count, Part& part) const;

  std::array<Part, std::size(attachment_parts)> parts_;
  std::array<AttachmentPart, std::size(attachment_parts)> attachments_;  ///< in these, when all elements are there
  std::size_t width_ = 1, padded_ = 0, each_ = 0;                        ///< `each_`: parameters
};

struct JointBatch : ElementBatch {
  std::vector<int> row;
  std::vector<std::ptrdiff_t> D;
  bool streamed = false;

  JointArrays joints() const { return joints(0, static_cast<int>(size())); }
  JointArrays joints(int first, int last) const;
};

struct ForceBatch : ElementBatch {
  std::vector<Attachment<double>> attachment;  ///< of elements that are evaluated one by one
  std::vector<std::ptrdiff_t> history, switches;

  /// Of coordinates, where the elements share those with others, and the places of D; else empty.
  std::vector<int> row;
  std::vector<std::ptrdiff_t> D;

  ForceElements elements(int first, int last) const;
  LawElements laws(int first, int last) const;
};

}  // namespace linkwork
