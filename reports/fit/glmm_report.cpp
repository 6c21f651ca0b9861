#include "reports/fit/glmm_report.hpp"

#include <string>

#include "reports/fit/coefficient_words.hpp"
#include "reports/fit/interval_columns.hpp"
#include "reports/fit/matrix_table.hpp"
#include "reports/fit/random_tables.hpp"

namespace tcert {
namespace {

std::optional<statistics::Interval> at(const std::vector<std::optional<statistics::Interval>>& list,
                                       std::size_t k) {
  return k < list.size() ? list[k] : std::nullopt;
}

std::string title_of(const statistics::GlmmFit& fit) {
  return fit.quadrature > 1 ? "Logistic mixed model: log odds of success, adaptive quadrature by " +
                                  std::to_string(fit.quadrature) + " points"
                            : "Logistic mixed model: log odds of success, Laplace";
}

/// A fixed effect, or a standard deviation or a correlation of random ones.
struct Parameter {
  std::optional<std::string> group;  ///< Of a random effect.
  std::string name;
  std::optional<double> value;
  std::optional<statistics::Interval> profile;
  const statistics::LogisticCoefficient* fixed = nullptr;
};

ColumnsOf<statistics::LogisticCoefficient> wald_columns() {
  using Fixed = statistics::LogisticCoefficient;
  return ColumnsOf<Fixed>()
      .number("std.error", "SE", &Fixed::standard_error)
      .number("statistic", "z", &Fixed::z)
      .p("p.value", "p", &Fixed::p_value)
      .ends({"conf.low", "Wald low"}, {"conf.high", "Wald high"}, &Fixed::interval);
}

ColumnsOf<Parameter> parameter_columns() {
  return ColumnsOf<Parameter>()
      .text("effect", "effect", [](auto& r) { return r.fixed != nullptr ? "fixed" : "ran_pars"; })
      .text("group", "group", &Parameter::group)
      .text("term", "term", &Parameter::name)
      .number("estimate", "estimate", &Parameter::value)
      .part(wald_columns(), &Parameter::fixed)
      .ends({"profile.low", "profile low"}, {"profile.high", "profile high"}, &Parameter::profile)
      .part(ratio_columns(odds_ratio_name(), "profile"),
            [](auto& r) {
              return r.fixed == nullptr ? std::nullopt
                                        : std::optional(LogRatio{
                                              r.value, r.fixed->interval, limits_of(r.profile)});
            })
      .text("kind", "", [](auto& r) {
        return r.fixed == nullptr ? "" : std::string(reason_without_estimate(r.fixed->kind));
      });
}

std::vector<Parameter> parameters_of(const statistics::GlmmFit& fit,
                                     const statistics::GlmmProfile& profile) {
  std::vector<Parameter> all;
  for (std::size_t k = 0; k < fit.coefficients.size(); ++k) {
    const statistics::LogisticCoefficient& one = fit.coefficients[k];
    const bool finite = one.kind == statistics::CoefficientKind::finite;
    all.push_back(
        {{}, one.column, one.estimate, finite ? at(profile.coefficients, k) : std::nullopt, &one});
  }
  for (std::size_t t = 0; t < fit.random.size(); ++t) {
    const statistics::GlmmRandomTerm& term = fit.random[t];
    const std::vector<RandomParameter> own = random_parameters(term);
    for (std::size_t a = 0; a < own.size(); ++a) {
      all.push_back({term.group,
                     own[a].name,
                     own[a].value,
                     a < term.columns.size() ? at(profile.sds, t) : std::nullopt});
    }
  }
  return all;
}

Table coefficient_table(const statistics::GlmmFit& fit, const statistics::GlmmProfile& profile) {
  Table table =
      parameter_columns().table("coefficients", title_of(fit), parameters_of(fit, profile));
  table.n = static_cast<std::int64_t>(fit.rows);
  return table;
}

std::optional<double> residual_df(const statistics::GlmmFit& fit) {
  return fit.log_likelihood
             ? std::optional(static_cast<double>(fit.rows) - static_cast<double>(fit.parameters))
             : std::nullopt;
}

Table summary_table(const statistics::GlmmFit& fit) {
  Record summary("summary", "Fit");
  summary.integer("nobs", "rows", fit.rows)
      .integer("nAGQ", "quadrature points", static_cast<std::size_t>(fit.quadrature))
      .number("logLik", "log-likelihood", fit.log_likelihood)
      .number("logLik_laplace", "log-likelihood by Laplace", fit.laplace_log_likelihood)
      .number("logLik_fixed", "without random effects", fit.fixed_log_likelihood)
      .number("AIC", "AIC", fit.aic)
      .number("BIC", "BIC", fit.bic)
      .integer("npar", "parameters", fit.parameters)
      .number("df.residual", "residual df", residual_df(fit));
  add_mixed_summary(fit, summary);
  summary.number("step_tolerance", "step tolerance [SE]", fit.options.step_tolerance);
  return std::move(summary).table();
}

}  // namespace

FitReport glmm_report(const statistics::GlmmFit& fit,
                      const statistics::GlmmProfile& profile,
                      const std::vector<statistics::DroppedTerm>& dropped) {
  FitReport report;
  report.model = "glmm";
  report.summary = summary_table(fit);
  report.tables = {coefficient_table(fit, profile), boundary_table(fit.random)};
  if (!dropped.empty()) {
    report.tables.push_back(drop_table(dropped, "-2 log-likelihood without"));
  }
  const std::vector<std::string> names = names_of(fit.coefficients);
  if (fit.covariance.rows() == static_cast<Eigen::Index>(names.size())) {
    report.details.push_back(
        matrix_table("vcov", "Covariance of the fixed effects", names, fit.covariance));
  }
  report.details.push_back(mode_table(fit.random));
  report.conditions = fit.conditions;
  return report;
}

}  // namespace tcert
