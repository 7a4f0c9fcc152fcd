#include "linkwork/model/batch.hpp"

#include <algorithm>
#include <cstring>

namespace linkwork {
namespace {

std::size_t padded_size(std::size_t count, std::size_t width) { return (count + width - 1) / width * width; }

}  // namespace

void ElementBatch::reserve(std::size_t count, std::size_t parameters_each, int width) {
  width_ = static_cast<std::size_t>(width);
  padded_ = padded_size(count, width_);
  for (std::vector<int>* list : {&body_i, &body_j}) list->reserve(padded_);
  number.reserve(count);
  each_ = parameters_each;
  parameters.reserve(each_ * padded_);
}

void ElementBatch::append(int of_model, int i, int j, const Parameter* first_parameter, std::size_t parameter_count) {
  number.push_back(of_model);
  body_i.push_back(i);
  body_j.push_back(j);
  parameters.insert(parameters.end(), first_parameter, first_parameter + parameter_count);
  time_dependent = time_dependent || std::any_of(first_parameter, first_parameter + parameter_count,
                                                 [](const Parameter& it) { return it.signal >= 0; });
}

void ElementBatch::attach(const Attachment<double>& at) {
  const double* numbers[] = {at.s_i.data(), at.s_j.data(), at.C_i.data(), at.C_j.data()};
  for (std::size_t p = 0; p < parts_.size(); ++p) attach(size() - 1, numbers[p], attachment_parts[p], parts_[p]);
}

void ElementBatch::attach(std::size_t element, const double* numbers, int count, Part& part) const {
  const std::size_t group = width_ * static_cast<std::size_t>(count);
  const auto put = [&](std::size_t first, std::size_t lanes) {
    for (int c = 0; c < count; ++c)
      std::fill_n(part.numbers.begin() + std::ptrdiff_t(first + c * width_), lanes, numbers[c]);
  };
  if (element == 0) {
    part.numbers.resize(group);
    put(0, width_);
  }
  if (!part.varies) {
    const auto same = [&](int c) { return std::memcmp(&numbers[c], &part.numbers[c * width_], sizeof(double)) == 0; };
    int c = 0;
    while (c < count && same(c)) ++c;
    if (c == count) return;
    part.varies = true;
    const std::vector<double> common = std::move(part.numbers);
    part.numbers.reserve(padded_ * static_cast<std::size_t>(count));
    for (std::size_t k = 0; k < padded_; k += width_)
      part.numbers.insert(part.numbers.end(), common.begin(), common.end());
  }
  put(group * (element / width_) + element % width_, 1);
}

void ElementBatch::fill_up() {
  if (number.empty()) return;
  const std::size_t last = (size() - 1) % width_;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    auto& [numbers, varies] = parts_[p];
    if (numbers.empty()) continue;  // nothing was attached
    attachments_[p] = {numbers.data(), varies ? attachment_parts[p] : 0};
    double* end = numbers.data() + numbers.size();  // with the group of the last element before it
    for (double* lanes = end - width_ * attachment_parts[p]; lanes != end; lanes += width_)
      std::fill(lanes + last + 1, lanes + width_, double{lanes[last]});
  }
  body_i.resize(padded_, body_i.back());
  body_j.resize(padded_, body_j.back());
  while (parameters.size() < each_ * padded_) parameters.push_back(parameters[parameters.size() - each_]);
}

ElementArrays ElementBatch::arrays(int first, int last) const {
  return {.count = last - first,
          .body_i = body_i.data() + first,
          .body_j = body_j.data() + first,
          .attachment = attachments_.data(),
          .first = first,
          .parameters = parameters.data() + each_ * static_cast<std::size_t>(first),
          .parameter_count = static_cast<int>(each_),
          .time_dependent = time_dependent};
}

JointArrays JointBatch::joints(int first, int last) const {
  return {arrays(first, last), streamed, number.data() + first, row.data() + first, D.data() + first};
}

ForceElements ForceBatch::elements(int first, int last) const {
  return {arrays(first, last), history.data() + first, switches.data() + first};
}

LawElements ForceBatch::laws(int first, int last) const {
  return {elements(first, last), row.data() + first, D.data() + first};
}

}  // namespace linkwork
