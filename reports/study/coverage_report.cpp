#include "reports/study/coverage_report.hpp"

#include <fmt/format.h>

#include <map>

#include "reports/columns_of.hpp"
#include "reports/study/study_summary.hpp"

namespace tcert {

using namespace study::coverage;

FitReport coverage_report(const std::vector<Coverage>& rows, const Options& options) {
  ColumnsOf<Coverage> columns;
  columns.text("scenario", "scenario", &Coverage::scenario)
      .text("quantity", "quantity", &Coverage::quantity)
      .text("method", "method", &Coverage::method)
      .fixed("truth", "truth", "", 4, &Coverage::truth)
      .fixed("mean_estimate", "mean estimate", "", 4, &Coverage::mean_estimate)
      .integer("intervals", "intervals", &Coverage::intervals)
      .integer("missing", "missing", &Coverage::missing)
      .integer("withheld", "withheld", &Coverage::withheld)
      .fixed("coverage", "coverage", "", 4, &Coverage::covered)
      .fixed("mc_se", "its SE", "", 4, &Coverage::monte_carlo_se)
      .fixed("mean_width", "mean width", "", 4, &Coverage::mean_width);
  FitReport report = study_report("coverage", options.seed);
  report.summary = study_summary({{"data_sets", options.data_sets},
                                  {"replicates", options.replicates},
                                  {"seed", options.seed}});
  report.tables = {columns.table("coverage", "How often intervals cover the truth", rows)};
  report.tables.front().footnotes = {
      fmt::format("Of nominal {:g} % intervals, over {} data sets of each scenario with 30 trials "
                  "a day. Withheld: "
                  "fewer than 10 of an outcome.",
                  100.0 * options.level,
                  options.data_sets)};
  return report;
}

FitReport inference_report(const std::vector<InferenceRate>& rows, const Options& options) {
  ColumnsOf<InferenceRate> columns;
  columns.text("scenario", "scenario", [](auto& row) { return row.scenario.name; })
      .text("coefficient", "coefficient", &InferenceRate::coefficient)
      .text("method", "method", &InferenceRate::method)
      .integer("tests", "tests", &InferenceRate::tests)
      .integer("missing", "missing", &InferenceRate::missing)
      .integer("withheld", "withheld", &InferenceRate::withheld)
      .fixed("rejected", "truth rejected", "", 4, &InferenceRate::rejected)
      .fixed("mc_se", "its SE", "", 4, &InferenceRate::monte_carlo_se);
  FitReport report = study_report("inference", options.seed);
  report.summary = study_summary({{"data_sets", options.data_sets},
                                  {"replicates", options.replicates},
                                  {"seed", options.seed}});
  report.tables = {columns.table(
      "inference", "How often tests of coefficients by clusters reject the truth", rows)};
  report.tables.front().footnotes = {fmt::format(
      "At a nominal {:g} %, over {} data sets of each scenario with 30 trials a day; an interval "
      "misses the truth as often. Withheld: fewer than 10 of an outcome.",
      100.0 * (1.0 - options.level),
      options.data_sets)};
  return report;
}

namespace {

/// Shares of data sets in which a number misses the truth.
template <class Rate>
FitReport miss_report(const std::string& study,
                      ColumnsOf<Rate>& columns,
                      const std::string& table,
                      const std::string& title,
                      const std::vector<Rate>& rows,
                      const Options& options,
                      const std::string& of) {
  columns.text("kind", "kind", [](auto& row) { return row.printed.is_test ? "test" : "interval"; })
      .integer("sets", "sets", &Rate::sets)
      .integer("without", "without", &Rate::without)
      .fixed("missed", "truth missed", "", 4, &Rate::missed)
      .fixed("mc_se", "its SE", "", 4, &Rate::monte_carlo_se);
  FitReport report = study_report(study, options.seed);
  report.summary = study_summary({{"data_sets", options.data_sets},
                                  {"replicates", options.replicates},
                                  {"seed", options.seed}});
  report.tables = {columns.table(table, title, rows)};
  report.tables.front().footnotes = {fmt::format(
      "Share of {} data sets in which an interval does not hold the truth, or a test at 5 % "
      "rejects it; without: withheld, or not there. {}",
      options.data_sets,
      of)};
  return report;
}

}  // namespace

FitReport hypotheses_report(const std::vector<MissRate>& rows, const Options& options) {
  ColumnsOf<MissRate> columns;
  columns.text("scenario", "scenario", [](auto& row) { return row.scenario.name; })
      .text("table", "table", [](auto& row) { return row.printed.table; })
      .text("name", "number", [](auto& row) { return row.printed.name; })
      .fixed("nominal", "nominal", "", 2, [](auto& row) { return row.printed.nominal; });
  return miss_report(
      "hypotheses",
      columns,
      "misses",
      "How often what H1 and H2 print misses the truth",
      rows,
      options,
      "30 trials a day; resamples are those of 22 days, more in proportion of fewer.");
}

FitReport advance_report(const std::vector<AdvanceRate>& rows, const Options& options) {
  ColumnsOf<AdvanceRate> columns;
  columns.text("scenario", "scenario", [](auto& row) { return row.scenario.name; })
      .text("name", "number", [](auto& row) { return row.printed.name; });
  return miss_report("advance",
                     columns,
                     "advance_misses",
                     "How often what H3 prints misses the truth",
                     rows,
                     options,
                     "9 trials of either algorithm a day.");
}

FitReport equivalence_report(const std::vector<ScenarioRates>& rows,
                             std::size_t data_sets,
                             std::uint64_t seed) {
  const auto of_scenario = [](auto member) {
    return [member](const ScenarioRates& row) { return row.first.*member; };
  };
  const auto of_rates = [](auto member) {
    return [member](const ScenarioRates& row) { return row.second.*member; };
  };
  ColumnsOf<ScenarioRates> columns;
  columns.integer("days", "days", of_scenario(&LightingScenario::days))
      .fixed("icc", "within-day correlation", "", 1, of_scenario(&LightingScenario::icc))
      .fixed("margin", "margin", "", 2, of_scenario(&LightingScenario::margin))
      .fixed("difference", "true difference", "", 3, of_scenario(&LightingScenario::difference))
      .integer("data_sets", "data sets", of_rates(&EquivalenceRates::tested))
      .fixed("equivalent", "all pairs equivalent", "", 4, of_rates(&EquivalenceRates::equivalent))
      .fixed("pair_equivalent", "one pair equivalent", "", 4, of_rates(&EquivalenceRates::one_pair))
      .fixed("different", "different", "", 4, of_rates(&EquivalenceRates::different))
      .fixed("mean_se", "mean SE", "", 4, of_rates(&EquivalenceRates::mean_error))
      .fixed("true_se", "true SE", "", 4, of_rates(&EquivalenceRates::true_error))
      .fixed("mean_range", "mean range", "", 4, of_rates(&EquivalenceRates::mean_range))
      .fixed("margin_80",
             "margin of 80 % power",
             "",
             4,
             of_rates(&EquivalenceRates::mean_power_margin));
  FitReport report = study_report("equivalence", seed);
  report.summary = study_summary({{"data_sets", data_sets}, {"seed", seed}});
  report.tables = {columns.table(
      "equivalence", "How often AUCs of lightings are found equivalent, or different", rows)};
  report.tables.front().footnotes = {
      "Shares of the data sets: 30 trials a day in three lightings, two of AUC 0.76 and one "
      "that lies lower by the true difference. Tests at 5 %."};
  return report;
}

FitReport gate_coverage_report(const GateSummary& summary, const GateOptions& options) {
  ColumnsOf<GateCoverage> columns;
  columns.text("method", "set", &GateCoverage::method)
      .integer("sets", "sets", &GateCoverage::sets)
      .fixed("unbounded_share",
             "without bounds",
             "",
             4,
             [](const GateCoverage& row) {
               return static_cast<double>(row.unbounded) / static_cast<double>(row.sets);
             })
      .fixed("coverage", "covers the large-sample point", "", 4, &GateCoverage::covered)
      .fixed("mc_se", "its SE", "", 4, &GateCoverage::monte_carlo_se)
      .fixed("covers_zero", "covers 0", "", 4, &GateCoverage::covered_zero)
      .fixed("median_width_m", "median width", "m", 5, &GateCoverage::median_width_m);
  FitReport report = study_report("gate", options.first_seed);
  report.summary = study_summary({{"data_sets", options.studies},
                                  {"replicates", options.replicates},
                                  {"seed", options.first_seed}});
  report.tables = {columns.table(
      "gate_coverage", "How often the sets of the 50 % point cover it", summary.methods)};
  report.tables.front().footnotes = {
      fmt::format("{} micro-studies; the large-sample 50 % point is {:.5f} m (SE {:.5f}), slope "
                  "{:.2f} per metre; estimates: mean {:.5f} m, median {:.5f} m; {} are separated.",
                  options.studies,
                  summary.point_m,
                  summary.point_error_m,
                  summary.slope_per_m,
                  summary.mean_estimate_m,
                  summary.median_estimate_m,
                  summary.separated)};
  return report;
}

FitReport ray_coverage_report(const std::vector<RayCoverage>& rows, std::uint64_t seed) {
  ColumnsOf<RayCoverage> columns;
  columns.text("scenario", "scenario", &RayCoverage::scenario)
      .integer("calibrations", "calibrations", &RayCoverage::calibrations)
      .integer("bound_days", "days of the bound", &RayCoverage::bound_days)
      .integer("rank", "rank of q", &RayCoverage::rank)
      .fixed("promised", "promised", "", 4, &RayCoverage::promised)
      .fixed("expected", "by the law", "", 4, &RayCoverage::expected)
      .fixed("covered", "new days covered", "", 4, &RayCoverage::covered)
      .fixed("mc_se", "its SE", "", 4, &RayCoverage::monte_carlo_se)
      .fixed("low", "5 % quantile", "", 4, &RayCoverage::low)
      .fixed("expected_low", "by the law", "", 4, &RayCoverage::expected_low)
      .fixed("distance", "Kolmogorov distance", "", 2, &RayCoverage::distance)
      .fixed("mean_q_m", "mean q", "m", 4, &RayCoverage::mean_quantile_m);
  const std::size_t calibrations = rows.empty() ? 0 : rows.front().calibrations;
  const std::size_t new_days = rows.empty() ? 0 : rows.front().new_days;
  FitReport report = study_report("rays", seed);
  report.summary =
      study_summary({{"data_sets", calibrations}, {"new_days", new_days}, {"seed", seed}});
  report.tables = {
      columns.table("ray_coverage", "How often a bound of rays holds on all of a new day", rows)};
  report.tables.front().footnotes = {fmt::format(
      "Each calibration is asked of {} new days, two rays and 20 to 60 ticks a day. The law: "
      "covered "
      "days are beta-binomial with Beta(rank, n + 1 - rank). Distance: of the two distributions, "
      "times the root of the calibrations; 1.63 is passed in 1 of 100 studies.",
      new_days)};
  return report;
}

std::optional<bool> NullAuc::covers() const noexcept {
  return interval ? std::optional(interval->low <= 0.5 && 0.5 <= interval->high) : std::nullopt;
}

FitReport null_report(const std::vector<NullAuc>& rows) {
  struct Sum {
    std::string panel;
    std::size_t corpora = 0;
    std::size_t intervals = 0;
    std::size_t covered = 0;
    std::size_t known = 0;
    double auc = 0.0;
  };
  std::map<std::string, Sum> sums;
  for (const NullAuc& row : rows) {
    Sum& sum = sums[std::string(to_string(row.panel))];
    sum.panel = to_string(row.panel);
    ++sum.corpora;
    sum.covered += row.covers().value_or(false) ? 1 : 0;
    sum.intervals += row.interval ? 1 : 0;
    sum.known += row.auc ? 1 : 0;
    sum.auc += row.auc.value_or(0.0);
  }
  std::vector<Sum> panels;
  panels.reserve(sums.size());
  for (const auto& [name, sum] : sums) {
    panels.push_back(sum);
  }
  ColumnsOf<Sum> of_panels;
  of_panels.text("panel", "panel", &Sum::panel)
      .integer("corpora", "corpora", &Sum::corpora)
      .integer("intervals", "with an interval", &Sum::intervals)
      .integer("covered", "intervals that hold 0.5", &Sum::covered)
      .fixed("mean_auc", "mean AUC", "", 3, [](const Sum& sum) {
        return sum.auc / static_cast<double>(sum.known);
      });
  ColumnsOf<NullAuc> of_corpora;
  of_corpora.integer("seed", "seed", &NullAuc::seed)
      .text("panel", "panel", [](const NullAuc& row) { return std::string(to_string(row.panel)); })
      .estimate(
          "auc", "AUC", "", 3, [](const NullAuc& row) { return Estimated(row.auc, row.interval); })
      .yes_or_no("covers", "holds 0.5", &NullAuc::covers);
  const std::uint64_t seed = rows.empty() ? 1 : rows.front().seed;
  FitReport report = study_report("null", seed);
  report.summary = study_summary({{"first_seed", seed}});
  report.tables = {of_panels.table("null", "H1 where there is nothing to be found", panels),
                   of_corpora.table("null_corpora", "Its corpora", rows)};
  report.tables.front().footnotes = {
      "Corpora in which the outcome has nothing to do with the margin: AUC of the certificate, "
      "nominal 95 % intervals."};
  return report;
}

}  // namespace tcert
