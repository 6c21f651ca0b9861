#include "reports/fit/logistic_report.hpp"

#include "reports/fit/coefficient_words.hpp"
#include "reports/fit/interval_columns.hpp"
#include "reports/fit/matrix_table.hpp"

namespace tcert {
namespace {

bool is_robust(const statistics::LogisticFit& fit) {
  return fit.variance == statistics::CoefficientVariance::robust;
}

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): it has no default constructor.
struct LogisticRow : RowOf<statistics::LogisticCoefficient> {
  statistics::ProfileLimits profile;
  statistics::ClusterT by_t;
};

Table coefficient_table(const statistics::LogisticFit& fit,
                        const std::vector<statistics::ProfileLimits>& profiles,
                        const statistics::ClusterInferences& inferences) {
  using Logistic = statistics::LogisticCoefficient;
  ColumnsOf<LogisticRow> columns;
  columns.text("term", "term", &Logistic::column)
      .number("estimate", "estimate", &Logistic::estimate)
      .number("std.error", is_robust(fit) ? "robust SE" : "SE", &Logistic::standard_error)
      .number("statistic", "z", &Logistic::z)
      .p("p.value", "p", &Logistic::p_value)
      .ends({"conf.low", "Wald low"}, {"conf.high", "Wald high"}, &Logistic::interval);
  std::string other;
  if (!is_robust(fit)) {
    columns.part(profile_columns(), [](auto& r) { return &r.profile; });
    other = "profile";
  } else if (fit.clustered) {
    columns.part(inference_columns(), [](auto& r) { return &r.by_t; });
    other = "t";
  }
  columns
      .part(ratio_columns(odds_ratio_name(), other),
            [robust = is_robust(fit)](auto& r) {
              return std::optional(LogRatio{
                  r.of.estimate, r.of.interval, robust ? limits_of(r.by_t.interval) : r.profile});
            })
      .text("kind", "", [](auto& r) { return std::string(reason_without_estimate(r.of.kind)); });
  Table table = columns.table("coefficients", "Logistic regression: log odds of success");
  table.n = static_cast<std::int64_t>(fit.rows);
  for (std::size_t k = 0; k < fit.coefficients.size(); ++k) {
    const Logistic& one = fit.coefficients[k];
    table.add_row(
        columns.row({{one},
                     k < profiles.size() ? profiles[k] : statistics::ProfileLimits{},
                     k < inferences.of.size() ? inferences.of[k] : statistics::ClusterT{}}));
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
                          const std::vector<statistics::DroppedTerm>& dropped,
                          const statistics::ClusterInferences& inferences) {
  FitReport report;
  report.model = "glm";
  report.tables = {coefficient_table(fit, profiles, inferences)};
  if (is_robust(fit)) {
    std::vector<std::string>& notes = report.tables.front().footnotes;
    notes.emplace_back(
        "Robust variance: no profile intervals and no likelihood-ratio tests, which take the rows "
        "to be independent.");
    if (fit.clustered) {
      notes.push_back(t_footnote(fit.clusters, inferences.by));
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
  const std::vector<std::string> names = names_of(fit.coefficients);
  if (fit.covariance.rows() == static_cast<Eigen::Index>(names.size())) {
    report.details.push_back(
        matrix_table("vcov", "Covariance of the coefficients", names, fit.covariance));
  }
  report.conditions = fit.conditions;
  point_to_t(report.conditions);
  return report;
}

}  // namespace tcert
