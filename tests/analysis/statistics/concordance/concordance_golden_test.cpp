// Every case of the survival::concordance goldens, from the data sets they were made of.

#include <gtest/gtest.h>

#include <statistics/concordance/concordance.hpp>
#include <statistics/cox/cox.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>
#include "analysis/statistics/survival/survival_golden.hpp"

#include "analysis/statistics/worst.hpp"

namespace tcert::statistics {
namespace {

using nlohmann::json;

constexpr double kRelative = 1e-10;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

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
  Call(ModelFrame of, std::vector<std::vector<double>> values)
      : frame(std::move(of)), outcome(survival_outcome(frame)), predictors(std::move(values)) {
    if (frame.weights) {
      weights.assign(frame.weights->begin(), frame.weights->end());
    }
  }

  [[nodiscard]] ConcordanceOptions options() const {
    ConcordanceOptions result;
    result.weights = weights;
    result.strata = frame.strata ? &*frame.strata : nullptr;
    result.cluster = frame.cluster ? &*frame.cluster : nullptr;
    return result;
  }
  [[nodiscard]] ConcordanceResult run(const ConcordanceOptions& with,
                                      LargerMeans larger = LargerMeans::longer_time) const {
    std::vector<Predictor> list;
    for (const auto& values : predictors) {
      list.push_back({"x", values, larger});
    }
    return concordance(outcome, list, with);
  }

  ModelFrame frame;
  SurvivalOutcome outcome;
  std::vector<std::vector<double>> predictors;
  std::vector<double> weights;
};

Call single_call(const json& expected) {
  FrameOptions options;
  options.weights = golden_text(expected, "w");
  options.cluster = golden_text(expected, "cluster");
  options.strata = golden_text(expected, "strata");
  ModelFrame frame = golden_frame(golden_text(expected, "data"),
                                  golden_text(expected, "y") + " ~ " + golden_text(expected, "x"),
                                  options);
  const Eigen::VectorXd x = frame.design.col(1);
  return {std::move(frame), {{x.begin(), x.end()}}};
}

void expect_dfbetas(const Call& call,
                    const ConcordanceEstimate& estimate,
                    const json& expected,
                    Worst& worst) {
  std::vector<double> dfbeta = estimate.dfbeta;
  if (call.frame.cluster) {
    std::vector<double> sums(call.frame.cluster->levels.size(), 0.0);
    for (std::size_t row = 0; row < dfbeta.size(); ++row) {
      sums[call.frame.cluster->codes[row]] += dfbeta[row];
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
    golden_ = golden_values("concordance.json");
    if (golden_.is_null()) {
      GTEST_SKIP() << "no golden values: stats/golden/concordance.json is missing";
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
std::size_t expect_pair_weights(const Call& call, const json& expected, Worst& worst) {
  std::size_t variants = 0;
  for (const auto& [name, value] : expected.items()) {
    SCOPED_TRACE(name);
    ConcordanceOptions options = call.options();
    options.pair_weight = kPairWeights.at(name);
    if (value.is_object() && value.contains("error")) {
      EXPECT_THROW(static_cast<void>(call.run(options)), std::invalid_argument);
      continue;
    }
    const ConcordanceResult result = call.run(options);
    const ConcordanceEstimate& estimate = result.estimates[0];
    if (!value.is_object()) {  // R crashes on (start, stop] rows
      EXPECT_TRUE(estimate.c.has_value());
      continue;
    }
    worst.expect("C by pair weight", estimate.c.value_or(kNan), golden_number(value["C"]));
    worst.expect(
        "variance by pair weight", estimate.variance.value_or(kNan), golden_number(value["var"]));
    expect_counts(estimate, value["count"], worst);
    ++variants;
  }
  return variants;
}

void expect_limited(const Call& call, const json& expected, Worst& worst) {
  for (const double latest : {5.0, 12.0}) {
    const std::string key = "ymax_" + std::to_string(static_cast<int>(latest));
    if (expected.contains(key) && !expected[key].contains("error")) {
      ConcordanceOptions options = call.options();
      options.latest = latest;
      const ConcordanceResult early = call.run(options);
      worst.expect(
          "C by ymax", early.estimates[0].c.value_or(kNan), golden_number(expected[key]["C"]));
      worst.expect("variance by ymax",
                   early.estimates[0].variance.value_or(kNan),
                   golden_number(expected[key]["var"]));
    }
  }
}

void expect_influence(const Call& call, const json& first, Worst& worst) {
  const auto& strata = call.frame.strata;
  const TimeOrder order = strata ? time_order(call.outcome, strata->codes, strata->levels.size())
                                 : time_order(call.outcome);
  const RowPairs row =
      concordance_pairs({&order, &call.outcome, call.weights}, call.predictors[0]).rows[0];
  const double concordant = golden_number(first[0]);
  const double discordant = golden_number(first[1]);
  worst.expect("influence", row.net, concordant - discordant);
  worst.expect("influence", row.comparable, concordant + discordant + golden_number(first[2]));
}

TEST_F(ConcordanceGolden, SinglePredictorsEqualR) {
  std::size_t cases = 0;
  std::size_t variants = 0;
  for (const auto& [name, expected] : golden_["single"].items()) {
    SCOPED_TRACE(name);
    const Call call = single_call(expected);
    const ConcordanceResult result = call.run(call.options());
    const ConcordanceEstimate& estimate = result.estimates[0];
    EXPECT_EQ(call.outcome.rows(), expected["n"].get<std::size_t>());
    worst_.expect("C", estimate.c.value_or(kNan), golden_number(expected["C"]));
    worst_.expect("variance", estimate.variance.value_or(kNan), golden_number(expected["var"]));
    worst_.expect("se", estimate.std_error.value_or(kNan), golden_number(expected["se"]));
    worst_.expect("cvar", estimate.null_variance.value_or(kNan), golden_number(expected["cvar"]));
    expect_counts(estimate, expected["count"], worst_);
    if (estimate.c) {
      expect_dfbetas(call, estimate, expected, worst_);
    }
    expect_influence(call, expected["influence_first"], worst_);
    const ConcordanceResult reverse = call.run(call.options(), LargerMeans::shorter_time);
    worst_.expect(
        "C_reverse", reverse.estimates[0].c.value_or(kNan), golden_number(expected["C_reverse"]));
    expect_brute_force(estimate, expected.value("brute_force", json()), worst_);
    expect_hmisc(estimate, expected.value("Hmisc_rcorr_cens", json()), worst_);
    expect_limited(call, expected, worst_);
    variants += expect_pair_weights(call, expected.value("timewt", json::object()), worst_);
    ++cases;
  }
  std::printf("concordance golden cases run: %zu single, %zu pair weights\n", cases, variants);
  worst_.print();
  EXPECT_GT(cases, 0U);
}

/// The terms of "y ~ a + b".
std::vector<std::string> terms_of(const std::string& formula) {
  std::vector<std::string> terms;
  std::istringstream right(formula.substr(formula.find('~') + 1));
  for (std::string term; right >> term;) {
    if (term != "+") {
      terms.push_back(term);
    }
  }
  return terms;
}

/// Linear predictor of the Cox model of some terms of a frame.
std::vector<double> cox_score(const ModelFrame& frame, const std::vector<std::string>& terms) {
  CoxData data;
  data.outcome = survival_outcome(frame);
  std::vector<Eigen::Index> used;
  for (std::size_t column = 0; column < frame.columns.size(); ++column) {
    const std::size_t term = frame.term_of[column];
    if (term > 0 && std::find(terms.begin(), terms.end(), frame.terms[term - 1]) != terms.end()) {
      used.push_back(static_cast<Eigen::Index>(column));
      data.columns.push_back(frame.columns[column]);
      data.term_of.push_back(data.terms.size());
      data.terms.push_back(frame.columns[column]);
    }
  }
  data.design = frame.design(Eigen::all, used);
  const Eigen::VectorXd score = fit_cox(data).linear_predictors;
  return {score.begin(), score.end()};
}

/// The scores of all models on the rows that are complete in every one.
Call paired_call(const json& expected) {
  const auto first = expected["models"][0].get<std::string>();
  std::string formula = first;
  for (const json& model : expected["models"]) {
    for (const std::string& term : terms_of(model.get<std::string>())) {
      formula += " + " + term;
    }
  }
  FrameOptions options;
  options.cluster = golden_text(expected, "cluster");
  ModelFrame frame = golden_frame(golden_text(expected, "data"), formula, options);
  std::vector<std::vector<double>> scores;
  for (const json& model : expected["models"]) {
    scores.push_back(cox_score(frame, terms_of(model.get<std::string>())));
  }
  return {std::move(frame), std::move(scores)};
}

TEST_F(ConcordanceGolden, PairedModelsEqualR) {
  std::size_t cases = 0;
  for (const auto& [name, expected] : golden_["paired"].items()) {
    SCOPED_TRACE(name);
    const Call call = paired_call(expected);
    const ConcordanceResult result = call.run(call.options(), LargerMeans::shorter_time);
    const std::size_t k = call.predictors.size();
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
}  // namespace tcert::statistics
