#include "reports/fit/firth_report.hpp"

#include <cmath>

#include "reports/fit/cells.hpp"
#include "reports/fit/coefficient_words.hpp"
#include "reports/fit/interval_columns.hpp"
#include "reports/fit/logistic_report.hpp"

namespace tcert {
namespace {

std::optional<double> statistic(const std::optional<statistics::ChiSquareTest>& test) {
  return test ? std::optional(test->statistic) : std::nullopt;
}

std::optional<double> p_value(const std::optional<statistics::ChiSquareTest>& test) {
  return test ? std::optional(test->p_value) : std::nullopt;
}

Table coefficient_table(const statistics::FirthFit& fit) {
  Table table;
  table.name = "coefficients";
  table.title = "Logistic regression with Firth's penalty: log odds of success";
  table.n = static_cast<std::int64_t>(fit.rows);
  table.columns = {text_column("term", "term"),
                   number_column("estimate", "estimate"),
                   number_column("std.error", "SE"),
                   number_column("statistic", "chi-squared"),
                   p_column(),
                   number_column("conf.low", "Wald low"),
                   number_column("conf.high", "Wald high")};
  append_columns(profile_columns(), table.columns);
  append_columns(ratio_columns(odds_ratio_name(), {"profile"}), table.columns);
  table.columns.push_back(text_column("kind", ""));
  for (const statistics::FirthCoefficient& one : fit.coefficients) {
    std::vector<TableCell> cells{one.column,
                                 number_cell(one.estimate),
                                 number_cell(one.standard_error),
                                 number_cell(statistic(one.test)),
                                 p_cell(p_value(one.test)),
                                 low_cell(one.wald),
                                 high_cell(one.wald)};
    append_profile(limits_of(one.profile), cells);
    cells.push_back(ratio_cell(one.estimate));
    append_ratios(one.wald, cells);
    append_ratios(one.profile, cells);
    cells.emplace_back(std::string(reason_without_estimate(one.kind)));
    table.add_row(std::move(cells));
  }
  table.footnotes = {
      "chi-squared and p: penalised likelihood ratio, the coefficient at 0 under the penalty of "
      "the "
      "whole model; profile: its interval."};
  return table;
}

Table term_table(const statistics::FirthFit& fit) {
  Table table;
  table.name = "drop1";
  table.title = "Penalised likelihood-ratio test of each term";
  table.columns = {text_column("term", "term"),
                   integer_column("df", "df"),
                   number_column("statistic", "chi-squared"),
                   p_column()};
  for (const statistics::FirthTerm& one : fit.terms) {
    table.add_row({one.term,
                   integer_cell(one.df),
                   number_cell(statistic(one.test)),
                   p_cell(p_value(one.test))});
  }
  return table;
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
      .number("statistic", "chi-squared of all terms", statistic(fit.likelihood_ratio))
      .integer("df", "df", fit.likelihood_ratio ? fit.likelihood_ratio->df : 0)
      .p("p.value", "p", p_value(fit.likelihood_ratio))
      .text("penalty", "penalty", "Firth")
      .text("separation", "separation", std::string(statistics::to_string(fit.separation)))
      .text("termination", "termination", std::string(statistics::to_string(fit.termination)))
      .integer("iterations", "iterations", static_cast<std::size_t>(fit.iterations))
      .number("gradient_norm", "gradient norm", fit.gradient_norm)
      .number("last_step", "last step [SE]", fit.last_step);
  report.summary = std::move(summary).table();
  std::vector<std::string> names;
  for (const statistics::FirthCoefficient& one : fit.coefficients) {
    names.push_back(one.column);
  }
  report.details.push_back(
      matrix_table("vcov", "Covariance of the coefficients", names, fit.covariance));
  report.conditions = fit.conditions;
  return report;
}

}  // namespace tcert
