// Cox models without a maximum, against an exact test of small tables.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <statistics/cox/cox.hpp>
#include <string>
#include <table/random.hpp>
#include <vector>

#include "support/data_table.hpp"

namespace tcert::statistics {
namespace {

CoxData small_table(std::uint64_t index, std::size_t rows, bool truncated) {
  table::RandomStream random(23, 1, index);
  CoxData data;
  const auto n = static_cast<Eigen::Index>(rows);
  data.design.resize(n, 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double start = truncated ? random.below(3) : 0.0;
    if (truncated) {
      data.outcome.start.push_back(start);
    }
    data.outcome.stop.push_back(start + 1.0 + random.below(6));
    data.outcome.event.push_back(random.below(3) == 0 ? 0 : 1);
    data.design(i, 0) = random.below(3);
    data.design(i, 1) = random.below(2 + static_cast<std::uint32_t>(index % 4));
  }
  data.columns = data.terms = {"a", "b"};
  data.term_of = {0, 1};
  return data;
}

bool at_risk(const CoxData& data, std::size_t row, double time) {
  return data.outcome.stop[row] >= time &&
         (data.outcome.start.empty() || data.outcome.start[row] < time);
}

/// x of a row with an event less x of one at risk, all pairs.
std::vector<Eigen::Vector2d> pairs_of(const CoxData& data, Ties ties) {
  std::vector<Eigen::Vector2d> pairs;
  for (std::size_t i = 0; i < data.rows(); ++i) {
    for (std::size_t j = 0; data.outcome.event[i] != 0 && j < data.rows(); ++j) {
      const double time = data.outcome.stop[i];
      const bool tied = data.outcome.event[j] != 0 && data.outcome.stop[j] == time;
      const Eigen::Vector2d pair = data.design.row(static_cast<Eigen::Index>(i)) -
                                   data.design.row(static_cast<Eigen::Index>(j));
      if (at_risk(data, j, time) && !(tied && ties == Ties::exact) && !pair.isZero(0.0)) {
        pairs.push_back(pair);
      }
    }
  }
  return pairs;
}

/// The edges of the cone of directions with no negative margin, and one inside if it is a half
/// plane. The numbers are small and whole: exact.
std::vector<Eigen::Vector2d> recession_rays(const std::vector<Eigen::Vector2d>& pairs) {
  std::vector<Eigen::Vector2d> rays;
  for (const Eigen::Vector2d& pair : pairs) {
    const Eigen::Vector2d across(-pair(1), pair(0));
    for (const Eigen::Vector2d& ray : {pair, across, Eigen::Vector2d(-across)}) {
      const bool never_falls = std::all_of(
          pairs.begin(), pairs.end(), [&](const auto& other) { return other.dot(ray) >= 0.0; });
      if (never_falls) {
        rays.push_back(ray);
      }
    }
  }
  return rays;
}

bool spans_the_plane(const std::vector<Eigen::Vector2d>& pairs) {
  return std::any_of(pairs.begin(), pairs.end(), [&](const Eigen::Vector2d& pair) {
    const Eigen::Vector2d& first = pairs.front();
    return first(0) * pair(1) != first(1) * pair(0);
  });
}

/// Breslow's log partial likelihood.
double loglik(const CoxData& data, const Eigen::Vector2d& beta) {
  const Eigen::VectorXd eta = data.design * beta;
  double sum = 0.0;
  for (std::size_t i = 0; i < data.rows(); ++i) {
    if (data.outcome.event[i] == 0) {
      continue;
    }
    const double own = eta(static_cast<Eigen::Index>(i));
    double others = 0.0;
    for (std::size_t j = 0; j < data.rows(); ++j) {
      if (at_risk(data, j, data.outcome.stop[i])) {
        others += std::exp(eta(static_cast<Eigen::Index>(j)) - own);
      }
    }
    sum -= std::log(others);
  }
  return sum;
}

/// The derivative of the limit by a finite column: beta far along `inside`, `estimate` beside it.
double slope_of_limit(const CoxData& data,
                      const Eigen::Vector2d& inside,
                      Eigen::Index column,
                      double estimate) {
  constexpr double kStep = 1e-4;
  Eigen::Vector2d beta = 60.0 * inside;
  beta(column) = estimate + kStep;
  const double above = loglik(data, beta);
  beta(column) = estimate - kStep;
  return (above - loglik(data, beta)) / (2.0 * kStep);
}

TEST(CoxMonotone, SmallTablesAreDiagnosedExactly) {
  std::size_t monotone = 0;
  std::size_t finite = 0;
  std::size_t beside = 0;
  for (std::uint64_t index = 0; index < 600; ++index) {
    const CoxData data = small_table(index, 5 + index % 9, index % 3 == 0);
    for (const Ties ties : {Ties::efron, Ties::breslow, Ties::exact}) {
      SCOPED_TRACE("table " + std::to_string(index) + ", " + std::string(to_string(ties)));
      const std::vector<Eigen::Vector2d> pairs = pairs_of(data, ties);
      if (pairs.empty() || !spans_the_plane(pairs)) {
        continue;
      }
      CoxOptions options;
      options.ties = ties;
      const CoxFit fit = fit_cox(data, options);
      const std::vector<Eigen::Vector2d> rays = recession_rays(pairs);
      EXPECT_EQ(to_string(fit.summary.termination),
                to_string(rays.empty() ? CoxTermination::converged : CoxTermination::monotone));
      ++(rays.empty() ? finite : monotone);
      Eigen::Vector2d inside = Eigen::Vector2d::Zero();
      for (const Eigen::Vector2d& ray : rays) {
        inside += ray;
      }
      for (Eigen::Index j = 0; j < 2; ++j) {
        const CoxCoefficient& coefficient = fit.coefficients[static_cast<std::size_t>(j)];
        const bool runs_away = std::any_of(
            rays.begin(), rays.end(), [&](const Eigen::Vector2d& ray) { return ray(j) != 0.0; });
        EXPECT_EQ(coefficient.estimate.has_value(), !runs_away);
        EXPECT_EQ(std::any_of(fit.conditions.begin(),
                              fit.conditions.end(),
                              [&](const Condition& condition) {
                                return condition.kind == ConditionKind::monotone_likelihood &&
                                       condition.column == coefficient.column;
                              }),
                  runs_away);
        if (ties == Ties::breslow && !rays.empty() && coefficient.estimate) {
          // A row with a risk of exp(60) that leaves a set keeps 1e-32 of it there.
          EXPECT_NEAR(slope_of_limit(data, inside, j, *coefficient.estimate),
                      0.0,
                      data.outcome.left_truncated() ? 1e-5 : 1e-6);
          EXPECT_LT(*coefficient.model_se, 1e3);
          ++beside;
        }
      }
    }
  }
  EXPECT_GT(monotone, 200U);
  EXPECT_GT(finite, 200U);
  EXPECT_GT(beside, 5U);
}

CoxFit fit_of(const std::string& csv, const std::string& formula) {
  return fit_cox(cox_data(model_frame(parse_formula(formula), test_support::table_of(csv))));
}

TEST(CoxMonotone, AnInformationThatVanishesIsNoConvergence) {
  // The row with x = 0 at time 2 has its event after those with x = 1: down; -39.83 was a stop.
  const CoxFit three =
      fit_of("t,e,x\n1,0,1\n1,0,1\n2,1,0\n4,0,1\n6,1,2\n4,1,0\n", "Surv(t, e) ~ x");
  EXPECT_EQ(three.summary.termination, CoxTermination::monotone);
  EXPECT_FALSE(three.coefficients[0].estimate.has_value());
  EXPECT_FALSE(three.coefficients[0].hazard_ratio.has_value());
  ASSERT_EQ(three.conditions.size(), 1U);
  EXPECT_EQ(three.conditions[0].detail, "its coefficient runs to -infinity");
}

TEST(CoxMonotone, AMaximumFarAwayIsBelieved) {
  // One event in a thousand pairs speaks against the column: large, but finite.
  std::string csv = "t,e,x\n";
  for (int row = 0; row < 400; ++row) {
    csv += std::to_string(row + 1) + ",1," + (row < 399 ? "1" : "0") + "\n";
  }
  csv += "0.5,1,0\n";
  const CoxFit fit = fit_of(csv, "Surv(t, e) ~ x");
  EXPECT_EQ(fit.summary.termination, CoxTermination::converged);
  EXPECT_TRUE(fit.coefficients[0].estimate.has_value());
}

TEST(CoxMonotone, WhatDoesNotConvergeHasNoNumbers) {
  CoxData data = small_table(1, 12, false);
  CoxOptions options;
  options.iterations = 1;
  const CoxFit fit = fit_cox(data, options);
  EXPECT_EQ(fit.summary.termination, CoxTermination::iteration_limit);
  EXPECT_TRUE(has_error(fit.conditions));
  EXPECT_FALSE(fit.coefficients[0].estimate.has_value());
  EXPECT_FALSE(fit.loglik.has_value());
}

}  // namespace
}  // namespace tcert::statistics
