// Rank-revealing QR of D^T of growing mechanisms: linkwork's own beside SuiteSparse's SPQR, on the same matrix, in
// turns. Build and run: cmake --build build/dev --target bench_rank && build/dev/bench_rank
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <new>

#include "linkwork/constraints/closed_loops.hpp"
#include "linkwork/constraints/row_selection.hpp"
#include "linkwork/linear/block/kept_orders.hpp"
#include "mechanisms.hpp"
#include "spqr_rank.hpp"

using namespace support;

namespace {

void join(Model& model, const std::string& kind, int i, int j, const Vec3<double>& P) {
  support::join(model, kind, kind + std::to_string(model.joints().size()), i, j, P);
}

/// Plates in a square of n x n, joined to their neighbors: all by hinges about z (redundant), or by balls.
Model plates(int n, const std::string& kind) {
  Model model;
  Random random(7);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      model.add_body("plate" + std::to_string(model.bodies().size()),
                     body_at({1.0 * i, 1.0 * j, 0.1 * random.number()}));
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (i + 1 < n) join(model, kind, n * i + j, n * (i + 1) + j, {i + 0.5, 1.0 * j, 0.2 * random.number()});
      if (j + 1 < n) join(model, kind, n * i + j, n * i + j + 1, {1.0 * i, j + 0.5, 0.2 * random.number()});
    }
  return model;
}

/// Legs of two bars from one frame to the ground.
Model legs(int n) {
  Model model;
  Random random(8);
  const int frame = model.add_body("frame", body_at({0, 0, 1}));
  for (int k = 0; k < n; ++k) {
    const Vec3<double> foot = random.vec3(), knee = random.vec3(), hip = random.vec3();
    const int lower = model.add_body("lower" + std::to_string(k), body_at(0.5 * (foot + knee)));
    const int upper = model.add_body("upper" + std::to_string(k), body_at(0.5 * (hip + knee)));
    join(model, "universal", ground, lower, foot);
    join(model, "revolute", lower, upper, knee);
    join(model, "spherical", upper, frame, hip);
  }
  return model;
}

/// Of the processor, with one thread.
double seconds(const std::function<void()>& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void measure(const char* name, int size, const Model& model) {
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  const ClosedLoops core(system, at, 1e-9);
  const SparseRows D = core.scaled_D(at);
  const Eigen::SparseMatrix<double> transposed = D.transpose();
  double own = 1e300, reference = 1e300;
  const int repeats = static_cast<int>(1 + 20000 / D.rows());
  std::size_t own_count = 0, reference_count = 0;
  for (int round = 0; round < (D.rows() > 100000 ? 1 : 3); ++round) {
    own = std::min(own, seconds([&] {
                          for (int k = 0; k < repeats; ++k) {
                            block::kept_orders(system).forget();
                            own_count = dependent_rows(core, D, 1e-9).size();
                          }
                        }) / repeats);
    try {
      reference = std::min(reference, seconds([&] {
                                        for (int k = 0; k < repeats; ++k)
                                          reference_count = spqr_dependent_columns(transposed, 1e-9).size();
                                      }) / repeats);
    } catch (const std::bad_alloc&) {  // it gives up where hubs fill its factors
      reference = INFINITY;
    }
  }
  std::printf("%-14s %6d %8ld %8zu %8zu %10.6f %10.6f %8.2f\n", name, size, static_cast<long>(D.rows()), own_count,
              reference_count, own, reference, own / reference);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int most = argc > 1 ? std::atoi(argv[1]) : 1 << 30;
  std::printf("%-14s %6s %8s %8s %8s %10s %10s %8s\n", "mechanism", "size", "rows", "dead", "SPQR's", "own [s]",
              "SPQR [s]", "ratio");
  for (const int n : {1, 10, 200, 2000, 20000, 50000})
    if (n <= most) measure("ladder", n, ladder(n));
  for (const int n : {4, 10, 30, 100, 224})
    if (n * n <= most) measure("plates, balls", n, plates(n, "spherical"));
  for (const int n : {4, 10, 30, 60})
    if (n * n <= most) measure("plates, hinges", n, plates(n, "revolute"));
  for (const int n : {3, 30, 300, 3000, 30000})
    if (n <= most) measure("legs of a hub", n, legs(n));
}
