// Cox models by hand, against slow ones, by invariance and on data that cannot be fitted.

#include <statistics/cox/cox.hpp>

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <statistics/cox/cox_baseline.hpp>
#include <statistics/cox/cox_residuals.hpp>
#include <statistics/cox/cox_terms.hpp>
#include <statistics/cox/cox_zph.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {
namespace {

CoxData cox(std::vector<double> stop, std::vector<std::uint8_t> event, Eigen::MatrixXd design) {
  CoxData data;
  data.outcome.stop = std::move(stop);
  data.outcome.event = std::move(event);
  data.design = std::move(design);
  for (Eigen::Index j = 0; j < data.design.cols(); ++j) {
    data.columns.push_back("x" + std::to_string(j + 1));
    data.terms.push_back(data.columns.back());
    data.term_of.push_back(static_cast<std::size_t>(j));
  }
  return data;
}

table::Factor factor(std::vector<std::uint32_t> codes, std::size_t levels) {
  table::Factor result;
  result.codes = std::move(codes);
  for (std::size_t k = 0; k < levels; ++k) {
    result.levels.push_back("g" + std::to_string(k));
  }
  return result;
}

/// Times on a coarse grid, so most are tied. Parts are added by the tests.
struct Made {
  bool truncated = false;
  bool weighted = false;
  bool stratified = false;
  std::size_t rows = 60;
  Eigen::Index columns = 3;
};

CoxData make(const Made& made, unsigned seed) {
  std::mt19937 engine(seed);
  const auto unit = [&] { return static_cast<double>(engine() >> 8) / 16777216.0; };
  const auto n = static_cast<Eigen::Index>(made.rows);
  Eigen::MatrixXd design(n, made.columns);
  std::vector<double> stop;
  std::vector<double> start;
  std::vector<std::uint8_t> event;
  std::vector<std::uint32_t> stratum;
  Eigen::VectorXd weights(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < made.columns; ++j) {
      design(i, j) = j == 0 ? std::floor(2.0 * unit()) : 4.0 * unit() - 1.0;
    }
    const double time = 1.0 - 5.0 * std::log(1.0 - unit()) * std::exp(-0.4 * design(i, 1));
    stop.push_back(std::ceil(time));
    start.push_back(std::floor(unit() * stop.back()) - 1.0);
    event.push_back(unit() < 0.7 ? 1 : 0);
    stratum.push_back(static_cast<std::uint32_t>(3.0 * unit()));
    weights(i) = 0.5 + std::floor(4.0 * unit());
  }
  CoxData data = cox(stop, event, design);
  if (made.truncated) {
    data.outcome.start = start;
  }
  if (made.weighted) {
    data.weights = weights;
  }
  if (made.stratified) {
    data.strata = factor(stratum, 3);
  }
  return data;
}

// ---- By hand ----

TEST(Cox, TwoRowsThatOutweighEachOtherByHand) {
  // Events at 1 (x = 1, at risk {1, 0, 1}) and 2 (x = 0, at risk {0, 1}), the last row censored:
  // l(b) = b - log(2 e^b + 1) + 0 - log(1 + e^b); l'(b) = 1 - 2r/(2r + 1) - r/(1 + r), r = e^b;
  // zero where (1 + r) = r (2r + 1), so r = sqrt(1/2).
  const CoxFit fit = fit_cox(cox({1, 2, 3}, {1, 1, 0}, Eigen::Vector3d(1, 0, 1)));
  const double r = std::sqrt(0.5);
  EXPECT_NEAR(fit.coefficients[0].hazard_ratio.value(), r, 1e-12);
  const double information = 2 * r / ((2 * r + 1) * (2 * r + 1)) + r / ((1 + r) * (1 + r));
  EXPECT_NEAR(fit.coefficients[0].model_se.value(), 1 / std::sqrt(information), 1e-12);
  EXPECT_NEAR(fit.loglik_null.value(), -std::log(3.0) - std::log(2.0), 1e-14);
  EXPECT_NEAR(fit.loglik.value(), std::log(r) - std::log(2 * r + 1) - std::log(1 + r), 1e-14);
  EXPECT_EQ(fit.events, 2U);
  EXPECT_EQ(fit.summary.termination, CoxTermination::converged);
}

TEST(Cox, TiedEventsByHand) {
  // Two events (x = 1, x = 0) tied among x = 1, 0, 1; r = e^b, numerator r in all rules.
  const CoxData data = cox({1, 1, 2}, {1, 1, 0}, Eigen::Vector3d(1, 0, 1));
  CoxOptions options;
  const auto loglik = [&](Ties ties) {
    options.ties = ties;
    return fit_cox(data, options).loglik_null.value();
  };
  // At b = 0: Breslow 1/9; Efron 1/3 x 1/(3 - 1); exact 1/3, for 3 pairs.
  EXPECT_NEAR(loglik(Ties::breslow), -std::log(9.0), 1e-14);
  EXPECT_NEAR(loglik(Ties::efron), -std::log(6.0), 1e-14);
  EXPECT_NEAR(loglik(Ties::exact), -std::log(3.0), 1e-14);
}

TEST(Cox, BaselineOfEqualRowsIsNelsonAalen) {
  // A binary x that says nothing: hazards 1/4, then 2/3 by Breslow, 1/3 + 1/2 by Efron.
  Eigen::MatrixXd none(4, 0);
  CoxOptions options;
  options.ties = Ties::breslow;
  CoxData data = cox({1, 2, 2, 3}, {1, 1, 1, 0}, none);
  std::vector<BaselineHazard> baseline = cox_baseline(data, fit_cox(data, options));
  ASSERT_EQ(baseline[0].time, (std::vector<double>{1, 2, 3}));
  EXPECT_NEAR(baseline[0].hazard[0], 0.25, 1e-15);
  EXPECT_NEAR(baseline[0].hazard[1], 0.25 + 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(baseline[0].hazard[2], 0.25 + 2.0 / 3.0, 1e-15);
  baseline = cox_baseline(data, fit_cox(data));
  EXPECT_NEAR(baseline[0].hazard[1], 0.25 + 1.0 / 3.0 + 0.5, 1e-15);
}

// ---- Against the definition ----

/// Sums over subsets of size d of what `visit` says.
void for_each_subset(const std::vector<std::size_t>& set,
                     std::size_t d,
                     const std::function<void(const std::vector<std::size_t>&)>& visit) {
  std::vector<bool> chosen(set.size(), false);
  std::fill(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(d), true);
  do {
    std::vector<std::size_t> subset;
    for (std::size_t k = 0; k < set.size(); ++k) {
      if (chosen[k]) {
        subset.push_back(set[k]);
      }
    }
    visit(subset);
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
}

/// The partial log-likelihood straight from its definition, each risk set found by looking at every
/// row.
double slow_loglik(const CoxData& data, const Eigen::VectorXd& beta, Ties ties) {
  const std::size_t n = data.rows();
  const auto& outcome = data.outcome;
  const auto stratum = [&](std::size_t i) { return data.strata ? data.strata->codes[i] : 0U; };
  const auto weight = [&](std::size_t i) {
    return data.weights ? (*data.weights)(static_cast<Eigen::Index>(i)) : 1.0;
  };
  std::vector<double> predictor(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    predictor[i] = data.design.row(row).dot(beta) + (data.offset ? (*data.offset)(row) : 0.0);
  }
  double loglik = 0.0;
  std::vector<bool> done(n, false);
  for (std::size_t i = 0; i < n; ++i) {
    if (outcome.event[i] == 0 || done[i]) {
      continue;
    }
    std::vector<std::size_t> at_risk;
    std::vector<std::size_t> events;
    for (std::size_t k = 0; k < n; ++k) {
      const bool started = outcome.start.empty() || outcome.start[k] < outcome.stop[i];
      if (stratum(k) != stratum(i) || !started || outcome.stop[k] < outcome.stop[i]) {
        continue;
      }
      at_risk.push_back(k);
      if (outcome.event[k] != 0 && outcome.stop[k] == outcome.stop[i]) {
        events.push_back(k);
        done[k] = true;
      }
    }
    const auto risk_of = [&](const std::vector<std::size_t>& set) {
      double sum = 0.0;
      for (const std::size_t k : set) {
        sum += weight(k) * std::exp(predictor[k]);
      }
      return sum;
    };
    double total_weight = 0.0;
    for (const std::size_t k : events) {
      loglik += weight(k) * predictor[k];
      total_weight += weight(k);
    }
    const auto d = static_cast<double>(events.size());
    if (ties == Ties::exact) {
      double sum = 0.0;
      for_each_subset(at_risk, events.size(), [&](const std::vector<std::size_t>& subset) {
        double product = 0.0;
        for (const std::size_t k : subset) {
          product += predictor[k];
        }
        sum += std::exp(product);
      });
      loglik -= std::log(sum);
      continue;
    }
    for (std::size_t k = 0; k < events.size(); ++k) {
      const double share = ties == Ties::efron ? static_cast<double>(k) / d : 0.0;
      loglik -= total_weight / d * std::log(risk_of(at_risk) - share * risk_of(events));
    }
  }
  return loglik;
}

/// Score and information by central differences of the slow likelihood: for checks to 1e-6.
Eigen::VectorXd slow_score(const CoxData& data, const Eigen::VectorXd& beta, Ties ties) {
  Eigen::VectorXd score(beta.size());
  for (Eigen::Index j = 0; j < beta.size(); ++j) {
    const Eigen::VectorXd step = 1e-5 * Eigen::VectorXd::Unit(beta.size(), j);
    score(j) = (slow_loglik(data, beta + step, ties) - slow_loglik(data, beta - step, ties)) / 2e-5;
  }
  return score;
}

Eigen::MatrixXd slow_information(const CoxData& data, const Eigen::VectorXd& beta, Ties ties) {
  Eigen::MatrixXd information(beta.size(), beta.size());
  for (Eigen::Index j = 0; j < beta.size(); ++j) {
    const Eigen::VectorXd step = 1e-3 * Eigen::VectorXd::Unit(beta.size(), j);
    information.col(j) =
        (slow_score(data, beta - step, ties) - slow_score(data, beta + step, ties)) / 2e-3;
  }
  return information;
}

void expect_maximum_of_slow_likelihood(const CoxData& data, Ties ties) {
  CoxOptions options;
  options.ties = ties;
  const CoxFit fit = fit_cox(data, options);
  ASSERT_EQ(fit.summary.termination, CoxTermination::converged);
  EXPECT_NEAR(fit.loglik.value(), slow_loglik(data, fit.beta, ties), 1e-11 * std::abs(*fit.loglik));
  EXPECT_NEAR(fit.loglik_null.value(),
              slow_loglik(data, Eigen::VectorXd::Zero(fit.beta.size()), ties),
              1e-11 * std::abs(*fit.loglik));
  EXPECT_LT(slow_score(data, fit.beta, ties).cwiseAbs().maxCoeff(), 1e-5);
  const Eigen::MatrixXd unity = fit.model_vcov * slow_information(data, fit.beta, ties);
  EXPECT_LT((unity - Eigen::MatrixXd::Identity(unity.rows(), unity.cols())).cwiseAbs().maxCoeff(),
            1e-4);
}

TEST(Cox, MaximisesTheLikelihoodOfTheDefinition) {
  for (unsigned seed = 0; seed < 16; ++seed) {
    SCOPED_TRACE(seed);
    Made made;
    made.truncated = (seed & 1U) != 0;
    made.weighted = (seed & 2U) != 0;
    made.stratified = (seed & 4U) != 0;
    CoxData data = make(made, seed);
    if ((seed & 8U) != 0) {
      data.offset = 0.3 * data.design.col(2).array().sin();
    }
    expect_maximum_of_slow_likelihood(data, Ties::efron);
    expect_maximum_of_slow_likelihood(data, Ties::breslow);
  }
}

TEST(Cox, ExactTiesAreTheSumOverAllSubsets) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    Made made;
    made.rows = 16;
    made.columns = 2;
    made.truncated = (seed & 1U) != 0;
    CoxData data = make(made, seed + 40);
    expect_maximum_of_slow_likelihood(data, Ties::exact);
  }
}

TEST(Cox, RulesForTiesAgreeWithoutTies) {
  CoxData data = make({}, 7);
  for (std::size_t i = 0; i < data.rows(); ++i) {
    data.outcome.stop[i] += 1e-3 * static_cast<double>(i);
  }
  CoxOptions options;
  const CoxFit efron = fit_cox(data, options);
  for (const Ties ties : {Ties::breslow, Ties::exact}) {
    options.ties = ties;
    const CoxFit fit = fit_cox(data, options);
    EXPECT_NEAR(fit.loglik.value(), efron.loglik.value(), 1e-11);
    EXPECT_LT((fit.beta - efron.beta).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LT((fit.vcov - efron.vcov).cwiseAbs().maxCoeff(), 1e-10);
  }
}

TEST(Cox, ExactTiesOfThousandsNeitherOverflowNorCancel) {
  // All 2,000 events of 3,000 rows at one time: a hypergeometric with one binary column. Its
  // log-likelihood at 0 is -log C(3000, 2000).
  const std::size_t n = 3000;
  std::vector<double> stop(n, 1.0);
  std::vector<std::uint8_t> event(n, 0);
  Eigen::MatrixXd x(static_cast<Eigen::Index>(n), 1);
  for (std::size_t i = 0; i < n; ++i) {
    event[i] = i < 2000 ? 1 : 0;
    x(static_cast<Eigen::Index>(i), 0) = i % 3 == 0 ? 1.0 : 0.0;
  }
  CoxOptions options;
  options.ties = Ties::exact;
  const CoxFit fit = fit_cox(cox(stop, event, x), options);
  const double expected = std::lgamma(2001.0) + std::lgamma(1001.0) - std::lgamma(3001.0);
  EXPECT_NEAR(fit.loglik_null.value(), expected, 1e-10 * std::abs(expected));
  EXPECT_EQ(fit.summary.termination, CoxTermination::converged);
}

// ---- Residuals and the robust variance ----

TEST(Cox, ScoreResidualsSumToTheScoreAndDfbetasFollowTheJackknife) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    Made made;
    made.rows = 200;
    made.truncated = (seed & 1U) != 0;
    made.weighted = (seed & 2U) != 0;
    made.stratified = (seed & 4U) != 0;
    CoxData data = make(made, seed + 100);
    for (const Ties ties : {Ties::efron, Ties::breslow}) {
      CoxOptions options;
      options.ties = ties;
      const CoxFit fit = fit_cox(data, options);
      const CoxResiduals residuals = cox_residuals(data, fit);
      const Eigen::VectorXd weights = data.weights.value_or(Eigen::VectorXd::Ones(200));
      EXPECT_LT((residuals.score.transpose() * weights).cwiseAbs().maxCoeff(), 1e-8);
      EXPECT_LT(std::abs(residuals.martingale.dot(weights)), 1e-9);
      EXPECT_LT(residuals.dfbeta.colwise().sum().cwiseAbs().maxCoeff(), 1e-8);

      // The influence of a row's weight on beta is exactly the derivative along the weight with
      // Breslow's rule; Efron's rule shares tied events by their mean weight.
      if (ties == Ties::breslow) {
        const double step = 1e-5;
        for (Eigen::Index row = 0; row < 200; row += 23) {
          CoxData heavier = data;
          CoxData lighter = data;
          heavier.weights = weights;
          lighter.weights = weights;
          (*heavier.weights)(row) += step;
          (*lighter.weights)(row) -= step;
          const Eigen::VectorXd slope =
              (fit_cox(heavier, options).beta - fit_cox(lighter, options).beta) / (2 * step);
          EXPECT_LT(
              (slope * weights(row) - residuals.dfbeta.row(row).transpose()).cwiseAbs().maxCoeff(),
              1e-6);
        }
      }
    }
  }
}

TEST(Cox, RobustVarianceIsThatOfTheDfbetas) {
  Made made;
  made.truncated = true;
  made.weighted = true;
  CoxData data = make(made, 3);
  std::vector<std::uint32_t> days;
  for (std::size_t i = 0; i < data.rows(); ++i) {
    days.push_back(static_cast<std::uint32_t>(i * 7 % 40));
  }
  data.cluster = factor(days, 41);  // A level without rows is no cluster.
  const CoxFit fit = fit_cox(data);
  const CoxResiduals residuals = cox_residuals(data, fit);
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(41, 3);
  for (std::size_t i = 0; i < days.size(); ++i) {
    sums.row(days[i]) += residuals.dfbeta.row(static_cast<Eigen::Index>(i));
  }
  EXPECT_EQ(fit.clusters, 40U);
  EXPECT_TRUE(fit.robust);
  EXPECT_LT((sums.transpose() * sums - fit.vcov).cwiseAbs().maxCoeff(), 1e-13);

  data.cluster.reset();
  EXPECT_TRUE(fit_cox(data).robust);  // By its fractional weights.
  *data.weights = data.weights->array() + 0.5;
  EXPECT_FALSE(fit_cox(data).robust);
}

// ---- Against R, late entry ----

/// Sixteen rows with ties, late entry, weights and clusters, for `coxph(Surv(start, stop, event) ~
/// x
/// + g + cluster(day), weights = w)` with `coxph.control(eps = 1e-14)`.
CoxData late_entries() {
  Eigen::MatrixXd design(16, 2);
  design.col(0) << .5, -1.2, .3, 2.1, -.4, 1.5, -.8, .2, 1.1, .9, -1.5, .7, 0, -.3, 1.8, -.6;
  design.col(1) << 1, 0, 0, 1, 1, 0, 1, 0, 1, 1, 0, 0, 1, 0, 1, 0;
  CoxData data = cox({3, 5, 5, 6, 8, 8, 4, 9, 6, 2, 9, 7, 6, 8, 7, 5},
                     {1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 0, 1, 1, 1},
                     design);
  data.outcome.start = {0, 0, 1, 2, 0, 3, 1, 4, 2, 0, 5, 3, 0, 2, 4, 1};
  data.weights = Eigen::VectorXd(16);
  *data.weights << 1, 2, 1.5, 1, .5, 1, 2, 1, 1, 1.5, 1, 2, 1, 1, .5, 1;
  data.cluster = factor({0, 1, 2, 3, 4, 0, 1, 2, 3, 4, 0, 1, 2, 3, 4, 0}, 5);
  return data;
}

/// What R says.
struct Reference {
  Ties ties;
  std::vector<double> beta, model_se, robust_se, zph, dfbeta_ss;
  double loglik_null, loglik, robust_score, deviance_ss, hazard_at_8;
};

void expect_reference(const Reference& reference) {
  const CoxData data = late_entries();
  CoxOptions options;
  options.ties = reference.ties;
  const CoxFit fit = fit_cox(data, options);
  const CoxResiduals residuals = cox_residuals(data, fit);
  const ProportionalityTests zph = cox_zph(data, fit);
  const auto expect_near = [](double actual, double expected) {
    EXPECT_NEAR(actual, expected, 1e-11 * std::abs(expected));
  };
  for (std::size_t j = 0; j < 2; ++j) {
    expect_near(fit.coefficients[j].estimate.value(), reference.beta[j]);
    expect_near(fit.coefficients[j].model_se.value(), reference.model_se[j]);
    expect_near(fit.coefficients[j].robust_se.value(), reference.robust_se[j]);
    expect_near(zph.parts[j].test->statistic, reference.zph[j]);
    expect_near(residuals.dfbeta.col(static_cast<Eigen::Index>(j)).squaredNorm(),
                reference.dfbeta_ss[j]);
  }
  expect_near(zph.global->statistic, reference.zph[2]);
  expect_near(fit.loglik_null.value(), reference.loglik_null);
  expect_near(fit.loglik.value(), reference.loglik);
  expect_near(fit.robust_score.value().statistic, reference.robust_score);
  expect_near(residuals.deviance.squaredNorm(), reference.deviance_ss);
  const BaselineHazard baseline = cox_baseline(data, fit).front();
  const auto at = std::find(baseline.time.begin(), baseline.time.end(), 8.0);
  expect_near(baseline.hazard[static_cast<std::size_t>(at - baseline.time.begin())],
              reference.hazard_at_8);
}

TEST(Cox, LateEntryWithTiesWeightsAndClustersEqualsR) {
  expect_reference({Ties::efron,
                    {0.300624826733589, 0.605975754570175},
                    {0.298983171668557, 0.659878015962734},
                    {0.234430949197685, 0.315982720480881},
                    {1.383122607028321, 0.030411393241574, 1.383126826665236},
                    {0.113746473945134, 0.159197466142780},
                    -26.6592202738816,
                    -25.4091378548772,
                    2.35535382744263,
                    12.1898351880598,
                    1.43334210886326});
  expect_reference({Ties::breslow,
                    {0.265761054790647, 0.563676363707599},
                    {0.297653393275245, 0.653124981817030},
                    {0.220530540736452, 0.277156654662144},
                    {1.018122703692595943, 0.000313068064504794, 1.033351497482619008},
                    {0.0960952014253253, 0.1351021636862543},
                    -27.7433248229934,
                    -26.6850479070552,
                    2.66263784380535,
                    11.2459593296771,
                    1.23332856372457});
}

// ---- Invariance ----

TEST(Cox, SplitRowsGiveTheSameFit) {
  Made made;
  made.rows = 150;
  const CoxData whole = make(made, 11);
  CoxData split = whole;
  split.outcome = {};
  std::vector<Eigen::Index> from;
  for (std::size_t i = 0; i < whole.rows(); ++i) {
    const double stop = whole.outcome.stop[i];
    const double cut = std::floor(stop / 2.0) + 0.5;
    const bool cuts = cut < stop && i % 3 != 0;
    if (cuts) {
      split.outcome.start.push_back(-1.0);
      split.outcome.stop.push_back(cut);
      split.outcome.event.push_back(0);
      from.push_back(static_cast<Eigen::Index>(i));
    }
    split.outcome.start.push_back(cuts ? cut : -1.0);
    split.outcome.stop.push_back(stop);
    split.outcome.event.push_back(whole.outcome.event[i]);
    from.push_back(static_cast<Eigen::Index>(i));
  }
  split.design = whole.design(from, Eigen::all);
  for (const Ties ties : {Ties::efron, Ties::breslow, Ties::exact}) {
    CoxOptions options;
    options.ties = ties;
    const CoxFit a = fit_cox(whole, options);
    const CoxFit b = fit_cox(split, options);
    EXPECT_NEAR(a.loglik.value(), b.loglik.value(), 1e-10);
    EXPECT_LT((a.beta - b.beta).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LT((a.vcov - b.vcov).cwiseAbs().maxCoeff(), 1e-10);
    if (ties != Ties::exact) {
      EXPECT_NEAR(cox_zph(whole, a, TimeTransform::identity).global->statistic,
                  cox_zph(split, b, TimeTransform::identity).global->statistic,
                  1e-8);
    }
  }
}

TEST(Cox, RowOrderUnitsAndOriginDoNotMatter) {
  Made made;
  made.truncated = true;
  made.stratified = true;
  const CoxData data = make(made, 5);
  CoxData other = data;
  const std::size_t n = data.rows();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t from = (i * 23 + 5) % n;  // 23 and 60 share no factor.
    const auto row = static_cast<Eigen::Index>(i);
    other.outcome.start[i] = data.outcome.start[from];
    other.outcome.stop[i] = data.outcome.stop[from];
    other.outcome.event[i] = data.outcome.event[from];
    other.strata->codes[i] = data.strata->codes[from];
    other.design.row(row) = data.design.row(static_cast<Eigen::Index>(from));
    other.design(row, 1) = 1e6 * other.design(row, 1) + 1e9;
  }
  const CoxFit a = fit_cox(data);
  const CoxFit b = fit_cox(other);
  EXPECT_NEAR(a.loglik.value(), b.loglik.value(), 1e-10);
  EXPECT_NEAR(a.beta(0), b.beta(0), 1e-9);
  EXPECT_NEAR(a.beta(1), 1e6 * b.beta(1), 1e-9);
  EXPECT_NEAR(a.wald.value().statistic, b.wald.value().statistic, 1e-8);
}

bool named(const CoxFit& fit, ConditionKind kind, const std::string& column) {
  return std::any_of(fit.conditions.begin(), fit.conditions.end(), [&](const Condition& condition) {
    return condition.kind == kind && condition.column == column;
  });
}

TEST(Cox, HugeOffsetsDoNotOverflow) {
  CoxData data = make({}, 2);
  const CoxFit plain = fit_cox(data);
  data.offset = Eigen::VectorXd::Constant(60, 2000.0);
  const CoxFit moved = fit_cox(data);
  EXPECT_NEAR(moved.loglik.value(), plain.loglik.value(), 1e-9);
  EXPECT_LT((moved.beta - plain.beta).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(Cox, AConstantOffsetChangesNothing) {
  CoxData data = make({}, 2);
  const CoxFit plain = fit_cox(data);
  for (const double offset : {-2000.0, -1000.0, 1000.0}) {
    data.offset = Eigen::VectorXd::Constant(60, offset);
    const CoxFit moved = fit_cox(data);
    EXPECT_NEAR(moved.loglik.value(), plain.loglik.value(), 1e-9);
    EXPECT_LT((moved.beta - plain.beta).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LT((moved.vcov - plain.vcov).cwiseAbs().maxCoeff(), 1e-10);
  }
}

TEST(Cox, WideOffsetsAreRightOrNamed) {
  // Every risk set holds a row with the largest offset, so those alone count: as without the
  // others.
  CoxData data = cox({1, 2, 3, 4, 5, 6, 7, 7, 7},
                     {1, 1, 1, 1, 1, 0, 0, 0, 0},
                     (Eigen::VectorXd(9) << 0, 2, 1, 3, 1, 2, 5, 7, 1).finished());
  data.offset = (Eigen::VectorXd(9) << 500, 500, 500, 500, 500, 500, -500, -500, -500).finished();
  const CoxFit wide = fit_cox(data);
  CoxData few = cox(
      {1, 2, 3, 4, 5, 6}, {1, 1, 1, 1, 1, 0}, (Eigen::VectorXd(6) << 0, 2, 1, 3, 1, 2).finished());
  const CoxFit rest = fit_cox(few);
  EXPECT_NEAR(wide.beta(0), rest.beta(0), 1e-8);
  EXPECT_NEAR(wide.coefficients[0].model_se.value(), rest.coefficients[0].model_se.value(), 1e-8);
  // At the last event only rows are at risk that weigh nothing beside the first ones.
  data.offset = (Eigen::VectorXd(9) << 4000, 4000, 4000, 0, 0, 0, 0, 0, 0).finished();
  const CoxFit none = fit_cox(data);
  EXPECT_TRUE(named(none, ConditionKind::infinite_value, "offset"));
  EXPECT_TRUE(has_error(none.conditions));
  EXPECT_FALSE(none.coefficients[0].estimate.has_value());
}

TEST(Cox, ExtremeUnitsChangeNoTest) {
  CoxData data = make({}, 2);
  const CoxFit plain = fit_cox(data);
  for (const double unit : {1e-300, 1e-200, 1e200, 1e300}) {
    CoxData other = data;
    other.design.col(1) *= unit;
    const CoxFit fit = fit_cox(other);
    EXPECT_NEAR(fit.coefficients[1].z.value(), plain.coefficients[1].z.value(), 1e-9);
    EXPECT_NEAR(fit.coefficients[1].p_value.value(), plain.coefficients[1].p_value.value(), 1e-9);
    EXPECT_NEAR(*fit.coefficients[1].model_se * unit, *plain.coefficients[1].model_se, 1e-9);
  }
}

TEST(Cox, WholeWeightsAreRepeatedRows) {
  CoxData data = make({}, 9);
  CoxData repeated = data;
  repeated.outcome = {};
  std::vector<Eigen::Index> from;
  data.weights = Eigen::VectorXd(60);
  for (Eigen::Index i = 0; i < 60; ++i) {
    const int times = 1 + static_cast<int>(i % 3);
    (*data.weights)(i) = times;
    for (int k = 0; k < times; ++k) {
      from.push_back(i);
      repeated.outcome.stop.push_back(data.outcome.stop[static_cast<std::size_t>(i)]);
      repeated.outcome.event.push_back(data.outcome.event[static_cast<std::size_t>(i)]);
    }
  }
  repeated.design = data.design(from, Eigen::all);
  CoxOptions options;
  options.ties = Ties::breslow;
  const CoxFit a = fit_cox(data, options);
  const CoxFit b = fit_cox(repeated, options);
  EXPECT_NEAR(a.loglik.value(), b.loglik.value(), 1e-10);
  EXPECT_LT((a.vcov - b.vcov).cwiseAbs().maxCoeff(), 1e-11);
}

// ---- Data that cannot be fitted, misuse ----

TEST(Cox, NamesTooFewRowsAndNoEvents) {
  const CoxFit none = fit_cox(cox({}, {}, Eigen::MatrixXd(0, 1)));
  EXPECT_TRUE(named(none, ConditionKind::no_rows, ""));
  ASSERT_EQ(none.coefficients.size(), 1U);
  EXPECT_FALSE(none.coefficients[0].estimate.has_value());
  EXPECT_FALSE(none.loglik.has_value());

  EXPECT_TRUE(
      named(fit_cox(cox({1}, {1}, Eigen::MatrixXd::Ones(1, 1))), ConditionKind::too_few_rows, ""));
  EXPECT_TRUE(
      named(fit_cox(cox({1, 2}, {0, 0}, Eigen::Vector2d(0, 1))), ConditionKind::no_events, ""));
  const CoxFit two = fit_cox(cox({1, 2}, {1, 1}, Eigen::Vector2d(0, 1)));
  EXPECT_TRUE(named(two, ConditionKind::monotone_likelihood, "x1"));
  EXPECT_NEAR(two.loglik.value(), 0.0, 1e-10);
  // All at risk have their event at once: nothing to learn.
  CoxOptions exact;
  exact.ties = Ties::exact;
  EXPECT_TRUE(named(fit_cox(cox({1, 1}, {1, 1}, Eigen::Vector2d(0, 1)), exact),
                    ConditionKind::constant_column,
                    "x1"));
}

TEST(Cox, NamesConstantAndCollinearColumns) {
  CoxData data = make({}, 4);
  Eigen::MatrixXd design(60, 5);
  design.leftCols(3) = data.design;
  design.col(3).setConstant(0.1);
  design.col(4) = 2.0 * data.design.col(1).array() - 3.0 * data.design.col(2).array() + 5.0;
  const CoxData wide = cox(data.outcome.stop, data.outcome.event, design);
  for (const Ties ties : {Ties::efron, Ties::breslow, Ties::exact}) {
    CoxOptions options;
    options.ties = ties;
    const CoxFit fit = fit_cox(wide, options);
    const CoxFit narrow = fit_cox(data, options);
    EXPECT_TRUE(named(fit, ConditionKind::constant_column, "x4"));
    EXPECT_TRUE(named(fit, ConditionKind::collinear_column, "x5"));
    EXPECT_EQ(fit.df, 3U);
    EXPECT_FALSE(fit.coefficients[3].estimate.has_value());
    EXPECT_FALSE(fit.coefficients[4].interval.has_value());
    EXPECT_TRUE(std::isnan(fit.vcov(4, 4)));
    EXPECT_NEAR(fit.loglik.value(), narrow.loglik.value(), 1e-10);
    EXPECT_NEAR(fit.wald.value().statistic, narrow.wald.value().statistic, 1e-9);
    EXPECT_NEAR(fit.coefficients[1].z.value(), narrow.coefficients[1].z.value(), 1e-9);
  }
  const CoxResiduals residuals = cox_residuals(wide, fit_cox(wide));
  EXPECT_TRUE(std::isnan(residuals.dfbeta(0, 3)));
  EXPECT_FALSE(std::isnan(residuals.dfbeta(0, 2)));
}

TEST(Cox, NamesAColumnThatIsConstantWithinStrata) {
  Made made;
  made.stratified = true;
  CoxData data = make(made, 6);
  for (std::size_t i = 0; i < data.rows(); ++i) {
    data.design(static_cast<Eigen::Index>(i), 2) = 3.7 * data.strata->codes[i];
  }
  const CoxFit fit = fit_cox(data);
  EXPECT_TRUE(named(fit, ConditionKind::constant_column, "x3"));
  EXPECT_EQ(fit.df, 2U);
}

TEST(Cox, NamesEveryColumnThatRunsAway) {
  // No event where x1 = 0; x3 repeats the pattern of its complement with noise on top of neither.
  for (const bool truncated : {false, true}) {
    SCOPED_TRACE(truncated);
    Made made;
    made.rows = 80;
    made.truncated = truncated;
    CoxData data = make(made, 21);
    for (std::size_t i = 0; i < data.rows(); ++i) {
      if (data.design(static_cast<Eigen::Index>(i), 0) == 0.0) {
        data.outcome.event[i] = 0;
      }
    }
    for (const Ties ties : {Ties::efron, Ties::breslow, Ties::exact}) {
      CoxOptions options;
      options.ties = ties;
      const CoxFit fit = fit_cox(data, options);
      EXPECT_TRUE(named(fit, ConditionKind::monotone_likelihood, "x1"));
      EXPECT_FALSE(named(fit, ConditionKind::monotone_likelihood, "x2"));
      EXPECT_FALSE(fit.coefficients[0].model_se.has_value());
      EXPECT_FALSE(fit.wald.has_value());

      // The limit is the fit to the rows that are left when those of x1 = 0 never are at risk.
      std::vector<Eigen::Index> kept;
      CoxData rest = data;
      rest.outcome = {};
      for (std::size_t i = 0; i < data.rows(); ++i) {
        if (data.design(static_cast<Eigen::Index>(i), 0) != 0.0) {
          kept.push_back(static_cast<Eigen::Index>(i));
          rest.outcome.stop.push_back(data.outcome.stop[i]);
          rest.outcome.event.push_back(data.outcome.event[i]);
          if (truncated) {
            rest.outcome.start.push_back(data.outcome.start[i]);
          }
        }
      }
      rest.design = data.design(kept, Eigen::all);
      const CoxFit limit = fit_cox(rest, options);
      EXPECT_NEAR(fit.loglik.value(), limit.loglik.value(), 1e-8);
      EXPECT_NEAR(fit.beta(1), limit.beta(1), 1e-8);
      EXPECT_NEAR(
          fit.coefficients[2].model_se.value(), limit.coefficients[2].model_se.value(), 1e-8);
    }
  }
}

TEST(Cox, ARatioThatHasRunAwayIsNoEstimate) {
  // Thirty rows in order but for two, out of it by a hair: R prints a hazard ratio of 1.3e188.
  std::vector<double> stop;
  Eigen::MatrixXd design(30, 1);
  for (Eigen::Index i = 0; i < 30; ++i) {
    stop.push_back(30.0 - static_cast<double>(i));
    design(i, 0) = static_cast<double>(i + 1) / 30.0;
  }
  design(14, 0) = design(15, 0) + 1e-6;
  for (const double unit : {1.0, 1e-6, 1e6}) {
    const CoxFit fit = fit_cox(cox(stop, std::vector<std::uint8_t>(30, 1), unit * design));
    EXPECT_TRUE(named(fit, ConditionKind::near_separation, "x1"));
    EXPECT_FALSE(fit.coefficients[0].estimate.has_value());
    EXPECT_FALSE(fit.coefficients[0].hazard_ratio.has_value());
    EXPECT_TRUE(std::isnan(fit.vcov(0, 0)));
    EXPECT_TRUE(fit.likelihood_ratio.has_value()) << "the likelihood has its maximum";
    EXPECT_GT(fit.beta(0), 0.0) << "predictors still order the rows";
  }
  // Out of order by a tenth of the range it is an ordinary, if steep, slope.
  design(14, 0) = design(15, 0) + 0.1;
  EXPECT_TRUE(fit_cox(cox(stop, std::vector<std::uint8_t>(30, 1), design))
                  .coefficients[0]
                  .estimate.has_value());
}

TEST(Cox, ClustersTooFewForAVarianceAreNamed) {
  CoxData data = make({}, 8);
  data.cluster = factor(std::vector<std::uint32_t>(60, 0), 1);
  const CoxFit one = fit_cox(data);
  EXPECT_TRUE(named(one, ConditionKind::one_cluster, ""));
  EXPECT_FALSE(one.coefficients[0].robust_se.has_value());
  EXPECT_FALSE(one.coefficients[0].p_value.has_value());
  EXPECT_TRUE(one.coefficients[0].model_se.has_value());
  for (std::size_t i = 0; i < 60; ++i) {
    data.cluster->codes[i] = static_cast<std::uint32_t>(i % 2);
  }
  data.cluster->levels = {"a", "b"};
  const CoxFit two = fit_cox(data);
  EXPECT_TRUE(named(two, ConditionKind::few_clusters, ""));
  EXPECT_FALSE(two.robust_score.has_value());
}

TEST(Cox, RefusesMisuse) {
  CoxData data = make({}, 1);
  CoxOptions options;
  options.ties = Ties::exact;
  options.robust = true;
  EXPECT_THROW(static_cast<void>(fit_cox(data, options)), std::invalid_argument);
  options.robust.reset();
  data.weights = Eigen::VectorXd::Constant(60, 2.0);
  EXPECT_THROW(static_cast<void>(fit_cox(data, options)), std::invalid_argument);
  options.ties = Ties::efron;
  options.level = 1.0;
  EXPECT_THROW(static_cast<void>(fit_cox(data, options)), std::invalid_argument);
  options.level = 0.95;
  data.columns.pop_back();
  EXPECT_THROW(static_cast<void>(fit_cox(data, options)), std::invalid_argument);

  data = make({}, 1);
  data.weights = Eigen::VectorXd::Zero(60);
  EXPECT_TRUE(named(fit_cox(data), ConditionKind::bad_weight, ""));
  data.weights.reset();
  data.design(3, 1) = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(named(fit_cox(data), ConditionKind::infinite_value, "x2"));
}

}  // namespace
}  // namespace tcert::statistics
