#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>

#include "fit/equations.h"

namespace gradmesh {
namespace {

/// Number of columns up to which a full matrix is quicker.
constexpr Eigen::Index most_full = 150;

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

Eigen::VectorXd solve_sparse(const std::vector<NormalEquations>& parts, const Eigen::VectorXd& rhs,
                             const Eigen::VectorXd& damping) {
  const Eigen::Index n = rhs.size();
  std::vector<Eigen::Triplet<double>> entries;
  for (const NormalEquations& p : parts)
    for (std::size_t b = 0; b < p.columns.size(); ++b)
      for (std::size_t a = 0; a < p.columns.size(); ++a)
        if (p.columns[a] >= p.columns[b])
          entries.emplace_back(p.columns[a], p.columns[b],
                               p.matrix(Eigen::Index(a), Eigen::Index(b)));
  for (int i = 0; i < int(n); ++i) entries.emplace_back(i, i, 0.0);
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  for (Eigen::Index i = 0; i < n; ++i)
    matrix.coeffRef(i, i) = damped(matrix.coeff(i, i), damping(i));
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(rhs);
}

}  // namespace

Eigen::VectorXd solve(const std::vector<NormalEquations>& parts, const Eigen::VectorXd& damping) {
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(damping.size());
  for (const NormalEquations& p : parts)
    for (std::size_t a = 0; a < p.columns.size(); ++a) rhs(p.columns[a]) += p.rhs(Eigen::Index(a));
  return rhs.size() <= most_full ? solve_full(parts, rhs, damping)
                                 : solve_sparse(parts, rhs, damping);
}

}  // namespace gradmesh
