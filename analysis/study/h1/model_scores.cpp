#include "analysis/study/h1/model_scores.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <statistics/basics/standard_deviation.hpp>
#include <statistics/concordance/concordance_replicates.hpp>
#include <statistics/roc/auc_statistic.hpp>
#include <table/not_a_number.hpp>

namespace tcert::study {
namespace {

/// Centred and scaled: a fit is the same, but better conditioned. A constant column is 0.
Eigen::VectorXd standardised(const std::vector<double>& values) {
  const Eigen::Map<const Eigen::VectorXd> x(values.data(),
                                            static_cast<Eigen::Index>(values.size()));
  const double sd = statistics::standard_deviation(values);
  return sd > 0.0 ? Eigen::VectorXd((x.array() - x.mean()) / sd) : Eigen::VectorXd::Zero(x.size());
}

/// Indices of the rows, each as often as it was drawn.
std::vector<std::size_t> drawn_rows(std::span<const std::uint32_t> multiplicity) {
  std::vector<std::size_t> rows;
  rows.reserve(multiplicity.size());
  for (std::size_t row = 0; row < multiplicity.size(); ++row) {
    rows.insert(rows.end(), multiplicity[row], row);
  }
  return rows;
}

statistics::CoxFit light_fit(const statistics::CoxData& data) {
  statistics::CoxOptions options;
  options.inference = false;
  return statistics::fit_cox(data, options);
}

bool usable(const statistics::CoxFit& fit) {
  return fit.summary.termination == statistics::CoxTermination::converged;
}

/// False if these rows do not tell the last column from a constant or from those before it: its
/// 0 is then no estimate.
bool last_is_estimated(const statistics::CoxFit& fit) {
  return !fit.estimated.empty() && fit.estimated.back();
}

std::vector<std::uint32_t> as_multiplicity(std::span<const std::uint8_t> train) {
  return {train.begin(), train.end()};
}

}  // namespace

H1Model::H1Model(const H1Data& data, const std::vector<std::size_t>& columns) : data_(data) {
  const auto rows = static_cast<Eigen::Index>(data.rows());
  logistic_.design = Eigen::MatrixXd::Ones(rows, static_cast<Eigen::Index>(columns.size()) + 1);
  logistic_.columns = {"(Intercept)"};
  logistic_.term_of = {0};
  logistic_.own_units = {{}};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    logistic_.design.col(static_cast<Eigen::Index>(k) + 1) =
        standardised(data.predictors[columns[k]]);
    logistic_.columns.push_back(data.names[columns[k]]);
    logistic_.terms.push_back(data.names[columns[k]]);
    logistic_.term_of.push_back(k + 1);
    logistic_.own_units.emplace_back(data.predictors[columns[k]]);
  }
  logistic_.response = "success";
  logistic_.successes.resize(rows);
  for (Eigen::Index row = 0; row < rows; ++row) {
    logistic_.successes[row] = data.success[static_cast<std::size_t>(row)];
  }
  refit_ = std::make_unique<statistics::LogisticRefit>(logistic_);
  if (data.censored) {
    cox_.outcome = *data.censored;
    cox_.design = logistic_.design.rightCols(static_cast<Eigen::Index>(columns.size()));
    cox_.columns = logistic_.terms;
    cox_.terms = logistic_.terms;
    cox_.term_of.resize(columns.size());
    std::iota(cox_.term_of.begin(), cox_.term_of.end(), std::size_t{0});
  }
}

double H1Model::auc(std::span<const std::uint32_t> multiplicity) const {
  const statistics::LogisticReplicate fit = refit_->fit(multiplicity);
  if (!fit.coefficients) {
    return table::kNaN;
  }
  const Eigen::VectorXd predictor = refit_->linear_predictor(*fit.coefficients);
  const statistics::Score score{{predictor.data(), static_cast<std::size_t>(predictor.size())}};
  double value = table::kNaN;
  statistics::auc_statistic({&score, 1}, data_.success).make_kernel()(multiplicity, {&value, 1});
  return value;
}

double H1Model::c(std::span<const std::uint32_t> multiplicity) const {
  const statistics::CoxFit fit = light_fit(statistics::on_rows(cox_, drawn_rows(multiplicity)));
  if (!usable(fit)) {
    return table::kNaN;
  }
  const Eigen::VectorXd risk = cox_.design * fit.beta;
  const statistics::Predictor predictor{"",
                                        {risk.data(), static_cast<std::size_t>(risk.size())},
                                        statistics::LargerMeans::shorter_time};
  statistics::ConcordanceReplicates::Scratch scratch;
  return statistics::ConcordanceReplicates(cox_.outcome, predictor).c(multiplicity, scratch);
}

double H1Model::added_logistic_coefficient(std::span<const std::uint32_t> multiplicity) const {
  const statistics::LogisticReplicate fit = refit_->fit(multiplicity);
  return fit.coefficients ? refit_->column_coefficients(*fit.coefficients)(Eigen::last)
                          : table::kNaN;
}

double H1Model::added_cox_coefficient(std::span<const std::uint32_t> multiplicity) const {
  const statistics::CoxFit fit = light_fit(statistics::on_rows(cox_, drawn_rows(multiplicity)));
  return usable(fit) && last_is_estimated(fit) ? fit.beta(Eigen::last) : table::kNaN;
}

std::optional<std::vector<double>> H1Model::logistic_scores(
    std::span<const std::uint8_t> train) const {
  const statistics::LogisticReplicate fit = refit_->fit(as_multiplicity(train));
  if (!fit.coefficients) {
    return std::nullopt;
  }
  const Eigen::VectorXd scores = refit_->linear_predictor(*fit.coefficients);
  return std::vector<double>(scores.data(), scores.data() + scores.size());
}

std::optional<std::vector<double>> H1Model::cox_scores(std::span<const std::uint8_t> train) const {
  const statistics::CoxFit fit = light_fit(statistics::on_rows(cox_, drawn_rows(as_multiplicity(train))));
  if (!usable(fit)) {
    return std::nullopt;
  }
  const Eigen::VectorXd scores = cox_.design * fit.beta;
  return std::vector<double>(scores.data(), scores.data() + scores.size());
}

H1Models h1_models(const H1Data& data) {
  H1Models all;
  if (data.predictors.size() < 2 || data.rows() < 2) {
    return all;
  }
  std::vector<std::size_t> rivals(data.predictors.size() - 1);
  std::iota(rivals.begin(), rivals.end(), std::size_t{1});
  all.models.emplace_back(data, rivals);
  rivals.push_back(0);
  all.models.emplace_back(data, rivals);
  return all;
}

}  // namespace tcert::study
