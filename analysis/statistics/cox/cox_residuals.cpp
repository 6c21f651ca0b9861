#include <statistics/cox/cox_residuals.hpp>

#include <cmath>
#include <statistics/cox/cox_hazard_steps.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

/// sign(m) sqrt(-2 (m + event log(event - m))).
double deviance_residual(double martingale, bool event) {
  const double gain = event ? martingale + std::log(1.0 - martingale) : martingale;
  return std::copysign(std::sqrt(std::max(0.0, -2.0 * gain)), martingale);
}

void fill_martingale(const CoxData& data,
                     const CoxRows& rows,
                     const HazardSteps& steps,
                     CoxResiduals& residuals) {
  const auto n = static_cast<Eigen::Index>(data.rows());
  // A row that is at risk at no event time has nothing to explain.
  residuals.martingale = Eigen::VectorXd::Zero(n);
  for (std::size_t place = 0; place < rows.rows(); ++place) {
    const std::uint32_t row = rows.sets.order[place];
    residuals.martingale(row) = static_cast<double>(data.outcome.event[row]) -
                                steps.risks.score[place] * hazard_of_row(rows, steps, place);
  }
  residuals.deviance.resize(n);
  for (Eigen::Index row = 0; row < n; ++row) {
    residuals.deviance(row) = deviance_residual(
        residuals.martingale(row), data.outcome.event[static_cast<std::size_t>(row)] != 0);
  }
}

void fill_score(const CoxData& data,
                const CoxRows& rows,
                const HazardSteps& steps,
                CoxResiduals& residuals) {
  const auto n = static_cast<Eigen::Index>(data.rows());
  const auto p = static_cast<Eigen::Index>(rows.columns);
  residuals.score = Eigen::MatrixXd::Zero(n, p);
  for_each_score_residual(rows, steps, [&](std::size_t place, const double* residual) {
    residuals.score.row(rows.sets.order[place]) =
        Eigen::Map<const Eigen::VectorXd>(residual, p).cwiseProduct(rows.scale);
  });
}

void fill_schoenfeld(const CoxRows& rows, const HazardSteps& steps, CoxResiduals& residuals) {
  const auto p = static_cast<Eigen::Index>(rows.columns);
  for (std::size_t t = 0; t < rows.sets.times(); ++t) {
    for (std::size_t place = rows.sets.events_begin[t]; place < rows.sets.begin[t + 1]; ++place) {
      residuals.event_rows.push_back(rows.sets.order[place]);
    }
  }
  residuals.schoenfeld.resize(static_cast<Eigen::Index>(residuals.event_rows.size()), p);
  Eigen::Index event = 0;
  for (std::size_t t = 0; t < rows.sets.times(); ++t) {
    const Eigen::Map<const Eigen::VectorXd> mean(steps.mean.data() + t * rows.columns, p);
    for (std::size_t place = rows.sets.events_begin[t]; place < rows.sets.begin[t + 1]; ++place) {
      const Eigen::Map<const Eigen::VectorXd> x(rows.row(place), p);
      residuals.schoenfeld.row(event++) = (x - mean).cwiseProduct(rows.scale);
    }
  }
}

/// The columns with a coefficient.
std::vector<Eigen::Index> known_columns(const CoxFit& fit) {
  std::vector<Eigen::Index> known;
  for (Eigen::Index j = 0; j < fit.model_vcov.cols(); ++j) {
    if (!std::isnan(fit.model_vcov(j, j))) {
      known.push_back(j);
    }
  }
  return known;
}

void scale_residuals(const CoxData& data, const CoxFit& fit, CoxResiduals& residuals) {
  const std::vector<Eigen::Index> known = known_columns(fit);
  // From the scores of all columns, since one that is NA may still share information with others.
  const Eigen::MatrixXd variance = fit.limit_model_vcov(Eigen::all, known);
  const Eigen::VectorXd se = fit.model_vcov(known, known).diagonal().cwiseSqrt();
  const Eigen::Index p = residuals.score.cols();
  const double missing = std::nan("");

  Eigen::MatrixXd change = residuals.score * variance;
  if (data.weights) {
    change = data.weights->asDiagonal() * change;
  }
  residuals.dfbeta = Eigen::MatrixXd::Constant(change.rows(), p, missing);
  residuals.dfbetas = residuals.dfbeta;
  residuals.dfbeta(Eigen::all, known) = change;
  residuals.dfbetas(Eigen::all, known) = change * se.cwiseInverse().asDiagonal();

  const Eigen::VectorXd beta = fit.beta(known);
  const auto events = static_cast<double>(fit.events);
  Eigen::MatrixXd scaled = residuals.schoenfeld * variance * events;
  scaled.rowwise() += beta.transpose();
  residuals.scaled_schoenfeld = Eigen::MatrixXd::Constant(scaled.rows(), p, missing);
  residuals.scaled_schoenfeld(Eigen::all, known) = scaled;
}

}  // namespace

CoxResiduals cox_residuals(const CoxData& data, const CoxFit& fit) {
  if (fit.limit_model_vcov.cols() != data.design.cols() || fit.beta.size() != data.design.cols() ||
      fit.summary.termination == CoxTermination::no_fit) {
    throw std::invalid_argument("Cox residuals: the fit has no variance");
  }
  const CoxRows rows = cox_rows(data);
  const HazardSteps steps = hazard_steps(rows, fit.beta.cwiseProduct(rows.scale), fit.ties);
  CoxResiduals residuals;
  fill_martingale(data, rows, steps, residuals);
  if (fit.ties != Ties::exact) {
    fill_score(data, rows, steps, residuals);
    fill_schoenfeld(rows, steps, residuals);
    scale_residuals(data, fit, residuals);
  }
  return residuals;
}

}  // namespace tcert::statistics
