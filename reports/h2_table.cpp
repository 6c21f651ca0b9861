#include "reports/h2_table.hpp"

#include <string>
#include <utility>

#include "reports/fit/interval_columns.hpp"
#include "reports/h1_intervals.hpp"
#include "reports/h1_within_table.hpp"
#include "reports/h2_notes.hpp"
#include "reports/panel_rows.hpp"

namespace tcert {
namespace {

using study::H2Level;
using study::H2Panel;

std::string level_text(const study::H2Table& h2) { return h1_interval_text(h2.options.trials); }

/// AUC or C of a panel.
struct Quantity {
  std::string panel_name;
  std::string name;
  const H2Panel& panel;
  const study::H2Equality& equality;
};

std::vector<Quantity> quantities_of(const study::H2Table& h2) {
  std::vector<Quantity> all;
  for (const H2Panel& panel : h2.panels) {
    if (panel.auc) {
      all.push_back({panel_name(h2, panel), "AUC", panel, *panel.auc});
    }
    if (panel.c) {
      all.push_back({panel_name(h2, panel), "C", panel, *panel.c});
    }
  }
  return all;
}

template <class Row>
ColumnsOf<Row> quantity_columns() {
  return ColumnsOf<Row>()
      .text("panel", "panel", [](const Quantity& r) { return r.panel_name; })
      .text("quantity", "of", [](const Quantity& r) { return r.name; });
}

/// Two groups of a quantity.
struct Groups : Quantity {
  std::size_t first;
  std::size_t second;

  [[nodiscard]] bool is_withheld() const {
    return !panel.levels[first].withheld.empty() || !panel.levels[second].withheld.empty();
  }
};

ColumnsOf<Groups> group_columns() {
  return quantity_columns<Groups>()
      .text("first", "first", [](auto& r) { return r.equality.groups.names[r.first]; })
      .text("second", "second", [](auto& r) { return r.equality.groups.names[r.second]; });
}

Table pair_table(const study::H2Table& h2) {
  using Pair = statistics::EquivalencePair;
  struct Row : Groups {
    const Pair& pair;
  };
  const auto tests = ColumnsOf<Pair>()
                         .fixed("std_error", "SE", &Pair::standard_error)
                         .p("p_tost", "p of equivalence", &Pair::p_value)
                         .yes_or_no("equivalent", "equivalent", &Pair::equivalent)
                         .fixed("smallest_margin", "smallest margin", &Pair::smallest_margin);
  const auto columns =
      ColumnsOf<Row>()
          .part(group_columns(), [](auto& r) { return static_cast<const Groups*>(&r); })
          .estimate("difference",
                    "difference [90 %]",
                    [](auto& r) {
                      return Estimated(
                          r.pair.difference,
                          r.is_withheld() ? std::nullopt : std::optional(r.pair.interval));
                    })
          .part(tests, [](auto& r) { return r.is_withheld() ? nullptr : &r.pair; });
  Table table = columns.table("h2_pairs", "H2: differences of all pairs, with 90 % intervals");
  for (const Quantity& of : quantities_of(h2)) {
    for (const Pair& pair : of.equality.tests.pairs) {
      table.add_row(columns.row({{of, pair.first, pair.second}, pair}));
    }
  }
  return table;
}

Table interaction_table(const study::H2Table& h2) {
  using study::H2Interaction;
  struct Row {
    std::string panel;
    std::string test;
    const H2Interaction& one;

    const H2Interaction& operator*() const noexcept { return one; }
  };
  const auto columns = ColumnsOf<Row>()
                           .text("panel", "panel", &Row::panel)
                           .text("model", "model", &H2Interaction::model)
                           .text("test", "test", &Row::test)
                           .part(chi_square_columns("p"), &H2Interaction::test);
  Table table = columns.table("h2_interaction",
                              "H2: does the effect of the predictor differ between groups?");
  for (const H2Panel& panel : h2.panels) {
    for (const H2Interaction& one : panel.interactions) {
      table.add_row(columns.row({panel_name(h2, panel), "cluster-robust Wald", one}));
    }
    if (const auto& one = panel.mixed_interaction) {
      table.add_row(columns.row({panel_name(h2, panel), "likelihood ratio", *one}));
    }
  }
  table.footnotes = {
      "Group x predictor beside both by themselves. A robust Wald test of few clusters rejects too "
      "often."};
  return table;
}

/// Those of the first panel that has strata: one that cannot be scored has none.
std::string within_columns(const study::H2Table& h2) {
  for (const H2Panel& panel : h2.panels) {
    if (!panel.trials.within.columns.empty()) {
      return h1_within_columns(panel.trials);
    }
  }
  return "";
}

ColumnsOf<InPanel<H2Level, H2Panel>> level_columns(const std::string& heading) {
  return panel_columns<H2Level, H2Panel>().text("group", heading, &H2Level::name);
}

/// Beside the whole group, pairs of trials of one stratum.
Table within_table(const study::H2Table& h2) {
  const std::string level = " within [" + level_text(h2) + "]";
  const auto columns = level_columns(h2.options.trials.group)
                           .fixed("auc", "AUC", [](auto& r) { return r->auc.value; })
                           .estimate("auc_within", "AUC" + level, &H2Level::auc_within)
                           .fixed("c", "C", [](auto& r) { return r->c.value; })
                           .estimate("c_within", "C" + level, &H2Level::c_within);
  Table table = columns.table("h2_within",
                              "H2, within " + within_columns(h2) + ": " +
                                  h2.options.trials.predictors.front().column + " by " +
                                  h2.options.trials.group,
                              rows_of(h2, &H2Panel::levels));
  for (const H2Panel& panel : h2.panels) {
    if (!panel.trials.within.columns.empty()) {
      table.footnotes.push_back(h1_within_note(panel.trials, panel_name(h2, panel)));
    }
  }
  return table;
}

Table interval_table(const study::H2Table& h2) {
  std::vector<NamedScore> scores;
  for (const auto& row : rows_of(h2, &H2Panel::levels)) {
    scores.push_back({row.name, row->name, "AUC", &row->auc});
    scores.push_back({row.name, row->name, "C", &row->c});
    scores.push_back({row.name, row->name, "AUC within strata", &row->auc_within});
    scores.push_back({row.name, row->name, "C within strata", &row->c_within});
  }
  return score_interval_table("h2_intervals", "group", h2.options.trials.group, scores);
}

Table closed_form_table(const study::H2Table& h2) {
  return level_columns("group")
      .part(closed_form_columns("auc", "SE of AUC"), [](auto& r) { return &r->auc; })
      .part(closed_form_columns("c", "SE of C"), [](auto& r) { return &r->c; })
      .p("or_p", "p of OR", [](auto& r) { return r->odds.p_value; })
      .p("hr_censored_p", "p of HR, censored", [](auto& r) { return r->censored.p_value; })
      .p("hr_at_limit_p", "p of HR, at limit", [](auto& r) { return r->at_limit.p_value; })
      .p("hr_stratified_p", "p of HR, stratified", [](auto& r) { return r->stratified.p_value; })
      .part(closed_form_columns("auc_within", "SE of AUC within"),
            [](auto& r) { return &r->auc_within; })
      .part(closed_form_columns("c_within", "SE of C within"), [](auto& r) { return &r->c_within; })
      .table("h2_closed_form", "Closed forms by cluster", rows_of(h2, &H2Panel::levels));
}

/// Every entry of the joint covariances, one a row.
Table covariance_table(const study::H2Table& h2) {
  const auto columns = group_columns().number("covariance", "covariance", [](auto& r) {
    return r.is_withheld()
               ? std::nullopt
               : std::optional(r.equality.groups.covariance(static_cast<Eigen::Index>(r.first),
                                                            static_cast<Eigen::Index>(r.second)));
  });
  Table table = columns.table("h2_covariance", "Covariance of the groups' AUCs and Cs");
  for (const Quantity& of : quantities_of(h2)) {
    for (std::size_t i = 0; i < of.equality.groups.names.size(); ++i) {
      for (std::size_t j = i; j < of.equality.groups.names.size(); ++j) {
        table.add_row(columns.row({of, i, j}));
      }
    }
  }
  return table;
}

void add_conditions(const study::H2Table& h2, FitReport& report) {
  for (const H2Panel& panel : h2.panels) {
    report.add(panel.trials.conditions);
    report.add(panel.conditions);
    for (const H2Level& level : panel.levels) {
      for (statistics::Condition condition : level.conditions) {
        // One group without an estimate leaves those of the others.
        if (condition.severity == statistics::ConditionSeverity::error) {
          condition.severity = statistics::ConditionSeverity::warning;
        }
        condition.detail = level.name + (condition.detail.empty() ? "" : ": " + condition.detail);
        report.conditions.push_back(std::move(condition));
      }
    }
  }
}

/// AUC, C, odds and hazard ratios of each group.
Table level_table(const study::H2Table& h2) {
  Table table = level_columns(h2.options.trials.group)
                    .integer("n", "n", &H2Level::trials)
                    .integer("events", "successes", &H2Level::successes)
                    .integer("clusters", "clusters", &H2Level::clusters)
                    .estimate("auc", "AUC [" + level_text(h2) + "]", &H2Level::auc)
                    .estimate("c", "C [" + level_text(h2) + "]", &H2Level::c)
                    .estimate("or", "OR per SD", &H2Level::odds)
                    .estimate("hr_censored", "HR per SD, failures censored", &H2Level::censored)
                    .estimate("hr_at_limit", "HR, failures at limit", &H2Level::at_limit)
                    .estimate("hr_stratified", "HR, stratified", &H2Level::stratified)
                    .table("h2",
                           "H2: " + h2.options.trials.predictors.front().column + " by " +
                               h2.options.trials.group,
                           rows_of(h2, &H2Panel::levels));
  table.n = static_cast<std::int64_t>(h2.trials);
  table.footnotes = h2_level_notes(h2);
  return table;
}

/// Are the groups equivalent, are they different: one row for AUC and one for C.
Table equality_table(const study::H2Table& h2) {
  using Tests = statistics::Equivalence;
  using Range = statistics::RangeUnderEquality;
  const auto tests = ColumnsOf<Tests>()
                         .fixed("margin", "margin", [](auto& one) { return one.options.margin; })
                         .yes_or_no("equivalent", "equivalent", &Tests::equivalent)
                         .p("p_tost", "p of equivalence", &Tests::p_value)
                         .fixed("smallest_margin", "smallest margin", &Tests::smallest_margin)
                         .fixed("margin_80", "margin with 80 % power", &Tests::margin_with_power)
                         .part(chi_square_columns("p", "p of a difference"), &Tests::heterogeneity)
                         .fixed("range", "max - min", &Tests::range);
  const auto range = ColumnsOf<Range>()
                         .fixed("range_expected", "expected if equal", &Range::expected)
                         .fixed("range_95", "95 % below", &Range::upper)
                         .p("range_p", "p by permutation", &Range::p_value);
  Table table = quantity_columns<Quantity>()
                    .part(tests, [](auto& r) { return &r.equality.tests; })
                    .part(range, [](auto& r) { return &r.equality.range; })
                    .table("h2_equality", "H2: equality of the groups", quantities_of(h2));
  table.footnotes = h2_equality_notes(h2);
  return table;
}

}  // namespace

FitReport h2_report(const study::H2Table& h2) {
  const study::H1Options& options = h2.options.trials;
  FitReport report;
  report.model = "h2";
  Record summary("summary", "Options");
  summary.integer("trials", "trials", h2.trials)
      .integer("outcome_missing", "without outcome", h2.outcome_missing)
      .text("predictor", "predictor", options.predictors.front().column)
      .text("group", "group", options.group)
      .text("success", "outcome", options.success)
      .text("time", "time", options.time)
      .text("cluster", "cluster", options.cluster)
      .text("strata", "strata", options.strata)
      .text("within", "within", within_columns(h2))
      .text("interval", "interval", std::string(statistics::to_string(options.interval)))
      .number("landmark_s", "landmark [s]", options.landmark_s)
      .number("margin", "margin", h2.options.margin)
      .number("level", "level", options.level)
      .integer("replicates", "replicates", options.replicates)
      .integer("permutations", "permutations", h2.options.permutations)
      .integer("seed", "seed", options.seed);
  report.summary = std::move(summary).table();
  report.tables = {level_table(h2)};
  if (!within_columns(h2).empty()) {
    report.tables.push_back(within_table(h2));
  }
  report.tables.insert(report.tables.end(),
                       {equality_table(h2), pair_table(h2), interaction_table(h2)});
  report.details = {interval_table(h2), closed_form_table(h2), covariance_table(h2)};
  add_conditions(h2, report);
  return report;
}

}  // namespace tcert
