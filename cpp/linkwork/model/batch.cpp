#include "linkwork/model/batch.hpp"

#include <algorithm>
#include <cstring>

namespace linkwork {
namespace {

std::size_t padded_size(std::size_t count, std::size_t width) { return (count + width - 1) / width * width; }

}  // namespace

void JointBatch::reserve(std::size_t count, std::size_t parameters_each, int width) {
  width_ = static_cast<std::size_t>(width);
  padded_ = padded_size(count, width_);
  for (std::vector<int>* list : {&body_i, &body_j, &row}) list->reserve(padded_);
  D.reserve(count);
  parameters.reserve(parameters_each * padded_);
}

void JointBatch::attach(std::size_t joint, const Attachment<double>& at) {
  auto column = columns_.begin();
  const auto append = [&](double number) {
    auto& [numbers, varies] = *column++;
    if (joint == 0) numbers.assign(width_, number);
    if (!varies && std::memcmp(&number, numbers.data(), sizeof number) != 0) {
      varies = true;
      numbers.assign(padded_, double{numbers.front()});
    }
    if (varies) numbers[joint] = number;
  };
  for (const auto* vector : {&at.s_i, &at.s_j}) std::for_each_n(vector->data(), 3, append);
  for (const auto* frame : {&at.C_i, &at.C_j}) std::for_each_n(frame->data(), 9, append);
}

void JointBatch::fill_up() {
  if (row.empty()) return;
  const std::size_t per_joint = parameters.size() / row.size();
  for (std::size_t k = 0; k < attachment_size; ++k) {
    auto& [numbers, varies] = columns_[k];
    if (varies) std::fill(numbers.begin() + std::ssize(row), numbers.end(), double{numbers[row.size() - 1]});
    attachments_[k] = {numbers.data(), varies ? 1 : 0};
  }
  body_i.resize(padded_, body_i.back());
  body_j.resize(padded_, body_j.back());
  while (parameters.size() < per_joint * padded_) parameters.push_back(parameters[parameters.size() - per_joint]);
}

JointArrays JointBatch::arrays(int first, int last) const {
  const int per_joint = body_i.empty() ? 0 : static_cast<int>(parameters.size() / body_i.size());
  return {.count = last - first,
          .body_i = body_i.data() + first,
          .body_j = body_j.data() + first,
          .attachment = attachments_.data(),
          .first = first,
          .parameters = parameters.data() + std::ptrdiff_t{per_joint} * first,
          .parameter_count = per_joint,
          .streamed = streamed,
          .time_dependent = time_dependent,
          .row = row.data() + first,
          .D = D.data() + first};
}

}  // namespace linkwork
