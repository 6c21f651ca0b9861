#include <statistics/logistic/separation.hpp>

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/orthonormal_basis.hpp>
#include <string>
#include <table/random.hpp>
#include <utility>
#include <vector>

namespace tcert::statistics {
namespace {

/// Data on small whole numbers, so that the oracle can be exact.
struct Data {
  Eigen::MatrixXd design;
  Eigen::VectorXd successes;
  Eigen::VectorXd trials;
};

/// Every direction of recession of a cone in p dimensions is a sum of extreme ones and of the
/// lineality; with a design of full rank there is no lineality, and an extreme direction is the
/// null vector of p - 1 rows. All of them are tried.
class Oracle {
 public:
  explicit Oracle(const Data& data) : data_(data), p_(data.design.cols()) {
    std::vector<Eigen::Index> chosen;
    choose(0, chosen);
  }

  /// Extreme directions of {d : s x d >= 0}.
  [[nodiscard]] const std::vector<Eigen::VectorXd>& directions() const { return directions_; }

  [[nodiscard]] std::vector<bool> overlaps() const {
    std::vector<bool> result(static_cast<std::size_t>(data_.design.rows()), true);
    for (const Eigen::VectorXd& d : directions_) {
      for (Eigen::Index i = 0; i < data_.design.rows(); ++i) {
        if (std::abs(data_.design.row(i).dot(d)) > 1e-6) {
          result[static_cast<std::size_t>(i)] = false;
        }
      }
    }
    return result;
  }

 private:
  void choose(Eigen::Index first, std::vector<Eigen::Index>& chosen) {
    if (static_cast<Eigen::Index>(chosen.size()) == p_ - 1) {
      try_rows(chosen);
      return;
    }
    for (Eigen::Index i = first; i < data_.design.rows(); ++i) {
      chosen.push_back(i);
      choose(i + 1, chosen);
      chosen.pop_back();
    }
  }

  void try_rows(const std::vector<Eigen::Index>& chosen) {
    const Eigen::MatrixXd rows = data_.design(chosen, Eigen::all);
    Eigen::VectorXd d = Eigen::VectorXd::Ones(1);
    if (p_ > 1) {
      const Eigen::FullPivLU<Eigen::MatrixXd> lu(rows);
      if (lu.rank() < p_ - 1) {
        return;
      }
      d = lu.kernel().col(0).normalized();
    }
    if (recedes(d)) {
      directions_.push_back(d);
    }
    if (recedes(-d)) {
      directions_.emplace_back(-d);
    }
  }

  [[nodiscard]] bool recedes(const Eigen::VectorXd& d) const {
    for (Eigen::Index i = 0; i < data_.design.rows(); ++i) {
      const double margin = data_.design.row(i).dot(d);
      if ((data_.successes[i] > 0.0 && margin < -1e-6) ||
          (data_.successes[i] < data_.trials[i] && margin > 1e-6)) {
        return false;
      }
    }
    return true;
  }

  const Data& data_;
  Eigen::Index p_;
  std::vector<Eigen::VectorXd> directions_;
};

Data random_data(std::uint64_t seed) {
  table::RandomStream random(seed, 7, 0);
  const auto p = static_cast<Eigen::Index>(1 + random.below(4));
  const auto n = p + static_cast<Eigen::Index>(random.below(9));
  Data data{Eigen::MatrixXd(n, p), Eigen::VectorXd(n), Eigen::VectorXd(n)};
  const bool sloped = random.below(2) == 1;
  for (Eigen::Index i = 0; i < n; ++i) {
    double sum = 0.0;
    for (Eigen::Index j = 0; j < p; ++j) {
      data.design(i, j) = j == 0 ? 1.0 : static_cast<double>(random.below(5)) - 2.0;
      sum += j == 0 ? 0.0 : data.design(i, j);
    }
    data.trials[i] = 1.0 + static_cast<double>(random.below(2) * random.below(2));
    const double noise = static_cast<double>(random.below(3)) - 1.0;
    data.successes[i] =
        sloped ? (sum + noise > 0.0 ? data.trials[i] : 0.0)
               : static_cast<double>(random.below(static_cast<std::uint32_t>(data.trials[i]) + 1));
  }
  return data;
}

LogisticInput input_of(const Data& data) {
  LogisticInput input;
  input.design = data.design;
  input.successes = data.successes;
  input.trials = data.trials;
  for (Eigen::Index j = 0; j < data.design.cols(); ++j) {
    input.columns.push_back(j == 0 ? "(Intercept)" : "x" + std::to_string(j));
    input.term_of.push_back(static_cast<std::size_t>(j));
    if (j > 0) {
      input.terms.push_back(input.columns.back());
    }
  }
  return input;
}

TEST(Separation, EqualsTheExtremeDirectionsOfRandomSmallData) {
  int kinds[3] = {0, 0, 0};
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    SCOPED_TRACE(seed);
    const Data data = random_data(seed);
    const OrthonormalBasis space = orthonormal_basis(data.design);
    if (!space.dropped.empty()) {
      continue;
    }
    const SeparationResult found = find_separation(space.basis, data.successes, data.trials);
    const std::vector<bool> expected = Oracle(data).overlaps();
    ASSERT_EQ(found.overlaps, expected);
    const auto apart = std::count(expected.begin(), expected.end(), false);
    EXPECT_EQ(found.kind,
              apart == 0                    ? Separation::none
              : apart == data.design.rows() ? Separation::complete
                                            : Separation::quasi);
    ++kinds[static_cast<int>(found.kind)];
  }
  std::printf("separation oracle: %d none, %d quasi, %d complete\n", kinds[0], kinds[1], kinds[2]);
  EXPECT_GT(kinds[0], 100);
  EXPECT_GT(kinds[1], 100);
  EXPECT_GT(kinds[2], 100);
}

/// What the extreme directions say of coefficient j.
CoefficientKind kind_of(const std::vector<Eigen::VectorXd>& directions, Eigen::Index j) {
  bool positive = false;
  bool negative = false;
  for (const Eigen::VectorXd& d : directions) {
    positive = positive || d[j] > 1e-6;
    negative = negative || d[j] < -1e-6;
  }
  if (positive && negative) {
    return CoefficientKind::diverging;
  }
  return positive   ? CoefficientKind::plus_infinity
         : negative ? CoefficientKind::minus_infinity
                    : CoefficientKind::finite;
}

TEST(Separation, NamesTheInfiniteCoefficientsOfRandomSmallData) {
  int separated = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    const Data data = random_data(seed);
    const LogisticFit fit = fit_logistic(input_of(data));
    if (has(fit.conditions, ConditionKind::one_class) || fit.rank < fit.coefficients.size()) {
      continue;
    }
    const Oracle oracle(data);
    EXPECT_EQ(fit.separation == Separation::none, oracle.directions().empty());
    EXPECT_EQ(fit.termination, Termination::converged);
    separated += fit.separation != Separation::none ? 1 : 0;
    for (Eigen::Index j = 0; j < data.design.cols(); ++j) {
      const LogisticCoefficient& coefficient = fit.coefficients[static_cast<std::size_t>(j)];
      EXPECT_EQ(coefficient.kind, kind_of(oracle.directions(), j)) << coefficient.column;
      EXPECT_EQ(coefficient.estimate.has_value(), coefficient.kind == CoefficientKind::finite);
    }
    // The likelihood that was reached is the supremum: far along, the fitted values are the limits.
    if (fit.separation != Separation::none) {
      const std::vector<bool> overlaps = oracle.overlaps();
      for (std::size_t i = 0; i < overlaps.size(); ++i) {
        const double fitted = fit.fitted[static_cast<Eigen::Index>(i)];
        EXPECT_EQ(overlaps[i], fitted != 0.0 && fitted != 1.0);
      }
    }
  }
  EXPECT_GT(separated, 300);
}

LogisticInput line(const std::vector<double>& x, const std::vector<double>& y) {
  Data data{Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(x.size()), 2),
            Eigen::VectorXd(static_cast<Eigen::Index>(y.size())),
            Eigen::VectorXd::Ones(static_cast<Eigen::Index>(y.size()))};
  for (std::size_t i = 0; i < x.size(); ++i) {
    data.design(static_cast<Eigen::Index>(i), 1) = x[i];
    data.successes[static_cast<Eigen::Index>(i)] = y[i];
  }
  return input_of(data);
}

TEST(Separation, SaysWhereANumberTellsTheOutcomesApart) {
  const LogisticFit complete = fit_logistic(line({1, 2, 3, 4}, {1, 1, 0, 0}));
  EXPECT_EQ(complete.separation, Separation::complete);
  EXPECT_EQ(complete.coefficients[0].kind, CoefficientKind::plus_infinity);
  EXPECT_EQ(complete.coefficients[1].kind, CoefficientKind::minus_infinity);
  EXPECT_EQ(complete.conditions.back().detail,
            "the estimate is -infinity, every row with x1 >= 3 has y = 0, every row with x1 <= 2 "
            "has y = 1");
  EXPECT_EQ(complete.log_likelihood, 0.0);

  const LogisticFit quasi = fit_logistic(line({1, 2, 2, 4}, {0, 0, 1, 1}));
  EXPECT_EQ(quasi.separation, Separation::quasi);
  EXPECT_EQ(quasi.conditions.back().detail,
            "the estimate is +infinity, every row with x1 > 2 has y = 1, every row with x1 < 2 has "
            "y = 0");
  EXPECT_NEAR(*quasi.log_likelihood, 2.0 * std::log(0.5), 1e-14) << "the two tied rows";
  EXPECT_NEAR(quasi.fitted[1], 0.5, 1e-15);
  EXPECT_EQ(quasi.fitted[3], 1.0);
}

TEST(Separation, IsNotSeenWhereASingleRowOverlapsByLittle) {
  const LogisticFit fit = fit_logistic(line({1, 2, 3, 3.0001, 4, 5}, {0, 0, 1, 0, 1, 1}));
  EXPECT_EQ(fit.separation, Separation::none);
  EXPECT_EQ(fit.coefficients[1].kind, CoefficientKind::ran_away) << "finite, by a hair";
  EXPECT_TRUE(fit.log_likelihood.has_value());
}

TEST(Separation, DoesNotDependOnUnitsOrPlace) {
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i < 60; ++i) {
    x.push_back(1.7e9 + 1e-3 * i);
    y.push_back(i < 31 ? 0.0 : 1.0);
  }
  EXPECT_EQ(fit_logistic(line(x, y)).separation, Separation::complete);
  std::swap(y[30], y[31]);
  EXPECT_EQ(fit_logistic(line(x, y)).separation, Separation::none);
}

}  // namespace
}  // namespace tcert::statistics
