#include "linkwork/linear/blas_buffer.hpp"

#include <doctest/doctest.h>
#include <sys/resource.h>

#include <algorithm>
#include <new>

#include "linkwork/linear/linear_solver.hpp"
#include "support.hpp"

using namespace linkwork;

namespace {

/// While it is there the process gets no more memory that is worth a buffer.
class NoMemory {
 public:
  NoMemory() {
    getrlimit(RLIMIT_AS, &before_);
    rlimit none = before_;
    none.rlim_cur = 1 << 20;
    setrlimit(RLIMIT_AS, &none);
  }
  ~NoMemory() { setrlimit(RLIMIT_AS, &before_); }

 private:
  rlimit before_;
};

/// Whether the buffer is not to be had.
bool refused() {
  const NoMemory none;
  try {
    reserve_blas_buffer();
  } catch (const std::bad_alloc&) {
    return true;
  }
  return false;
}

bool no_solver_has_blas() {
  const auto& all = linear_solvers();
  return std::none_of(all.begin(), all.end(), [](const auto& it) { return it.blas && it.available(); });
}

}  // namespace

TEST_CASE("where there is no memory for the buffer of BLAS it is refused, and had later; it is taken once" *
          doctest::skip(support::sanitized || no_solver_has_blas())) {
  CHECK(refused());
  CHECK(refused());
  reserve_blas_buffer();
  CHECK_FALSE(refused());
}
