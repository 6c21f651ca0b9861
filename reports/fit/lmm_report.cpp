#include "reports/fit/lmm_report.hpp"

#include <string>

#include "reports/fit/coefficient_words.hpp"
#include "reports/fit/matrix_table.hpp"
#include "reports/fit/random_tables.hpp"

namespace tcert {
namespace {

/// A fixed effect, or a standard deviation or a correlation of random ones.
struct LmmParameter {
  std::optional<std::string> group;
  std::string name;
  std::optional<double> value;
  const statistics::LmmCoefficient* fixed = nullptr;
};

ColumnsOf<LmmParameter> lmm_columns(const std::optional<RatioName>& ratio) {
  using Fixed = statistics::LmmCoefficient;
  const auto by_t = ColumnsOf<Fixed>()
                        .number("std.error", "SE", &Fixed::standard_error)
                        .number("df", "df", &Fixed::df)
                        .number("statistic", "t", &Fixed::t)
                        .p("p.value", "p", &Fixed::p_value)
                        .ends({"conf.low", "low"}, {"conf.high", "high"}, &Fixed::interval);
  ColumnsOf<LmmParameter> columns;
  columns
      .text("effect", "effect", [](auto& r) { return r.fixed != nullptr ? "fixed" : "ran_pars"; })
      .text("group", "group", &LmmParameter::group)
      .text("term", "term", &LmmParameter::name)
      .number("estimate", "estimate", &LmmParameter::value)
      .part(by_t, &LmmParameter::fixed);
  if (ratio) {
    columns.part(ratio_columns(*ratio, ""), [](auto& r) {
      return r.fixed == nullptr ? std::nullopt
                                : std::optional(LogRatio{r.value, r.fixed->interval, {}});
    });
  }
  return columns.text("kind", "", [](auto& r) {
    return r.fixed == nullptr ? "" : std::string(reason_without_estimate(r.fixed->kind));
  });
}

std::vector<LmmParameter> lmm_parameters(const statistics::LmmFit& fit) {
  std::vector<LmmParameter> all;
  for (const statistics::LmmCoefficient& one : fit.coefficients) {
    all.push_back({{}, one.column, one.estimate, &one});
  }
  for (const statistics::GlmmRandomTerm& term : fit.random) {
    for (const RandomParameter& one : random_parameters(term)) {
      all.push_back({term.group, one.name, one.value});
    }
  }
  if (fit.log_likelihood) {
    all.push_back({"Residual", "sd__Observation", fit.residual_sd});
  }
  return all;
}

Table lmm_summary(const statistics::LmmFit& fit) {
  const bool restricted = fit.options.restricted;
  Record summary("summary", "Fit");
  summary.integer("nobs", "rows", fit.rows)
      .text("method", "method", restricted ? "REML" : "ML")
      .number(
          "logLik", restricted ? "restricted log-likelihood" : "log-likelihood", fit.log_likelihood)
      .number("AIC", "AIC", fit.aic)
      .number("BIC", "BIC", fit.bic)
      .integer("npar", "parameters", fit.parameters)
      .number("sigma",
              "residual SD",
              fit.log_likelihood ? std::optional(fit.residual_sd) : std::nullopt);
  add_mixed_summary(fit, summary);
  return std::move(summary).table();
}

}  // namespace

std::optional<RatioName> ratio_of_response(const statistics::Formula& formula) {
  const bool is_log = formula.response.is_call("log") && formula.response.arguments.size() == 1;
  return is_log ? std::optional(RatioName{"ratio", "ratio", "ratio"}) : std::nullopt;
}

FitReport lmm_report(const statistics::LmmFit& fit,
                     const std::string& response,
                     const std::optional<RatioName>& ratio) {
  FitReport report;
  report.model = "lmm";
  report.summary = lmm_summary(fit);
  report.tables = {lmm_columns(ratio).table(
                       "coefficients", "Linear mixed model of " + response, lmm_parameters(fit)),
                   boundary_table(fit.random)};
  Table& main = report.tables.front();
  main.n = static_cast<std::int64_t>(fit.rows);
  main.footnotes.emplace_back(
      "t with Satterthwaite's degrees of freedom. R2 (Nakagawa): marginal of the fixed effects "
      "alone, conditional with the random ones.");
  const std::vector<std::string> names = names_of(fit.coefficients);
  report.details = {matrix_table("vcov", "Covariance of the fixed effects", names, fit.covariance),
                    mode_table(fit.random)};
  report.conditions = fit.conditions;
  return report;
}

}  // namespace tcert
