#pragma once

#include <memory>
#include <utility>

#include "linkwork/formulation/formulation.hpp"

namespace linkwork {

/// A formulation whose solutions are those of one linear system,
///   [M  D^T] { v_dot }   {a}
///   [D  -E ] {-lambda} = {b},   E = diag(compliance_),
/// by one of the forms of SaddleSolver.
class DirectFormulation : public Formulation {
 public:
  explicit DirectFormulation(std::unique_ptr<SaddleSolver> saddle) : saddle_(std::move(saddle)) {}

  void factorize(const Evaluation& at) override {
    saddle_->factorize(at, compliance_);
    at_ = &at;
  }
  void solve(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda) override {
    saddle_->solve(a, b, v_dot, lambda);
    refine(a, b, v_dot, lambda);
  }
  void factorize_and_solve(const Evaluation& at, const ConstVector& a, const ConstVector& b, MutableVector v_dot,
                           MutableVector lambda) override {
    saddle_->factorize_and_solve(at, compliance_, a, b, v_dot, lambda);
    at_ = &at;
    refine(a, b, v_dot, lambda);
  }
  SaddleSolver& saddle() const override { return *saddle_; }

 protected:
  /// What else a solution needs.
  virtual void refine(const ConstVector&, const ConstVector&, MutableVector, MutableVector) {}

  std::unique_ptr<SaddleSolver> saddle_;
  const Evaluation* at_ = nullptr;  ///< of the last factorization
  VectorXd compliance_;             ///< positive in dropped rows; empty: none yields
};

}  // namespace linkwork
