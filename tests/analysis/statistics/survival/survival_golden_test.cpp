// Every case of the survfit and survdiff goldens, from the data sets they were made of.

#include <gtest/gtest.h>

#include <statistics/survival/log_rank.hpp>
#include <statistics/survival/survival_curve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>
#include "analysis/statistics/survival/survival_golden.hpp"

#include "analysis/statistics/worst.hpp"

namespace tcert::statistics {
namespace {

using nlohmann::json;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Outcome, groups, strata and weights of a case.
struct Call {
  explicit Call(const json& test_case) {
    FrameOptions options;
    options.right_side = RightSide::groups;
    options.weights = golden_text(test_case, "weights");
    frame = golden_frame(golden_text(test_case, "data"), golden_text(test_case, "f"), options);
    outcome = survival_outcome(frame);
    if (frame.weights) {
      weights.assign(frame.weights->begin(), frame.weights->end());
    }
  }

  ModelFrame frame;
  SurvivalOutcome outcome;
  std::vector<double> weights;
};

const std::map<std::string, IntervalScale> kScales{{"ci_log", IntervalScale::log},
                                                   {"ci_log-log", IntervalScale::log_log},
                                                   {"ci_plain", IntervalScale::plain},
                                                   {"ci_logit", IntervalScale::logit},
                                                   {"ci_arcsin", IntervalScale::arcsin}};

class SurvivalGolden : public ::testing::Test {
 protected:
  void SetUp() override {
    golden_ = golden_values("survfit.json");
    if (golden_.is_null()) {
      GTEST_SKIP() << "no golden values: stats/golden/survfit.json is missing";
    }
  }

  void expect_points(const std::vector<SurvivalCurve>& curves, const json& expected, bool robust);
  void expect_intervals(const std::vector<SurvivalCurve>& curves, const json& expected);
  void expect_quantiles(const std::vector<SurvivalCurve>& curves, const json& expected);
  void expect_table(const std::vector<SurvivalCurve>& curves, const json& expected);

  json golden_;
  Worst worst_{1e-10};
};

const SurvivalCurve& curve_named(const std::vector<SurvivalCurve>& curves, const json& name) {
  const auto found = std::find_if(curves.begin(), curves.end(), [&](const SurvivalCurve& curve) {
    return curve.group == name.get<std::string>();
  });
  if (found == curves.end()) {
    throw std::runtime_error("no curve " + name.dump());
  }
  return *found;
}

void SurvivalGolden::expect_points(const std::vector<SurvivalCurve>& curves,
                                   const json& expected,
                                   bool robust) {
  const json& points = expected["points"];
  for (std::size_t k = 0; k < points["time"].size(); ++k) {
    const double time = golden_number(points["time"][k]);
    const SurvivalPoint* const point = curve_named(curves, points["strata"][k]).at(time);
    ASSERT_NE(point, nullptr);
    worst_.expect("time", point->time, time);
    worst_.expect("n.risk", point->at_risk, golden_number(points["n_risk"][k]));
    worst_.expect("n.event", point->events, golden_number(points["n_event"][k]));
    worst_.expect("n.censor", point->censored, golden_number(points["n_censor"][k]));
    worst_.expect("surv", point->survival, golden_number(points["surv"][k]));
    // R's robust std.err is that of the curve, else it is that of its logarithm.
    worst_.expect("std.err",
                  robust ? point->std_error() : point->log_std_error,
                  golden_number(points["std_err_of_log_surv"][k]));
    worst_.expect("cumhaz", point->cumulative_hazard, golden_number(points["cumhaz"][k]));
    worst_.expect("std.chaz", point->hazard_std_error, golden_number(points["std_chaz"][k]));
  }
  double survival = 0.0;
  double hazard = 0.0;
  std::size_t times = 0;
  for (const SurvivalCurve& curve : curves) {
    for (const SurvivalPoint& point : curve.points) {
      survival += point.survival;
      hazard += point.cumulative_hazard;
      ++times;
    }
  }
  EXPECT_EQ(times, expected["n_times"].get<std::size_t>());
  worst_.expect("sum of surv", survival, golden_number(expected["sum_surv"]));
  worst_.expect("sum of cumhaz", hazard, golden_number(expected["sum_cumhaz"]));
}

void SurvivalGolden::expect_intervals(const std::vector<SurvivalCurve>& curves,
                                      const json& expected) {
  const json& points = expected["points"];
  for (const auto& [key, scale] : kScales) {
    SCOPED_TRACE(key);
    for (std::size_t k = 0; k < points["time"].size(); ++k) {
      const SurvivalPoint* const point =
          curve_named(curves, points["strata"][k]).at(golden_number(points["time"][k]));
      const Interval interval = survival_interval(point->survival, point->log_std_error, scale);
      worst_.expect("lower", interval.low, golden_number(expected[key]["lower"][k]));
      worst_.expect("upper", interval.high, golden_number(expected[key]["upper"][k]));
    }
    for (std::size_t g = 0; g < curves.size(); ++g) {
      const SurvivalQuantile median = survival_quantile(curves[g], 0.5, scale);
      const json& values = expected[key]["median"];
      worst_.expect("median", median.time.value_or(kNan), golden_number(values["est"][g]));
      worst_.expect("median lower", median.low.value_or(kNan), golden_number(values["lower"][g]));
      worst_.expect("median upper", median.high.value_or(kNan), golden_number(values["upper"][g]));
    }
  }
}

void SurvivalGolden::expect_quantiles(const std::vector<SurvivalCurve>& curves,
                                      const json& expected) {
  const double shares[] = {0.25, 0.5, 0.75};
  const auto value = [](const json& values, std::size_t group, std::size_t share) {
    return golden_number(values.is_object() ? values["values"][group][share] : values[share]);
  };
  for (std::size_t g = 0; g < curves.size(); ++g) {
    for (std::size_t k = 0; k < 3; ++k) {
      const SurvivalQuantile quantile = survival_quantile(curves[g], shares[k]);
      worst_.expect("quantile", quantile.time.value_or(kNan), value(expected["quantile"], g, k));
      worst_.expect("quantile lower", quantile.low.value_or(kNan), value(expected["lower"], g, k));
      worst_.expect("quantile upper", quantile.high.value_or(kNan), value(expected["upper"], g, k));
    }
  }
}

void SurvivalGolden::expect_table(const std::vector<SurvivalCurve>& curves, const json& expected) {
  const json& counts = expected["n_total"];
  const json& table = expected["table_rmean_common"];
  const char* const columns[] = {"records",
                                 "n.max",
                                 "n.start",
                                 "events",
                                 "rmean",
                                 "se(rmean)",
                                 "median",
                                 "0.95LCL",
                                 "0.95UCL"};
  for (std::size_t g = 0; g < curves.size(); ++g) {
    const SurvivalCurve& curve = curves[g];
    EXPECT_EQ(curve.rows, counts[g].get<std::size_t>());
    const auto cell = [&](std::size_t column) {
      return golden_number(table.contains("values") ? table["values"][g][column]
                                                    : table[columns[column]]);
    };
    double events = 0.0;
    double most = 0.0;
    for (const SurvivalPoint& point : curve.points) {
      events += point.events;
      most = std::max(most, point.at_risk);
    }
    const RestrictedMean mean = restricted_mean(curve, common_limit(curves));
    const SurvivalQuantile median = survival_quantile(curve, 0.5);
    worst_.expect("n.max", most, cell(1));
    worst_.expect("n.start", curve.points.front().at_risk, cell(2));
    worst_.expect("events", events, cell(3));
    worst_.expect("rmean", mean.mean, cell(4));
    worst_.expect("se(rmean)", mean.std_error, cell(5));
    worst_.expect("table median", median.time.value_or(kNan), cell(6));
    worst_.expect("table LCL", median.low.value_or(kNan), cell(7));
    worst_.expect("table UCL", median.high.value_or(kNan), cell(8));
  }
}

TEST_F(SurvivalGolden, CurvesEqualSurvfit) {
  std::size_t cases = 0;
  for (const auto& [name, expected] : golden_["km"].items()) {
    SCOPED_TRACE(name);
    const Call call(expected);
    CurveOptions options;
    options.weights = call.weights;
    options.groups = &*call.frame.groups;
    const std::vector<SurvivalCurve> curves = survival_curves(call.outcome, options);
    expect_points(curves, expected, call.frame.weights.has_value());
    expect_intervals(curves, expected);
    expect_quantiles(curves, expected["quantiles_25_50_75"]);
    expect_table(curves, expected);
    ++cases;
  }
  std::printf("survfit golden cases run: %zu curves\n", cases);
  worst_.print();
  EXPECT_GT(cases, 0U);
}

TEST_F(SurvivalGolden, FlemingHarringtonVariantsEqualSurvfit) {
  const SurvivalOutcome outcome =
      survival_outcome(golden_frame("edge_ties.csv", "Surv(time, status) ~ 1"));
  std::size_t cases = 0;
  for (const int stype : {1, 2}) {
    for (const int ctype : {1, 2}) {
      const std::string name = "stype" + std::to_string(stype) + "_ctype" + std::to_string(ctype);
      SCOPED_TRACE(name);
      const json& expected = golden_["edge_ties_fleming_harrington"][name];
      CurveOptions options;
      options.survival =
          stype == 1 ? SurvivalEstimate::kaplan_meier : SurvivalEstimate::exponential;
      options.hazard =
          ctype == 1 ? HazardEstimate::nelson_aalen : HazardEstimate::fleming_harrington;
      const SurvivalCurve curve = survival_curves(outcome, options)[0];
      ASSERT_EQ(curve.points.size(), expected["time"].size());
      for (std::size_t k = 0; k < curve.points.size(); ++k) {
        const SurvivalPoint& point = curve.points[k];
        const Interval interval = survival_interval(point.survival, point.log_std_error);
        worst_.expect("time", point.time, golden_number(expected["time"][k]));
        worst_.expect("surv", point.survival, golden_number(expected["surv"][k]));
        worst_.expect("std.err", point.log_std_error, golden_number(expected["std_err"][k]));
        worst_.expect("cumhaz", point.cumulative_hazard, golden_number(expected["cumhaz"][k]));
        worst_.expect("std.chaz", point.hazard_std_error, golden_number(expected["std_chaz"][k]));
        worst_.expect("lower", interval.low, golden_number(expected["lower"][k]));
        worst_.expect("upper", interval.high, golden_number(expected["upper"][k]));
      }
      ++cases;
    }
  }
  std::printf("survfit golden cases run: %zu stype and ctype variants\n", cases);
  worst_.print();
}

TEST_F(SurvivalGolden, LogRankTestsEqualSurvdiff) {
  std::size_t cases = 0;
  for (const auto& [name, tests] : golden_["survdiff"].items()) {
    const Call call(tests);
    for (const char* const rho : {"0", "1"}) {
      SCOPED_TRACE(name + ", rho " + rho);
      const json& expected = tests[rho];
      const LogRankTest test = log_rank_test(call.outcome,
                                             *call.frame.groups,
                                             call.frame.strata ? &*call.frame.strata : nullptr,
                                             golden_number(expected["rho"]));
      ASSERT_EQ(test.groups.size(), expected["groups"].size());
      double largest = 0.0;
      for (Eigen::Index g = 0; g < test.covariance.rows(); ++g) {
        largest = std::max(largest, test.covariance(g, g));
      }
      for (std::size_t g = 0; g < test.groups.size(); ++g) {
        EXPECT_EQ(test.groups[g].group, expected["groups"][g].get<std::string>());
        EXPECT_EQ(test.groups[g].rows, expected["n"][g].get<std::size_t>());
        worst_.expect("observed", test.groups[g].observed, golden_number(expected["obs"][g]));
        worst_.expect("expected", test.groups[g].expected, golden_number(expected["exp"][g]));
        for (std::size_t h = 0; h < test.groups.size(); ++h) {
          worst_.expect("variance (of the largest)",
                        test.covariance(static_cast<Eigen::Index>(g), static_cast<Eigen::Index>(h)),
                        golden_number(expected["var"]["values"][g][h]),
                        largest);
        }
      }
      EXPECT_EQ(test.df, expected["df"].get<std::size_t>());
      worst_.expect("chisq", test.chi_squared.value(), golden_number(expected["chisq"]));
      worst_.expect("p", test.p_value.value(), golden_number(expected["p"]));
      ++cases;
    }
  }
  std::printf("survdiff golden cases run: %zu\n", cases);
  worst_.print();
  EXPECT_GT(cases, 0U);
}

}  // namespace
}  // namespace tcert::statistics
