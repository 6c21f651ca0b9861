#include "reports/fit/cox_report.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reports/fit/cells.hpp"
#include "reports/fit/interval_columns.hpp"

namespace tcert {
namespace {

Table coefficient_table(const statistics::CoxFit& fit) {
  Table table;
  table.name = "coefficients";
  table.title = "Cox model: log hazard ratios";
  table.n = static_cast<std::int64_t>(fit.rows);
  table.columns = {text_column("term", "term"),
                   number_column("estimate", "estimate"),
                   number_column("std.error", "SE"),
                   number_column("robust.se", "robust SE"),
                   number_column("statistic", "z"),
                   p_column(),
                   number_column("conf.low", "low"),
                   number_column("conf.high", "high")};
  const bool clustered = fit.clusters > 0;
  std::vector<std::string> others;
  if (clustered) {
    append_columns(t_columns(), table.columns);
    others = {"t"};
    table.footnotes.push_back(t_footnote(fit.clusters));
  }
  append_columns(ratio_columns(hazard_ratio_name(), others), table.columns);
  for (const statistics::CoxCoefficient& one : fit.coefficients) {
    std::vector<TableCell> cells{one.column,
                                 number_cell(one.estimate),
                                 number_cell(one.model_se),
                                 number_cell(one.robust_se),
                                 number_cell(one.z),
                                 p_cell(one.p_value),
                                 low_cell(one.interval),
                                 high_cell(one.interval)};
    const statistics::ClusterT by_t =
        statistics::by_cluster_t(one.estimate, one.robust_se, one.z, fit.clusters, fit.level);
    if (clustered) {
      append_t(by_t, cells);
    }
    cells.push_back(number_cell(one.hazard_ratio));
    append_ratios(one.interval, cells);
    if (clustered) {
      append_ratios(by_t.interval, cells);
    }
    table.add_row(std::move(cells));
  }
  return table;
}

void add_test(const std::string& name,
              const std::string& heading,
              const std::optional<statistics::ChiSquareTest>& test,
              Record& summary) {
  summary.number(
      "statistic." + name, heading, test ? std::optional(test->statistic) : std::nullopt);
  summary.p("p.value." + name, heading + " p", test ? std::optional(test->p_value) : std::nullopt);
}

Table summary_of(const statistics::CoxFit& fit,
                 const std::optional<statistics::ConcordanceResult>& concordance) {
  Record summary("summary", "Fit");
  summary.integer("n", "rows", fit.rows)
      .integer("nevent", "events", fit.events)
      .integer("clusters", "clusters", fit.clusters)
      .integer("df", "df", fit.df);
  const std::string rows_independent = fit.robust ? ", rows independent" : "";
  const std::string suffix = fit.robust ? ".rows_independent" : "";
  add_test("log" + suffix, "likelihood ratio" + rows_independent, fit.likelihood_ratio, summary);
  add_test("sc" + suffix, "score" + rows_independent, fit.score, summary);
  add_test("wald", "Wald", fit.wald, summary);
  add_test("robust", "robust score", fit.robust_score, summary);
  const statistics::ConcordanceEstimate* const c =
      concordance ? &concordance->estimates.front() : nullptr;
  summary.number("concordance", "C", c != nullptr ? c->c : std::nullopt)
      .number("std.error.concordance", "SE of C", c != nullptr ? c->std_error : std::nullopt)
      .number("logLik.null", "null log-likelihood", fit.loglik_null)
      .number("logLik", "log-likelihood", fit.loglik)
      .number("AIC", "AIC", fit.aic)
      .number("BIC", "BIC", fit.bic)
      .text("ties", "ties", std::string(statistics::to_string(fit.ties)))
      .text("variance", "variance", fit.robust ? "robust" : "model")
      .text(
          "termination", "termination", std::string(statistics::to_string(fit.summary.termination)))
      .integer("iterations", "iterations", fit.summary.iterations)
      .number("gradient_norm", "gradient norm", fit.summary.gradient_norm)
      .number("last_step", "last step", fit.summary.last_step)
      .number("loglik_tolerance", "tolerance", fit.summary.loglik_tolerance)
      .number("step_tolerance", "step tolerance", fit.summary.step_tolerance)
      .number("rank_tolerance", "rank tolerance", fit.summary.rank_tolerance);
  return std::move(summary).table();
}

void append_tests(const statistics::ProportionalityTests& tests, bool with_global, Table& table) {
  const auto append = [&](const std::string& name,
                          const std::optional<statistics::ChiSquareTest>& test) {
    table.add_row({name,
                   test ? number_cell(test->statistic) : TableCell{},
                   test ? integer_cell(test->df) : TableCell{},
                   test ? p_cell(test->p_value) : TableCell{}});
  };
  for (const statistics::ProportionalityTest& part : tests.parts) {
    append(part.name, part.test);
  }
  if (with_global) {
    append("GLOBAL", tests.global);
  }
}

Table proportionality_table(std::string name, std::string title) {
  Table table;
  table.name = std::move(name);
  table.title = std::move(title);
  table.columns = {text_column("term", "term"),
                   number_column("statistic", "chi-squared"),
                   integer_column("df", "df"),
                   p_column()};
  return table;
}

}  // namespace

FitReport cox_report(const statistics::CoxFit& fit,
                     const std::optional<statistics::ConcordanceResult>& concordance) {
  FitReport report;
  report.model = "cox";
  report.tables = {coefficient_table(fit)};
  report.summary = summary_of(fit, concordance);
  std::vector<std::string> names;
  for (const statistics::CoxCoefficient& one : fit.coefficients) {
    names.push_back(one.column);
  }
  const auto p = static_cast<Eigen::Index>(names.size());
  if (p > 0 && fit.vcov.rows() == p) {
    report.details.push_back(
        matrix_table("vcov", "Covariance of the coefficients", names, fit.vcov));
    report.details.push_back(
        matrix_table("model_vcov", "The same by the model", names, fit.model_vcov));
  }
  report.conditions = fit.conditions;
  point_to_t(report.conditions);
  return report;
}

void add_proportionality(const statistics::ProportionalityTests& by_term,
                         const statistics::ProportionalityTests& by_column,
                         FitReport& report) {
  Table terms = proportionality_table("zph",
                                      "Test of proportional hazards, time scale " +
                                          std::string(statistics::to_string(by_term.transform)));
  append_tests(by_term, true, terms);
  report.tables.push_back(std::move(terms));
  Table columns = proportionality_table("zph_columns", "The same by coefficient");
  append_tests(by_column, false, columns);
  report.details.push_back(std::move(columns));
  report.conditions.insert(
      report.conditions.end(), by_term.conditions.begin(), by_term.conditions.end());
}

void add_term_tests(const statistics::TermTests& anova,
                    const statistics::TermTests& drop1,
                    FitReport& report) {
  const auto table_of =
      [](const statistics::TermTests& tests, std::string name, std::string title) {
        Table table = proportionality_table(std::move(name), std::move(title));
        table.columns.push_back(number_column("logLik", "log-likelihood"));
        table.columns.push_back(number_column("AIC", "AIC"));
        for (const statistics::TermTest& one : tests.rows) {
          table.add_row({one.term,
                         one.test ? number_cell(one.test->statistic) : TableCell{},
                         one.test ? integer_cell(one.test->df) : TableCell{},
                         one.test ? p_cell(one.test->p_value) : TableCell{},
                         number_cell(one.loglik),
                         number_cell(one.aic)});
        }
        return table;
      };
  report.tables.push_back(table_of(drop1, "drop1", "Likelihood-ratio test of each term"));
  report.details.push_back(table_of(anova, "anova", "Terms added in turn"));
  for (const statistics::TermTests* const tests : {&anova, &drop1}) {
    // Without a refit there is no test; the fit itself stands.
    for (statistics::Condition condition :
         tests->rows.empty() ? tests->conditions : statistics::Conditions{}) {
      condition.severity = std::min(condition.severity, statistics::ConditionSeverity::warning);
      condition.detail += condition.detail.empty() ? "" : "; ";
      condition.detail += tests == &anova ? "no anova" : "no drop1";
      report.conditions.push_back(std::move(condition));
    }
  }
}

Table baseline_table(const std::vector<statistics::BaselineHazard>& hazards) {
  Table table;
  table.name = "basehaz";
  table.title = "Cumulative baseline hazard, all covariates 0";
  table.columns = {text_column("strata", "stratum"),
                   time_column("time", "time"),
                   number_column("hazard", "hazard")};
  for (const statistics::BaselineHazard& one : hazards) {
    for (std::size_t i = 0; i < one.time.size(); ++i) {
      const bool is_finite = std::isfinite(one.hazard[i]);
      table.add_row({one.stratum,
                     number_cell(one.time[i]),
                     is_finite ? number_cell(one.hazard[i]) : TableCell{}});
    }
  }
  return table;
}

Table curve_table(const std::vector<statistics::CoxCurve>& curves,
                  const std::vector<std::size_t>& rows) {
  Table table;
  table.name = "curves";
  table.title = "Predicted survival";
  table.columns = {integer_column("row", "row"),
                   text_column("strata", "stratum"),
                   time_column("time", "time"),
                   number_column("estimate", "survival"),
                   number_column("std.error", "SE"),
                   number_column("conf.low", "low"),
                   number_column("conf.high", "high")};
  for (const statistics::CoxCurve& one : curves) {
    for (std::size_t i = 0; i < one.time.size(); ++i) {
      table.add_row({integer_cell(rows[one.row]),
                     one.stratum,
                     number_cell(one.time[i]),
                     number_cell(one.survival[i]),
                     number_cell(one.std_err[i]),
                     number_cell(one.lower[i]),
                     number_cell(one.upper[i])});
    }
  }
  return table;
}

Table residual_table(const statistics::CoxResiduals& residuals,
                     const std::string& word,
                     const std::vector<std::string>& columns,
                     const std::vector<std::size_t>& rows) {
  Table table;
  table.name = word;
  table.title = word + " residuals";
  table.columns = {integer_column(apart_from("row", columns), "row")};
  const bool by_event = word == "schoenfeld" || word == "scaledsch";
  Eigen::MatrixXd values;
  if (word == "martingale" || word == "deviance") {
    values = word == "martingale" ? residuals.martingale : residuals.deviance;
    table.columns.push_back(number_column("residual", word));
  } else {
    const std::vector<std::pair<std::string, const Eigen::MatrixXd*>> matrices{
        {"score", &residuals.score},
        {"dfbeta", &residuals.dfbeta},
        {"dfbetas", &residuals.dfbetas},
        {"schoenfeld", &residuals.schoenfeld},
        {"scaledsch", &residuals.scaled_schoenfeld}};
    for (const auto& [name, matrix] : matrices) {
      if (name == word) {
        values = *matrix;
      }
    }
    for (const std::string& column : columns) {
      table.columns.push_back(number_column(column, column));
    }
  }
  if (values.cols() + 1 != static_cast<Eigen::Index>(table.columns.size())) {
    throw std::invalid_argument("no residuals of the kind '" + word + "'");
  }
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const std::size_t row = rows[by_event ? residuals.event_rows[at] : at];
    std::vector<TableCell> cells{integer_cell(row + 1)};
    for (Eigen::Index j = 0; j < values.cols(); ++j) {
      cells.push_back(number_cell(values(i, j)));
    }
    table.add_row(std::move(cells));
  }
  return table;
}

}  // namespace tcert
