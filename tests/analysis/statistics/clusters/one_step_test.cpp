#include <statistics/clusters/one_step.hpp>

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <table/random.hpp>

namespace tcert::statistics {
namespace {

TEST(OneStepChanges, AreThoseOfRefitsInALinearModel) {
  table::RandomStream random(1, 72, 0);
  constexpr Eigen::Index kClusters = 12;
  constexpr Eigen::Index kRows = 5;
  Eigen::MatrixXd x(kClusters * kRows, 3);
  Eigen::VectorXd y(x.rows());
  for (Eigen::Index row = 0; row < x.rows(); ++row) {
    x.row(row) << 1.0, random.normal(), random.normal();
    y(row) = random.normal();
  }
  const Eigen::MatrixXd information = x.transpose() * x;
  const Eigen::VectorXd all = information.llt().solve(x.transpose() * y);
  // inverse = L L' with L the inverse of the upper factor.
  const Eigen::MatrixXd l =
      information.llt().matrixU().solve(Eigen::MatrixXd::Identity(3, 3)).eval();
  SandwichParts parts;
  parts.scores.resize(3, kClusters);
  for (Eigen::Index g = 0; g < kClusters; ++g) {
    const Eigen::MatrixXd own = x.middleRows(g * kRows, kRows);
    parts.scores.col(g) =
        l.transpose() * own.transpose() * (y.segment(g * kRows, kRows) - own * all);
    parts.shares.emplace_back(l.transpose() * own.transpose() * own * l);
  }
  const Eigen::MatrixXd changes = l * one_step_changes(parts);
  for (Eigen::Index g = 0; g < kClusters; ++g) {
    const Eigen::MatrixXd own = x.middleRows(g * kRows, kRows);
    const Eigen::VectorXd refit =
        Eigen::MatrixXd(information - own.transpose() * own)
            .llt()
            .solve(x.transpose() * y - own.transpose() * y.segment(g * kRows, kRows));
    EXPECT_TRUE(changes.col(g).isApprox(refit - all, 1e-10)) << g;
  }
}

/// Rounding leaves of the rest's information a little of either sign: no number may come of it.
TEST(OneStepChanges, AreMissingWhereAClusterHoldsAllOfADirection) {
  table::RandomStream random(1, 72, 1);
  for (int draw = 0; draw < 100; ++draw) {
    Eigen::VectorXd direction(4);
    SandwichParts parts;
    parts.scores.resize(4, 1);
    for (Eigen::Index j = 0; j < 4; ++j) {
      direction(j) = random.normal();
      parts.scores(j, 0) = 1e-9 * random.normal();
    }
    direction.normalize();
    parts.shares = {direction * direction.transpose()};
    EXPECT_TRUE(one_step_changes(parts).array().isNaN().all()) << draw;
  }
}

}  // namespace
}  // namespace tcert::statistics
