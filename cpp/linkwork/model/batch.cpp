#include "linkwork/model/batch.hpp"

#include <algorithm>

namespace linkwork {
namespace {

constexpr std::size_t attachment_size = 24;

std::size_t padded_size(std::size_t count, int width) {
  const auto step = static_cast<std::size_t>(width);
  return (count + step - 1) / step * step;
}

}  // namespace

void JointBatch::reserve(std::size_t count, std::size_t parameters_each, int width) {
  const std::size_t padded = padded_size(count, width);
  for (std::vector<int>* list : {&body_i, &body_j, &row}) list->reserve(padded);
  D.reserve(count);
  attachment.reserve(count);
  parameters.reserve(parameters_each * padded);
}

void JointBatch::pack(int width) {
  if (row.empty()) return;
  const auto step = static_cast<std::size_t>(width);
  const std::size_t padded = padded_size(row.size(), width), per_joint = parameters.size() / row.size();
  packed.resize(attachment_size * padded);
  for (std::size_t k = 0; k < padded; ++k) {
    const Attachment<double>& at = attachment[std::min(k, row.size() - 1)];
    double* to = packed.data() + attachment_size * step * (k / step) + k % step;
    for (const auto* vector : {&at.s_i, &at.s_j})
      for (int c = 0; c < 3; ++c, to += step) *to = (*vector)[c];
    for (const auto* frame : {&at.C_i, &at.C_j})
      for (int c = 0; c < 9; ++c, to += step) *to = frame->data()[c];
  }
  attachment = std::vector<Attachment<double>>();  // gives the memory back, which {} would not
  body_i.resize(padded, body_i.back());
  body_j.resize(padded, body_j.back());
  while (parameters.size() < per_joint * padded) parameters.push_back(parameters[parameters.size() - per_joint]);
}

JointArrays JointBatch::arrays(int first, int last) const {
  const int per_joint = body_i.empty() ? 0 : static_cast<int>(parameters.size() / body_i.size());
  return {.count = last - first,
          .body_i = body_i.data() + first,
          .body_j = body_j.data() + first,
          .attachment = packed.data() + attachment_size * first,
          .parameters = parameters.data() + std::ptrdiff_t{per_joint} * first,
          .parameter_count = per_joint,
          .time_dependent = time_dependent,
          .row = row.data() + first,
          .D = D.data() + first};
}

}  // namespace linkwork
