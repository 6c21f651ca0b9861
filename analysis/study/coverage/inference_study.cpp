#include "analysis/study/coverage/inference_study.hpp"

#include <cmath>
#include <statistics/basics/normal.hpp>
#include <statistics/basics/student_t.hpp>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/clusters/cluster_variance.hpp>
#include <statistics/cox/cox_sandwich.hpp>
#include <statistics/logistic/logistic_sandwich.hpp>

namespace tcert::study::coverage {
namespace {

constexpr int kPanels = 4000;
constexpr double kReach = 9.0;

double density(double x) { return std::exp(-0.5 * x * x); }

/// The root of a falling function between -5 and 5.
template <typename Function>
double root_of(const Function& falling) {
  double low = -5.0;
  double high = 5.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (falling(middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

table::Factor days_of(const Study& study) {
  table::Factor day;
  day.codes = study.day;
  day.levels.resize(1 + static_cast<std::size_t>(study.day.back()));
  return day;
}

statistics::LogisticInput logistic_of(const Study& study,
                                      const std::vector<const std::vector<double>*>& predictors) {
  statistics::LogisticInput input;
  input.design = Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(study.success.size()),
                                       static_cast<Eigen::Index>(predictors.size()) + 1);
  input.columns = {"(Intercept)"};
  input.term_of = {0};
  for (std::size_t k = 0; k < predictors.size(); ++k) {
    input.design.col(static_cast<Eigen::Index>(k) + 1) = vector_of(*predictors[k]);
    input.columns.emplace_back(k == 0 ? "x" : "added");
    input.terms.push_back(input.columns.back());
    input.term_of.push_back(k + 1);
  }
  input.successes = vector_of({study.success.begin(), study.success.end()});
  input.cluster = days_of(study);
  return input;
}

statistics::CoxData cox_of(const Study& study, const statistics::LogisticInput& logistic) {
  statistics::CoxData data;
  data.outcome = {{}, study.time, study.success};
  data.design = logistic.design.rightCols(logistic.design.cols() - 1);
  data.columns = logistic.terms;
  data.terms = logistic.terms;
  for (std::size_t k = 0; k < data.terms.size(); ++k) {
    data.term_of.push_back(k);
  }
  data.cluster = logistic.cluster;
  return data;
}

/// p of the last coefficient being `truth`.
void test_last(const std::optional<statistics::ClusteredFit>& fit,
               double truth,
               const statistics::WildOptions& options,
               std::array<std::optional<double>, kInferences.size()>& p) {
  if (!fit) {
    return;
  }
  const Eigen::Index last = fit->parts.estimates.size() - 1;
  const double distance = fit->parts.estimates(last) - truth;
  const auto groups = static_cast<double>(fit->parts.clusters());
  const double cr0 = sandwich_cr0(fit->parts)(last, last);
  const auto by_t = [&](double variance, double df) {
    return statistics::by_student_t(distance, std::sqrt(variance), df, options.level).p_value;
  };
  if (cr0 > 0.0) {
    p[0] =
        statistics::normal_p_value(distance / std::sqrt(cr0), statistics::Alternative::two_sided);
  }
  p[1] = by_t(cr0 * groups / (groups - 1.0), groups - 1.0);
  p[2] = by_t(sandwich_cr2(fit->parts)(last, last), satterthwaite_df(fit->parts)(last));
  p[3] = by_t(statistics::jackknife_variance(fit->parts.estimates(last),
                                             fit->left_out().values.row(last).transpose()),
              groups - 1.0);
  const auto k = static_cast<std::size_t>(last);
  if (const auto null = fit->parts_at(k, truth)) {
    p[4] = statistics::wild_p_value(*null, k, options);
  }
}

}  // namespace

double limit_log_odds(double r) {
  const double threshold = statistics::normal_quantile(kFailureShare);
  const double noise = std::sqrt(1.0 - r * r);
  const double step = 2.0 * kReach / kPanels;
  // The intercept is the root of the first score, given the slope.
  const auto score = [&](double intercept, double slope, bool by_x) {
    double sum = 0.0;
    for (int i = 0; i < kPanels; ++i) {
      const double x = -kReach + (i + 0.5) * step;
      const double residual = statistics::normal_cdf((r * x - threshold) / noise) -
                              1.0 / (1.0 + std::exp(-intercept - slope * x));
      sum += density(x) * residual * (by_x ? x : 1.0);
    }
    return sum;
  };
  return root_of([&](double slope) {
    const double intercept =
        root_of([&](double candidate) { return score(candidate, slope, false); });
    return score(intercept, slope, true);
  });
}

double limit_log_hazard(double r) {
  const double threshold = statistics::normal_quantile(kFailureShare);
  const double step = 2.0 * kReach / kPanels;
  return root_of([&](double beta) {
    // At risk when the trial of ability l arrives are all that are no abler.
    double at_risk = 0.0;
    double moment = 0.0;
    double sum = 0.0;
    for (int i = 0; i < kPanels; ++i) {
      const double l = -kReach + (i + 0.5) * step;
      const double risk = density(l) * std::exp(beta * r * l);
      at_risk += risk;
      moment += risk * (r * l + beta * (1.0 - r * r));
      if (l > threshold) {
        sum += density(l) * (r * l - moment / at_risk);
      }
    }
    return sum;
  });
}

TruthTests truth_tests_of(const Scenario& scenario,
                          std::uint32_t stream,
                          const Options& options,
                          std::uint64_t index) {
  static const double log_odds = limit_log_odds(kFirstCorrelation);
  static const double log_hazard = limit_log_hazard(kFirstCorrelation);
  const Study study = simulate(scenario, options.seed, stream, index);
  const Study unrelated = simulate(scenario, options.seed, stream + 1, index);
  TruthTests tests;
  tests.withheld = is_withheld(study);
  if (tests.withheld) {
    return tests;
  }
  statistics::WildOptions wild;
  wild.replicates = options.replicates;
  wild.seed = options.seed + index;
  wild.level = options.level;
  for (const bool added : {false, true}) {
    const auto logistic = added ? logistic_of(study, {&study.second, &unrelated.first})
                                : logistic_of(study, {&study.first});
    statistics::LogisticOptions robust;
    robust.variance = statistics::CoefficientVariance::robust;
    const std::size_t row = added ? 2 : 0;
    test_last(clustered_fit(logistic, fit_logistic(logistic, robust)),
              added ? 0.0 : log_odds,
              wild,
              tests.p[row]);
    const statistics::CoxData cox = cox_of(study, logistic);
    test_last(clustered_fit(cox, fit_cox(cox)), added ? 0.0 : log_hazard, wild, tests.p[row + 1]);
  }
  return tests;
}

std::vector<InferenceRate> inference_rates(const Scenario& scenario,
                                           const std::vector<TruthTests>& sets,
                                           double level) {
  std::vector<InferenceRate> rates;
  for (std::size_t c = 0; c < kCoefficients.size(); ++c) {
    for (std::size_t m = 0; m < kInferences.size(); ++m) {
      InferenceRate rate;
      rate.scenario = scenario;
      rate.coefficient = kCoefficients[c];
      rate.method = kInferences[m];
      double rejected = 0.0;
      for (const TruthTests& set : sets) {
        const std::optional<double>& p = set.p[c][m];
        rate.withheld += set.withheld ? 1U : 0U;
        rate.missing += !set.withheld && !p ? 1U : 0U;
        rate.tests += p ? 1U : 0U;
        rejected += p && *p < 1.0 - level ? 1.0 : 0.0;
      }
      const auto tests = static_cast<double>(rate.tests);
      rate.rejected = rejected / tests;
      rate.monte_carlo_se = std::sqrt(rate.rejected * (1.0 - rate.rejected) / tests);
      rates.push_back(std::move(rate));
    }
  }
  return rates;
}

}  // namespace tcert::study::coverage
