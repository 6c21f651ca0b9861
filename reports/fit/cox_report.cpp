#include "reports/fit/cox_report.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reports/fit/interval_columns.hpp"
#include "reports/fit/matrix_table.hpp"

namespace tcert {
namespace {

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): it has no default constructor.
struct CoxRow : RowOf<statistics::CoxCoefficient> {
  statistics::ClusterT by_t;
};

Table coefficient_table(const statistics::CoxFit& fit,
                        const statistics::ClusterInferences& inferences) {
  using Cox = statistics::CoxCoefficient;
  const bool clustered = fit.clusters > 0;
  ColumnsOf<CoxRow> columns;
  columns.text("term", "term", &Cox::column)
      .number("estimate", "estimate", &Cox::estimate)
      .number("std.error", "SE", &Cox::model_se)
      .number("robust.se", "robust SE", &Cox::robust_se)
      .number("statistic", "z", &Cox::z)
      .p("p.value", "p", &Cox::p_value)
      .ends({"conf.low", "low"}, {"conf.high", "high"}, &Cox::interval);
  if (clustered) {
    columns.part(inference_columns(), [](auto& r) { return &r.by_t; });
  }
  columns.part(ratio_columns(hazard_ratio_name(), clustered ? "t" : ""), [](auto& r) {
    return std::optional(LogRatio{r.of.estimate, r.of.interval, limits_of(r.by_t.interval)});
  });
  Table table = columns.table("coefficients", "Cox model: log hazard ratios");
  table.n = static_cast<std::int64_t>(fit.rows);
  for (std::size_t k = 0; k < fit.coefficients.size(); ++k) {
    table.add_row(
        columns.row({{fit.coefficients[k]},
                     k < inferences.of.size() ? inferences.of[k] : statistics::ClusterT{}}));
  }
  if (clustered) {
    table.footnotes.push_back(t_footnote(fit.clusters, inferences.by));
  }
  return table;
}

void add_test(const std::string& name,
              const std::string& heading,
              const std::optional<statistics::ChiSquareTest>& test,
              Record& summary) {
  summary.number("statistic." + name, heading, statistic_of(test))
      .p("p.value." + name, heading + " p", p_of(test));
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

ColumnsOf<statistics::ProportionalityTest> proportionality_columns() {
  using Test = statistics::ProportionalityTest;
  return ColumnsOf<Test>()
      .text("term", "term", &Test::name)
      .part(chi_square_columns(), &Test::test);
}

Table term_table(const statistics::TermTests& tests, std::string name, std::string title) {
  using Test = statistics::TermTest;
  return ColumnsOf<Test>()
      .text("term", "term", &Test::term)
      .part(chi_square_columns(), &Test::test)
      .number("logLik", "log-likelihood", &Test::loglik)
      .number("AIC", "AIC", &Test::aic)
      .table(std::move(name), std::move(title), tests.rows);
}

}  // namespace

FitReport cox_report(const statistics::CoxFit& fit,
                     const std::optional<statistics::ConcordanceResult>& concordance,
                     const statistics::ClusterInferences& inferences) {
  FitReport report;
  report.model = "cox";
  report.tables = {coefficient_table(fit, inferences)};
  report.summary = summary_of(fit, concordance);
  const std::vector<std::string> names = names_of(fit.coefficients);
  if (!names.empty() && fit.vcov.rows() == static_cast<Eigen::Index>(names.size())) {
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
  const ColumnsOf<statistics::ProportionalityTest> columns = proportionality_columns();
  Table terms = columns.table("zph",
                              "Test of proportional hazards, time scale " +
                                  std::string(statistics::to_string(by_term.transform)),
                              by_term.parts);
  terms.add_row(columns.row({"GLOBAL", by_term.global}));
  report.tables.push_back(std::move(terms));
  report.details.push_back(
      columns.table("zph_columns", "The same by coefficient", by_column.parts));
  report.add(by_term.conditions);
}

void add_term_tests(const statistics::TermTests& anova,
                    const statistics::TermTests& drop1,
                    FitReport& report) {
  report.tables.push_back(term_table(drop1, "drop1", "Likelihood-ratio test of each term"));
  report.details.push_back(term_table(anova, "anova", "Terms added in turn"));
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

namespace {

/// A step of a curve.
template <class Curve>
struct Step {
  const Curve& curve;
  std::size_t at;
};

}  // namespace

Table baseline_table(const std::vector<statistics::BaselineHazard>& hazards) {
  using Hazard = statistics::BaselineHazard;
  const auto columns =
      ColumnsOf<Step<Hazard>>()
          .text("strata", "stratum", [](auto& r) { return r.curve.stratum; })
          .time("time", "time", [](auto& r) { return r.curve.time[r.at]; })
          .number("hazard", "hazard", [](auto& r) { return r.curve.hazard[r.at]; });
  Table table = columns.table("basehaz", "Cumulative baseline hazard, all covariates 0");
  for (const Hazard& one : hazards) {
    for (std::size_t i = 0; i < one.time.size(); ++i) {
      table.add_row(columns.row({one, i}));
    }
  }
  return table;
}

Table curve_table(const std::vector<statistics::CoxCurve>& curves,
                  const std::vector<std::size_t>& rows) {
  using Curve = statistics::CoxCurve;
  const auto columns =
      ColumnsOf<Step<Curve>>()
          .integer("row", "row", [&](auto& r) { return rows[r.curve.row]; })
          .text("strata", "stratum", [](auto& r) { return r.curve.stratum; })
          .time("time", "time", [](auto& r) { return r.curve.time[r.at]; })
          .number("estimate", "survival", [](auto& r) { return r.curve.survival[r.at]; })
          .number("std.error", "SE", [](auto& r) { return r.curve.std_err[r.at]; })
          .number("conf.low", "low", [](auto& r) { return r.curve.lower[r.at]; })
          .number("conf.high", "high", [](auto& r) { return r.curve.upper[r.at]; });
  Table table = columns.table("curves", "Predicted survival");
  for (const Curve& one : curves) {
    for (std::size_t i = 0; i < one.time.size(); ++i) {
      table.add_row(columns.row({one, i}));
    }
  }
  return table;
}

Table residual_table(const statistics::CoxResiduals& residuals,
                     const std::string& word,
                     const std::vector<std::string>& columns,
                     const std::vector<std::size_t>& rows) {
  const bool by_event = word == "schoenfeld" || word == "scaledsch";
  const bool is_vector = word == "martingale" || word == "deviance";
  Eigen::MatrixXd values;
  if (is_vector) {
    values = word == "martingale" ? residuals.martingale : residuals.deviance;
  }
  for (const auto& [name, matrix] : {std::pair("score", &residuals.score),
                                     std::pair("dfbeta", &residuals.dfbeta),
                                     std::pair("dfbetas", &residuals.dfbetas),
                                     std::pair("schoenfeld", &residuals.schoenfeld),
                                     std::pair("scaledsch", &residuals.scaled_schoenfeld)}) {
    if (name == word) {
      values = *matrix;
    }
  }
  ColumnsOf<Eigen::Index> shown;
  shown.integer(apart_from("row", columns), "row", [&](Eigen::Index i) {
    const auto at = static_cast<std::size_t>(i);
    return rows[by_event ? residuals.event_rows[at] : at] + 1;
  });
  if (is_vector) {
    shown.number("residual", word, [&](Eigen::Index i) { return values(i, 0); });
  } else {
    add_matrix_columns(columns, values, shown);
  }
  if (values.cols() + 1 != static_cast<Eigen::Index>(shown.all().size())) {
    throw std::invalid_argument("no residuals of the kind '" + word + "'");
  }
  Table table = shown.table(word, word + " residuals");
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    table.add_row(shown.row(i));
  }
  return table;
}

}  // namespace tcert
