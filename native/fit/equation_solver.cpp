#include "fit/equation_solver.h"

#include <Eigen/Cholesky>
#include <limits>
#include <numeric>
#include <utility>

#include "base/parallel.h"

namespace gradmesh {
namespace {

/// Number of columns up to which a full matrix is quicker.
constexpr Eigen::Index most_full = 60;

double damped(double diagonal, double damping) {
  constexpr double least = 1e-9;
  return diagonal * (1 + damping) + least;
}

Eigen::VectorXd solve_full(const std::vector<NormalEquations>& parts, const Eigen::VectorXd& rhs,
                           const Eigen::VectorXd& damping) {
  const Eigen::Index n = rhs.size();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (const NormalEquations& p : parts)
    for (std::size_t b = 0; b < p.columns.size(); ++b)
      for (std::size_t a = 0; a < p.columns.size(); ++a)
        matrix(p.columns[a], p.columns[b]) += p.matrix(Eigen::Index(a), Eigen::Index(b));
  for (Eigen::Index i = 0; i < n; ++i) matrix(i, i) = damped(matrix(i, i), damping(i));
  return matrix.ldlt().solve(rhs);
}

/// Returns by how much damping raises the diagonal of the sum of the equations.
Eigen::VectorXd raised_by(const std::vector<NormalEquations>& parts,
                          const Eigen::VectorXd& damping) {
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(damping.size());
  for (const NormalEquations& p : parts)
    for (std::size_t a = 0; a < p.columns.size(); ++a)
      diagonal(p.columns[a]) += p.matrix(Eigen::Index(a), Eigen::Index(a));
  Eigen::VectorXd raised(damping.size());
  for (Eigen::Index i = 0; i < damping.size(); ++i)
    raised(i) = damped(diagonal(i), damping(i)) - diagonal(i);
  return raised;
}

/// Cholesky's method, front by front.
class Factorisation {
 private:
  struct Factor {
    /// The columns that are eliminated: a lower triangle, and the rows of the others below it.
    Eigen::MatrixXd lower;
    /// What is left over for the parent, as a lower triangle.
    Eigen::MatrixXd left_over;
    bool is_definite = true;
  };

  auto top(std::size_t front) const {
    const Eigen::MatrixXd& lower = factors_[front].lower;
    return lower.topRows(lower.cols()).triangularView<Eigen::Lower>();
  }
  auto below(std::size_t front) const {
    const Eigen::MatrixXd& lower = factors_[front].lower;
    return lower.bottomRows(lower.rows() - lower.cols());
  }

 public:
  Factorisation(const Elimination& elimination, const std::vector<NormalEquations>& parts,
                const Eigen::VectorXd& raised)
      : elimination_(elimination),
        parts_(parts),
        raised_(raised),
        factors_(elimination.fronts.size()) {}

  /// Eliminates these fronts, whose children are eliminated already or come before them.
  void eliminate(const std::vector<int>& fronts) {
    for (const int front : fronts) eliminate(front);
  }

  /// Returns the solution once all fronts are eliminated; values that are not finite if the matrix
  /// is not positive definite.
  Eigen::VectorXd solve(Eigen::VectorXd rhs) const {
    const std::size_t count = factors_.size();
    for (std::size_t f = 0; f < count; ++f) {
      auto [own, later] = gathered(elimination_.fronts[f], rhs);
      if (!factors_[f].is_definite) own.setConstant(std::numeric_limits<double>::quiet_NaN());
      top(f).solveInPlace(own);
      later.noalias() -= below(f) * own;
      scatter(elimination_.fronts[f], own, later, rhs);
    }
    for (std::size_t f = count; f-- > 0;) {
      auto [own, later] = gathered(elimination_.fronts[f], rhs);
      own.noalias() -= below(f).transpose() * later;
      const auto triangle = top(f);
      triangle.transpose().solveInPlace(own);
      scatter(elimination_.fronts[f], own, later, rhs);
    }
    return rhs;
  }

 private:
  void eliminate(int number) {
    const Front& front = elimination_.fronts[std::size_t(number)];
    const auto size = Eigen::Index(front.columns.size()), own = Eigen::Index(front.eliminated);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    for (const int part : front.parts) add_part(part, matrix);
    for (Eigen::Index i = 0; i < own; ++i) matrix(i, i) += raised_(front.columns[std::size_t(i)]);
    for (const int child : front.children) take_left_over(child, matrix);

    Factor& factor = factors_[std::size_t(number)];
    Eigen::Ref<Eigen::MatrixXd> top = matrix.topLeftCorner(own, own);
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> lower(top);
    factor.is_definite = lower.info() == Eigen::Success;
    if (size > own) {
      auto below = matrix.bottomLeftCorner(size - own, own);
      lower.matrixU().solveInPlace<Eigen::OnTheRight>(below);
      factor.left_over = matrix.bottomRightCorner(size - own, size - own);
      factor.left_over.selfadjointView<Eigen::Lower>().rankUpdate(below, -1);
    }
    factor.lower = matrix.leftCols(own);
  }

  void add_part(int part, Eigen::MatrixXd& matrix) const {
    const std::vector<int>& places = elimination_.places[std::size_t(part)];
    const Eigen::MatrixXd& from = parts_[std::size_t(part)].matrix;
    for (std::size_t b = 0; b < places.size(); ++b)
      for (std::size_t a = 0; a < places.size(); ++a)
        if (places[a] >= places[b])
          matrix(places[a], places[b]) += from(Eigen::Index(a), Eigen::Index(b));
  }

  void take_left_over(int child, Eigen::MatrixXd& matrix) {
    // Both are in the order of elimination.
    const std::vector<int>& places = elimination_.fronts[std::size_t(child)].in_parent;
    const Eigen::MatrixXd from = std::exchange(factors_[std::size_t(child)].left_over, {});
    for (std::size_t b = 0; b < places.size(); ++b)
      for (std::size_t a = b; a < places.size(); ++a)
        matrix(places[a], places[b]) += from(Eigen::Index(a), Eigen::Index(b));
  }

  /// Returns the values of the columns that a front eliminates, and of those that depend on them.
  static std::pair<Eigen::VectorXd, Eigen::VectorXd> gathered(const Front& front,
                                                              const Eigen::VectorXd& values) {
    const auto own = Eigen::Index(front.eliminated);
    Eigen::VectorXd all(Eigen::Index(front.columns.size()));
    for (Eigen::Index i = 0; i < all.size(); ++i) all(i) = values(front.columns[std::size_t(i)]);
    return {all.head(own), all.tail(all.size() - own)};
  }
  static void scatter(const Front& front, const Eigen::VectorXd& own, const Eigen::VectorXd& later,
                      Eigen::VectorXd& values) {
    for (Eigen::Index i = 0; i < own.size(); ++i) values(front.columns[std::size_t(i)]) = own(i);
    for (Eigen::Index i = 0; i < later.size(); ++i)
      values(front.columns[std::size_t(own.size() + i)]) = later(i);
  }

  const Elimination& elimination_;
  const std::vector<NormalEquations>& parts_;
  const Eigen::VectorXd& raised_;
  std::vector<Factor> factors_;
};

std::vector<std::vector<int>> columns_of(const std::vector<NormalEquations>& parts) {
  std::vector<std::vector<int>> columns;
  for (const NormalEquations& part : parts) columns.push_back(part.columns);
  return columns;
}

}  // namespace

EquationSolver::Order::Order(const std::vector<NormalEquations>& parts, Eigen::Index columns)
    : elimination(columns_of(parts), std::size_t(columns)) {
  // In multiplications. Where there is less to do in all, threads cost more than they save; a tree
  // has at most this share of all.
  constexpr double worth_it = 1e6, share = 0.1, front_alone = 200;
  const std::vector<Front>& fronts = elimination.fronts;
  std::vector<double> of_tree;
  double all = 0;
  for (const Front& front : fronts) {
    const auto size = double(front.columns.size());
    double work = front_alone + front.eliminated * size * size;
    all += work;
    for (const int child : front.children) work += of_tree[std::size_t(child)];
    of_tree.push_back(work);
  }
  std::vector<int> tree(fronts.size(), -1);
  for (std::size_t i = fronts.size(); i-- > 0;) {
    const int parent = fronts[i].parent;
    if (parent >= 0 && tree[std::size_t(parent)] >= 0) {
      tree[i] = tree[std::size_t(parent)];
    } else if (all > worth_it && of_tree[i] < share * all) {
      tree[i] = int(trees.size());
      trees.emplace_back();
    }
  }
  for (std::size_t i = 0; i < fronts.size(); ++i)
    (tree[i] < 0 ? afterwards : trees[std::size_t(tree[i])]).push_back(int(i));
}

void EquationSolver::prepare(const std::vector<NormalEquations>& parts, Eigen::Index columns) {
  if (!order_) order_.emplace(parts, columns);
}

Eigen::VectorXd EquationSolver::solve(const std::vector<NormalEquations>& parts,
                                      const Eigen::VectorXd& damping) {
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(damping.size());
  for (const NormalEquations& p : parts)
    for (std::size_t a = 0; a < p.columns.size(); ++a) rhs(p.columns[a]) += p.rhs(Eigen::Index(a));
  if (rhs.size() <= most_full) return solve_full(parts, rhs, damping);
  prepare(parts, rhs.size());
  const Eigen::VectorXd raised = raised_by(parts, damping);
  Factorisation factorisation(order_->elimination, parts, raised);
  parallel_for(order_->trees.size(),
               [&](std::size_t tree) { factorisation.eliminate(order_->trees[tree]); });
  factorisation.eliminate(order_->afterwards);
  return factorisation.solve(std::move(rhs));
}

Eigen::VectorXd solve(const std::vector<NormalEquations>& parts, const Eigen::VectorXd& damping) {
  return EquationSolver().solve(parts, damping);
}

}  // namespace gradmesh
