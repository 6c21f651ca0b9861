#include "reports/h1_table.hpp"

#include <cstdint>
#include <string>

namespace tcert {
namespace {

std::string outcome(bool success) { return success ? "success" : "failure"; }

TableCell integer(std::size_t value) { return static_cast<std::int64_t>(value); }

TableCell number_or_missing(const std::optional<double>& value) {
  return value ? TableCell{Number{*value}} : TableCell{};
}

TableCell share(std::size_t part, std::size_t whole) {
  return whole == 0 ? TableCell{} : Number{static_cast<double>(part) / static_cast<double>(whole)};
}

TableCell estimate(const std::optional<double>& value, const std::optional<Interval>& interval) {
  if (!value) {
    return {};
  }
  Estimate cell{*value};
  if (interval) {
    cell.low = interval->low;
    cell.high = interval->high;
  }
  return cell;
}

std::string joined(const Conditions& conditions) {
  std::string text;
  for (const Condition& condition : conditions) {
    text += (text.empty() ? "" : "; ") + std::string(words(condition.kind));
    text += condition.detail.empty() ? "" : ": " + condition.detail;
  }
  return text;
}

std::string panel_note(const H1Panel& panel) {
  if (panel.kind == H1PanelKind::paper) {
    return "Paper panel: the early window as configured, " + std::to_string(panel.trials) +
           " trials; " + std::to_string(panel.ended_in_window) +
           " of them end inside their window (" + std::to_string(panel.failures_ended_in_window) +
           " failures), which then contains the outcome.";
  }
  return "Landmark panel: the time window alone, " + std::to_string(panel.trials) +
         " trials; excluded: " + std::to_string(panel.ended_by_landmark) +
         " that end before the landmark, " + std::to_string(panel.still_at_landmark) +
         " that stand still at it. Conclusions are drawn from this panel.";
}

}  // namespace

Table h1_table(const H1Table& h1) {
  Table table;
  table.name = "h1";
  table.title = "H1: early certificate margin against contact heuristics";
  table.n = static_cast<std::int64_t>(h1.trials);
  table.columns = {{"panel", "panel", "", ColumnKind::text},
                   {"predictor", "predictor", "", ColumnKind::text},
                   {"better", "better if", "", ColumnKind::text},
                   {"n", "n", "", ColumnKind::integer},
                   {"successes", "successes", "", ColumnKind::integer},
                   {"failures", "failures", "", ColumnKind::integer},
                   {"missing", "missing", "", ColumnKind::integer},
                   {"auc", "AUC [95 % CI]", "", ColumnKind::estimate, 3},
                   {"tc_gain", "gain of TC [95 % CI]", "", ColumnKind::estimate, 3},
                   {"p", "p", "", ColumnKind::p_value},
                   {"conditions", "conditions", "", ColumnKind::text}};
  for (const H1Panel& panel : h1.panels) {
    for (const H1Row& row : panel.rows) {
      const auto& gain = row.tc_gain;
      std::string conditions = joined(row.auc.conditions);
      if (gain && !gain->conditions.empty()) {
        conditions += (conditions.empty() ? "" : "; ") + joined(gain->conditions);
      }
      table.add_row({std::string(to_string(panel.kind)),
                     std::string(row.predictor),
                     std::string(row.higher == HigherMeans::success ? "larger" : "smaller"),
                     integer(panel.complete),
                     integer(row.auc.successes),
                     integer(row.auc.failures),
                     integer(row.missing),
                     estimate(row.auc.auc, row.auc.interval),
                     gain ? estimate(gain->difference, gain->interval) : TableCell{},
                     gain && gain->p_value ? TableCell{PValue{*gain->p_value}} : TableCell{},
                     conditions});
    }
    table.footnotes.push_back(panel_note(panel));
  }
  table.footnotes.emplace_back(
      "AUC: Pr(a success outranks a failure) in the a-priori direction, ties one half, on the rows "
      "where all predictors are known; intervals and p by DeLong, two-sided, not adjusted for "
      "multiplicity, trials of one day taken as independent.");
  if (h1.outcome_missing > 0) {
    table.footnotes.push_back(std::to_string(h1.outcome_missing) +
                              " trials without an outcome are left out.");
  }
  return table;
}

Table issuance_table(const H1Table& h1) {
  Table table;
  table.name = "issued";
  table.title = "Certificates issued, by outcome";
  table.n = static_cast<std::int64_t>(h1.trials - h1.outcome_missing);
  table.columns = {{"outcome", "outcome", "", ColumnKind::text},
                   {"issued", "issued", "", ColumnKind::integer},
                   {"trials", "trials", "", ColumnKind::integer},
                   {"share", "share", "", ColumnKind::number, 3}};
  for (const IssuedCount& count : h1.issued) {
    table.add_row({outcome(count.success),
                   integer(count.issued),
                   integer(count.trials),
                   share(count.issued, count.trials)});
  }
  return table;
}

Table tc_early_table(const H1Table& h1) {
  Table table;
  table.name = "tc_early";
  table.title = "Spread of the early certificate margin, by outcome";
  table.n = static_cast<std::int64_t>(h1.trials - h1.outcome_missing);
  table.columns = {{"panel", "panel", "", ColumnKind::text},
                   {"outcome", "outcome", "", ColumnKind::text},
                   {"trials", "trials", "", ColumnKind::integer},
                   {"p10_m", "p10", "m", ColumnKind::number, 3},
                   {"p50_m", "p50", "m", ColumnKind::number, 3},
                   {"p90_m", "p90", "m", ColumnKind::number, 3},
                   {"missing_share", "share NA", "", ColumnKind::number, 3},
                   {"negative_share", "share below 0", "", ColumnKind::number, 3}};
  for (const H1Panel& panel : h1.panels) {
    for (const TcDistribution& one : panel.distribution) {
      table.add_row({std::string(to_string(panel.kind)),
                     outcome(one.success),
                     integer(one.trials),
                     number_or_missing(one.p10),
                     number_or_missing(one.p50),
                     number_or_missing(one.p90),
                     share(one.missing, one.trials),
                     share(one.negative, one.trials - one.missing)});
    }
  }
  table.footnotes = {"share below 0: of the trials in which TC_early is known."};
  return table;
}

}  // namespace tcert
