#include <statistics/cox/cox_baseline.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <statistics/basics/normal.hpp>
#include <statistics/cox/cox_hazard_steps.hpp>
#include <stdexcept>

namespace tcert::statistics {
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

/// Which events a row can meet in the limit of coefficients that run to infinity: only rows of the
/// largest risk in their direction are left at each event time, and a row's hazard depends on where
/// it stands beside them.
class Limit {
 public:
  Limit(const CoxRows& rows, const CoxFit& fit) {
    if (fit.recession.size() == 0) {
      return;
    }
    direction_ = fit.recession.cwiseProduct(rows.scale);
    const auto along = [&](std::size_t place) {
      return Eigen::Map<const Eigen::VectorXd>(rows.row(place), direction_.size()).dot(direction_);
    };
    double widest = 0.0;
    for (std::size_t place = 0; place < rows.rows(); ++place) {
      widest = std::max(widest, std::abs(along(place)));
    }
    tolerance_ = kSame * widest;
    for (std::size_t t = 0; t < rows.sets.times(); ++t) {
      top_.push_back(along(rows.sets.events_begin[t]));
      for (std::size_t place = rows.sets.events_begin[t]; place < rows.sets.begin[t + 1]; ++place) {
        top_.back() = std::max(top_.back(), along(place));
      }
    }
  }

  /// What the hazard of `x`, a scaled row, is multiplied by at event time `t`: 0, 1 or infinity.
  [[nodiscard]] double share(const Eigen::VectorXd& x, std::size_t t) const {
    if (top_.empty()) {
      return 1.0;
    }
    const double above = x.dot(direction_) - top_[t];
    return std::abs(above) <= tolerance_ ? 1.0
           : above < 0.0                 ? 0.0
                                         : std::numeric_limits<double>::infinity();
  }

 private:
  static constexpr double kSame = 1e-9;
  Eigen::VectorXd direction_;
  std::vector<double> top_;  ///< By event time.
  double tolerance_ = 0.0;
};

/// The cumulative hazard of one row, as the event times of a stratum pass.
struct RowHazard {
  double hazard = 0.0;
  double variance = 0.0;  ///< The part without that of the coefficients.
  Eigen::VectorXd mean;   ///< Integral of the risk sets' mean by the hazard.

  void pass(const HazardSteps& steps, const Limit& limit, const Eigen::VectorXd& x, std::size_t t) {
    const double share = limit.share(x, t);
    if (share == 0.0) {
      return;
    }
    hazard += share * steps.hazard[t];
    variance += share * steps.hazard_variance[t];
    mean +=
        share * Eigen::Map<const Eigen::VectorXd>(
                    steps.mean_hazard.data() + t * static_cast<std::size_t>(x.size()), x.size());
  }
};

/// Calls `visit(hazard)` at each time of the grid, for the row `x` of a stratum whose first event
/// time is `first`.
template <class Visit>
void follow(const HazardSteps& steps,
            const Limit& limit,
            const TimeGrid& grid,
            std::size_t first,
            const Eigen::VectorXd& x,
            const Visit& visit) {
  RowHazard row{0.0, 0.0, Eigen::VectorXd::Zero(x.size())};
  std::size_t next = first;
  for (const std::size_t step : grid.step) {
    for (; step != RiskSets::kNever && next <= step; ++next) {
      row.pass(steps, limit, x, next);
    }
    visit(row);
  }
}

/// Adds one time to a curve.
void add_point(const RowHazard& row,
               const Eigen::VectorXd& x,
               double risk,
               const Eigen::MatrixXd& variance,
               double factor,
               CoxCurve& curve) {
  const double survival = std::exp(-risk * row.hazard);
  const Eigen::VectorXd slope = x * row.hazard - row.mean;
  const double log_se =
      row.hazard == 0.0 ? 0.0 : risk * std::sqrt(row.variance + slope.dot(variance * slope));
  curve.survival.push_back(survival);
  curve.std_err.push_back(survival * log_se);
  const bool bounded = survival > 0.0 && !std::isnan(log_se);
  curve.lower.push_back(bounded ? survival * std::exp(-factor * log_se) : std::nan(""));
  curve.upper.push_back(bounded ? std::min(1.0, survival * std::exp(factor * log_se))
                                : std::nan(""));
}

}  // namespace

std::vector<BaselineHazard> cox_baseline(const CoxData& data,
                                         const CoxFit& fit,
                                         const Eigen::VectorXd& x,
                                         double offset) {
  check_fit(data, fit);
  if (x.size() != 0 && x.size() != data.design.cols()) {
    throw std::invalid_argument("Cox baseline: the row does not fit the model");
  }
  const CoxRows rows = cox_rows(data);
  const HazardSteps steps = hazard_increments(rows, fit.beta.cwiseProduct(rows.scale), fit.ties);
  const Limit limit(rows, fit);
  const Eigen::VectorXd centred =
      x.size() == 0 ? Eigen::VectorXd(-rows.centre) : Eigen::VectorXd(x - rows.centre);
  const Eigen::VectorXd scaled = centred.cwiseQuotient(rows.scale);
  const double risk =
      std::exp(centred.dot(fit.beta) + offset - rows.offset_centre - steps.risks.shift);
  std::vector<BaselineHazard> result;
  const std::vector<TimeGrid> grids = time_grids(data, rows.sets);
  for (std::size_t s = 0; s < grids.size(); ++s) {
    if (grids[s].time.empty()) {
      continue;
    }
    BaselineHazard baseline;
    baseline.stratum = level_of(data, s);
    baseline.time = grids[s].time;
    follow(steps, limit, grids[s], rows.sets.stratum_begin[s], scaled, [&](const RowHazard& row) {
      baseline.hazard.push_back(risk * row.hazard);
    });
    result.push_back(std::move(baseline));
  }
  return result;
}

std::vector<CoxCurve> cox_curves(const CoxData& data,
                                 const CoxFit& fit,
                                 const Eigen::MatrixXd& design,
                                 const Eigen::VectorXd& offset) {
  check_fit(data, fit);
  if (design.cols() != data.design.cols() || fit.limit_vcov.cols() != design.cols() ||
      (offset.size() != 0 && offset.size() != design.rows())) {
    throw std::invalid_argument("Cox curves: new rows do not fit the model");
  }
  const CoxRows rows = cox_rows(data);
  const Eigen::VectorXd beta = fit.beta.cwiseProduct(rows.scale);
  const HazardSteps steps = hazard_increments(rows, beta, fit.ties);
  const Limit limit(rows, fit);
  const Eigen::MatrixXd variance =
      rows.scale.asDiagonal() * fit.limit_vcov * rows.scale.asDiagonal();
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
      const double risk = std::exp(x.dot(beta) + shifted);
      follow(steps, limit, grids[s], rows.sets.stratum_begin[s], x, [&](const RowHazard& hazard) {
        add_point(hazard, x, risk, variance, factor, curve);
      });
      curves.push_back(std::move(curve));
    }
  }
  return curves;
}

}  // namespace tcert::statistics
