#pragma once

#include <array>
#include <vector>

#include "linkwork/math/types.hpp"
#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/model.hpp"

namespace linkwork {

/// Force elements that are inertia of a coordinate x between two bodies: with x_dot = d v and x_ddot = d v_dot - gamma
/// each adds b x_dot^2 / 2 to the kinetic energy, so that in (12.1)
///   M = diag(m I, J) + sum b d^T d,   g includes sum b gamma d^T.
/// The rows d stand in Evaluation::D behind those of the joints, as those of a joint of one row.
class Inerters {
 public:
  /// `D`: the place of the first row.
  Inerters(const Model& model, std::ptrdiff_t D);

  bool empty() const { return all_.empty(); }
  std::size_t count() const { return all_.size(); }
  std::ptrdiff_t D_size() const { return 2 * velocity_size * static_cast<std::ptrdiff_t>(all_.size()); }
  double inertance(std::size_t k) const { return all_[k].inertance; }
  int force(std::size_t k) const { return all_[k].force; }  ///< of the model
  std::array<int, 2> bodies(std::size_t k) const { return {all_[k].i, all_[k].j}; }

  /// Of a row in D.
  std::ptrdiff_t place(std::size_t k) const { return D_ + 2 * velocity_size * static_cast<std::ptrdiff_t>(k); }
  /// The part of d that belongs to its first or second body: that body, or the ground, whose 6 numbers mean nothing.
  struct Part {
    int body;
    const double* d;
  };
  std::array<Part, 2> row(std::size_t k, const double* D) const {
    const double* first = D + place(k);
    return {Part{all_[k].i, first}, Part{all_[k].j, first + velocity_size}};
  }
  /// d x.
  double rate(std::size_t k, const double* D, const double* x) const;
  /// y += sum factor_k d_k^T, of all inerters.
  template <class Factor>
  void add(const double* D, const Factor& factor, double* y) const {
    for (std::size_t k = 0; k < all_.size(); ++k) {
      const double f = factor(k);
      for (const Part& part : row(k, D))
        if (part.body != ground)
          for (int c = 0; c < velocity_size; ++c) y[velocity_size * std::ptrdiff_t{part.body} + c] += f * part.d[c];
    }
  }

  /// What linear solvers take for the model: without forces, and with a joint of one row for each inerter, behind the
  /// others. With the compliance 1 / b of such a row its multiplier is -b x_ddot.
  static Model as_joints(const Model& model);

 private:
  struct Inerter {
    int i, j, force;
    double inertance;
  };

  std::vector<Inerter> all_;
  std::ptrdiff_t D_;
};

}  // namespace linkwork
