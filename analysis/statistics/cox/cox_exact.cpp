// The exact conditional likelihood of tied events. With d events among m rows at risk it is
// prod(r of the events) / e_d(r), e_d the d-th elementary symmetric polynomial of the risks. Were
// each row to have an event by an independent coin with odds s r, then Pr(d heads) =
// e_d s^d / prod(1 + s r), and score and information are mean and variance of the sum of x over the
// heads, given d of them. The recursion over the rows is in these probabilities; s is chosen so
// that d heads are expected.

#include <algorithm>
#include <cmath>
#include <statistics/basics/compensated_sum.hpp>
#include <statistics/cox/cox_likelihood.hpp>
#include <statistics/cox/cox_risk_pass.hpp>

namespace tcert::statistics {
namespace {

/// Rows at risk at one time: their places and risks.
struct AtRisk {
  std::vector<std::size_t> places;
  std::vector<double> risk;
};

void rows_at_risk(const CoxRows& rows, const RiskScores& risks, std::size_t t, AtRisk& at) {
  const RiskSets& sets = rows.sets;
  const std::size_t end = sets.begin[sets.stratum_begin[sets.stratum_of[t] + 1]];
  at.places.clear();
  at.risk.clear();
  for (std::size_t place = sets.begin[t]; place < end; ++place) {
    if (sets.first[sets.order[place]] <= t) {
      at.places.push_back(place);
      at.risk.push_back(risks.score[place]);
    }
  }
}

/// s with sum s r / (1 + s r) near d. \pre 0 < d < rows.
double odds_factor(const std::vector<double>& risk, double d) {
  double total = 0.0;
  for (const double r : risk) {
    total += r;
  }
  const auto m = static_cast<double>(risk.size());
  double log_s = std::log(d / total * m / (m - d));
  for (int step = 0; step < 50; ++step) {
    double heads = 0.0;
    double variance = 0.0;
    for (const double r : risk) {
      const double odds = std::exp(log_s) * r;
      const double p = odds / (1.0 + odds);
      heads += p;
      variance += p / (1.0 + odds);
    }
    // A tenth of a standard deviation is near enough: s cancels.
    if (std::abs(heads - d) <= 0.1 * std::sqrt(variance)) {
      break;
    }
    log_s += std::clamp((d - heads) / variance, -2.0, 2.0);
  }
  return std::exp(log_s);
}

/// Per number of heads: probability, and with it the expected sum of x and of its products.
class HeadCounts {
 public:
  HeadCounts(std::size_t d, std::size_t columns)
      : columns_(columns),
        width_(1 + columns + columns * (columns + 1) / 2),
        values_((d + 1) * width_, 0.0) {
    values_[0] = 1.0;
  }

  [[nodiscard]] const double* at(std::size_t k) const { return values_.data() + k * width_; }

  /// Throws one more coin; counts outside low..high are not needed.
  void toss(double head, double tail, const double* x, std::size_t low, std::size_t high) {
    for (std::size_t k = high + 1; k-- > low;) {
      double* const to = values_.data() + k * width_;
      if (k == 0) {
        scale(to, tail);
      } else {
        combine(to, to - width_, head, tail, x);
      }
    }
  }

 private:
  void scale(double* to, double tail) const {
    for (std::size_t i = 0; i < width_; ++i) {
      to[i] *= tail;
    }
  }

  void combine(double* to, const double* from, double head, double tail, const double* x) const {
    const double probability = from[0];
    to[0] = to[0] * tail + probability * head;
    const double* const from_sum = from + 1;
    double* const to_sum = to + 1;
    const double* from_product = from_sum + columns_;
    double* to_product = to_sum + columns_;
    for (std::size_t a = 0; a < columns_; ++a) {
      const double joined = from_sum[a] + x[a] * probability;
      for (std::size_t b = 0; b <= a; ++b) {
        const double product = *from_product++ + joined * x[b] + x[a] * from_sum[b];
        *to_product = *to_product * tail + product * head;
        ++to_product;
      }
      to_sum[a] = to_sum[a] * tail + joined * head;
    }
  }

  std::size_t columns_;
  std::size_t width_;
  std::vector<double> values_;
};

void subtract_triangle(const double* mean, const double* products, Eigen::MatrixXd& information) {
  for (Eigen::Index a = 0; a < information.rows(); ++a) {
    for (Eigen::Index b = 0; b <= a; ++b) {
      information(a, b) += *products++ - mean[a] * mean[b];
    }
  }
}

/// One time with 1 < d < m: its part of everything but the events' own predictors and x.
void add_tied_time(const CoxRows& rows, const AtRisk& at, std::size_t d, CoxDerivatives& sum) {
  const std::size_t m = at.places.size();
  const std::size_t p = rows.columns;
  const double s = odds_factor(at.risk, static_cast<double>(d));
  double log_tails = 0.0;
  std::vector<double> head(m);
  std::vector<double> centre(p, 0.0);
  double heads = 0.0;
  for (std::size_t i = 0; i < m; ++i) {
    const double odds = s * at.risk[i];
    head[i] = odds / (1.0 + odds);
    log_tails -= std::log1p(odds);
    heads += head[i];
    for (std::size_t j = 0; j < p; ++j) {
      centre[j] += head[i] * rows.row(at.places[i])[j];
    }
  }
  for (double& c : centre) {
    c /= heads;
  }

  HeadCounts counts(d, p);
  std::vector<double> x(p);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < p; ++j) {
      x[j] = rows.row(at.places[i])[j] - centre[j];
    }
    const std::size_t left = m - 1 - i;
    counts.toss(head[i],
                1.0 / (1.0 + s * at.risk[i]),
                x.data(),
                d > left ? d - left : 0,
                std::min(i + 1, d));
  }
  const double* const end = counts.at(d);
  sum.loglik -= std::log(end[0]) - static_cast<double>(d) * std::log(s) - log_tails;
  std::vector<double> conditional(end + 1, end + 1 + p + p * (p + 1) / 2);
  for (double& value : conditional) {
    value /= end[0];
  }
  for (std::size_t j = 0; j < p; ++j) {
    sum.score(static_cast<Eigen::Index>(j)) -= conditional[j] + static_cast<double>(d) * centre[j];
  }
  subtract_triangle(conditional.data(), conditional.data() + p, sum.information);
}

/// One time with a single event.
void add_single_event(const RiskSet& set, CoxDerivatives& sum) {
  const double z = set.others.zeroth() + set.events.zeroth();
  const auto p = static_cast<std::size_t>(sum.score.size());
  std::vector<double> mean(p);
  std::vector<double> products(p * (p + 1) / 2);
  for (std::size_t j = 0; j < p; ++j) {
    mean[j] = (set.others.first()[j] + set.events.first()[j]) / z;
    sum.score(static_cast<Eigen::Index>(j)) -= mean[j];
  }
  for (std::size_t k = 0; k < products.size(); ++k) {
    products[k] = (set.others.second()[k] + set.events.second()[k]) / z;
  }
  sum.loglik -= std::log(z);
  subtract_triangle(mean.data(), products.data(), sum.information);
}

}  // namespace

CoxDerivatives exact_derivatives(const CoxRows& rows, const Eigen::VectorXd& beta) {
  const auto p = static_cast<Eigen::Index>(rows.columns);
  RiskScores risks;
  risk_scores(rows, beta, risks);
  CoxDerivatives result;
  result.score = Eigen::VectorXd::Zero(p);
  result.information = Eigen::MatrixXd::Zero(p, p);
  AtRisk at;
  CompensatedSum loglik;
  std::vector<CompensatedSum> score(rows.columns);
  for_each_risk_set(rows, risks, true, [&](const RiskSet& set) {
    result.loglik = 0.0;
    result.score.setZero();
    const std::size_t begin = rows.sets.events_begin[set.time];
    const std::size_t end = rows.sets.begin[set.time + 1];
    if (end - begin > 1) {
      rows_at_risk(rows, risks, set.time, at);
      if (at.places.size() == end - begin) {
        return;  // All of them have an event: certain.
      }
      add_tied_time(rows, at, end - begin, result);
    } else {
      add_single_event(set, result);
    }
    for (std::size_t place = begin; place < end; ++place) {
      const Eigen::Map<const Eigen::VectorXd> x(rows.row(place), p);
      result.score += x;
      result.loglik += x.dot(beta) + rows.offset_of(place) - risks.shift;
    }
    loglik.add(result.loglik);
    for (std::size_t j = 0; j < score.size(); ++j) {
      score[j].add(result.score(static_cast<Eigen::Index>(j)));
    }
  });
  result.loglik = loglik.value();
  for (std::size_t j = 0; j < score.size(); ++j) {
    result.score(static_cast<Eigen::Index>(j)) = score[j].value();
  }
  result.information = Eigen::MatrixXd(result.information.selfadjointView<Eigen::Lower>());
  return result;
}

}  // namespace tcert::statistics
