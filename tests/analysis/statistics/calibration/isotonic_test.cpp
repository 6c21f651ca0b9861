// R's isoreg (scripts/golden/isotonic.R), and the min-max formula that defines the fit.

#include <statistics/calibration/isotonic.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

using Values = std::vector<double>;

Values fitted(const IsotonicFit& fit, const Values& x) {
  Values values;
  for (const double one : x) {
    values.push_back(fit.at(one));
  }
  return values;
}

TEST(IsotonicFit, IsThatOfR) {
  const nlohmann::json golden = nlohmann::json::parse(std::ifstream(TCERT_GOLDEN "/isotonic.json"));
  double worst = 0.0;
  for (const auto& [name, one] : golden["cases"].items()) {
    const auto x = one["x"].get<Values>();
    const auto y = one["y"].get<Values>();
    for (const Trend trend : {Trend::rising, Trend::falling}) {
      const auto expected = one[trend == Trend::rising ? "rising" : "falling"].get<Values>();
      const Values actual = fitted(isotonic_fit(x, y, trend), x);
      for (std::size_t i = 0; i < x.size(); ++i) {
        worst = std::max(worst, std::abs(actual[i] - expected[i]));
        EXPECT_NEAR(actual[i], expected[i], 1e-12) << name << ' ' << i;
      }
    }
  }
  std::printf("  worst disagreement with isoreg: %.1e\n", worst);
}

/// max over j <= i of min over k >= i of the mean of rows j to k, rows in order of x.
Values min_max(const Values& y) {
  Values fit(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) {
    double most = -1e300;
    for (std::size_t j = 0; j <= i; ++j) {
      double least = 1e300;
      double sum = 0.0;
      for (std::size_t k = j; k < y.size(); ++k) {
        sum += y[k];
        if (k >= i) {
          least = std::min(least, sum / static_cast<double>(k - j + 1));
        }
      }
      most = std::max(most, least);
    }
    fit[i] = most;
  }
  return fit;
}

TEST(IsotonicFit, IsWhatTheMinMaxFormulaGives) {
  for (std::uint64_t round = 0; round < 200; ++round) {
    table::RandomStream random(9, 1, round);
    const std::size_t rows = 1 + random.below(24);
    Values x;
    Values y;
    for (std::size_t i = 0; i < rows; ++i) {
      x.push_back(static_cast<double>(i));
      y.push_back(random.normal() + 0.05 * static_cast<double>(i));
    }
    const IsotonicFit fit = isotonic_fit(x, y, Trend::rising);
    const Values expected = min_max(y);
    for (std::size_t i = 0; i < rows; ++i) {
      EXPECT_NEAR(fit.at(x[i]), expected[i], 1e-12);
    }
    for (std::size_t b = 1; b < fit.blocks.size(); ++b) {
      EXPECT_GT(fit.blocks[b].value, fit.blocks[b - 1].value);
      EXPECT_GT(fit.blocks[b].first_x, fit.blocks[b - 1].last_x);
    }
  }
}

TEST(IsotonicFit, TakesTheDirectionOfTheDataAndFallsWhereThereIsNone) {
  const Values x{0, 1, 2, 3};
  EXPECT_EQ(isotonic_fit(x, Values{1, 2, 2.5, 4}).trend, Trend::rising);
  EXPECT_EQ(isotonic_fit(x, Values{4, 2.5, 3, 1}).trend, Trend::falling);
  EXPECT_EQ(isotonic_fit(x, Values{5, 5, 5, 5}).trend, Trend::falling);
  EXPECT_EQ(isotonic_fit(x, Values{5, 5, 5, 5}).blocks.size(), 1U);
}

TEST(IsotonicFit, JoinsItsBlocksAndKeepsTheirValuesOutside) {
  const IsotonicFit fit = isotonic_fit(Values{0, 1, 3, 4}, Values{2, 4, 8, 6}, Trend::rising);
  ASSERT_EQ(fit.blocks.size(), 3U);
  EXPECT_EQ(fit.blocks[2].rows, 2U);
  EXPECT_EQ(fit.blocks[2].mean_x, 3.5);
  EXPECT_EQ(fit.at(-9), 2.0);
  EXPECT_EQ(fit.at(2), 5.5);
  EXPECT_EQ(fit.at(9), 7.0);
  EXPECT_EQ(fit.squares, 2.0);
}

TEST(IsotonicFit, RefusesWhatIsNoNumberAndWhatHasNoPartner) {
  const Values one{1.0};
  EXPECT_TRUE(isotonic_fit(Values{}, Values{}, Trend::rising).blocks.empty());
  EXPECT_THROW(static_cast<void>(isotonic_fit(one, Values{}, Trend::rising)),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(isotonic_fit(one, Values{std::nan("")}, Trend::rising)),
               std::invalid_argument);
}

}  // namespace
}  // namespace tcert::statistics
