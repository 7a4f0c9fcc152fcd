#include "linkwork/model/batch.hpp"

#include <algorithm>

namespace linkwork {
namespace {

constexpr std::size_t attachment_size = 24;

std::size_t padded_size(std::size_t count, std::size_t width) { return (count + width - 1) / width * width; }

}  // namespace

void JointBatch::reserve(std::size_t count, std::size_t parameters_each, int width) {
  width_ = static_cast<std::size_t>(width);
  const std::size_t padded = padded_size(count, width_);
  for (std::vector<int>* list : {&body_i, &body_j, &row}) list->reserve(padded);
  D.reserve(count);
  attachments.resize(attachment_size * padded);
  parameters.reserve(parameters_each * padded);
}

void JointBatch::attach(std::size_t joint, const Attachment<double>& at) {
  double* to = attachments.data() + attachment_size * width_ * (joint / width_) + joint % width_;
  for (const auto* vector : {&at.s_i, &at.s_j})
    for (int c = 0; c < 3; ++c, to += width_) *to = (*vector)[c];
  for (const auto* frame : {&at.C_i, &at.C_j})
    for (int c = 0; c < 9; ++c, to += width_) *to = frame->data()[c];
}

void JointBatch::fill_up() {
  if (row.empty()) return;
  const std::size_t padded = padded_size(row.size(), width_), per_joint = parameters.size() / row.size();
  const std::size_t last = (row.size() - 1) % width_;
  double* group = attachments.data() + attachment_size * (padded - width_);  // that of the last joint
  for (std::size_t number = 0; number < attachment_size; ++number, group += width_)
    std::fill(group + last + 1, group + width_, group[last]);
  body_i.resize(padded, body_i.back());
  body_j.resize(padded, body_j.back());
  while (parameters.size() < per_joint * padded) parameters.push_back(parameters[parameters.size() - per_joint]);
}

JointArrays JointBatch::arrays(int first, int last) const {
  const int per_joint = body_i.empty() ? 0 : static_cast<int>(parameters.size() / body_i.size());
  return {.count = last - first,
          .body_i = body_i.data() + first,
          .body_j = body_j.data() + first,
          .attachment = attachments.data() + attachment_size * first,
          .parameters = parameters.data() + std::ptrdiff_t{per_joint} * first,
          .parameter_count = per_joint,
          .time_dependent = time_dependent,
          .row = row.data() + first,
          .D = D.data() + first};
}

}  // namespace linkwork
