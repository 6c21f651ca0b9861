#include "reports/h3_table.hpp"

#include <string>
#include <utility>
#include <vector>

#include "reports/h1_intervals.hpp"
#include "reports/h3_chosen_table.hpp"
#include "reports/hypothesis_conditions.hpp"
#include "reports/hypothesis_findings.hpp"

namespace tcert {
namespace {

using study::H3Case;
using study::H3Group;

std::string percent(double fraction) { return significant(100.0 * fraction, kShownDigits) + " %"; }

std::vector<std::string> notes(const study::H3Table& h3) {
  const study::H3Options& o = h3.options;
  std::vector<std::string> notes = {
      "A replay can only lose successes: it cannot see failures that speed would cause.",
      ("Laws: squash is that of section 3.5, on the tick margin; clip that of 4.4 (G1), on the "
       "robust margin, where the guards G2 and G3 halt."),
      ("Rates: total length over total time of the trials that succeed ungated, standing still "
       "included; a stall counts at the retreat speed, so that no trial drops out of the pair. "
       "Commanded speed: median of the trials' medians."),
      "Gain: gated less ungated '" + o.gated + "', the same trials. Gap: '" + o.baseline +
          "' less ungated '" + o.gated + "', '" + o.baseline +
          "' standardised to the lightings of '" + o.gated +
          "': its rate under each, weighted by the metres that '" + o.gated +
          "' drove there, so that the gap does not hold what light each happened to run in (as run "
          "it "
          "is in h3_intervals). The share that is recovered is NA unless the gap's interval "
          "excludes 0.",
      "Intervals of rates, gains and shares: " + interval_words(o.interval) + ", " +
          percent(o.level) + ", " + std::to_string(o.replicates) + " resamples of whole '" +
          (o.cluster.empty() ? "trial" : o.cluster) +
          "' clusters of both algorithms jointly, seed " + std::to_string(o.seed) + ".",
      "Lost: successes that stall or pass the trial limit, of all trials. Non-inferior: the "
      "one-sided " +
          percent(o.level) + " Clopper-Pearson bound of that loss is below " +
          percent(o.loss_margin) +
          ". Retained: of the successes, Wilson. Both of so many fewer trials as those of a "
          "cluster "
          "are alike (design effect): in what is lost or in what failed, whichever is more alike.",
      "Front: on the Pareto front of {relative gain, retained} within its lighting."};
  if (h3.unknown > 0) {
    notes.push_back(std::to_string(h3.unknown) + " trials without an outcome are left out.");
  }
  for (const H3Group& group : h3.groups) {
    if (group.baseline.value && group.ungated.value && !group.gap.value) {
      notes.push_back(group.lighting + ": no gap, for '" + o.baseline +
                      "' has no success under a lighting in which '" + o.gated + "' has one.");
    }
  }
  return notes;
}

struct LightingCase : RowOf<H3Case> {
  const H3Group& group;
};

Table case_table(const study::H3Table& h3) {
  const std::string level = interval_text(h3.options.interval, h3.options.level);
  const auto columns =
      ColumnsOf<LightingCase>()
          .text("lighting", "lighting", [](auto& r) { return r.group.lighting; })
          .text("speed_law", "law", &H3Case::law)
          .fixed("beta_per_m", "beta", "1/m", 0, &H3Case::beta_per_m)
          .estimate("gain_m_per_min", "gain", "m/min", 2, &H3Case::gain)
          .estimate("gap_recovered", "share of gap", "", 2, &H3Case::recovered)
          .integer("lost", "lost", &H3Case::lost)
          .fixed("lost_share", "share lost", &H3Case::lost_share)
          .fixed("lost_upper", "bound", &H3Case::lost_upper)
          .yes_or_no("non_inferior", "non-inferior", &H3Case::non_inferior)
          .estimate("gated_m_per_min", "gated", "m/min", 2, &H3Case::gated)
          .estimate("gain_share", "relative gain [" + level + "]", &H3Case::gain_share)
          .fixed("gated_speed_cmd_mps", "commanded", "m/s", 3, &H3Case::speed_cmd_mps)
          .estimate("retained",
                    "retained",
                    [](auto& r) { return Estimated(r.of.retained, r.of.retained_interval); })
          .fixed("design_effect", "design effect", "", 2, &H3Case::design_effect)
          .integer("stalls", "stalls", &H3Case::stalls)
          .integer("stalled_trials", "trials with stalls", &H3Case::stalled_trials)
          .yes_or_no("on_front", "front", &H3Case::on_front);
  Table table =
      columns.table("h3", "H3: speed gated by the margin, against '" + h3.options.baseline + "'");
  for (const H3Group& group : h3.groups) {
    for (const H3Case& one : group.cases) {
      table.add_row(columns.row({{one}, group}));
    }
  }
  table.n =
      h3.groups.empty()
          ? 0
          : static_cast<std::int64_t>(h3.groups.front().trials + h3.groups.front().baseline_trials);
  table.footnotes = notes(h3);
  return table;
}

Table baseline_table(const study::H3Table& h3) {
  const std::string& gated = h3.options.gated;
  const std::string& baseline = h3.options.baseline;
  const std::string standardised = baseline + " at the lightings of " + gated;
  Table table = ColumnsOf<H3Group>()
                    .text("lighting", "lighting", &H3Group::lighting)
                    .integer("trials", gated + " trials", &H3Group::trials)
                    .integer("successes", "successes", &H3Group::successes)
                    .integer("baseline_trials", baseline + " trials", &H3Group::baseline_trials)
                    .integer("baseline_successes", "successes", &H3Group::baseline_successes)
                    .integer("clusters", "clusters", &H3Group::clusters)
                    .estimate("ungated_m_per_min", gated, "m/min", 2, &H3Group::ungated)
                    .estimate("baseline_m_per_min", baseline, "m/min", 2, &H3Group::baseline)
                    .estimate("baseline_standardised_m_per_min",
                              standardised,
                              "m/min",
                              2,
                              &H3Group::baseline_standardised)
                    .estimate("gap_m_per_min", "gap", "m/min", 2, &H3Group::gap)
                    .fixed("speed_cmd_mps", gated + " commanded", "m/s", 3, &H3Group::speed_cmd_mps)
                    .fixed("baseline_speed_cmd_mps",
                           baseline + " commanded",
                           "m/s",
                           3,
                           &H3Group::baseline_speed_cmd_mps)
                    .fixed("loop_latency_ms", "latency p50", "ms", 2, &H3Group::latency_ms)
                    .table("h3_baseline", "Ungated rates of advance", h3.groups);
  table.footnotes = {
      "Latency: median of the trials' medians of the policy loop, as logged; a replay does not "
      "change it."};
  return table;
}

/// Every interval, and the gap as it ran.
Table interval_table(const study::H3Table& h3) {
  struct Row {
    const H3Group& group;
    const H3Case* one;  ///< Null of what is the group's.
    std::string quantity;
    const study::H3Estimate& found;

    [[nodiscard]] std::string name() const {
      return group.lighting + ", " +
             (one == nullptr
                  ? ""
                  : one->law + ", beta " + significant(one->beta_per_m, kShownDigits) + ", ") +
             quantity;
    }
  };
  const auto law = ColumnsOf<H3Case>()
                       .text("speed_law", "law", &H3Case::law)
                       .fixed("beta_per_m", "beta", "1/m", 0, &H3Case::beta_per_m);
  const auto columns = ColumnsOf<Row>()
                           .text("lighting", "lighting", [](auto& r) { return r.group.lighting; })
                           .part(law, &Row::one)
                           .text("quantity", "of", &Row::quantity)
                           .number("estimate", "estimate", [](auto& r) { return r.found.value; })
                           .part(bootstrap_columns(), [](auto& r) { return &r.found.intervals; });
  Table table =
      columns.table("h3_intervals", "Bootstrap intervals of the same resamples by three methods");
  for (const H3Group& group : h3.groups) {
    const auto add = [&](const H3Case* one, const char* quantity, const study::H3Estimate& found) {
      if (found.value) {
        const Row row{group, one, quantity, found};
        table.add_row(columns.row(row));
        add_no_bca(row.name(), found.intervals, table);
      }
    };
    add(nullptr, "ungated", group.ungated);
    add(nullptr, "baseline", group.baseline);
    add(nullptr, "baseline standardised", group.baseline_standardised);
    add(nullptr, "gap", group.gap);
    add(nullptr, "gap as run", group.gap_as_run);
    for (const H3Case& one : group.cases) {
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
      .number("true_loss", "true loss of the power", h3.options.true_loss)
      .number("beta_per_m", "beta [1/m]", h3.options.beta.per_m)
      .integer(
          "beta_folds", "folds that choose beta", h3.options.beta.per_m ? 1 : h3.options.beta.folds)
      .text("interval", "interval", std::string(statistics::to_string(h3.options.interval)))
      .integer("replicates", "replicates", h3.options.replicates)
      .integer("seed", "seed", h3.options.seed)
      .integer("outcome_missing", "without outcome", h3.unknown);
  report.summary = std::move(summary).table();
  report.tables = {case_table(h3), h3_chosen_table(h3), baseline_table(h3)};
  report.details = {interval_table(h3)};
  report.conditions = conditions_of(h3);
  report.findings = h3_findings(h3);
  return report;
}

}  // namespace tcert
