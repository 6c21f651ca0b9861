#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <terrain/separable_gp.hpp>

namespace tcert::terrain {
namespace {

struct Refit {
  Eigen::VectorXd mean;
  Eigen::VectorXd variance;
  double log_likelihood = 0.0;
};

/// The posterior from scratch, by one dense factorisation.
Refit refit(const Grid& grid,
            const GpPrior& prior,
            const std::vector<Position>& at,
            const std::vector<double>& values) {
  const auto kernel = [&](const Position& p, const Position& q) {
    return prior.variance *
           std::exp(-0.5 * (p - q).squaredNorm() / (prior.length_scale * prior.length_scale));
  };
  const auto n = static_cast<Eigen::Index>(at.size());
  Eigen::MatrixXd k(n, n);
  Eigen::VectorXd residual(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      k(i, j) = kernel(at[static_cast<std::size_t>(i)], at[static_cast<std::size_t>(j)]);
    }
    k(i, i) += prior.noise_variance;
    residual(i) = values[static_cast<std::size_t>(i)] - prior.mean;
  }
  const Eigen::LLT<Eigen::MatrixXd> llt(k);
  const Eigen::VectorXd alpha = llt.solve(residual);
  Refit fit{Eigen::VectorXd(static_cast<Eigen::Index>(grid.size())),
            Eigen::VectorXd(static_cast<Eigen::Index>(grid.size()))};
  Eigen::VectorXd row(n);
  for (std::size_t c = 0; c < grid.size(); ++c) {
    for (Eigen::Index i = 0; i < n; ++i) {
      row(i) = kernel(position(grid.cell(c)), at[static_cast<std::size_t>(i)]);
    }
    fit.mean(static_cast<Eigen::Index>(c)) = prior.mean + row.dot(alpha);
    fit.variance(static_cast<Eigen::Index>(c)) =
        prior.variance - llt.matrixL().solve(row).squaredNorm();
  }
  const Eigen::MatrixXd l = llt.matrixL();
  fit.log_likelihood = -0.5 * residual.dot(alpha) - l.diagonal().array().log().sum() -
                       0.5 * static_cast<double>(n) * std::log(2.0 * M_PI);
  return fit;
}

/// Largest errors of the incremental posterior, of the mean relative to the largest value and of
/// the variance relative to the prior's.
std::pair<double, double> errors(
    const Grid& grid, const GpPrior& prior, std::size_t n, bool on_cells, double scale) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(0.0, grid.rows - 1.0);
  std::uniform_real_distribution<double> y(0.0, grid.columns - 1.0);
  std::normal_distribution<double> value(prior.mean, scale);
  SeparableGp gp(grid, prior);
  std::vector<Position> at;
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i) {
    Position p(x(random), y(random));
    at.push_back(on_cells ? position(nearest_cell(p)) : p);
    values.push_back(value(random));
    gp.add(at.back(), values.back());
  }
  const Refit fit = refit(grid, prior, at, values);
  EXPECT_NEAR(fit.log_likelihood, gp.log_likelihood(), 1e-8 * std::abs(fit.log_likelihood));
  double mean = 0.0;
  double variance = 0.0;
  for (std::size_t c = 0; c < grid.size(); ++c) {
    const auto i = static_cast<Eigen::Index>(c);
    mean = std::max(mean, std::abs(fit.mean(i) - gp.mean()[c]));
    variance = std::max(variance, std::abs(fit.variance(i) - gp.variance()[c]));
  }
  return {mean / (std::abs(prior.mean) + scale), variance / prior.variance};
}

TEST(SeparableGp, EqualsAFullRefit) {
  struct Case {
    Grid grid;
    GpPrior prior;
    std::size_t n;
    double scale;
  };
  const std::vector<Case> cases{
      {{20, 15}, {1.0, 0.5, 3.0, 1e-4}, 40, 0.7},
      {{20, 15}, {0.0, 0.5, 3.2, 1e-2}, 40, 0.7},
      {{61, 43}, {0.0, 2.0, 30.0, 1.0}, 200, 1000.0},
      {{61, 43}, {1000.0, 9e4, 20.0, 1.0}, 200, 300.0},
      {{40, 90}, {0.0, 2.0, 1.0, 0.1}, 100, 3.0},
      {{1, 50}, {0.0, 2.0, 5.0, 0.1}, 30, 3.0},
  };
  for (const Case& c : cases) {
    for (const bool on_cells : {true, false}) {
      SCOPED_TRACE(c.prior.length_scale);
      const auto [mean, variance] = errors(c.grid, c.prior, c.n, on_cells, c.scale);
      EXPECT_LT(mean, 1e-9);
      EXPECT_LT(variance, 1e-9);
    }
  }
}

TEST(SeparableGp, EqualsAFullRefitAtFullSize) {
  const auto [mean, variance] = errors({599, 400}, {0.0, 2.0, 30.0, 1.0}, 120, false, 1000.0);
  EXPECT_LT(mean, 1e-9);
  EXPECT_LT(variance, 1e-9);
}

TEST(SeparableGp, KeepsMemorySmall) {
  SeparableGp gp({600, 400}, {0.0, 2.0, 30.0, 1.0});
  for (int i = 0; i < 500; ++i) {
    gp.add(Position(37 * i % 600, 91 * i % 400), i % 13);
  }
  EXPECT_LT(gp.bytes(), std::size_t{50} << 20U);
}

TEST(SeparableGp, RefusesWhatCannotBe) {
  EXPECT_THROW(SeparableGp({0, 4}, {}), std::invalid_argument);
  EXPECT_THROW(SeparableGp({4, 4}, {0.0, -1.0, 3.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(SeparableGp({4, 4}, {0.0, 1.0, 0.0, 1.0}), std::invalid_argument);
  SeparableGp exact({4, 4}, {0.0, 1.0, 2.0, 0.0});
  exact.add({1.0, 1.0}, 3.0);
  EXPECT_THROW(exact.add({1.0, 1.0}, 3.0), std::domain_error);
}

}  // namespace
}  // namespace tcert::terrain
