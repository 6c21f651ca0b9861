#include "analysis/cox/cox_baseline.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/basics/normal.hpp"
#include "analysis/cox/cox_hazard_steps.hpp"

namespace tcert {
namespace {

/// The distinct stopping times of one stratum, each with the last event time up to it.
struct TimeGrid {
  std::vector<double> time;
  std::vector<std::size_t> step;  ///< RiskSets::kNever before the first event.
};

std::vector<TimeGrid> time_grids(const CoxData& data, const RiskSets& sets) {
  std::vector<TimeGrid> grids(sets.strata());
  for (std::size_t row = 0; row < data.rows(); ++row) {
    grids[data.strata ? data.strata->codes[row] : 0].time.push_back(data.outcome.stop[row]);
  }
  for (std::size_t s = 0; s < grids.size(); ++s) {
    std::vector<double>& time = grids[s].time;
    std::sort(time.begin(), time.end());
    time.erase(std::unique(time.begin(), time.end()), time.end());
    std::size_t next = sets.stratum_begin[s];
    for (const double t : time) {
      while (next < sets.stratum_begin[s + 1] && sets.time[next] <= t) {
        ++next;
      }
      grids[s].step.push_back(next == sets.stratum_begin[s] ? RiskSets::kNever : next - 1);
    }
  }
  return grids;
}

std::string level_of(const CoxData& data, std::size_t stratum) {
  return data.strata ? data.strata->levels[stratum] : std::string();
}

void check_fit(const CoxData& data, const CoxFit& fit) {
  if (fit.beta.size() != data.design.cols() || fit.summary.termination == CoxTermination::no_fit) {
    throw std::invalid_argument("Cox baseline: no fit to this data");
  }
}

/// The variance of the coefficients in scaled columns; a dropped column has none.
Eigen::MatrixXd scaled_variance(const CoxRows& rows, const CoxFit& fit) {
  Eigen::MatrixXd variance = rows.scale.asDiagonal() * fit.vcov * rows.scale.asDiagonal();
  for (Eigen::Index j = 0; j < variance.cols(); ++j) {
    if (fit.beta(j) == 0.0 && std::isnan(variance(j, j))) {
      variance.row(j).setZero();
      variance.col(j).setZero();
    }
  }
  return variance;
}

/// Fills one curve from the hazard's steps.
void fill_curve(const HazardSteps& steps,
                const TimeGrid& grid,
                const Eigen::VectorXd& x,
                double risk,
                const Eigen::MatrixXd& variance,
                double factor,
                CoxCurve& curve) {
  const Eigen::Index p = x.size();
  for (std::size_t k = 0; k < grid.time.size(); ++k) {
    const std::size_t step = grid.step[k];
    double survival = 1.0;
    double log_se = 0.0;
    if (step != RiskSets::kNever) {
      const Eigen::Map<const Eigen::VectorXd> mean(
          steps.mean_hazard.data() + step * static_cast<std::size_t>(p), p);
      const Eigen::VectorXd slope = x * steps.hazard[step] - mean;
      survival = std::exp(-risk * steps.hazard[step]);
      log_se = risk * std::sqrt(steps.hazard_variance[step] + slope.dot(variance * slope));
    }
    curve.survival.push_back(survival);
    curve.std_err.push_back(survival * log_se);
    const bool bounded = survival > 0.0 && !std::isnan(log_se);
    curve.lower.push_back(bounded ? survival * std::exp(-factor * log_se) : std::nan(""));
    curve.upper.push_back(bounded ? std::min(1.0, survival * std::exp(factor * log_se))
                                  : std::nan(""));
  }
}

}  // namespace

std::vector<BaselineHazard> cox_baseline(const CoxData& data, const CoxFit& fit) {
  check_fit(data, fit);
  const CoxRows rows = cox_rows(data);
  const HazardSteps steps = hazard_steps(rows, fit.beta.cwiseProduct(rows.scale), fit.ties);
  const double risk = std::exp(-rows.centre.dot(fit.beta) - rows.offset_centre - steps.risks.shift);
  std::vector<BaselineHazard> result;
  const std::vector<TimeGrid> grids = time_grids(data, rows.sets);
  for (std::size_t s = 0; s < grids.size(); ++s) {
    if (grids[s].time.empty()) {
      continue;
    }
    BaselineHazard baseline;
    baseline.stratum = level_of(data, s);
    baseline.time = grids[s].time;
    for (const std::size_t step : grids[s].step) {
      baseline.hazard.push_back(step == RiskSets::kNever ? 0.0 : risk * steps.hazard[step]);
    }
    result.push_back(std::move(baseline));
  }
  return result;
}

std::vector<CoxCurve> cox_curves(const CoxData& data,
                                 const CoxFit& fit,
                                 const Eigen::MatrixXd& design,
                                 const Eigen::VectorXd& offset) {
  check_fit(data, fit);
  if (design.cols() != data.design.cols() || fit.vcov.cols() != design.cols() ||
      (offset.size() != 0 && offset.size() != design.rows())) {
    throw std::invalid_argument("Cox curves: new rows do not fit the model");
  }
  const CoxRows rows = cox_rows(data);
  const Eigen::VectorXd beta = fit.beta.cwiseProduct(rows.scale);
  const HazardSteps steps = hazard_steps(rows, beta, fit.ties);
  const Eigen::MatrixXd variance = scaled_variance(rows, fit);
  const double factor = normal_factor(fit.level);
  std::vector<CoxCurve> curves;
  const std::vector<TimeGrid> grids = time_grids(data, rows.sets);
  for (std::size_t s = 0; s < grids.size(); ++s) {
    for (Eigen::Index row = 0; row < design.rows() && !grids[s].time.empty(); ++row) {
      const Eigen::VectorXd x =
          (design.row(row).transpose() - rows.centre).cwiseQuotient(rows.scale);
      const double shifted =
          (offset.size() == 0 ? 0.0 : offset(row)) - rows.offset_centre - steps.risks.shift;
      CoxCurve curve;
      curve.stratum = level_of(data, s);
      curve.row = static_cast<std::size_t>(row);
      curve.time = grids[s].time;
      fill_curve(steps, grids[s], x, std::exp(x.dot(beta) + shifted), variance, factor, curve);
      curves.push_back(std::move(curve));
    }
  }
  return curves;
}

}  // namespace tcert
