// What R says (scripts/golden/equivalence.R).

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <statistics/basics/binomial_interval.hpp>
#include <statistics/equivalence/equivalence.hpp>
#include <string>

namespace tcert::statistics {
namespace {

using nlohmann::json;

constexpr double kRelative = 1e-10;

std::map<std::string, double>& worst() {
  static std::map<std::string, double> table;
  return table;
}

void expect_equal(const std::string& quantity, double actual, const json& golden) {
  const auto expected = golden.get<double>();
  const double error =
      actual == expected ? 0.0 : std::abs(actual - expected) / std::max(std::abs(expected), 1e-300);
  worst()[quantity] = std::max(worst()[quantity], error);
  EXPECT_LE(error, kRelative) << quantity << ": " << actual << " is not " << expected;
}

json golden() {
  std::ifstream file(std::string(TCERT_GOLDEN) + "/equivalence.json");
  return json::parse(file);
}

TEST(EquivalenceGolden, ProportionsEqualR) {
  const json cases = golden()["proportions"];
  for (const json& one : cases) {
    const auto k = one["k"].get<std::size_t>();
    const auto n = one["n"].get<std::size_t>();
    const auto level = one["level"].get<double>();
    SCOPED_TRACE(std::to_string(k) + " of " + std::to_string(n));
    const Interval exact = clopper_pearson(k, n, level).value();
    expect_equal("Clopper-Pearson", exact.low, one["exact"][0]);
    expect_equal("Clopper-Pearson", exact.high, one["exact"][1]);
    expect_equal("one-sided bound", *clopper_pearson_upper(k, n, level), one["upper"]);
    const Interval score = wilson(k, n, level).value();
    expect_equal("Wilson", score.low, one["wilson"][0]);
    expect_equal("Wilson", score.high, one["wilson"][1]);
  }
  std::printf("proportion golden cases run: %zu\n", cases.size());
  EXPECT_GT(cases.size(), 0U);
}

TEST(EquivalenceGolden, LossesEqualR) {
  const json cases = golden()["losses"];
  for (const json& one : cases) {
    const auto margin = one["margin"].get<double>();
    const NonInferiority mine =
        non_inferiority(one["k"].get<std::size_t>(), one["n"].get<std::size_t>(), margin).value();
    expect_equal("loss bound", mine.upper, one["upper"]);
    expect_equal("loss p", mine.p_value, one["p"]);
    EXPECT_EQ(mine.non_inferior, one["p"].get<double>() < 0.05);
  }
  std::printf("loss golden cases run: %zu\n", cases.size());
  EXPECT_GT(cases.size(), 0U);
}

GroupEstimates groups_of(const json& one) {
  const auto values = one["estimate"].get<std::vector<double>>();
  const auto k = static_cast<Eigen::Index>(values.size());
  GroupEstimates groups;
  groups.values = Eigen::Map<const Eigen::VectorXd>(values.data(), k);
  groups.covariance.resize(k, k);
  for (Eigen::Index i = 0; i < k; ++i) {
    groups.names.push_back(std::to_string(i));
    for (Eigen::Index j = 0; j < k; ++j) {
      groups.covariance(i, j) =
          one["covariance"][static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].get<double>();
    }
  }
  return groups;
}

TEST(EquivalenceGolden, GroupsEqualR) {
  const json cases = golden()["groups"];
  for (const json& one : cases) {
    EquivalenceOptions options;
    options.margin = one["margin"].get<double>();
    const Equivalence mine = equivalence(groups_of(one), options);
    ASSERT_EQ(mine.pairs.size(), one["pairs"].size());
    for (std::size_t i = 0; i < mine.pairs.size(); ++i) {
      const json& pair = one["pairs"][i];
      EXPECT_EQ(mine.pairs[i].first, pair["first"].get<std::size_t>());
      EXPECT_EQ(mine.pairs[i].second, pair["second"].get<std::size_t>());
      expect_equal("difference", mine.pairs[i].difference, pair["difference"]);
      expect_equal("SE", mine.pairs[i].standard_error, pair["se"]);
      expect_equal("interval", mine.pairs[i].interval.low, pair["low"]);
      expect_equal("interval", mine.pairs[i].interval.high, pair["high"]);
      expect_equal("TOST p", mine.pairs[i].p_value, pair["p"]);
      EXPECT_EQ(mine.pairs[i].equivalent, pair["equivalent"].get<bool>());
    }
    EXPECT_EQ(mine.equivalent, one["equivalent"].get<bool>());
    expect_equal("TOST p of all", mine.p_value.value(), one["p"]);
    expect_equal("smallest margin", mine.smallest_margin.value(), one["smallest_margin"]);
    expect_equal("margin with power", mine.margin_with_power.value(), one["margin_with_power"]);
    expect_equal("range", mine.range.value(), one["range"]);
    expect_equal("Wald", mine.heterogeneity.value().statistic, one["wald"]);
    EXPECT_EQ(mine.heterogeneity->df, one["df"].get<std::size_t>());
    expect_equal("Wald p", mine.heterogeneity->p_value, one["wald_p"]);
  }
  std::printf("equivalence golden cases run: %zu\n", cases.size());
  EXPECT_GT(cases.size(), 0U);
}

TEST(EquivalenceGolden, ZWorstDisagreement) {
  for (const auto& [quantity, error] : worst()) {
    std::printf("  %-20s %.1e\n", quantity.c_str(), error);
  }
}

}  // namespace
}  // namespace tcert::statistics
