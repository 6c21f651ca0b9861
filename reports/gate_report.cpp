#include "reports/gate_report.hpp"

#include <string>

#include "reports/columns_of.hpp"
#include "reports/findings.hpp"

namespace tcert {
namespace {

/// Of metres.
constexpr int kDecimals = 4;

std::string words_of(study::ConfidenceSetKind kind) {
  switch (kind) {
    case study::ConfidenceSetKind::bounded:
      return "bounded";
    case study::ConfidenceSetKind::two_rays:
      return "unbounded: all but";
    case study::ConfidenceSetKind::whole_line:
      return "unbounded: everything";
    case study::ConfidenceSetKind::unknown:
      break;
  }
  return "none";
}

/// A confidence set of the 50 % point.
struct Method {
  std::string name;
  std::optional<double> point;
  const study::ConfidenceSet& set;

  [[nodiscard]] bool is(study::ConfidenceSetKind kind) const { return set.kind == kind; }
  [[nodiscard]] bool is_bounded() const { return is(study::ConfidenceSetKind::bounded); }
  [[nodiscard]] bool has_ends() const {
    return is_bounded() || is(study::ConfidenceSetKind::two_rays);
  }
  [[nodiscard]] bool is_known() const { return !is(study::ConfidenceSetKind::unknown); }
};

Table point_table(const study::GateStudy& study) {
  const study::EvenChance& even = study.even;
  std::vector<Method> methods{{"Fieller", even.point, even.fieller},
                              {"profile", even.point, even.profile}};
  if (study.options.replicates > 0) {
    methods.push_back({"bootstrap percentile", even.point, even.percentile});
    methods.push_back({"bootstrap BCa", even.point, even.bca});
  }
  Table table =
      ColumnsOf<Method>()
          .text("method", "method", &Method::name)
          .fixed("point_m", "50 % point", "m", kDecimals, &Method::point)
          .text("set", "set", [](auto& r) { return words_of(r.set.kind); })
          .fixed(
              "low_m", "low", "m", kDecimals, [](auto& r) { return when(r.has_ends(), r.set.low); })
          .fixed("high_m",
                 "high",
                 "m",
                 kDecimals,
                 [](auto& r) { return when(r.has_ends(), r.set.high); })
          .fixed("width_m",
                 "width",
                 "m",
                 kDecimals,
                 [](auto& r) { return when(r.is_bounded(), r.set.high - r.set.low); })
          .yes_or_no("covers_zero",
                     "covers 0",
                     [](auto& r) { return when(r.is_known(), r.set.covers(0.0)); })
          .table("gate", "Margin of an even chance to pass: -alpha / beta", methods);
  table.n = static_cast<std::int64_t>(even.rows);
  table.footnotes = {
      "The margin is the smallest tick margin of the pass. Its distance from 0 is the "
      "bias of the certificate's threshold, sensor noise included.",
      "Bootstrap: " + std::to_string(study.options.replicates) + " resamples of passes, seed " +
          std::to_string(study.options.seed) + "; " + std::to_string(even.failed_replicates) +
          " were separated and are left out."};
  if (study.incomplete > 0) {
    table.footnotes.push_back(std::to_string(study.incomplete) +
                              " passes without outcome or margin are left out.");
  }
  return table;
}

/// Whether margin 0 is where the chance to pass is even.
Table findings_of(const study::GateStudy& study) {
  using study::ConfidenceSetKind;
  const char* const about = "Gate, margin 0 is an even chance to pass";
  const study::EvenChance& even = study.even;
  const study::ConfidenceSet& set = even.profile;
  const std::string level = significant(100.0 * study.options.level, 3) + " %";
  if (!even.point || set.kind != ConfidenceSetKind::bounded) {
    return findings_table(
        {{about,
          "not decided",
          std::to_string(even.rows) + " passes, " + std::to_string(even.successes) +
              " of them successes, do not say where the chance to pass is even."}});
  }
  return findings_table(
      {{about,
        set.covers(0.0) ? "not decided" : "contradicted",
        "The chance to pass is even at a margin of " +
            in_words(even.point,
                     statistics::Interval{set.low, set.high, study.options.level},
                     kDecimals) +
            " m, " + (set.covers(0.0) ? "which covers 0." : "which does not cover 0.")}},
      {"Rule of the gate: contradicted if the " + level +
       " profile set does not cover 0; a set that covers it does not prove it."});
}

Table slope_table(const study::EvenChance& even) {
  struct Coefficient {
    std::string name;
    std::optional<double> estimate;
    std::optional<double> std_error;
    std::optional<double> p_value;
    std::optional<statistics::Interval> wald;
    std::optional<statistics::Interval> profile;
  };
  const auto columns =
      ColumnsOf<Coefficient>()
          .text("term", "term", &Coefficient::name)
          .number("estimate", "estimate", &Coefficient::estimate)
          .number("std.error", "SE", &Coefficient::std_error)
          .p("p.value", "p", &Coefficient::p_value)
          .ends({"wald_low", "Wald low"}, {"wald_high", "high"}, &Coefficient::wald)
          .ends({"profile_low", "profile low"}, {"profile_high", "high"}, &Coefficient::profile);
  Table table = columns.table("gate_slope", "logit Pr(success) = alpha + beta margin");
  table.add_row(columns.row({"alpha", even.intercept, even.intercept_std_error, {}, {}, {}}));
  table.add_row(columns.row({"beta",
                             even.slope,
                             even.slope_std_error,
                             even.slope_p,
                             even.slope_wald,
                             even.slope_profile}));
  table.footnotes = {"beta is per metre of margin."};
  return table;
}

Table calibration_table(const study::GateStudy& study) {
  using Group = study::GateCalibration;
  Table table =
      ColumnsOf<Group>()
          .integer("passes", "passes", &Group::passes)
          .fixed("mean_margin_m", "mean margin", "m", kDecimals, &Group::mean_margin_m)
          .integer("successes", "successes", &Group::successes)
          .estimate("observed",
                    "observed",
                    [](auto& group) { return Estimated(group.observed, group.observed_interval); })
          .fixed("predicted", "predicted", &Group::predicted)
          .table("gate_calibration", "Calibration: passes of like margin", study.calibration);
  table.footnotes = {"observed: Wilson's interval. predicted: of the model fitted to all passes."};
  return table;
}

Table model_table(const statistics::LogisticFit& fit) {
  using Coefficient = statistics::LogisticCoefficient;
  Table table = ColumnsOf<Coefficient>()
                    .text("term", "term", &Coefficient::column)
                    .number("estimate", "estimate", &Coefficient::estimate)
                    .number("std.error", "SE", &Coefficient::standard_error)
                    .p("p.value", "p", &Coefficient::p_value)
                    .ends({"conf.low", "low"}, {"conf.high", "high"}, &Coefficient::interval)
                    .table("gate_model",
                           "With the least certificate before the gate as second predictor",
                           fit.coefficients);
  table.footnotes = {std::to_string(fit.rows) + " passes; Wald intervals; per metre."};
  return table;
}

Table pass_table(const study::GateStudy& study) {
  using Row = study::GateRow;
  return ColumnsOf<Row>()
      .text("trial_id", "pass", &Row::trial_id)
      .integer("success", "success", &Row::success)
      .fixed("bottleneck_m",
             "bottleneck margin",
             "m",
             kDecimals,
             [](auto& row) { return row.pass.bottleneck_m; })
      .fixed("before_m",
             "certificate before",
             "m",
             kDecimals,
             [](auto& row) { return row.pass.before_m; })
      .table("gate_passes", "The passes", study.rows);
}

Table curve_table(const study::GateStudy& study) {
  using Chance = study::GateChance;
  Table table =
      ColumnsOf<Chance>()
          .fixed("margin_m", "margin", "m", kDecimals, &Chance::margin_m)
          .estimate(
              "chance", "chance", [](auto& one) { return Estimated(one.chance, one.interval); })
          .table("gate_curve", "Fitted chance to pass", study.curve);
  table.footnotes = {"Pointwise Wald intervals on the logit scale."};
  return table;
}

}  // namespace

FitReport gate_report(const study::GateStudy& study) {
  FitReport report;
  report.model = "gate";
  Record summary("summary", "Options");
  summary.integer("passes", "passes", study.even.rows)
      .integer("successes", "successes", study.even.successes)
      .number("level", "level", study.options.level)
      .integer("replicates", "replicates", study.options.replicates)
      .integer("seed", "seed", study.options.seed);
  report.summary = std::move(summary).table();
  report.tables = {point_table(study), slope_table(study.even), calibration_table(study)};
  if (study.both) {
    report.tables.push_back(model_table(*study.both));
  }
  report.details = {pass_table(study), curve_table(study)};
  report.conditions = study.even.conditions;
  if (study.both) {
    for (statistics::Condition condition : study.both->conditions) {
      condition.detail = "with the certificate before the gate" +
                         (condition.detail.empty() ? "" : ": " + condition.detail);
      if (condition.severity == statistics::ConditionSeverity::error) {
        condition.severity = statistics::ConditionSeverity::warning;  // The point stands.
      }
      report.conditions.push_back(std::move(condition));
    }
  }
  report.findings = findings_of(study);
  return report;
}

}  // namespace tcert
