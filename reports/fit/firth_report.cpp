#include "reports/fit/firth_report.hpp"

#include "reports/fit/coefficient_words.hpp"
#include "reports/fit/interval_columns.hpp"
#include "reports/fit/matrix_table.hpp"

namespace tcert {
namespace {

Table coefficient_table(const statistics::FirthFit& fit) {
  using Row = statistics::FirthCoefficient;
  Table table =
      ColumnsOf<Row>()
          .text("term", "term", &Row::column)
          .number("estimate", "estimate", &Row::estimate)
          .number("std.error", "SE", &Row::standard_error)
          .number("statistic", "chi-squared", [](auto& one) { return statistic_of(one.test); })
          .p("p.value", "p", [](auto& one) { return p_of(one.test); })
          .ends({"conf.low", "Wald low"}, {"conf.high", "Wald high"}, &Row::interval)
          .part(profile_columns(), [](auto& one) { return std::optional(limits_of(one.profile)); })
          .part(ratio_columns(odds_ratio_name(), "profile"),
                [](auto& one) {
                  return std::optional(LogRatio{one.estimate, one.interval, limits_of(one.profile)});
                })
          .text(
              "kind", "", [](auto& one) { return std::string(reason_without_estimate(one.kind)); })
          .table("coefficients",
                 "Logistic regression with Firth's penalty: log odds of success",
                 fit.coefficients);
  table.n = static_cast<std::int64_t>(fit.rows);
  table.footnotes = {
      "chi-squared and p: penalised likelihood ratio, the coefficient at 0 under the penalty of "
      "the "
      "whole model; profile: its interval."};
  return table;
}

Table term_table(const statistics::FirthFit& fit) {
  using Term = statistics::FirthTerm;
  return ColumnsOf<Term>()
      .text("term", "term", &Term::term)
      .integer("df", "df", &Term::df)
      .number("statistic", "chi-squared", [](auto& one) { return statistic_of(one.test); })
      .p("p.value", "p", [](auto& one) { return p_of(one.test); })
      .table("drop1", "Penalised likelihood-ratio test of each term", fit.terms);
}

}  // namespace

FitReport firth_report(const statistics::FirthFit& fit) {
  FitReport report;
  report.model = "glm";
  report.tables = {coefficient_table(fit), term_table(fit)};
  Record summary("summary", "Fit");
  summary.integer("nobs", "rows", fit.rows)
      .number("logLik.penalised", "penalised log-likelihood", fit.penalised_log_likelihood)
      .number("logLik", "log-likelihood", fit.log_likelihood)
      .integer("df.residual", "residual df", fit.df_residual)
      .number("statistic", "chi-squared of all terms", statistic_of(fit.likelihood_ratio))
      .integer("df", "df", fit.likelihood_ratio ? fit.likelihood_ratio->df : 0)
      .p("p.value", "p", p_of(fit.likelihood_ratio))
      .text("penalty", "penalty", "Firth")
      .text("separation", "separation", std::string(statistics::to_string(fit.separation)))
      .text("termination", "termination", std::string(statistics::to_string(fit.termination)))
      .integer("iterations", "iterations", static_cast<std::size_t>(fit.iterations))
      .number("gradient_norm", "gradient norm", fit.gradient_norm)
      .number("last_step", "last step [SE]", fit.last_step);
  report.summary = std::move(summary).table();
  report.details.push_back(matrix_table(
      "vcov", "Covariance of the coefficients", names_of(fit.coefficients), fit.covariance));
  report.conditions = fit.conditions;
  return report;
}

}  // namespace tcert
