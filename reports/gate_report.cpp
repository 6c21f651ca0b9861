#include "reports/gate_report.hpp"

#include <limits>
#include <string>

#include "reports/fit/cells.hpp"

namespace tcert {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Column metres(std::string name, std::string heading) {
  return {std::move(name), std::move(heading), "m", ColumnKind::number, 4};
}

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

Table point_table(const study::GateStudy& study) {
  const study::EvenChance& even = study.even;
  Table table;
  table.name = "gate";
  table.title = "Margin of an even chance to pass: -alpha / beta";
  table.n = static_cast<std::int64_t>(even.rows);
  table.columns = {text_column("method", "method"),
                   metres("point_m", "50 % point"),
                   text_column("set", "set"),
                   metres("low_m", "low"),
                   metres("high_m", "high"),
                   metres("width_m", "width"),
                   text_column("covers_zero", "covers 0")};
  const auto add = [&](const char* method, const study::ConfidenceSet& set) {
    const bool has_ends = set.kind == study::ConfidenceSetKind::bounded ||
                          set.kind == study::ConfidenceSetKind::two_rays;
    const bool bounded = set.kind == study::ConfidenceSetKind::bounded;
    table.add_row({std::string(method),
                   number_cell(even.point),
                   words_of(set.kind),
                   has_ends ? TableCell{Number{set.low}} : TableCell{},
                   has_ends ? TableCell{Number{set.high}} : TableCell{},
                   bounded ? TableCell{Number{set.high - set.low}} : TableCell{},
                   set.kind == study::ConfidenceSetKind::unknown
                       ? TableCell{}
                       : TableCell{std::string(set.covers(0.0) ? "yes" : "no")}});
  };
  add("Fieller", even.fieller);
  add("profile", even.profile);
  if (study.options.replicates > 0) {
    add("bootstrap percentile", even.percentile);
    add("bootstrap BCa", even.bca);
  }
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
  for (const statistics::Condition& condition : even.conditions) {
    table.footnotes.push_back(statistics::to_string(condition) + ".");
  }
  return table;
}

Table slope_table(const study::EvenChance& even) {
  Table table;
  table.name = "gate_slope";
  table.title = "logit Pr(success) = alpha + beta margin";
  table.columns = {text_column("term", "term"),
                   number_column("estimate", "estimate"),
                   number_column("std.error", "SE"),
                   p_column(),
                   number_column("wald_low", "Wald low"),
                   number_column("wald_high", "high"),
                   number_column("profile_low", "profile low"),
                   number_column("profile_high", "high")};
  table.add_row({std::string("alpha"),
                 number_cell(even.intercept),
                 number_cell(even.intercept_std_error),
                 {},
                 {},
                 {},
                 {},
                 {}});
  table.add_row({std::string("beta"),
                 number_cell(even.slope),
                 number_cell(even.slope_std_error),
                 p_cell(even.slope_p),
                 low_cell(even.slope_wald),
                 high_cell(even.slope_wald),
                 low_cell(even.slope_profile),
                 high_cell(even.slope_profile)});
  table.footnotes = {"beta is per metre of margin."};
  return table;
}

Table calibration_table(const study::GateStudy& study) {
  Table table;
  table.name = "gate_calibration";
  table.title = "Calibration: passes of like margin";
  table.columns = {integer_column("passes", "passes"),
                   metres("mean_margin_m", "mean margin"),
                   integer_column("successes", "successes"),
                   {"observed", "observed", "", ColumnKind::estimate, 3},
                   {"predicted", "predicted", "", ColumnKind::number, 3}};
  for (const study::GateCalibration& group : study.calibration) {
    table.add_row(
        {integer_cell(group.passes),
         Number{group.mean_margin_m},
         integer_cell(group.successes),
         Estimate{group.observed, group.observed_interval.low, group.observed_interval.high},
         Number{group.predicted}});
  }
  table.footnotes = {"observed: Wilson's interval. predicted: of the model fitted to all passes."};
  return table;
}

Table model_table(const statistics::LogisticFit& fit) {
  Table table;
  table.name = "gate_model";
  table.title = "With the least certificate before the gate as second predictor";
  table.columns = {text_column("term", "term"),
                   number_column("estimate", "estimate"),
                   number_column("std.error", "SE"),
                   p_column(),
                   number_column("conf.low", "low"),
                   number_column("conf.high", "high")};
  for (const statistics::LogisticCoefficient& one : fit.coefficients) {
    table.add_row({one.column,
                   number_cell(one.estimate),
                   number_cell(one.standard_error),
                   p_cell(one.p_value),
                   low_cell(one.interval),
                   high_cell(one.interval)});
  }
  table.footnotes = {std::to_string(fit.rows) + " passes; Wald intervals; per metre."};
  for (const statistics::Condition& condition : fit.conditions) {
    table.footnotes.push_back(statistics::to_string(condition) + ".");
  }
  return table;
}

Table pass_table(const study::GateStudy& study) {
  Table table;
  table.name = "gate_passes";
  table.title = "The passes";
  table.columns = {text_column("trial_id", "pass"),
                   integer_column("success", "success"),
                   metres("bottleneck_m", "bottleneck margin"),
                   metres("before_m", "certificate before")};
  for (const study::GateRow& row : study.rows) {
    table.add_row({row.trial_id,
                   row.success ? integer_cell(*row.success ? 1 : 0) : TableCell{},
                   number_cell(row.pass.bottleneck_m),
                   row.pass.before_m && *row.pass.before_m > -kInfinity
                       ? number_cell(row.pass.before_m)
                       : TableCell{}});
  }
  return table;
}

Table curve_table(const study::GateStudy& study) {
  Table table;
  table.name = "gate_curve";
  table.title = "Fitted chance to pass";
  table.columns = {metres("margin_m", "margin"), {"chance", "chance", "", ColumnKind::estimate, 3}};
  for (const study::GateChance& one : study.curve) {
    table.add_row(
        {Number{one.margin_m}, Estimate{one.chance, one.interval.low, one.interval.high}});
  }
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
  return report;
}

}  // namespace tcert
