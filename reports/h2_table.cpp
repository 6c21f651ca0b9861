#include "reports/h2_table.hpp"

#include <string>
#include <utility>

#include "reports/fit/cells.hpp"
#include "reports/h1_intervals.hpp"
#include "reports/h1_within_table.hpp"
#include "reports/h2_notes.hpp"

namespace tcert {
namespace {

TableCell estimate(const study::H1Score& score) {
  return estimate_cell(score.value, score.interval);
}
TableCell ratio(const study::H1HazardRatio& one) { return estimate_cell(one.ratio, one.interval); }

std::string level_text(const study::H2Table& h2) { return h1_interval_text(h2.options.trials); }

std::optional<double> statistic(const std::optional<statistics::ChiSquareTest>& test) {
  return test ? std::optional(test->statistic) : std::nullopt;
}
std::optional<double> p_value(const std::optional<statistics::ChiSquareTest>& test) {
  return test ? std::optional(test->p_value) : std::nullopt;
}
TableCell df(const std::optional<statistics::ChiSquareTest>& test) {
  return test ? integer_cell(test->df) : TableCell{};
}

/// AUC and C of a panel, those that there are.
std::vector<std::pair<std::string, const study::H2Equality*>> equalities(
    const study::H2Panel& panel) {
  std::vector<std::pair<std::string, const study::H2Equality*>> all;
  if (panel.auc) {
    all.emplace_back("AUC", &*panel.auc);
  }
  if (panel.c) {
    all.emplace_back("C", &*panel.c);
  }
  return all;
}

bool is_withheld(const study::H2Panel& panel, std::size_t level) {
  return !panel.levels[level].withheld.empty();
}

Table pair_table(const study::H2Table& h2) {
  Table table;
  table.name = "h2_pairs";
  table.title = "H2: differences of all pairs, with 90 % intervals";
  table.columns = {text_column("panel", "panel"),
                   text_column("quantity", "of"),
                   text_column("first", "first"),
                   text_column("second", "second"),
                   estimate_column("difference", "difference [90 %]"),
                   fixed_column("std_error", "SE"),
                   p_column("p_tost", "p of equivalence"),
                   text_column("equivalent", "equivalent"),
                   fixed_column("smallest_margin", "smallest margin")};
  for (const study::H2Panel& panel : h2.panels) {
    for (const auto& [quantity, equality] : equalities(panel)) {
      for (const statistics::EquivalencePair& pair : equality->tests.pairs) {
        if (is_withheld(panel, pair.first) || is_withheld(panel, pair.second)) {
          table.add_row({h2_panel_name(h2, panel),
                         quantity,
                         equality->groups.names[pair.first],
                         equality->groups.names[pair.second],
                         estimate_cell(pair.difference, std::nullopt),
                         TableCell{},
                         TableCell{},
                         TableCell{},
                         TableCell{}});
          continue;
        }
        table.add_row({h2_panel_name(h2, panel),
                       quantity,
                       equality->groups.names[pair.first],
                       equality->groups.names[pair.second],
                       estimate_cell(pair.difference, pair.interval),
                       number_cell(pair.standard_error),
                       p_cell(pair.p_value),
                       yes_or_no_cell(pair.equivalent),
                       number_cell(pair.smallest_margin)});
      }
    }
  }
  return table;
}

Table interaction_table(const study::H2Table& h2) {
  Table table;
  table.name = "h2_interaction";
  table.title = "H2: does the effect of the predictor differ between groups?";
  table.columns = {text_column("panel", "panel"),
                   text_column("model", "model"),
                   text_column("test", "test"),
                   number_column("statistic", "chi-squared"),
                   integer_column("df", "df"),
                   p_column("p", "p")};
  for (const study::H2Panel& panel : h2.panels) {
    const auto add = [&](const std::string& model,
                         const char* test,
                         const std::optional<statistics::ChiSquareTest>& one) {
      table.add_row({h2_panel_name(h2, panel),
                     model,
                     std::string(test),
                     number_cell(statistic(one)),
                     df(one),
                     p_cell(p_value(one))});
    };
    for (const study::H2Interaction& one : panel.interactions) {
      add(one.model, "cluster-robust Wald", one.test);
    }
    if (panel.mixed_interaction) {
      add(panel.mixed_interaction->model, "likelihood ratio", panel.mixed_interaction->test);
    }
  }
  table.footnotes = {
      "Group x predictor beside both by themselves. A robust Wald test of few clusters rejects too "
      "often."};
  return table;
}

/// Those of the first panel that has strata: one that cannot be scored has none.
std::string within_columns(const study::H2Table& h2) {
  for (const study::H2Panel& panel : h2.panels) {
    if (!panel.trials.within.columns.empty()) {
      return h1_within_columns(panel.trials);
    }
  }
  return "";
}

/// Beside the whole group, pairs of trials of one stratum.
Table within_table(const study::H2Table& h2) {
  Table table;
  table.name = "h2_within";
  table.title = "H2, within " + within_columns(h2) + ": " +
                h2.options.trials.predictors.front().column + " by " + h2.options.trials.group;
  table.columns = {text_column("panel", "panel"),
                   text_column("group", h2.options.trials.group),
                   fixed_column("auc", "AUC"),
                   estimate_column("auc_within", "AUC within [" + level_text(h2) + "]"),
                   fixed_column("c", "C"),
                   estimate_column("c_within", "C within [" + level_text(h2) + "]")};
  for (const study::H2Panel& panel : h2.panels) {
    for (const study::H2Level& level : panel.levels) {
      table.add_row({h2_panel_name(h2, panel),
                     level.name,
                     number_cell(level.auc.value),
                     estimate(level.auc_within),
                     number_cell(level.c.value),
                     estimate(level.c_within)});
    }
  }
  for (const study::H2Panel& panel : h2.panels) {
    if (!panel.trials.within.columns.empty()) {
      table.footnotes.push_back(h1_within_note(panel.trials, h2_panel_name(h2, panel)));
    }
  }
  return table;
}

Table interval_table(const study::H2Table& h2) {
  Table table = h1_interval_columns("h2_intervals", "group", h2.options.trials.group);
  for (const study::H2Panel& panel : h2.panels) {
    for (const study::H2Level& level : panel.levels) {
      const auto add = [&](const char* quantity, const study::H1Score& score) {
        add_intervals(h2_panel_name(h2, panel), level.name, quantity, score, table);
      };
      add("AUC", level.auc);
      add("C", level.c);
      add("AUC within strata", level.auc_within);
      add("C within strata", level.c_within);
    }
  }
  return table;
}

Table closed_form_table(const study::H2Table& h2) {
  Table table;
  table.name = "h2_closed_form";
  table.title = "Closed forms by cluster";
  table.columns = {text_column("panel", "panel"),
                   text_column("group", "group"),
                   number_column("auc_std_error", "SE of AUC"),
                   number_column("auc_low", "low"),
                   number_column("auc_high", "high"),
                   number_column("c_std_error", "SE of C"),
                   number_column("c_low", "low"),
                   number_column("c_high", "high"),
                   p_column("or_p", "p of OR"),
                   p_column("hr_censored_p", "p of HR, censored"),
                   p_column("hr_at_limit_p", "p of HR, at limit"),
                   p_column("hr_stratified_p", "p of HR, stratified"),
                   number_column("auc_within_std_error", "SE of AUC within"),
                   number_column("auc_within_low", "low"),
                   number_column("auc_within_high", "high"),
                   number_column("c_within_std_error", "SE of C within"),
                   number_column("c_within_low", "low"),
                   number_column("c_within_high", "high")};
  for (const study::H2Panel& panel : h2.panels) {
    for (const study::H2Level& level : panel.levels) {
      table.add_row({h2_panel_name(h2, panel),
                     level.name,
                     number_cell(level.auc.std_error),
                     low_cell(level.auc.closed_form),
                     high_cell(level.auc.closed_form),
                     number_cell(level.c.std_error),
                     low_cell(level.c.closed_form),
                     high_cell(level.c.closed_form),
                     p_cell(level.odds.p_value),
                     p_cell(level.censored.p_value),
                     p_cell(level.at_limit.p_value),
                     p_cell(level.stratified.p_value),
                     number_cell(level.auc_within.std_error),
                     low_cell(level.auc_within.closed_form),
                     high_cell(level.auc_within.closed_form),
                     number_cell(level.c_within.std_error),
                     low_cell(level.c_within.closed_form),
                     high_cell(level.c_within.closed_form)});
    }
  }
  return table;
}

/// Every entry of the joint covariances, one a row.
Table covariance_table(const study::H2Table& h2) {
  Table table;
  table.name = "h2_covariance";
  table.title = "Covariance of the groups' AUCs and Cs";
  table.columns = {text_column("panel", "panel"),
                   text_column("quantity", "of"),
                   text_column("first", "first"),
                   text_column("second", "second"),
                   number_column("covariance", "covariance")};
  for (const study::H2Panel& panel : h2.panels) {
    for (const auto& [quantity, equality] : equalities(panel)) {
      const statistics::GroupEstimates& groups = equality->groups;
      for (std::size_t i = 0; i < groups.names.size(); ++i) {
        for (std::size_t j = i; j < groups.names.size(); ++j) {
          table.add_row({h2_panel_name(h2, panel),
                         quantity,
                         groups.names[i],
                         groups.names[j],
                         is_withheld(panel, i) || is_withheld(panel, j)
                             ? TableCell{}
                             : number_cell(groups.covariance(static_cast<Eigen::Index>(i),
                                                             static_cast<Eigen::Index>(j)))});
        }
      }
    }
  }
  return table;
}

void add_conditions(const study::H2Table& h2, FitReport& report) {
  const auto add = [&](const statistics::Conditions& conditions) {
    report.conditions.insert(report.conditions.end(), conditions.begin(), conditions.end());
  };
  for (const study::H2Panel& panel : h2.panels) {
    add(panel.trials.conditions);
    add(panel.conditions);
    for (const study::H2Level& level : panel.levels) {
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

}  // namespace

Table h2_level_table(const study::H2Table& h2) {
  Table table;
  table.name = "h2";
  table.title =
      "H2: " + h2.options.trials.predictors.front().column + " by " + h2.options.trials.group;
  table.n = static_cast<std::int64_t>(h2.trials);
  table.columns = {text_column("panel", "panel"),
                   text_column("group", h2.options.trials.group),
                   integer_column("n", "n"),
                   integer_column("events", "successes"),
                   integer_column("clusters", "clusters"),
                   estimate_column("auc", "AUC [" + level_text(h2) + "]"),
                   estimate_column("c", "C [" + level_text(h2) + "]"),
                   estimate_column("or", "OR per SD"),
                   estimate_column("hr_censored", "HR per SD, failures censored"),
                   estimate_column("hr_at_limit", "HR, failures at limit"),
                   estimate_column("hr_stratified", "HR, stratified")};
  for (const study::H2Panel& panel : h2.panels) {
    for (const study::H2Level& level : panel.levels) {
      table.add_row({h2_panel_name(h2, panel),
                     level.name,
                     integer_cell(level.trials),
                     integer_cell(level.successes),
                     integer_cell(level.clusters),
                     estimate(level.auc),
                     estimate(level.c),
                     ratio(level.odds),
                     ratio(level.censored),
                     ratio(level.at_limit),
                     ratio(level.stratified)});
    }
  }
  table.footnotes = h2_level_notes(h2);
  return table;
}

Table h2_equality_table(const study::H2Table& h2) {
  Table table;
  table.name = "h2_equality";
  table.title = "H2: equality of the groups";
  table.columns = {text_column("panel", "panel"),
                   text_column("quantity", "of"),
                   fixed_column("margin", "margin"),
                   text_column("equivalent", "equivalent"),
                   p_column("p_tost", "p of equivalence"),
                   fixed_column("smallest_margin", "smallest margin"),
                   fixed_column("margin_80", "margin with 80 % power"),
                   number_column("statistic", "chi-squared"),
                   integer_column("df", "df"),
                   p_column("p", "p of a difference"),
                   fixed_column("range", "max - min"),
                   fixed_column("range_expected", "expected if equal"),
                   fixed_column("range_95", "95 % below"),
                   p_column("range_p", "p by permutation")};
  for (const study::H2Panel& panel : h2.panels) {
    for (const auto& [quantity, equality] : equalities(panel)) {
      const statistics::Equivalence& tests = equality->tests;
      table.add_row({h2_panel_name(h2, panel),
                     quantity,
                     number_cell(tests.options.margin),
                     yes_or_no_cell(tests.equivalent),
                     p_cell(tests.p_value),
                     number_cell(tests.smallest_margin),
                     number_cell(tests.margin_with_power),
                     number_cell(statistic(tests.heterogeneity)),
                     df(tests.heterogeneity),
                     p_cell(p_value(tests.heterogeneity)),
                     number_cell(tests.range),
                     number_cell(equality->range.expected),
                     number_cell(equality->range.upper),
                     p_cell(equality->range.p_value)});
    }
  }
  table.footnotes = h2_equality_notes(h2);
  return table;
}

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
  report.tables = {h2_level_table(h2)};
  if (!within_columns(h2).empty()) {
    report.tables.push_back(within_table(h2));
  }
  report.tables.insert(report.tables.end(),
                       {h2_equality_table(h2), pair_table(h2), interaction_table(h2)});
  report.details = {interval_table(h2), closed_form_table(h2), covariance_table(h2)};
  add_conditions(h2, report);
  return report;
}

}  // namespace tcert
