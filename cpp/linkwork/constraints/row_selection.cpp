#include "linkwork/constraints/row_selection.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "linkwork/constraints/constraint_kernel.hpp"
#include "linkwork/linear/block/kept_orders.hpp"
#include "linkwork/linear/column_rank.hpp"
#include "linkwork/linear/qr/left_kernel.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork {
namespace {

constexpr double no_choice = 1e-8;        // of the volume that a choice could keep
constexpr double no_obstacle = 1e-6;      // part of gamma that obstructs no motion
constexpr int most_motions = 6;           // that are tried in a dead center
constexpr double firm = 1e-4;             // of it, of each row: its square
constexpr double equal = 1e-6;            // relative difference of volumes that is none
constexpr double most_selection = 5e6;    // flops of choosing rows in one component
constexpr std::size_t longest_loop = 60;  // joints, for dense algebra

/// Of numbers that are as large as the largest but for roundoff the first, so that units and processors choose alike.
Eigen::Index first_of_largest(const VectorXd& x) {
  const double least = (1.0 - equal) * x.maxCoeff();
  const auto found = std::find_if(x.begin(), x.end(), [&](double value) { return value >= least; });
  return std::min(found - x.begin(), x.size() - 1);  // the last of what are no numbers
}

/// Which `count` rows to leave out so that the rest spans as much as possible of all, at both poses: by Gram-Schmidt
/// with pivoting on the rows of orthonormal bases of ker D^T, because the volume of the kept rows is, up to a factor,
/// the determinant of the basis at the others. Rows that are not `preferred` are chosen where there is no other way.
/// The bases are used up. `weakest`, where given, becomes the least square, of all rows and bases, of what is left of a
/// row as it is chosen: the rest spans all at both poses where this is no roundoff.
Places choose_rows(int count, const VectorXd& preferred, std::vector<MatrixXd>& bases, double* weakest = nullptr) {
  Places chosen;
  double least = 1.0;
  for (int k = 0; k < count; ++k) {
    VectorXd score = VectorXd::Ones(bases.front().rows());
    for (const MatrixXd& N : bases) score.array() *= N.rowwise().squaredNorm().array();
    const VectorXd among = score.cwiseProduct(preferred);
    const Eigen::Index best = first_of_largest(among.maxCoeff() < no_choice * score.maxCoeff() ? score : among);
    chosen.push_back(static_cast<int>(best));
    for (MatrixXd& N : bases) {
      least = std::min(least, N.row(best).squaredNorm());
      const VectorXd u = N.row(best).transpose().normalized();
      N -= (N * u) * u.transpose();
      N.row(best).setZero();
    }
  }
  if (weakest) *weakest = least;
  return chosen;
}

/// A component of the loops at one pose.
struct ComponentPose {
  Places dependent;  ///< places in its rows
  MatrixXd kernel;   ///< orthonormal basis; empty where it would be too large
};

/// Rows of a component that depend on the others, at each pose.
struct DependentCounts {
  std::size_t assembled, perturbed;
};

/// Finds the redundant rows of the loops, component by component.
class Selection {
 public:
  Selection(MassWeightedLeastSquares& solver, const ClosedLoops& loops, LoopPose& assembled, LoopPose& perturbed,
            const PerturbedPose& found, double tolerance, bool prefer_closing)
      : solver_(solver),
        loops_(loops),
        assembled_(assembled),
        perturbed_(perturbed),
        found_(found),
        tolerance_(tolerance),
        prefer_closing_(prefer_closing) {
    rows_.resize(loops.component_count());
    independent_.assign(loops.component_count(), 0);
    for (int place = 0; place < loops.row_count(); ++place) rows_[loops.component_of_row(place)].push_back(place);
    list_first_rows();
    preferred_.resize(loops.row_count());
    for (int place = 0; place < loops.row_count(); ++place)
      preferred_[place] = !prefer_closing_ || loops.closing(joint_of(place));
  }

  RedundantRows run() {
    const std::vector<ComponentPose> assembled = components_at(assembled_), perturbed = components_at(perturbed_);
    Places redundant;
    for (std::size_t c = 0; c < rows_.size(); ++c) {
      if (assembled[c].dependent.empty()) {
        independent_[c] = 1;
        continue;
      }
      if (found_.mobile[c] && !found_.reached[c]) {
        append_permanent(c, assembled[c].kernel, redundant);
        continue;
      }
      const bool both = found_.reached[c] && perturbed[c].dependent.size() <= assembled[c].dependent.size();
      const ComponentPose& generic = both ? perturbed[c] : assembled[c];
      if (generic.dependent.empty()) continue;
      look_for_interruption();
      const Places chosen =
          generic.kernel.cols() > 0
              ? redundant_rows(c, generic, both ? &assembled[c] : nullptr)
              : redundant_rows_by_loops(c, both, {assembled[c].dependent.size(), perturbed[c].dependent.size()});
      for (const int local : chosen) redundant.push_back(rows_[c][local]);
    }
    std::sort(redundant.begin(), redundant.end());
    return {std::move(redundant), std::move(independent_)};
  }

 private:
  /// Of a dead center, which cannot be left. A motion v of ker D goes on where D v_dot = gamma(v) has a solution, so
  /// where n . gamma(v) = 0 for all n of ker D^T. The n for which it is not are those of the pose; the others say that
  /// rows repeat each other, as far as the second order knows.
  void append_permanent(std::size_t c, const MatrixXd& kernel, Places& redundant) {
    if (kernel.cols() == 0) return;
    MatrixXd obstacles(kernel.cols(), most_motions);
    for (int k = 0; k < most_motions; ++k) {
      const VectorXd gamma = curvature(c, static_cast<std::uint64_t>(k) + 2);
      obstacles.col(k) = kernel.transpose() * gamma / gamma.norm();
    }
    Eigen::ColPivHouseholderQR<MatrixXd> qr(obstacles);
    if (!(qr.maxPivot() > no_obstacle)) return;  // it is something else that holds the pose
    qr.setThreshold(no_obstacle / qr.maxPivot());
    const MatrixXd Q = qr.householderQ() * MatrixXd::Identity(kernel.cols(), kernel.cols());
    std::vector<MatrixXd> bases = {kernel * Q.rightCols(kernel.cols() - qr.rank())};
    if (bases.front().cols() == 0) return;
    for (const int local : choose_rows(static_cast<int>(bases.front().cols()), preferred_of(c), bases))
      redundant.push_back(rows_[c][local]);
  }

  /// gamma of a random motion that the constraints allow, its part without drivers, of the rows of a component, which
  /// are of unit length in the solver's metric.
  VectorXd curvature(std::size_t c, std::uint64_t seed) {
    const System& system = solver_.system();
    const VectorXd history = system.initial_history();
    Evaluation at = assembled_.at;
    const VectorXd v = random_allowed_velocity(solver_, loops_, at, seed);
    const VectorXd scale = system.delassus_diagonal(at).cwiseSqrt();
    VectorXd sum = VectorXd::Zero(system.row_count());
    for (const auto& [sign, weight] : {std::pair{1.0, 0.5}, {-1.0, 0.5}, {0.0, -1.0}}) {
      system.evaluate_constraints(0.0, found_.q, sign * v, history, at);
      sum += weight * at.gamma;
    }
    VectorXd out(static_cast<Eigen::Index>(rows_[c].size()));
    for (std::size_t r = 0; r < rows_[c].size(); ++r) {
      const int row = loops_.rows()[rows_[c][r]];
      out[static_cast<Eigen::Index>(r)] = scale[row] > 0.0 ? sum[row] / scale[row] : 0.0;
    }
    return out;
  }

  VectorXd preferred_of(std::size_t c) const {
    VectorXd preferred(static_cast<Eigen::Index>(rows_[c].size()));
    for (std::size_t r = 0; r < rows_[c].size(); ++r) preferred[static_cast<Eigen::Index>(r)] = preferred_[rows_[c][r]];
    return preferred;
  }

  /// Components share no body, so one solution gives a vector of the kernel of each.
  std::vector<ComponentPose> components_at(LoopPose& pose) {
    std::vector<ComponentPose> out(rows_.size());
    std::vector<Places> order(rows_.size());  // places in pose.dependent
    std::size_t most = 0;
    for (std::size_t k = 0; k < pose.dependent.size(); ++k) {
      const auto c = static_cast<std::size_t>(loops_.component_of_row(pose.dependent[k]));
      const auto first = rows_[c].begin();
      out[c].dependent.push_back(static_cast<int>(std::lower_bound(first, rows_[c].end(), pose.dependent[k]) - first));
      order[c].push_back(static_cast<int>(k));
    }
    for (std::size_t c = 0; c < rows_.size(); ++c) {
      const double n = static_cast<double>(rows_[c].size()), k = static_cast<double>(order[c].size());
      if (n * k * k > most_selection) order[c].clear();
      most = std::max(most, order[c].size());
      out[c].kernel.resize(static_cast<Eigen::Index>(rows_[c].size()), static_cast<Eigen::Index>(order[c].size()));
    }
    if (most == 0) return out;
    ConstraintKernel kernel(solver_, loops_, pose.at, rows_at(pose.dependent));
    for (std::size_t k = 0; k < most && kernel.regular(); ++k) {
      VectorXd n_d = VectorXd::Zero(kernel.size());
      for (const Places& places : order)
        if (k < places.size()) n_d[places[k]] = 1.0;
      look_for_interruption();
      const VectorXd n = kernel.vector(n_d);
      for (std::size_t c = 0; c < rows_.size(); ++c)
        if (k < order[c].size())
          for (std::size_t r = 0; r < rows_[c].size(); ++r)
            out[c].kernel(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(k)) = n[rows_[c][r]];
    }
    for (ComponentPose& component : out) {
      look_for_interruption();
      MatrixXd& N = component.kernel;
      if (!kernel.regular()) N.resize(N.rows(), 0);
      if (N.cols() > 0) N = Eigen::HouseholderQR<MatrixXd>(N).householderQ() * MatrixXd::Identity(N.rows(), N.cols());
    }
    return out;
  }

  /// Rows of joints that close loops are preferred: without them the tree holds in every pose, so that the kept rows
  /// degenerate only where the loops do.
  Places redundant_rows(std::size_t c, const ComponentPose& generic, const ComponentPose* other) {
    std::vector<MatrixXd> bases;
    for (const ComponentPose* pose : {&generic, other})
      if (pose && pose->kernel.cols() > 0) bases.push_back(pose->kernel);
    return choose_rows(static_cast<int>(generic.dependent.size()), preferred_of(c), bases);
  }

  /// Where the kernel is too large to be written out: what each closing joint repeats of the tree's part of its loop,
  /// and then whatever is still dependent. Where the rows of the tree stay, what is left out depends on what stays: the
  /// rest is independent, at each pose that was looked at, where each row was chosen firmly and they are as many as are
  /// dependent there in all.
  Places redundant_rows_by_loops(std::size_t c, bool both, DependentCounts dependent) {
    Places redundant;
    bool firmly = prefer_closing_;
    for (std::size_t first = 0; first < rows_[c].size();) {
      const Places joint = rows_of(joint_of(rows_[c][first]));
      if (preferred_[joint.front()] > 0.0) {
        const Places found = repeated_in_loop(joint_of(joint.front()), joint, both, firmly);
        redundant.insert(redundant.end(), found.begin(), found.end());
      }
      first += joint.size();
    }
    const std::size_t count = redundant.size();
    if (!firmly || count != dependent.perturbed) append_dependent(c, redundant);
    else independent_[c] = both && count == dependent.assembled;
    for (int& place : redundant)
      place = static_cast<int>(std::lower_bound(rows_[c].begin(), rows_[c].end(), place) - rows_[c].begin());
    return redundant;
  }

  /// Those that depend on each other beside `redundant` ones, which are ascending and remain so.
  void append_dependent(std::size_t c, Places& redundant) {
    Places kept;
    for (const int place : rows_[c])
      if (!std::binary_search(redundant.begin(), redundant.end(), place)) kept.push_back(place);
    for (const int k : dependent_rows(loops_, select_rows(perturbed_.D, kept), tolerance_))
      redundant.push_back(kept[k]);
    std::sort(redundant.begin(), redundant.end());
  }

  /// Rows of a closing joint; ascending. `firmly` becomes false where they hardly depend on the others at one of the
  /// poses.
  Places repeated_in_loop(int joint, const Places& own, bool both, bool& firmly) {
    look_for_interruption();
    Places rows = own;
    for (const int other : loops_.loop_of(joint, longest_loop))
      if (other != joint)
        for (const int place : rows_of(other)) rows.push_back(place);
    if (rows.size() == own.size()) return {};
    std::vector<MatrixXd> bases = {left_kernel_.of(perturbed_.D, rows, tolerance_)};
    if (both) bases.push_back(left_kernel_.of(assembled_.D, rows, tolerance_));
    Eigen::Index count = rows.size();
    for (const MatrixXd& N : bases) count = std::min(count, N.cols());
    VectorXd preferred = VectorXd::Zero(static_cast<Eigen::Index>(rows.size()));
    preferred.head(static_cast<Eigen::Index>(own.size())).setOnes();
    Places out;
    double weakest = 0.0;
    for (const int k : choose_rows(static_cast<int>(count), preferred, bases, &weakest))
      if (k < std::ssize(own)) out.push_back(own[k]);
    firmly &= weakest > firm;
    std::sort(out.begin(), out.end());
    return out;
  }

  void list_first_rows() {
    first_of_.resize(solver_.system().joint_count());
    for (int place = loops_.row_count(); place-- > 0;) first_of_[joint_of(place)] = place;
  }

  std::vector<int> rows_at(Places places) const {
    for (int& place : places) place = loops_.rows()[place];
    return places;
  }

  int joint_of(int place) const { return loops_.joint_of_row(place); }

  /// Places of a joint's rows.
  Places rows_of(int joint) const {
    const auto& first = solver_.system().model().joint_rows();
    Places out(first[joint + 1] - first[joint]);
    std::iota(out.begin(), out.end(), first_of_[joint]);
    return out;
  }

  MassWeightedLeastSquares& solver_;
  const ClosedLoops& loops_;
  LoopPose &assembled_, &perturbed_;
  const PerturbedPose& found_;
  const double tolerance_;
  const bool prefer_closing_;
  std::vector<Places> rows_;   ///< per component
  std::vector<int> first_of_;  ///< of each joint in them: its first row
  std::vector<char> independent_;
  VectorXd preferred_;  ///< per row of the loops: 1 for joints that close loops, else 0
  qr::LeftKernel left_kernel_;
};

/// Numbers for rows next to each other that have the same bodies.
std::vector<int> neighbors_on_same_bodies(const SparseRows& A) {
  std::vector<int> groups, bodies, last;
  for (int row = 0; row < A.rows(); ++row) {
    bodies.clear();
    for (SparseRows::InnerIterator it(A, row); it; ++it)
      if (const int body = static_cast<int>(it.col()) / velocity_size; bodies.empty() || bodies.back() != body)
        bodies.push_back(body);
    const bool same = std::equal(bodies.begin(), bodies.end(), last.begin(), last.end(), std::equal_to<>());
    groups.push_back(groups.empty() ? 0 : groups.back() + !same);
    if (!same) last.swap(bodies);
  }
  return groups;
}

}  // namespace

namespace {

ColumnRank rank_of_rows(const ClosedLoops& loops, const SparseRows& A, double tolerance) {
  const Eigen::Map<const Eigen::SparseMatrix<double>> transposed(A.cols(), A.rows(), A.nonZeros(), A.outerIndexPtr(),
                                                                 A.innerIndexPtr(), A.valuePtr());
  return rank_of_columns(transposed, tolerance, neighbors_on_same_bodies(A), block::kept_orders(loops.system()));
}

Evaluation constraints_at(const System& system, const TimedPose& pose) {
  Evaluation at = system.make_evaluation();
  system.evaluate_constraints(pose.t, pose.q, VectorXd::Zero(system.v_size()), pose.history, at);
  return at;
}

}  // namespace

Places dependent_rows(const ClosedLoops& loops, const SparseRows& A, double tolerance) {
  return rank_of_rows(loops, A, tolerance).dependent;
}

LoopPose::LoopPose(const System& system, const ClosedLoops& loops, const TimedPose& pose, double tolerance)
    : LoopPose(loops, constraints_at(system, pose), tolerance) {}

LoopPose::LoopPose(const ClosedLoops& loops, Evaluation given, double tolerance)
    : at(std::move(given)), D(loops.scaled_D(at)) {
  ColumnRank found = rank_of_rows(loops, D, tolerance);
  dependent = std::move(found.dependent);
  weak = std::move(found.weak);
}

RedundantRows redundant_rows(MassWeightedLeastSquares& solver, const ClosedLoops& loops, LoopPose& assembled,
                             LoopPose& perturbed, const PerturbedPose& found, double tolerance, bool prefer_closing) {
  return Selection(solver, loops, assembled, perturbed, found, tolerance, prefer_closing).run();
}

}  // namespace linkwork
