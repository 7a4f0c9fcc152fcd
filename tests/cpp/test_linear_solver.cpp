#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "linkwork/linear/linear_solver.hpp"
#include "linkwork/math/error.hpp"
#include "support.hpp"

using namespace support;

namespace {

constexpr double failure = 1e-14;  // a pivot ratio that the callers take for a breakdown

/// A symmetric matrix by its entries with row <= column; the diagonal is always stored.
using Entries = std::map<std::pair<int, int>, double>;

SparseMatrix compress(const Entries& upper, Storage storage) {
  const int size = upper.rbegin()->first.second + 1;
  std::vector<std::map<int, double>> columns(size);
  for (int k = 0; k < size; ++k) columns[k][k] = 0.0;
  for (const auto& [at, value] : upper) {
    columns[at.second][at.first] = value;
    if (storage == Storage::full) columns[at.first][at.second] = value;
  }
  SparseMatrix A{size, storage, {0}, {}, {}};
  for (const auto& column : columns) {
    for (const auto& [row, value] : column) {
      A.row.push_back(row);
      A.value.push_back(value);
    }
    A.column_begin.push_back(static_cast<int>(A.row.size()));
  }
  return A;
}

MatrixXd product(const Entries& upper, const MatrixXd& x) {
  MatrixXd y = MatrixXd::Zero(x.rows(), x.cols());
  for (const auto& [at, value] : upper) {
    y.row(at.first) += value * x.row(at.second);
    if (at.first != at.second) y.row(at.second) += value * x.row(at.first);
  }
  return y;
}

/// A band and a few far couplings, diagonally dominant.
Entries positive_definite(int size, Random& random) {
  Entries A;
  VectorXd sum = VectorXd::Zero(size);
  const auto couple = [&](int row, int column) {
    if (row == column) return;
    double& value = A[{std::min(row, column), std::max(row, column)}];
    sum[row] -= std::abs(value), sum[column] -= std::abs(value);
    value = random.number();
    sum[row] += std::abs(value), sum[column] += std::abs(value);
  };
  for (int k = 0; k < size; ++k) {
    for (const int distance : {1, 2})
      if (k + distance < size) couple(k, k + distance);
    if (k % 10 == 0) couple(k, random.integer(std::max(0, k - 100), k));
  }
  for (int k = 0; k < size; ++k) A[{k, k}] = sum[k] + random.number(0.1, 1.0);
  return A;
}

/// [H D^T; D 0], H positive definite; a third of the rows belong to D, each with 1 on a column of its own.
Entries saddle(int size, Random& random) {
  const int rows = size / 3, columns = size - rows;
  Entries A = positive_definite(columns, random);
  for (int row = 0; row < rows; ++row) {
    A[{2 * row, columns + row}] = 1.0;
    if (2 * row + 1 < columns) A[{2 * row + 1, columns + row}] = random.number();
    A[{columns + row, columns + row}] = 0.0;
  }
  return A;
}

Storage storage_of(const LinearSolverInfo& info) { return info.positive_definite ? Storage::upper : Storage::full; }

/// Residual of a solution, relative to the sizes of A, x and b.
double residual(const Entries& A, const MatrixXd& x, const MatrixXd& b) {
  double norm = 0.0;
  for (const auto& entry : A) norm = std::max(norm, std::abs(entry.second));
  const double error =
      (product(A, x) - b).cwiseAbs().maxCoeff() / (norm * x.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff());
  return std::isfinite(error) ? error : INFINITY;
}

/// Factorizes and solves with three right-hand sides at once.
void check_solves(LinearSolver& solver, const Entries& A, Storage storage, Random& random) {
  const SparseMatrix matrix = compress(A, storage);
  CHECK(solver.factorize(matrix).ratio > failure);
  const MatrixXd b = random.matrix(matrix.size, 3);
  MatrixXd x = b;
  solver.solve(x);
  CHECK(residual(A, x, b) < 1e-12);
  CHECK(solver.factor_nonzeros() >= matrix.size);
}

std::unique_ptr<LinearSolver> analyzed(const LinearSolverInfo& info, const Entries& pattern, Storage storage) {
  auto solver = info.make(storage);
  solver->analyze(compress(pattern, storage));
  return solver;
}

/// Runs a check with every solver of this build, in each storage that it is used with.
template <class Check>
void for_every_solver(Check check) {
  for (const LinearSolverInfo& info : linear_solvers()) {
    if (!info.make) continue;
    INFO(info.name);
    check(info, storage_of(info));
    if (info.dense) check(info, Storage::upper);
  }
}

template <class Check>
void for_every_indefinite_solver(Check check) {
  for (const LinearSolverInfo& info : linear_solvers()) {
    if (!info.make || info.positive_definite) continue;
    INFO(info.name);
    check(info);
  }
}

/// A failure is reported by a pivot ratio that is not above `failure`: it may be NaN.
double pivot_ratio(LinearSolver& solver, const Entries& A, Storage storage) {
  return solver.factorize(compress(A, storage)).ratio;
}

}  // namespace

TEST_CASE("every solver solves positive definite systems of every size from 1 to 60") {
  Random random(80);
  for_every_solver([&](const LinearSolverInfo& info, Storage storage) {
    for (int size = 1; size <= 60; ++size) {
      CAPTURE(size);
      const Entries A = positive_definite(size, random);
      check_solves(*analyzed(info, A, storage), A, storage, random);
    }
  });
}

TEST_CASE("every solver that can solves saddle point systems of every size from 3 to 60") {
  Random random(81);
  for_every_indefinite_solver([&](const LinearSolverInfo& info) {
    for (int size = 3; size <= 60; ++size) {
      CAPTURE(size);
      const Entries A = saddle(size, random);
      check_solves(*analyzed(info, A, Storage::full), A, Storage::full, random);
    }
  });
}

TEST_CASE("every sparse solver solves systems of several thousand") {
  Random random(82);
  const int size = 4000;
  const Entries A = positive_definite(size, random), K = saddle(size, random);
  for_every_solver([&](const LinearSolverInfo& info, Storage storage) {
    if (info.dense) return;
    for (const Entries& entries : {A, K}) {
      if (&entries != &A && info.positive_definite) continue;
      check_solves(*analyzed(info, entries, storage), entries, storage, random);
    }
  });
}

TEST_CASE("after one analyze every solver takes new values again and again") {
  Random random(83);
  for_every_solver([&](const LinearSolverInfo& info, Storage storage) {
    Entries A = positive_definite(40, random);
    const auto solver = analyzed(info, A, storage);
    for (int repetition = 0; repetition < 5; ++repetition) {
      const double scale = random.number(0.1, 10.0);
      for (auto& [at, value] : A) value *= at.first == at.second ? scale : scale * random.number(-1.0, 1.0);
      check_solves(*solver, A, storage, random);
    }
  });
}

TEST_CASE("LU keeps its accuracy where new values make the pivots of the last factorization useless") {
  Random random(84);
  for_every_indefinite_solver([&](const LinearSolverInfo& info) {
    Entries A = {{{0, 0}, 1.0}, {{0, 1}, 1.0}, {{1, 1}, 2.0}, {{1, 2}, 1.0}, {{2, 2}, 1.0}, {{0, 2}, 0.25}};
    const auto solver = analyzed(info, A, Storage::full);
    check_solves(*solver, A, Storage::full, random);
    A[{0, 0}] = 1e-14;
    A[{1, 1}] = 1e-14;
    check_solves(*solver, A, Storage::full, random);
  });
}

TEST_CASE("every solver can analyze another pattern, of another size") {
  Random random(85);
  for_every_solver([&](const LinearSolverInfo& info, Storage storage) {
    const auto solver = info.make(storage);
    for (const int size : {30, 50, 7}) {
      const Entries A = positive_definite(size, random);
      solver->analyze(compress(A, storage));
      check_solves(*solver, A, storage, random);
    }
  });
}

namespace {

/// Positive semidefinite with the last row equal to row `twin`: singular, with no zero in its pattern to show it.
Entries with_twin_row(int size, int twin, Random& random) {
  Entries A = positive_definite(size - 1, random);
  const auto value = [&](int a, int b) {
    const auto found = A.find({std::min(a, b), std::max(a, b)});
    return found == A.end() ? 0.0 : found->second;
  };
  const int last = size - 1;
  std::map<int, double> row;
  for (int k = 0; k < last; ++k)
    if (value(twin, k) != 0.0) row[k] = value(twin, k);
  for (const auto& [k, entry] : row) A[{k, last}] = entry;
  A[{last, last}] = value(twin, twin);
  return A;
}

}  // namespace

TEST_CASE("every solver reports a matrix with two equal rows as singular, and names one of the two if any") {
  Random random(86);
  for_every_solver([&](const LinearSolverInfo& info, Storage storage) {
    for (const int size : {2, 5, 20, 60}) {
      CAPTURE(size);
      const int twin = random.integer(0, size - 2);
      const Entries A = with_twin_row(size, twin, random);
      const Pivot pivot = analyzed(info, A, storage)->factorize(compress(A, storage));
      CAPTURE(pivot.ratio);
      CHECK_FALSE(pivot.ratio > failure);
      INFO("row ", pivot.row, " of equal rows ", twin, " and ", size - 1);
      if (pivot.row >= 0) CHECK((pivot.row == twin || pivot.row == size - 1));
    }
  });
}

TEST_CASE("every solver reports a zero matrix and a zero row as singular") {
  Random random(87);
  for_every_solver([&](const LinearSolverInfo& info, Storage storage) {
    Entries A = positive_definite(10, random);
    const auto solver = analyzed(info, A, storage);
    for (auto& [at, value] : A)
      if (at.first == 4 || at.second == 4) value = 0.0;
    CHECK_FALSE(pivot_ratio(*solver, A, storage) > failure);
    for (auto& entry : A) entry.second = 0.0;
    CHECK_FALSE(pivot_ratio(*solver, A, storage) > failure);
  });
}

TEST_CASE("every solver of positive definite systems reports an indefinite one") {
  Random random(88);
  for_every_solver([&](const LinearSolverInfo& info, Storage storage) {
    if (storage == Storage::full) return;
    Entries A = positive_definite(10, random);
    const auto solver = analyzed(info, A, storage);
    A[{6, 6}] *= -1.0;
    CHECK_FALSE(pivot_ratio(*solver, A, storage) > failure);
    A = positive_definite(10, random);
    A[{6, 6}] = 0.01 * A[{6, 6}];
    A[{6, 7}] = 3.0 * A[{7, 7}];
    CHECK_FALSE(pivot_ratio(*solver, A, storage) > failure);
  });
}

TEST_CASE("every solver reports NaN and infinity wherever they stand") {
  Random random(89);
  for_every_solver([&](const LinearSolverInfo& info, Storage storage) {
    for (const double bad : {double(NAN), double(INFINITY)})
      for (const auto& at : std::vector<std::pair<int, int>>{{0, 0}, {19, 19}, {0, 1}, {18, 19}, {10, 10}, {9, 11}}) {
        INFO(bad, " at row ", at.first, ", column ", at.second);
        Entries A = positive_definite(20, random);
        const auto solver = analyzed(info, A, storage);
        A.at(at) = bad;
        CHECK_FALSE(pivot_ratio(*solver, A, storage) > failure);
      }
  });
}

TEST_CASE("every solver reports NaN in a refactorization") {
  Random random(90);
  for_every_solver([&](const LinearSolverInfo& info, Storage storage) {
    Entries A = positive_definite(20, random);
    const auto solver = analyzed(info, A, storage);
    CHECK(pivot_ratio(*solver, A, storage) > failure);
    for (auto& entry : A) entry.second = NAN;
    CHECK_FALSE(pivot_ratio(*solver, A, storage) > failure);
  });
}

TEST_CASE("every solver works again after a failure") {
  Random random(91);
  for_every_solver([&](const LinearSolverInfo& info, Storage storage) {
    const Entries good = positive_definite(20, random);
    const auto solver = analyzed(info, good, storage);
    for (const double bad : {0.0, double(NAN)}) {
      Entries A = good;
      for (auto& entry : A) entry.second = bad;
      CHECK_FALSE(pivot_ratio(*solver, A, storage) > failure);
      check_solves(*solver, good, storage, random);
    }
  });
}

TEST_CASE("the pivot ratio of a positive definite solver does not change under diagonal scaling") {
  Random random(92);
  for_every_solver([&](const LinearSolverInfo& info, Storage storage) {
    if (storage == Storage::full) return;
    Entries A = positive_definite(15, random);
    const auto solver = analyzed(info, A, storage);
    const Pivot pivot = solver->factorize(compress(A, storage));
    for (auto& [at, value] : A) value *= std::pow(10.0, at.first % 5 - 2) * std::pow(10.0, at.second % 5 - 2);
    const Pivot scaled = solver->factorize(compress(A, storage));
    CHECK(scaled.ratio == doctest::Approx(pivot.ratio).epsilon(1e-10));
    CHECK(scaled.row == pivot.row);
  });
}

TEST_CASE("solver names are unique, and an unknown one is refused with a list of those there are") {
  std::set<std::string> names;
  for (const LinearSolverInfo& info : linear_solvers()) names.insert(info.name);
  CHECK(names.size() == linear_solvers().size());
  try {
    linear_solver_info("cholmud");
    FAIL("no error");
  } catch (const OptionError& error) {
    CHECK(error.code() == "unknown_linear_solver");
    CHECK(std::string(error.what()).find("'cholmud'") != std::string::npos);
    CHECK(std::string(error.what()).find("cholmod") != std::string::npos);
  }
}
