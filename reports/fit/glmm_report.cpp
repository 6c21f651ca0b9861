#include "reports/fit/glmm_report.hpp"

#include <string>

#include "reports/fit/cells.hpp"
#include "reports/fit/coefficient_words.hpp"
#include "reports/fit/interval_columns.hpp"

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

void add_fixed_rows(const statistics::GlmmFit& fit,
                    const statistics::GlmmProfile& profile,
                    Table& table) {
  for (std::size_t k = 0; k < fit.coefficients.size(); ++k) {
    const statistics::LogisticCoefficient& one = fit.coefficients[k];
    const std::optional<statistics::Interval> by_profile =
        one.kind == statistics::CoefficientKind::finite ? at(profile.coefficients, k)
                                                        : std::nullopt;
    std::vector<TableCell> cells{std::string("fixed"),
                                 TableCell{},
                                 one.column,
                                 number_cell(one.estimate),
                                 number_cell(one.standard_error),
                                 number_cell(one.z),
                                 p_cell(one.p_value),
                                 low_cell(one.interval),
                                 high_cell(one.interval),
                                 low_cell(by_profile),
                                 high_cell(by_profile),
                                 ratio_cell(one.estimate)};
    append_ratios(one.interval, cells);
    append_ratios(by_profile, cells);
    cells.emplace_back(std::string(reason_without_estimate(one.kind)));
    table.add_row(std::move(cells));
  }
}

/// A standard deviation or a correlation.
void add_parameter_row(const std::string& group,
                       const std::string& name,
                       double value,
                       const std::optional<statistics::Interval>& profile,
                       Table& table) {
  std::vector<TableCell> row(table.columns.size());
  row[0] = std::string("ran_pars");
  row[1] = group;
  row[2] = name;
  row[3] = number_cell(value);
  row[9] = low_cell(profile);
  row[10] = high_cell(profile);
  row.back() = std::string();
  table.add_row(std::move(row));
}

void add_random_rows(const statistics::GlmmFit& fit,
                     const statistics::GlmmProfile& profile,
                     Table& table) {
  for (std::size_t t = 0; t < fit.random.size(); ++t) {
    const statistics::GlmmRandomTerm& term = fit.random[t];
    for (std::size_t a = 0; a < term.columns.size(); ++a) {
      add_parameter_row(
          term.group, "sd__" + term.columns[a], term.sd[a], at(profile.sds, t), table);
    }
    for (std::size_t a = 1; a < term.columns.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        add_parameter_row(
            term.group,
            "cor__" + term.columns[b] + "." + term.columns[a],
            term.correlation(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)),
            std::nullopt,
            table);
      }
    }
  }
}

Table coefficient_table(const statistics::GlmmFit& fit, const statistics::GlmmProfile& profile) {
  Table table;
  table.name = "coefficients";
  table.title = title_of(fit);
  table.n = static_cast<std::int64_t>(fit.rows);
  table.columns = {text_column("effect", "effect"),
                   text_column("group", "group"),
                   text_column("term", "term"),
                   number_column("estimate", "estimate"),
                   number_column("std.error", "SE"),
                   number_column("statistic", "z"),
                   p_column(),
                   number_column("conf.low", "Wald low"),
                   number_column("conf.high", "Wald high"),
                   number_column("profile.low", "profile low"),
                   number_column("profile.high", "profile high")};
  append_columns(ratio_columns(odds_ratio_name(), {"profile"}), table.columns);
  table.columns.push_back(text_column("kind", ""));
  add_fixed_rows(fit, profile, table);
  add_random_rows(fit, profile, table);
  return table;
}

/// Half chi-squared with df - 1, half with df degrees of freedom.
Table boundary_table(const statistics::GlmmFit& fit) {
  Table table;
  table.name = "random";
  table.title = "Random effects, each against the model without it (on the boundary)";
  table.columns = {text_column("group", "group"),
                   integer_column("levels", "levels"),
                   text_column("singular", "singular"),
                   text_column("dropped", "without"),
                   number_column("statistic", "chi-squared"),
                   number_column("df", "df up to"),
                   p_column()};
  for (const statistics::GlmmRandomTerm& term : fit.random) {
    const auto& test = term.test;
    table.add_row({term.group,
                   integer_cell(term.levels.size()),
                   std::string(term.singular ? "yes" : "no"),
                   test ? TableCell{test->column} : TableCell{},
                   number_cell(test ? std::optional(test->chi_squared) : std::nullopt),
                   number_cell(test ? std::optional(static_cast<double>(test->df)) : std::nullopt),
                   p_cell(test ? std::optional(test->p_value) : std::nullopt)});
  }
  return table;
}

Table mode_table(const statistics::GlmmFit& fit) {
  Table table;
  table.name = "ran_vals";
  table.title = "Conditional modes of the random effects";
  table.columns = {text_column("effect", "effect"),
                   text_column("group", "group"),
                   text_column("level", "level"),
                   text_column("term", "term"),
                   number_column("estimate", "mode"),
                   number_column("std.error", "SD")};
  for (const statistics::GlmmRandomTerm& term : fit.random) {
    for (std::size_t level = 0; level < term.levels.size(); ++level) {
      for (std::size_t k = 0; k < term.columns.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(level);
        const auto column = static_cast<Eigen::Index>(k);
        table.add_row({std::string("ran_vals"),
                       term.group,
                       term.levels[level],
                       term.columns[k],
                       number_cell(term.modes(row, column)),
                       number_cell(term.mode_sds(row, column))});
      }
    }
  }
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
      .number("df.residual", "residual df", residual_df(fit))
      .number("ICC", "ICC", fit.icc)
      .number("R2_marginal", "marginal R2", fit.r2_marginal)
      .number("R2_conditional", "conditional R2", fit.r2_conditional)
      .text("singular", "singular", fit.singular ? "yes" : "no")
      .text("termination", "termination", std::string(statistics::to_string(fit.termination)))
      .integer("iterations", "iterations", static_cast<std::size_t>(fit.iterations))
      .integer("evaluations", "evaluations", static_cast<std::size_t>(fit.evaluations))
      .number("gradient_norm", "largest gradient", fit.gradient_norm)
      .number("last_step", "last step [SE]", fit.last_step)
      .number("step_tolerance", "step tolerance [SE]", fit.options.step_tolerance);
  return std::move(summary).table();
}

}  // namespace

FitReport glmm_report(const statistics::GlmmFit& fit,
                      const statistics::GlmmProfile& profile,
                      const std::vector<statistics::DroppedTerm>& dropped) {
  FitReport report;
  report.model = "glmm";
  report.summary = summary_table(fit);
  report.tables = {coefficient_table(fit, profile), boundary_table(fit)};
  if (!dropped.empty()) {
    report.tables.push_back(drop_table(dropped, "-2 log-likelihood without"));
  }
  std::vector<std::string> names;
  for (const statistics::LogisticCoefficient& one : fit.coefficients) {
    names.push_back(one.column);
  }
  if (fit.covariance.rows() == static_cast<Eigen::Index>(names.size())) {
    report.details.push_back(
        matrix_table("vcov", "Covariance of the fixed effects", names, fit.covariance));
  }
  report.details.push_back(mode_table(fit));
  report.conditions = fit.conditions;
  return report;
}

}  // namespace tcert
