#include "linkwork/ensemble/row_forms.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "linkwork/math/instruction_set.hpp"
#include "linkwork/math/rotation.hpp"

namespace linkwork {
namespace {

/// One joint of a kind in every lane, each with numbers of its own.
class ArbitraryJoints {
 public:
  explicit ArbitraryJoints(const JointKind& kind) : rows_(kind.info.rows) {
    const std::size_t parameter_count = kind.info.parameters.size();
    fill(attachments_, attachment_size);
    fill(parameters_, 3 * static_cast<std::ptrdiff_t>(parameter_count));
    layout_.size(states_, 2 * state_size);
    for (int body = 0; body < 2; ++body)
      for (int l = 0; l < width(); ++l) place(body, l);
    for (AlignedDoubles* of_rows : {&Phi_, &Phi_t_, &Phi_dot_, &gamma_}) layout_.size(*of_rows, rows_);
    layout_.size(D_, 2 * velocity_size * std::ptrdiff_t{rows_});
    put_constant_D(kind, layout_, D_, place_of_D_);
    kind.evaluate_lanes[0]({1, &i_, &j_, attachments_.data(), parameters_.data(), static_cast<int>(parameter_count),
                            &row_, &place_of_D_, states_.data()},
                           {Phi_.data(), Phi_t_.data(), Phi_dot_.data(), gamma_.data(), D_.data()});
  }

  /// Of D_i or, behind the rows of these, of D_j.
  RowForm form(int row) const {
    const auto always = [&](int k, double size) {
      const double* numbers = D_.data() + (velocity_size * row + k) * width();
      return std::all_of(numbers, numbers + width(), [&](double x) { return std::abs(x) == size; });
    };
    const int zeros = always(0, 0.0) + always(1, 0.0) + always(2, 0.0);
    if (zeros == 3) return RowForm::rotation;
    constexpr RowForm along[] = {RowForm::x, RowForm::y, RowForm::z};
    for (int k = 0; k < 3; ++k)
      if (zeros == 2 && always(k, 1.0)) return along[k];
    return RowForm::general;
  }

 private:
  static constexpr int state_size = sizeof(BodyState<double>) / sizeof(double);

  int width() const { return layout_.width; }
  double number() { return std::uniform_real_distribution<double>(0.3, 0.9)(generator_); }

  void fill(AlignedDoubles& numbers, std::ptrdiff_t count) {
    layout_.size(numbers, count);
    for (double& number_of_lane : numbers) number_of_lane = number();
  }

  void place(int body, int l) {
    BodyState<double> state;
    const Vec4<double> p = Vec4<double>(number(), number(), number(), number()).normalized();
    state.A = rotation_matrix<double>(p);
    for (Vec3<double>* it : {&state.r, &state.r_dot, &state.omega}) *it = {number(), number(), number()};
    layout_.give(state.r.data(), state_size, l, states_, std::ptrdiff_t{state_size} * body);
  }

  LaneLayout layout_{lane_kernels(instruction_set(0)).width};
  int rows_, i_ = 0, j_ = 1, row_ = 0;
  std::ptrdiff_t place_of_D_ = 0;
  std::mt19937 generator_;
  AlignedDoubles attachments_, parameters_, states_, Phi_, Phi_t_, Phi_dot_, gamma_, D_;
};

}  // namespace

void put_constant_D(const JointKind& kind, const LaneLayout& layout, AlignedDoubles& D, std::ptrdiff_t first) {
  if (!kind.holds_point) return;
  const auto put = [&](std::ptrdiff_t k, double x) { std::fill_n(layout.place(D, k, 0), layout.width, x); };
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      put(first + velocity_size * r + c, r == c ? 1.0 : 0.0);
      put(first + velocity_size * (kind.info.rows + r) + c, r == c ? -1.0 : -0.0);
    }
}

std::vector<RowForm> row_forms(int kind) {
  const JointKind& joint = joint_kinds()[kind];
  const ArbitraryJoints joints(joint);
  std::vector<RowForm> out;
  for (int row = 0; row < 2 * joint.info.rows; ++row) out.push_back(joints.form(row));
  return out;
}

}  // namespace linkwork
