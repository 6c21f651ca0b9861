#include "reports/fit/logistic_report.hpp"

#include "reports/fit/cells.hpp"
#include "reports/fit/coefficient_words.hpp"

namespace tcert {
namespace {

Table coefficient_table(const LogisticFit& fit,
                        const std::vector<std::optional<Interval>>& profiles) {
  Table table;
  table.name = "coefficients";
  table.title = "Logistic regression: log odds of success";
  table.n = static_cast<std::int64_t>(fit.rows);
  table.columns = {text_column("term", "term"),
                   number_column("estimate", "estimate"),
                   number_column("std.error", "SE"),
                   number_column("statistic", "z"),
                   p_column(),
                   number_column("conf.low", "Wald low"),
                   number_column("conf.high", "Wald high")};
  const bool robust = fit.variance == CoefficientVariance::robust;
  if (robust) {
    table.columns[2].heading = "robust SE";
  } else {
    table.columns.push_back(number_column("profile.low", "profile low"));
    table.columns.push_back(number_column("profile.high", "profile high"));
  }
  table.columns.push_back(number_column("odds.ratio", "odds ratio"));
  table.columns.push_back(text_column("kind", ""));
  for (std::size_t k = 0; k < fit.coefficients.size(); ++k) {
    const LogisticCoefficient& one = fit.coefficients[k];
    const std::optional<Interval> profile = k < profiles.size() ? profiles[k] : std::nullopt;
    std::vector<TableCell> cells{one.column,
                                 number_cell(one.estimate),
                                 number_cell(one.standard_error),
                                 number_cell(one.z),
                                 p_cell(one.p_value),
                                 low_cell(one.interval),
                                 high_cell(one.interval)};
    if (!robust) {
      cells.push_back(low_cell(profile));
      cells.push_back(high_cell(profile));
    }
    cells.push_back(number_cell(odds(one.estimate)));
    cells.emplace_back(std::string(reason_without_estimate(one.kind)));
    table.add_row(std::move(cells));
  }
  return table;
}

std::optional<double> df_null(const LogisticFit& fit) {
  const bool intercept =
      !fit.coefficients.empty() && fit.coefficients.front().column == "(Intercept)";
  return fit.rows == 0 ? std::nullopt
                       : std::optional(static_cast<double>(fit.rows) - (intercept ? 1.0 : 0.0));
}

}  // namespace

FitReport logistic_report(const LogisticFit& fit,
                          const std::vector<std::optional<Interval>>& profiles,
                          const std::vector<DroppedTerm>& dropped) {
  FitReport report;
  report.model = "glm";
  report.tables = {coefficient_table(fit, profiles)};
  if (fit.variance == CoefficientVariance::robust) {
    report.tables.front().footnotes.push_back(
        "Robust variance: no profile intervals and no likelihood-ratio tests, which take the rows "
        "to be independent.");
  } else {
    report.tables.push_back(drop_table(dropped, "deviance without"));
  }
  Record summary("summary", "Fit");
  summary.integer("nobs", "rows", fit.rows)
      .integer("clusters", "clusters", fit.clusters)
      .number("logLik", "log-likelihood", fit.log_likelihood)
      .number("deviance", "deviance", fit.deviance)
      .integer("df.residual", "residual df", fit.df_residual)
      .number("null.deviance", "null deviance", fit.null_deviance)
      .number("df.null", "null df", df_null(fit))
      .number("AIC", "AIC", fit.aic)
      .number("BIC", "BIC", fit.bic)
      .text(
          "variance", "variance", fit.variance == CoefficientVariance::robust ? "robust" : "model")
      .text("termination",
            "termination",
            has_error(fit.conditions) && !fit.log_likelihood && fit.iterations == 0
                ? "no fit"
                : std::string(to_string(fit.termination)))
      .integer("iterations", "iterations", static_cast<std::size_t>(fit.iterations))
      .number("gradient_norm", "gradient norm", fit.gradient_norm)
      .number("last_step", "last step [SE]", fit.last_step);
  report.summary = std::move(summary).table();
  std::vector<std::string> names;
  for (const LogisticCoefficient& one : fit.coefficients) {
    names.push_back(one.column);
  }
  if (fit.covariance.rows() == static_cast<Eigen::Index>(names.size())) {
    report.details.push_back(
        matrix_table("vcov", "Covariance of the coefficients", names, fit.covariance));
  }
  report.conditions = fit.conditions;
  return report;
}

}  // namespace tcert
