#include "analysis/cox_hazard_steps.hpp"

#include "analysis/cox_likelihood.hpp"
#include "analysis/cox_risk_pass.hpp"

namespace tcert {
namespace {

bool is_event(const CoxRows& rows, std::size_t place) noexcept {
  return place >= rows.sets.events_begin[rows.sets.last[rows.sets.order[place]]];
}

/// Where a row's exposure begins and ends in cumulative sums over event times.
struct Exposure {
  std::size_t last = 0;
  std::size_t before_last = 0;   ///< Valid if `has_before_last`.
  std::size_t before_first = 0;  ///< Valid if `has_before_first`.
  bool has_before_last = false;
  bool has_before_first = false;
  bool event = false;

  Exposure(const CoxRows& rows, std::size_t place) noexcept {
    const RiskSets& sets = rows.sets;
    const std::uint32_t row = sets.order[place];
    last = sets.last[row];
    const std::size_t origin = sets.stratum_begin[sets.stratum_of[last]];
    const std::size_t first = sets.first[row];
    has_before_last = last > origin;
    before_last = has_before_last ? last - 1 : 0;
    has_before_first = first > origin;
    before_first = has_before_first ? first - 1 : 0;
    event = is_event(rows, place);
  }

  /// Of cumulative sums and events' own steps, each `stride` apart.
  [[nodiscard]] double sum(const double* cumulative,
                           const double* event_step,
                           std::size_t stride) const noexcept {
    double total = 0.0;
    if (event) {
      total = event_step[last * stride] + (has_before_last ? cumulative[before_last * stride] : 0.0);
    } else {
      total = cumulative[last * stride];
    }
    return has_before_first ? total - cumulative[before_first * stride] : total;
  }
};

void accumulate_strata(const RiskSets& sets, std::vector<double>& values, std::size_t stride) {
  for (std::size_t s = 0; s < sets.strata(); ++s) {
    for (std::size_t t = sets.stratum_begin[s] + 1U; t < sets.stratum_begin[s + 1]; ++t) {
      for (std::size_t j = 0; j < stride; ++j) {
        values[t * stride + j] += values[(t - 1) * stride + j];
      }
    }
  }
}

}  // namespace

HazardSteps hazard_steps(const CoxRows& rows, const Eigen::VectorXd& beta, Ties ties) {
  const std::size_t times = rows.sets.times();
  const std::size_t p = rows.columns;
  HazardSteps steps;
  risk_scores(rows, beta, steps.risks);
  steps.hazard.resize(times);
  steps.hazard_variance.resize(times);
  steps.event_hazard.resize(times);
  steps.mean.resize(times * p);
  steps.mean_hazard.resize(times * p);
  steps.event_mean_hazard.resize(times * p);
  for_each_risk_set(rows, steps.risks, false, [&](const RiskSet& set) {
    const std::size_t t = set.time;
    double weight = 0.0;
    for (std::size_t place = rows.sets.events_begin[t]; place < rows.sets.begin[t + 1]; ++place) {
      weight += rows.weight[place];
    }
    const std::size_t d = rows.sets.events_at(t);
    const auto count = static_cast<double>(d);
    weight /= count;
    const TieSums sums = tie_sums(set.others.zeroth(), set.events.zeroth(), d, ties);
    steps.hazard[t] = weight * sums.a1;
    steps.hazard_variance[t] = weight * sums.a2;
    steps.event_hazard[t] = weight * sums.b1;
    for (std::size_t j = 0; j < p; ++j) {
      const double r = set.others.first()[j];
      const double e = set.events.first()[j];
      steps.mean[t * p + j] = (sums.a1 * r + sums.b1 * e) / count;
      steps.mean_hazard[t * p + j] = weight * (sums.a2 * r + sums.b2 * e);
      steps.event_mean_hazard[t * p + j] = weight * (sums.b2 * r + sums.c2 * e);
    }
  });
  accumulate_strata(rows.sets, steps.hazard, 1);
  accumulate_strata(rows.sets, steps.hazard_variance, 1);
  accumulate_strata(rows.sets, steps.mean_hazard, p);
  return steps;
}

double hazard_of_row(const CoxRows& rows, const HazardSteps& steps, std::size_t place) noexcept {
  return Exposure(rows, place).sum(steps.hazard.data(), steps.event_hazard.data(), 1);
}

void score_residual(const CoxRows& rows,
                    const HazardSteps& steps,
                    std::size_t place,
                    double* residual) noexcept {
  const std::size_t p = rows.columns;
  const Exposure exposure(rows, place);
  const double* const x = rows.row(place);
  const double risk = steps.risks.score[place];
  const double hazard = exposure.sum(steps.hazard.data(), steps.event_hazard.data(), 1);
  for (std::size_t j = 0; j < p; ++j) {
    const double mean_hazard =
        exposure.sum(steps.mean_hazard.data() + j, steps.event_mean_hazard.data() + j, p);
    residual[j] = -risk * (x[j] * hazard - mean_hazard);
    if (exposure.event) {
      residual[j] += x[j] - steps.mean[exposure.last * p + j];
    }
  }
}

}  // namespace tcert
