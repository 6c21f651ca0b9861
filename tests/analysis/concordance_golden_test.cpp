// Every case of the survival::concordance goldens, from the data sets they were made of.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "analysis/concordance.hpp"
#include "support/survival_golden.hpp"
#include "support/worst.hpp"

namespace tcert {
namespace {

using nlohmann::json;
using test_support::golden_frame;
using test_support::golden_number;
using test_support::GoldenFrame;
using test_support::Worst;

constexpr double kRelative = 1e-10;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string text(const json& test_case, const char* key) {
  return test_case.contains(key) && test_case[key].is_string() ? test_case[key].get<std::string>()
                                                               : std::string();
}

std::vector<double> five(const ConcordanceCounts& counts) {
  return {counts.concordant, counts.discordant, counts.tied_x, counts.tied_y, counts.tied_xy};
}

void expect_counts(const ConcordanceEstimate& estimate, const json& expected, Worst& worst) {
  if (expected.contains("values")) {
    ASSERT_EQ(estimate.by_stratum.size(), expected["values"].size());
    for (std::size_t s = 0; s < estimate.by_stratum.size(); ++s) {
      for (std::size_t k = 0; k < 5; ++k) {
        worst.expect(
            "counts", five(estimate.by_stratum[s])[k], golden_number(expected["values"][s][k]));
      }
    }
    return;
  }
  const char* const names[] = {"concordant", "discordant", "tied.x", "tied.y", "tied.xy"};
  for (std::size_t k = 0; k < 5; ++k) {
    worst.expect("counts", five(estimate.counts)[k], golden_number(expected[names[k]]));
  }
}

struct Call {
  GoldenFrame frame;
  ConcordanceOptions options;

  [[nodiscard]] ConcordanceResult run(LargerMeans larger = LargerMeans::longer_time) const {
    std::vector<Predictor> predictors;
    for (const auto& values : frame.predictors) {
      predictors.push_back({"x", values, larger});
    }
    return concordance(frame.outcome, predictors, options);
  }
};

Call make_call(GoldenFrame frame, bool strata, bool cluster) {
  Call call{std::move(frame), {}};
  call.options.weights = call.frame.weights;
  call.options.strata = strata ? &call.frame.strata : nullptr;
  call.options.cluster = cluster ? &call.frame.cluster : nullptr;
  return call;
}

void expect_dfbetas(const Call& call,
                    const ConcordanceEstimate& estimate,
                    const json& expected,
                    Worst& worst) {
  std::vector<double> dfbeta = estimate.dfbeta;
  if (call.options.cluster != nullptr) {
    std::vector<double> sums(call.frame.cluster.levels.size(), 0.0);
    for (std::size_t row = 0; row < dfbeta.size(); ++row) {
      sums[call.frame.cluster.codes[row]] += dfbeta[row];
    }
    dfbeta = sums;
  }
  double squares = 0.0;
  double largest = 0.0;
  for (const double value : dfbeta) {
    squares += value * value;
    largest = std::max(largest, std::abs(value));
  }
  worst.expect("dfbeta_ss", squares, golden_number(expected["dfbeta_ss"]));
  for (std::size_t k = 0; k < expected["dfbeta_first"].size() && k < dfbeta.size(); ++k) {
    worst.expect("dfbeta (of the largest)",
                 dfbeta[k],
                 golden_number(expected["dfbeta_first"][k]),
                 std::max(largest, 1e-300));
  }
}

void expect_brute_force(const ConcordanceEstimate& estimate, const json& expected, Worst& worst) {
  if (expected.is_null()) {
    return;
  }
  expect_counts(estimate, expected, worst);
  worst.expect("brute force C", estimate.c.value_or(kNan), golden_number(expected["C"]));
}

void expect_hmisc(const ConcordanceEstimate& estimate, const json& expected, Worst& worst) {
  // Hmisc counts ordered pairs and leaves out those tied in the outcome.
  if (!expected.is_object() || !expected.contains("C Index") || !estimate.c) {
    return;
  }
  worst.expect("Hmisc C", *estimate.c, golden_number(expected["C Index"]));
  worst.expect(
      "Hmisc pairs", 2.0 * estimate.counts.comparable(), golden_number(expected["Relevant Pairs"]));
}

class ConcordanceGolden : public ::testing::Test {
 protected:
  void SetUp() override {
    golden_ = test_support::golden_values("concordance.json");
    if (golden_.is_null()) {
      GTEST_SKIP() << "no golden values";
    }
  }

  json golden_;
  Worst worst_{kRelative};
};

const std::map<std::string, PairWeight> kPairWeights{
    {"n", PairWeight::equal},
    {"S", PairWeight::survival},
    {"S/G", PairWeight::survival_by_censoring},
    {"n/G2", PairWeight::inverse_censoring_squared},
    {"I", PairWeight::inverse_at_risk}};

/// Returns how many variants R has a value for.
std::size_t expect_pair_weights(Call call, const json& expected, Worst& worst) {
  std::size_t variants = 0;
  for (const auto& [name, value] : expected.items()) {
    SCOPED_TRACE(name);
    call.options.pair_weight = kPairWeights.at(name);
    if (!value.is_object()) {  // R crashes on (start, stop] rows
      const ConcordanceResult result = call.run();
      EXPECT_TRUE(result.estimates[0].c.has_value());
      continue;
    }
    if (value.contains("error")) {
      EXPECT_THROW(static_cast<void>(call.run()), std::invalid_argument);
      continue;
    }
    const ConcordanceResult result = call.run();
    const ConcordanceEstimate& estimate = result.estimates[0];
    worst.expect("C by pair weight", estimate.c.value_or(kNan), golden_number(value["C"]));
    worst.expect(
        "variance by pair weight", estimate.variance.value_or(kNan), golden_number(value["var"]));
    expect_counts(estimate, value["count"], worst);
    ++variants;
  }
  return variants;
}

TEST_F(ConcordanceGolden, SinglePredictorsEqualR) {
  std::size_t cases = 0;
  std::size_t variants = 0;
  for (const auto& [name, expected] : golden_["single"].items()) {
    SCOPED_TRACE(name);
    Call call = make_call(golden_frame({text(expected, "data"),
                                        text(expected, "y"),
                                        {text(expected, "x")},
                                        {},
                                        text(expected, "strata"),
                                        text(expected, "cluster"),
                                        text(expected, "w")}),
                          expected.contains("strata"),
                          expected.contains("cluster"));
    const ConcordanceResult result = call.run();
    const ConcordanceEstimate& estimate = result.estimates[0];
    EXPECT_EQ(call.frame.outcome.rows(), expected["n"].get<std::size_t>());
    worst_.expect("C", estimate.c.value_or(kNan), golden_number(expected["C"]));
    worst_.expect("variance", estimate.variance.value_or(kNan), golden_number(expected["var"]));
    worst_.expect("se", estimate.std_error.value_or(kNan), golden_number(expected["se"]));
    worst_.expect("cvar", estimate.null_variance.value_or(kNan), golden_number(expected["cvar"]));
    expect_counts(estimate, expected["count"], worst_);
    if (estimate.c) {
      expect_dfbetas(call, estimate, expected, worst_);
    }
    const TimeOrder order = time_order(call.frame.outcome,
                                       call.frame.strata.codes,
                                       std::max<std::size_t>(1, call.frame.strata.levels.size()));
    const RowPairs row = concordance_pairs({&order, &call.frame.outcome, call.frame.weights},
                                           call.frame.predictors[0])
                             .rows[0];
    const json& influence = expected["influence_first"];
    worst_.expect("influence", row.net, golden_number(influence[0]) - golden_number(influence[1]));
    worst_.expect(
        "influence",
        row.comparable,
        golden_number(influence[0]) + golden_number(influence[1]) + golden_number(influence[2]));
    const ConcordanceResult reverse = call.run(LargerMeans::shorter_time);
    worst_.expect(
        "C_reverse", reverse.estimates[0].c.value_or(kNan), golden_number(expected["C_reverse"]));
    expect_brute_force(estimate, expected.value("brute_force", json()), worst_);
    expect_hmisc(estimate, expected.value("Hmisc_rcorr_cens", json()), worst_);
    for (const double latest : {5.0, 12.0}) {
      const std::string key = "ymax_" + std::to_string(static_cast<int>(latest));
      if (expected.contains(key) && !expected[key].contains("error")) {
        Call limited = make_call(call.frame, false, expected.contains("cluster"));
        limited.options.latest = latest;
        const ConcordanceResult early = limited.run();
        worst_.expect(
            "C by ymax", early.estimates[0].c.value_or(kNan), golden_number(expected[key]["C"]));
        worst_.expect("variance by ymax",
                      early.estimates[0].variance.value_or(kNan),
                      golden_number(expected[key]["var"]));
      }
    }
    variants += expect_pair_weights(
        make_call(call.frame, expected.contains("strata"), expected.contains("cluster")),
        expected.value("timewt", json::object()),
        worst_);
    ++cases;
  }
  std::printf("concordance golden cases run: %zu single, %zu pair weights\n", cases, variants);
  worst_.print();
  EXPECT_GT(cases, 0U);
}

/// Columns of a model of numbers and factors, treatment contrasts.
std::vector<std::vector<double>> design_columns(const GoldenFrame& all,
                                                const std::vector<std::string>& names,
                                                const std::string& model) {
  std::vector<std::vector<double>> columns;
  std::istringstream right(model.substr(model.find('~') + 1));
  for (std::string name; right >> name;) {
    if (name == "+") {
      continue;
    }
    const auto at = std::find(names.begin(), names.end(), name);
    if (at != names.end()) {
      columns.push_back(all.predictors[static_cast<std::size_t>(at - names.begin())]);
      continue;
    }
    for (std::uint32_t level = 1; level < all.groups.levels.size(); ++level) {
      columns.emplace_back();
      for (const std::uint32_t code : all.groups.codes) {
        columns.back().push_back(code == level ? 1.0 : 0.0);
      }
    }
  }
  return columns;
}

TEST_F(ConcordanceGolden, PairedModelsEqualR) {
  const std::map<std::string, std::vector<std::string>> numbers{
      {"sim660.csv", {"x1", "x2", "x3", "x4"}},
      {"lung.csv", {"age", "sex", "ph.ecog"}},
      {"veteran.csv", {"karno", "age"}},
      {"edge_ties.csv", {"score1", "score2"}}};
  std::size_t cases = 0;
  for (const auto& [name, expected] : golden_["paired"].items()) {
    SCOPED_TRACE(name);
    const std::string data = text(expected, "data");
    ASSERT_EQ(numbers.count(data), 1U);
    const std::string first = expected["models"][0].get<std::string>();
    const bool cluster = expected["cluster"].is_string();
    const bool lighting = name == "sim660_3models";
    Call call = make_call(
        golden_frame({data,
                      first.substr(0, first.find(" ~")),
                      numbers.at(data),
                      lighting ? std::vector<std::string>{"lighting"} : std::vector<std::string>{},
                      "",
                      cluster ? text(expected, "cluster") : "",
                      ""}),
        false,
        cluster);
    std::vector<std::vector<double>> scores;
    for (const json& model : expected["models"]) {
      scores.push_back(test_support::efron_linear_predictor(
          call.frame.outcome,
          design_columns(call.frame, numbers.at(data), model.get<std::string>())));
    }
    call.frame.predictors = scores;
    const ConcordanceResult result = call.run(LargerMeans::shorter_time);
    const std::size_t k = scores.size();
    for (std::size_t i = 0; i < k; ++i) {
      worst_.expect("C", result.estimates[i].c.value_or(kNan), golden_number(expected["C"][i]));
      for (std::size_t m = 0; m < 5; ++m) {
        worst_.expect("counts",
                      five(result.estimates[i].counts)[m],
                      golden_number(expected["count"]["values"][i][m]));
      }
      for (std::size_t j = 0; j < k; ++j) {
        worst_.expect("vcov",
                      result.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)),
                      golden_number(expected["vcov"]["values"][i][j]));
      }
    }
    const json& contrast = expected["contrast_1_minus_2"];
    const ConcordanceDifference& difference = result.differences[0];
    worst_.expect("difference", difference.difference.value(), golden_number(contrast["diff"]));
    worst_.expect(
        "difference variance", difference.variance.value(), golden_number(contrast["var"]));
    if (golden_number(contrast["var"]) > 0.0) {
      worst_.expect("difference se", difference.std_error.value(), golden_number(contrast["se"]));
      worst_.expect("z", difference.z.value(), golden_number(contrast["z"]));
      worst_.expect("p", difference.p_value.value(), golden_number(contrast["p"]));
    } else {  // R has z = 0 / 0
      EXPECT_TRUE(has(difference.conditions, ConditionKind::same_ranking));
    }
    ++cases;
  }
  std::printf("concordance golden cases run: %zu paired\n", cases);
  worst_.print();
  EXPECT_GT(cases, 0U);
}

}  // namespace
}  // namespace tcert
