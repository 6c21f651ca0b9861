#include <statistics/cox/cox_predict.hpp>

#include <algorithm>
#include <cmath>
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

}  // namespace

Eigen::MatrixXd cox_risks(const CoxData& data,
                          const CoxFit& fit,
                          const CoxData& others,
                          std::span<const double> times) {
  if (others.design.cols() != data.design.cols() ||
      data.strata.has_value() != others.strata.has_value()) {
    throw std::invalid_argument("Cox risks: new rows do not fit the model");
  }
  const std::vector<BaselineHazard> baselines = cox_baseline(data, fit);
  Eigen::VectorXd predictor = others.design * fit.beta;
  if (others.offset) {
    predictor += *others.offset;
  }
  Eigen::MatrixXd risks(others.design.rows(), static_cast<Eigen::Index>(times.size()));
  for (Eigen::Index row = 0; row < risks.rows(); ++row) {
    const std::string stratum =
        others.strata ? others.strata->levels[others.strata->codes[static_cast<std::size_t>(row)]]
                      : "";
    const auto baseline =
        std::find_if(baselines.begin(), baselines.end(), [&](const BaselineHazard& one) {
          return one.stratum == stratum;
        });
    for (Eigen::Index t = 0; t < risks.cols(); ++t) {
      risks(row, t) = baseline == baselines.end()
                          ? table::kNaN
                          : -std::expm1(-hazard_at(*baseline, times[static_cast<std::size_t>(t)]) *
                                        std::exp(predictor(row)));
    }
  }
  return risks;
}

}  // namespace tcert::statistics
