#include "reports/h3_table.hpp"

#include <string>
#include <utility>
#include <vector>

#include "reports/fit/cells.hpp"
#include "reports/h1_intervals.hpp"

namespace tcert {
namespace {

TableCell estimate(const study::H3Estimate& one) { return estimate_cell(one.value, one.interval); }

std::string percent(double fraction) { return significant(100.0 * fraction, kShownDigits) + " %"; }

std::vector<std::string> notes(const study::H3Table& h3) {
  const study::H3Options& o = h3.options;
  std::vector<std::string> notes = {
      "A replay can only lose successes: it cannot see failures that speed would cause.",
      "Laws: squash is that of section 3.5, on the tick margin; clip that of 4.4 (G1), on the "
      "robust margin, where the guards G2 and G3 halt.",
      "Rates: total length over total time of the trials that succeed ungated, standing still "
      "included; a stall counts at the retreat speed, so that no trial drops out of the pair. "
      "Commanded speed: median of the trials' medians.",
      "Gain: gated less ungated '" + o.gated + "', the same trials. Gap: '" + o.baseline +
          "' less ungated '" + o.gated + "', '" + o.baseline +
          "' standardised to the lightings of '" + o.gated +
          "': its rate under each, weighted by the metres that '" + o.gated +
          "' drove there, so that the gap does not hold what light each happened to run in (the "
          "gap "
          "as run is in h3_intervals). The share that is recovered is NA unless the gap's interval "
          "excludes 0.",
      "Intervals of rates, gains and shares: " + interval_words(o.interval) + ", " +
          percent(o.level) + ", " + std::to_string(o.replicates) + " resamples of whole '" +
          (o.cluster.empty() ? "trial" : o.cluster) +
          "' clusters of both algorithms jointly, seed " + std::to_string(o.seed) + ".",
      "Lost: successes that stall or pass the trial limit, of all trials. Non-inferior: the "
      "one-sided " +
          percent(o.level) + " Clopper-Pearson bound of that loss is below " +
          percent(o.loss_margin) +
          ". Retained: of the successes, Wilson. Both take trials as independent.",
      "Front: on the Pareto front of {relative gain, retained} within its lighting."};
  if (h3.unknown > 0) {
    notes.push_back(std::to_string(h3.unknown) + " trials without an outcome are left out.");
  }
  for (const study::H3Group& group : h3.groups) {
    if (group.baseline.value && group.ungated.value && !group.gap.value) {
      notes.push_back(group.lighting + ": no gap, for '" + o.baseline +
                      "' has no success under a lighting in which '" + o.gated + "' has one.");
    }
    for (const statistics::Condition& condition : group.conditions) {
      notes.push_back(group.lighting + ": " + statistics::to_string(condition) + ".");
    }
  }
  return notes;
}

}  // namespace

Table h3_table(const study::H3Table& h3) {
  Table table;
  table.name = "h3";
  table.title = "H3: speed gated by the margin, against '" + h3.options.baseline + "'";
  table.columns = {text_column("lighting", "lighting"),
                   text_column("speed_law", "law"),
                   fixed_column("beta_per_m", "beta", "1/m", 0),
                   estimate_column("gated_m_per_min", "gated", "m/min", 2),
                   estimate_column("gain_m_per_min", "gain", "m/min", 2),
                   estimate_column("gain_share",
                                   "relative gain [" +
                                       interval_text(h3.options.interval, h3.options.level) + "]",
                                   "",
                                   3),
                   estimate_column("gap_recovered", "share of gap", "", 2),
                   fixed_column("gated_speed_cmd_mps", "commanded", "m/s", 3),
                   integer_column("lost", "lost"),
                   fixed_column("lost_share", "share lost", "", 3),
                   fixed_column("lost_upper", "bound", "", 3),
                   text_column("non_inferior", "non-inferior"),
                   estimate_column("retained", "retained", "", 3),
                   integer_column("stalls", "stalls"),
                   integer_column("stalled_trials", "trials with stalls"),
                   text_column("on_front", "front")};
  for (const study::H3Group& group : h3.groups) {
    for (const study::H3Case& one : group.cases) {
      table.add_row({group.lighting,
                     one.law,
                     Number{one.beta_per_m},
                     estimate(one.gated),
                     estimate(one.gain),
                     estimate(one.gain_share),
                     estimate(one.recovered),
                     number_cell(one.speed_cmd_mps),
                     integer_cell(one.lost),
                     number_cell(one.lost_share),
                     number_cell(one.lost_upper),
                     yes_or_no_cell(one.non_inferior),
                     estimate_cell(one.retained, one.retained_interval),
                     integer_cell(one.stalls),
                     integer_cell(one.stalled_trials),
                     yes_or_no_cell(one.on_front)});
    }
  }
  table.n =
      h3.groups.empty()
          ? 0
          : static_cast<std::int64_t>(h3.groups.front().trials + h3.groups.front().baseline_trials);
  table.footnotes = notes(h3);
  return table;
}

Table h3_baseline_table(const study::H3Table& h3) {
  Table table;
  table.name = "h3_baseline";
  table.title = "Ungated rates of advance";
  table.columns = {
      text_column("lighting", "lighting"),
      integer_column("trials", h3.options.gated + " trials"),
      integer_column("successes", "successes"),
      integer_column("baseline_trials", h3.options.baseline + " trials"),
      integer_column("baseline_successes", "successes"),
      integer_column("clusters", "clusters"),
      estimate_column("ungated_m_per_min", h3.options.gated, "m/min", 2),
      estimate_column("baseline_m_per_min", h3.options.baseline, "m/min", 2),
      estimate_column("baseline_standardised_m_per_min",
                      h3.options.baseline + " at the lightings of " + h3.options.gated,
                      "m/min",
                      2),
      estimate_column("gap_m_per_min", "gap", "m/min", 2),
      fixed_column("speed_cmd_mps", h3.options.gated + " commanded", "m/s", 3),
      fixed_column("baseline_speed_cmd_mps", h3.options.baseline + " commanded", "m/s", 3),
      fixed_column("loop_latency_ms", "latency p50", "ms", 2)};
  for (const study::H3Group& group : h3.groups) {
    table.add_row({group.lighting,
                   integer_cell(group.trials),
                   integer_cell(group.successes),
                   integer_cell(group.baseline_trials),
                   integer_cell(group.baseline_successes),
                   integer_cell(group.clusters),
                   estimate(group.ungated),
                   estimate(group.baseline),
                   estimate(group.baseline_standardised),
                   estimate(group.gap),
                   number_cell(group.speed_cmd_mps),
                   number_cell(group.baseline_speed_cmd_mps),
                   number_cell(group.latency_ms)});
  }
  table.footnotes = {
      "Latency: median of the trials' medians of the policy loop, as logged; a replay does not "
      "change it."};
  return table;
}

namespace {

/// Every interval, and the gap as it ran.
Table interval_table(const study::H3Table& h3) {
  Table table;
  table.name = "h3_intervals";
  table.title = "Bootstrap intervals of the same resamples by three methods";
  table.columns = {text_column("lighting", "lighting"),
                   text_column("speed_law", "law"),
                   fixed_column("beta_per_m", "beta", "1/m", 0),
                   text_column("quantity", "of"),
                   number_column("estimate", "estimate")};
  const std::vector<Column> ends = interval_columns();
  table.columns.insert(table.columns.end(), ends.begin(), ends.end());
  for (const study::H3Group& group : h3.groups) {
    const auto add =
        [&](const study::H3Case* one, const char* quantity, const study::H3Estimate& found) {
          if (!found.value) {
            return;
          }
          std::vector<TableCell> cells{
              group.lighting,
              one != nullptr ? TableCell{one->law} : TableCell{},
              one != nullptr ? TableCell{Number{one->beta_per_m}} : TableCell{},
              std::string(quantity),
              number_cell(found.value)};
          append_intervals(found.intervals, cells);
          table.add_row(std::move(cells));
          std::string of = group.lighting;
          if (one != nullptr) {
            of += ", " + one->law + ", beta " + significant(one->beta_per_m, kShownDigits);
          }
          add_no_bca(of.append(", ").append(quantity), found.intervals, table);
        };
    add(nullptr, "ungated", group.ungated);
    add(nullptr, "baseline", group.baseline);
    add(nullptr, "baseline standardised", group.baseline_standardised);
    add(nullptr, "gap", group.gap);
    add(nullptr, "gap as run", group.gap_as_run);
    for (const study::H3Case& one : group.cases) {
      add(&one, "gated", one.gated);
      add(&one, "gain", one.gain);
      add(&one, "relative gain", one.gain_share);
      add(&one, "share of gap", one.recovered);
    }
  }
  return table;
}

}  // namespace

FitReport h3_report(const study::H3Table& h3) {
  FitReport report;
  report.model = "h3";
  Record summary("summary", "Options");
  summary.text("gated", "gated", h3.options.gated)
      .text("baseline", "baseline", h3.options.baseline)
      .text("cluster", "cluster", h3.options.cluster)
      .number("level", "level", h3.options.level)
      .number("loss_margin", "loss margin", h3.options.loss_margin)
      .text("interval", "interval", std::string(statistics::to_string(h3.options.interval)))
      .integer("replicates", "replicates", h3.options.replicates)
      .integer("seed", "seed", h3.options.seed)
      .integer("outcome_missing", "without outcome", h3.unknown);
  report.summary = std::move(summary).table();
  report.tables = {h3_table(h3), h3_baseline_table(h3)};
  report.details = {interval_table(h3)};
  report.conditions = h3.conditions;
  for (const study::H3Group& group : h3.groups) {
    report.conditions.insert(
        report.conditions.end(), group.conditions.begin(), group.conditions.end());
  }
  return report;
}

}  // namespace tcert
