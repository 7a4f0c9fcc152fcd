#pragma once

#include <vector>

#include "linkwork/assembly/inerters.hpp"
#include "linkwork/math/instruction_set.hpp"
#include "linkwork/math/thread_pool.hpp"

namespace linkwork {

/// Coordinates that force elements lie along, each evaluated once for all of them, as joints of one row are: those of
/// inerters, which are part of the equations of motion, and those that elements of several kinds have in common.
/// Elements of a kind of which some have a coordinate of their own are evaluated by themselves.
class ElementCoordinates {
 public:
  ElementCoordinates() = default;  ///< none
  /// `behind`: the place in D of the first row that is no inerter's.
  ElementCoordinates(const Model& model, const Inerters& inerters, std::ptrdiff_t behind,
                     const InstructionSet& instructions);

  bool empty() const { return places_.empty(); }
  std::size_t count() const { return places_.size(); }
  std::ptrdiff_t D_size() const { return D_size_; }  ///< of rows that are no inerter's
  std::ptrdiff_t place(int row) const { return places_[row]; }
  /// Of the coordinate of a force element, or -1 where it is evaluated by itself.
  int row(int force) const { return rows_of_forces_.empty() ? -1 : rows_of_forces_[force]; }

  /// Those of one kind: of each the element in the model that it is evaluated for, and its row.
  struct Rows {
    CoordinateKind kind;
    bool valued;
    EvaluateJoints evaluate;
    JointBatch batch;
  };
  const std::vector<Rows>& rows() const { return rows_; }

  /// Rows, gammas, coordinates and rates at a state.
  void evaluate(const double* q, const double* v, double* D, double* gamma, double* Phi, double* rate,
                ThreadPool& threads) const;

 private:
  struct Row {
    int force;
    CoordinateKind kind;
    bool valued;
  };
  std::vector<Row> list_rows(const Model& model, const Inerters& inerters);
  void compile(const Model& model, const std::vector<Row>& all, CoordinateKind kind, bool valued,
               const InstructionSet& instructions);

  std::vector<std::ptrdiff_t> places_;
  std::vector<int> rows_of_forces_;
  std::vector<Rows> rows_;
  std::ptrdiff_t D_size_ = 0;
};

}  // namespace linkwork
