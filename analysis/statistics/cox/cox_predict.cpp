#include <statistics/cox/cox_predict.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <statistics/cox/cox_baseline.hpp>
#include <stdexcept>
#include <table/not_a_number.hpp>

namespace tcert::statistics {
namespace {

/// Cumulative at `time`.
double hazard_at(const BaselineHazard& baseline, double time) {
  const auto next = std::upper_bound(baseline.time.begin(), baseline.time.end(), time);
  return next == baseline.time.begin()
             ? 0.0
             : baseline.hazard[static_cast<std::size_t>(next - baseline.time.begin()) - 1];
}

/// 1 - S; 0 before the first event, also of a row whose hazard ratio is infinite.
double risk_of(double hazard, double predictor) {
  return hazard == 0.0 ? 0.0 : -std::expm1(-hazard * std::exp(predictor));
}

}  // namespace

Eigen::MatrixXd cox_risks(const CoxData& data,
                          const CoxFit& fit,
                          const CoxData& others,
                          std::span<const double> times) {
  if (others.design.cols() != data.design.cols() ||
      data.strata.has_value() != others.strata.has_value()) {
    throw std::invalid_argument("Cox risks: new rows do not fit the model");
  }
  // Beside a reference row among the rows of the fit: beside x = 0 the hazard may underflow. Rows
  // that stand elsewhere in the direction in which a coefficient runs to infinity meet other
  // events, and have a reference of their own.
  struct Reference {
    Eigen::VectorXd x;
    std::vector<BaselineHazard> baselines;
  };
  const double offset = data.offset ? data.offset->mean() : 0.0;
  std::map<double, Reference> references;
  Eigen::MatrixXd risks(others.design.rows(), static_cast<Eigen::Index>(times.size()));
  for (Eigen::Index row = 0; row < risks.rows(); ++row) {
    const std::string stratum =
        others.strata ? others.strata->levels[others.strata->codes[static_cast<std::size_t>(row)]]
                      : "";
    const Eigen::VectorXd x = others.design.row(row).transpose();
    const bool runs = fit.recession.size() > 0;
    Reference& reference = references[runs ? x.dot(fit.recession) : 0.0];
    if (reference.x.size() != x.size() || reference.baselines.empty()) {
      reference.x = runs ? x : Eigen::VectorXd(data.design.colwise().mean().transpose());
      reference.baselines = cox_baseline(data, fit, reference.x, offset);
    }
    const std::vector<BaselineHazard>& baselines = reference.baselines;
    const double predictor =
        (x - reference.x).dot(fit.beta) + (others.offset ? (*others.offset)[row] - offset : 0.0);
    const auto baseline =
        std::find_if(baselines.begin(), baselines.end(), [&](const BaselineHazard& one) {
          return one.stratum == stratum;
        });
    for (Eigen::Index t = 0; t < risks.cols(); ++t) {
      risks(row, t) =
          baseline == baselines.end()
              ? table::kNaN
              : risk_of(hazard_at(*baseline, times[static_cast<std::size_t>(t)]), predictor);
    }
  }
  return risks;
}

}  // namespace tcert::statistics
