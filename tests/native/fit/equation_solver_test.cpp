#include "fit/equation_solver.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

#include "base/parallel.h"

namespace gradmesh {
namespace {

/// Equations of the patches of a grid whose points have so many columns each.
std::vector<NormalEquations> random_parts(int rows, int columns, int of_point, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<NormalEquations> parts;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      NormalEquations& part = parts.emplace_back();
      for (const int point : {i * (columns + 1) + j, i * (columns + 1) + j + 1,
                              (i + 1) * (columns + 1) + j, (i + 1) * (columns + 1) + j + 1})
        for (int k = 0; k < of_point; ++k) part.columns.push_back(point * of_point + k);
      const auto size = Eigen::Index(part.columns.size());
      const Eigen::MatrixXd jacobian = Eigen::MatrixXd::NullaryExpr(
          size + 3, size, [&](Eigen::Index, Eigen::Index) { return number(random); });
      part.matrix = jacobian.transpose() * jacobian;
      part.rhs = Eigen::VectorXd::NullaryExpr(size, [&](Eigen::Index) { return number(random); });
    }
  return parts;
}

Eigen::VectorXd solved_at_once(const std::vector<NormalEquations>& parts,
                               const Eigen::VectorXd& damping) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(damping.size(), damping.size());
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(damping.size());
  for (const NormalEquations& part : parts)
    for (std::size_t a = 0; a < part.columns.size(); ++a) {
      rhs(part.columns[a]) += part.rhs(Eigen::Index(a));
      for (std::size_t b = 0; b < part.columns.size(); ++b)
        matrix(part.columns[a], part.columns[b]) += part.matrix(Eigen::Index(a), Eigen::Index(b));
    }
  matrix.diagonal() += matrix.diagonal().cwiseProduct(damping);
  matrix.diagonal().array() += 1e-9;
  return matrix.ldlt().solve(rhs);
}

void expect_near(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  ASSERT_TRUE(a.allFinite());
  EXPECT_LT((a - b).norm(), 1e-9 * (1 + b.norm()));
}

TEST(EquationSolver, finds_what_all_equations_at_once_give) {
  unsigned seed = 0;
  for (const auto& [rows, columns] : {std::pair{1, 1}, {3, 4}, {1, 40}, {9, 7}, {15, 16}})
    for (const int of_point : {1, 2, 5}) {
      SCOPED_TRACE(++seed);
      const int count = (rows + 1) * (columns + 1) * of_point;
      const Eigen::VectorXd damping = Eigen::VectorXd::Constant(count, 0.01);
      EquationSolver solver;
      // Again and again, with other numbers.
      for (const unsigned more : {0, 100}) {
        const auto parts = random_parts(rows, columns, of_point, seed + more);
        expect_near(solver.solve(parts, damping), solved_at_once(parts, damping));
      }
    }
}

TEST(EquationSolver, takes_parts_of_any_columns) {
  std::vector<NormalEquations> parts = random_parts(8, 8, 2, 7);
  // Points far from each other, one that only this part has, none at all, and one in no part.
  const int last = 9 * 9 * 2;
  parts.push_back({{0, last, 97}, 3 * Eigen::Matrix3d::Identity(), Eigen::Vector3d(1, 2, 3)});
  parts.push_back({{}, Eigen::MatrixXd(0, 0), Eigen::VectorXd(0)});
  const Eigen::VectorXd damping = Eigen::VectorXd::Constant(last + 2, 0.1);
  const Eigen::VectorXd found = solve(parts, damping);
  expect_near(found, solved_at_once(parts, damping));
  EXPECT_EQ(found(last + 1), 0);
}

TEST(EquationSolver, gives_no_numbers_where_the_matrix_is_not_definite) {
  std::vector<NormalEquations> parts = random_parts(8, 8, 2, 3);
  parts.front().matrix *= -5;
  EXPECT_FALSE(solve(parts, Eigen::VectorXd::Zero(9 * 9 * 2)).allFinite());
}

TEST(EquationSolver, finds_the_same_bits_on_any_number_of_threads) {
  const auto parts = random_parts(24, 24, 5, 5);
  const Eigen::VectorXd damping = Eigen::VectorXd::Constant(25 * 25 * 5, 0.01);
  const auto solved = [&](int threads) {
    const ThreadLimit limit(threads);
    return solve(parts, damping);
  };
  const Eigen::VectorXd alone = solved(1);
  for (const int threads : {2, 3, 7}) EXPECT_EQ(solved(threads), alone);
}

}  // namespace
}  // namespace gradmesh
