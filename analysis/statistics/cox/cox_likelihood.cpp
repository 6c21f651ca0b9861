#include <statistics/cox/cox_likelihood.hpp>

#include <algorithm>
#include <cmath>
#include <statistics/basics/compensated_sum.hpp>
#include <statistics/cox/cox_risk_pass.hpp>

namespace tcert::statistics {
TieSums tie_sums(double others, double events, std::size_t d, Ties ties) noexcept {
  TieSums sums;
  if (ties != Ties::efron || d == 1) {
    const auto count = static_cast<double>(d);
    const double inverse = 1.0 / (others + events);
    sums.log_z = count * std::log(others + events);
    sums.a1 = sums.b1 = count * inverse;
    sums.a2 = sums.b2 = sums.c2 = count * inverse * inverse;
    return sums;
  }
  // The logarithm of a product of shares of the first denominator, while it is far from 0.
  constexpr double kSmallestProduct = 1e-200;
  const double all = others + events;
  double product = 1.0;
  sums.log_z = static_cast<double>(d) * std::log(all);
  for (std::size_t k = 0; k < d; ++k) {
    const double g = static_cast<double>(d - k) / static_cast<double>(d);
    const double z = others + g * events;
    const double inverse = 1.0 / z;
    const double g_inverse = g * inverse;
    product *= z / all;
    if (product < kSmallestProduct) {
      sums.log_z += std::log(product);
      product = 1.0;
    }
    sums.a1 += inverse;
    sums.b1 += g_inverse;
    sums.a2 += inverse * inverse;
    sums.b2 += g_inverse * inverse;
    sums.c2 += g_inverse * g_inverse;
  }
  sums.log_z += std::log(product);
  return sums;
}

double add_risk_set(const CoxRows& rows,
                    const RiskSet& set,
                    Ties ties,
                    std::vector<double>& score,
                    std::vector<double>& information) {
  const std::size_t p = score.size();
  const std::size_t begin = rows.sets.events_begin[set.time];
  const std::size_t end = rows.sets.begin[set.time + 1];
  double weight = 0.0;
  for (std::size_t place = begin; place < end; ++place) {
    const double w = rows.weight_of(place);
    const double* const x = rows.row(place);
    weight += w;
    for (std::size_t j = 0; j < p; ++j) {
      score[j] += w * x[j];
    }
  }
  weight /= static_cast<double>(end - begin);

  const TieSums sums = tie_sums(set.others.zeroth(), set.events.zeroth(), end - begin, ties);
  const double* const r1 = set.others.first();
  const double* const e1 = set.events.first();
  const double* r2 = set.others.second();
  const double* e2 = set.events.second();
  double* out = information.data();
  for (std::size_t a = 0; a < p; ++a) {
    score[a] -= weight * (sums.a1 * r1[a] + sums.b1 * e1[a]);
    // Sums of positive parts alone, so that nothing cancels: (others + g events) / z.
    const double r = sums.a2 * r1[a] + sums.b2 * e1[a];
    const double e = sums.b2 * r1[a] + sums.c2 * e1[a];
    for (std::size_t b = 0; b <= a; ++b) {
      *out++ += weight * (sums.a1 * *r2++ + sums.b1 * *e2++ - (r * r1[b] + e * e1[b]));
    }
  }
  return weight * sums.log_z;
}

CoxDerivatives cox_derivatives(const CoxRows& rows, const Eigen::VectorXd& beta, Ties ties) {
  if (ties == Ties::exact) {
    return exact_derivatives(rows, beta);
  }
  const std::size_t p = rows.columns;
  RiskScores risks;
  risk_scores(rows, beta, risks);
  std::vector<double> score(p, 0.0);
  std::vector<double> information(p * (p + 1) / 2, 0.0);
  // Of hundreds of thousands of terms a plain sum loses more than Newton's last steps gain.
  CompensatedSum loglik;
  std::vector<CompensatedSum> score_sums(p);
  for_each_risk_set(rows, risks, true, [&](const RiskSet& set) {
    std::fill(score.begin(), score.end(), 0.0);
    loglik.add(-add_risk_set(rows, set, ties, score, information));
    for (std::size_t j = 0; j < p; ++j) {
      score_sums[j].add(score[j]);
    }
  });
  for (std::size_t t = 0; t < rows.sets.times(); ++t) {
    for (std::size_t place = rows.sets.events_begin[t]; place < rows.sets.begin[t + 1]; ++place) {
      double predictor = rows.offset_of(place) - risks.shift;
      for (std::size_t j = 0; j < p; ++j) {
        predictor += rows.row(place)[j] * beta(static_cast<Eigen::Index>(j));
      }
      loglik.add(rows.weight_of(place) * predictor);
    }
  }

  CoxDerivatives result;
  result.loglik = loglik.value();
  result.score.resize(static_cast<Eigen::Index>(p));
  for (std::size_t j = 0; j < p; ++j) {
    result.score(static_cast<Eigen::Index>(j)) = score_sums[j].value();
  }
  result.information.resize(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(p));
  std::size_t k = 0;
  for (Eigen::Index a = 0; a < result.information.rows(); ++a) {
    for (Eigen::Index b = 0; b <= a; ++b) {
      result.information(a, b) = result.information(b, a) = information[k++];
    }
  }
  return result;
}

}  // namespace tcert::statistics
