#include "reports/fit/logistic_report.hpp"

#include "reports/fit/cells.hpp"
#include "reports/fit/coefficient_words.hpp"
#include "reports/fit/interval_columns.hpp"

namespace tcert {
namespace {

bool is_robust(const statistics::LogisticFit& fit) {
  return fit.variance == statistics::CoefficientVariance::robust;
}

Table coefficient_table(const statistics::LogisticFit& fit,
                        const std::vector<statistics::ProfileLimits>& profiles) {
  Table table;
  table.name = "coefficients";
  table.title = "Logistic regression: log odds of success";
  table.n = static_cast<std::int64_t>(fit.rows);
  table.columns = {text_column("term", "term"),
                   number_column("estimate", "estimate"),
                   number_column("std.error", is_robust(fit) ? "robust SE" : "SE"),
                   number_column("statistic", "z"),
                   p_column(),
                   number_column("conf.low", "Wald low"),
                   number_column("conf.high", "Wald high")};
  std::vector<std::string> others;
  if (!is_robust(fit)) {
    append_columns(profile_columns(), table.columns);
    others = {"profile"};
  } else if (fit.clustered) {
    append_columns(t_columns(), table.columns);
    others = {"t"};
  }
  append_columns(ratio_columns(odds_ratio_name(), others), table.columns);
  table.columns.push_back(text_column("kind", ""));
  for (std::size_t k = 0; k < fit.coefficients.size(); ++k) {
    const statistics::LogisticCoefficient& one = fit.coefficients[k];
    const statistics::ProfileLimits profile =
        k < profiles.size() ? profiles[k] : statistics::ProfileLimits{};
    const statistics::ClusterT by_t = statistics::by_cluster_t(
        one.estimate, one.standard_error, one.z, fit.clusters, fit.options.level);
    std::vector<TableCell> cells{one.column,
                                 number_cell(one.estimate),
                                 number_cell(one.standard_error),
                                 number_cell(one.z),
                                 p_cell(one.p_value),
                                 low_cell(one.interval),
                                 high_cell(one.interval)};
    if (!is_robust(fit)) {
      append_profile(profile, cells);
    } else if (fit.clustered) {
      append_t(by_t, cells);
    }
    cells.push_back(ratio_cell(one.estimate));
    append_ratios(one.interval, cells);
    if (!is_robust(fit)) {
      cells.push_back(ratio_cell(profile.low));
      cells.push_back(ratio_cell(profile.high));
    } else if (fit.clustered) {
      append_ratios(by_t.interval, cells);
    }
    cells.emplace_back(std::string(reason_without_estimate(one.kind)));
    table.add_row(std::move(cells));
  }
  return table;
}

std::optional<double> df_null(const statistics::LogisticFit& fit) {
  const bool intercept =
      !fit.coefficients.empty() && fit.coefficients.front().column == "(Intercept)";
  return fit.rows == 0 ? std::nullopt
                       : std::optional(static_cast<double>(fit.rows) - (intercept ? 1.0 : 0.0));
}

}  // namespace

FitReport logistic_report(const statistics::LogisticFit& fit,
                          const std::vector<statistics::ProfileLimits>& profiles,
                          const std::vector<statistics::DroppedTerm>& dropped) {
  FitReport report;
  report.model = "glm";
  report.tables = {coefficient_table(fit, profiles)};
  if (is_robust(fit)) {
    std::vector<std::string>& notes = report.tables.front().footnotes;
    notes.emplace_back(
        "Robust variance: no profile intervals and no likelihood-ratio tests, which take the rows "
        "to be independent.");
    if (fit.clustered) {
      notes.push_back(t_footnote(fit.clusters));
    }
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
      .text("variance", "variance", is_robust(fit) ? "robust" : "model")
      .text("termination",
            "termination",
            statistics::has_error(fit.conditions) && !fit.log_likelihood && fit.iterations == 0
                ? "no fit"
                : std::string(statistics::to_string(fit.termination)))
      .integer("iterations", "iterations", static_cast<std::size_t>(fit.iterations))
      .number("gradient_norm", "gradient norm", fit.gradient_norm)
      .number("last_step", "last step [SE]", fit.last_step);
  report.summary = std::move(summary).table();
  std::vector<std::string> names;
  for (const statistics::LogisticCoefficient& one : fit.coefficients) {
    names.push_back(one.column);
  }
  if (fit.covariance.rows() == static_cast<Eigen::Index>(names.size())) {
    report.details.push_back(
        matrix_table("vcov", "Covariance of the coefficients", names, fit.covariance));
  }
  report.conditions = fit.conditions;
  point_to_t(report.conditions);
  return report;
}

}  // namespace tcert
