#include "linkwork/model/row_forms.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "linkwork/math/aligned.hpp"
#include "linkwork/math/instruction_set.hpp"
#include "linkwork/math/rotation.hpp"
#include "linkwork/model/joint_kind.hpp"

namespace linkwork {
namespace {

/// One joint of a kind in every lane, each with numbers of its own.
class ArbitraryJoints {
 public:
  explicit ArbitraryJoints(const JointKind& kind) : rows_(kind.info.rows) {
    const std::size_t parameter_count = kind.info.parameters.size();
    fill(attachments_, attachment_size);
    fill(parameters_, 3 * static_cast<std::ptrdiff_t>(parameter_count));
    size(states_, 2 * state_size);
    for (int body = 0; body < 2; ++body)
      for (int l = 0; l < width_; ++l) place(body, l);
    for (AlignedDoubles* of_rows : {&Phi_, &Phi_t_, &Phi_dot_, &gamma_}) size(*of_rows, rows_);
    size(D_, 2 * velocity_size * std::ptrdiff_t{rows_});
    kind.evaluate_lanes[0]({1, &i_, &j_, attachments_.data(), parameters_.data(), static_cast<int>(parameter_count),
                            &row_, &place_of_D_, states_.data()},
                           {Phi_.data(), Phi_t_.data(), Phi_dot_.data(), gamma_.data(), D_.data()});
  }

  RowForms forms() const {
    RowForms out{.rows = {}, .holds_point = holds_point(1.0) || holds_point(-1.0)};
    for (int row = 0; row < 2 * rows_; ++row) out.rows.push_back(form(row));
    return out;
  }

 private:
  static constexpr int state_size = sizeof(BodyState<double>) / sizeof(double);

  /// Of D_i or, behind the rows of these, of D_j.
  RowForm form(int row) const {
    const auto has = [&](int k, double size) { return always(row, k, size) || always(row, k, -size); };
    const int zeros = has(0, 0.0) + has(1, 0.0) + has(2, 0.0);
    if (zeros == 3) return RowForm::rotation;
    constexpr RowForm along[] = {RowForm::x, RowForm::y, RowForm::z};
    for (int k = 0; k < 3; ++k)
      if (zeros == 2 && has(k, 1.0)) return along[k];
    return RowForm::general;
  }

  bool holds_point(double s) const {
    for (int row = 0; row < rows_; ++row)
      for (int k = 0; k < 3; ++k) {
        const double number = row == k ? s : 0.0;
        if (!always(row, k, number) || !always(rows_ + row, k, -number)) return false;
      }
    return rows_ >= 3;
  }

  /// Number k of a row of D in all lanes.
  bool always(int row, int k, double number) const {
    const double* numbers = D_.data() + (std::ptrdiff_t{velocity_size} * row + k) * width_;
    return std::all_of(numbers, numbers + width_, [&](double x) { return x == number; });
  }

  void size(AlignedDoubles& numbers, std::ptrdiff_t count) const { numbers.assign(count * width_, 0.0); }
  double number() { return std::uniform_real_distribution<double>(0.3, 0.9)(generator_); }

  void fill(AlignedDoubles& numbers, std::ptrdiff_t count) {
    size(numbers, count);
    for (double& number_of_lane : numbers) number_of_lane = number();
  }

  void place(int body, int l) {
    BodyState<double> state;
    const Vec4<double> p = Vec4<double>(number(), number(), number(), number()).normalized();
    state.A = rotation_matrix<double>(p);
    for (Vec3<double>* it : {&state.r, &state.r_dot, &state.omega}) *it = {number(), number(), number()};
    for (int k = 0; k < state_size; ++k)
      states_[std::size_t(state_size * body + k) * std::size_t(width_) + std::size_t(l)] = state.r.data()[k];
  }

  int width_ = instruction_set(0).width, rows_, i_ = 0, j_ = 1, row_ = 0;
  std::ptrdiff_t place_of_D_ = 0;
  std::mt19937 generator_;
  AlignedDoubles attachments_, parameters_, states_, Phi_, Phi_t_, Phi_dot_, gamma_, D_;
};

}  // namespace

const RowForms& row_forms(int kind) {
  static const std::vector<RowForms> all = [] {
    std::vector<RowForms> out;
    for (const JointKind& it : joint_kinds()) out.push_back(ArbitraryJoints(it).forms());
    return out;
  }();
  return all[static_cast<std::size_t>(kind)];
}

}  // namespace linkwork
