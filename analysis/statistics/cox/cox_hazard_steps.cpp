#include <statistics/cox/cox_hazard_steps.hpp>

#include <algorithm>
#include <statistics/cox/cox_likelihood.hpp>
#include <statistics/cox/cox_risk_pass.hpp>

namespace tcert::statistics {
namespace {

bool is_event(const CoxRows& rows, std::size_t place) noexcept {
  return place >= rows.sets.events_begin[rows.sets.last[rows.sets.order[place]]];
}

/// A row's exposure: what its cumulative sums of `stride` numbers an event time are, as
/// end + own - begin. `none` is a row of zeros.
struct Exposure {
  const double* end;
  const double* own;
  const double* begin;
};

Exposure exposure_of(const RiskSets& sets,
                     std::uint32_t row,
                     bool event,
                     const double* cumulative,
                     const double* event_step,
                     const double* none,
                     std::size_t stride) noexcept {
  const std::size_t last = sets.last[row];
  const std::size_t first = sets.first[row];
  const std::size_t origin = sets.stratum_begin[sets.stratum_of[last]];
  Exposure exposure{cumulative + last * stride, none, none};
  if (event) {
    // Its own time counts by the reduced step.
    exposure.end = last > origin ? cumulative + (last - 1) * stride : none;
    exposure.own = event_step + last * stride;
  }
  if (first > origin) {
    exposure.begin = cumulative + (first - 1) * stride;
  }
  return exposure;
}

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

HazardSteps hazard_increments(const CoxRows& rows, const Eigen::VectorXd& beta, Ties ties) {
  const std::size_t times = rows.sets.times();
  const std::size_t p = rows.columns;
  HazardSteps steps;
  risk_scores(rows, beta, steps.risks);
  steps.none.assign(std::max<std::size_t>(1, p), 0.0);
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
      weight += rows.weight_of(place);
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
  return steps;
}

HazardSteps hazard_steps(const CoxRows& rows, const Eigen::VectorXd& beta, Ties ties) {
  HazardSteps steps = hazard_increments(rows, beta, ties);
  accumulate_strata(rows.sets, steps.hazard, 1);
  accumulate_strata(rows.sets, steps.hazard_variance, 1);
  accumulate_strata(rows.sets, steps.mean_hazard, rows.columns);
  return steps;
}

double hazard_of_row(const CoxRows& rows, const HazardSteps& steps, std::size_t place) noexcept {
  const Exposure exposure = exposure_of(rows.sets,
                                        rows.sets.order[place],
                                        is_event(rows, place),
                                        steps.hazard.data(),
                                        steps.event_hazard.data(),
                                        steps.none.data(),
                                        1);
  return *exposure.end + *exposure.own - *exposure.begin;
}

void for_each_score_residual(const CoxRows& rows,
                             const HazardSteps& steps,
                             const ScoreResidualVisit& visit) {
  const RiskSets& sets = rows.sets;
  const std::size_t p = rows.columns;
  std::vector<double> residual(p);
  std::vector<double> mean_hazard(p);
  double hazard = 0.0;
  const auto expose = [&](std::size_t place, bool event) {
    const Exposure exposure = exposure_of(sets,
                                          sets.order[place],
                                          event,
                                          steps.mean_hazard.data(),
                                          steps.event_mean_hazard.data(),
                                          steps.none.data(),
                                          p);
    for (std::size_t j = 0; j < p; ++j) {
      mean_hazard[j] = exposure.end[j] + exposure.own[j] - exposure.begin[j];
    }
    hazard = hazard_of_row(rows, steps, place);
  };
  const auto visit_alike = [&](std::size_t t, std::size_t begin, std::size_t end, bool event) {
    const double* const mean = steps.mean.data() + t * p;
    for (std::size_t place = begin; place < end; ++place) {
      if (place == begin || !sets.late_begin.empty()) {
        expose(place, event);
      }
      const double* const x = rows.row(place);
      const double risk = steps.risks.score[place];
      for (std::size_t j = 0; j < p; ++j) {
        residual[j] = -risk * (x[j] * hazard - mean_hazard[j]);
      }
      for (std::size_t j = 0; event && j < p; ++j) {
        residual[j] += x[j] - mean[j];
      }
      visit(place, residual.data());
    }
  };
  for (std::size_t t = 0; t < sets.times(); ++t) {
    visit_alike(t, sets.begin[t], sets.events_begin[t], false);
    visit_alike(t, sets.events_begin[t], sets.begin[t + 1], true);
  }
}

}  // namespace tcert::statistics
