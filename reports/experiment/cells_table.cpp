#include "reports/experiment/cells_table.hpp"

#include <cstdint>
#include <utility>

#include "reports/fit/cells.hpp"
#include "reports/h1_intervals.hpp"

namespace tcert {
namespace {

const char* const kWithheldNote =
    "Withheld for: why intervals and p-values are NA though their estimates are there.";

/// Of an H1Score or an H3Estimate.
template <class Score>
TableCell estimate(const Score& score) {
  return estimate_cell(score.value, score.interval);
}

/// The rival over which the certificate gains least; null without a rival that has a gain.
const study::H1Row* strongest_rival(const study::H1Panel& panel,
                                    study::H1Score study::H1Row::*gain) {
  const study::H1Row* strongest = nullptr;
  for (const study::H1Row& row : panel.rows) {
    const bool counts = row.kind == study::H1RowKind::rival && (row.*gain).value;
    if (counts && (strongest == nullptr || *(row.*gain).value < *(strongest->*gain).value)) {
      strongest = &row;
    }
  }
  return strongest;
}

void add_rival(const study::H1Panel& panel,
               study::H1Score study::H1Row::*gain,
               std::optional<double> study::H1Row::*holm,
               std::vector<TableCell>& cells) {
  const study::H1Row* const rival = strongest_rival(panel, gain);
  cells.push_back(rival != nullptr ? TableCell{rival->name} : TableCell{});
  cells.push_back(rival != nullptr ? estimate(rival->*gain) : TableCell{});
  cells.push_back(rival != nullptr ? p_cell(rival->*holm) : TableCell{});
}

/// Gains of the cell over the full method; NA for the full method itself.
const study::H1Row* row_against(const study::CellScores& scores, std::size_t panel) {
  if (!scores.against_full || panel >= scores.against_full->panels.size()) {
    return nullptr;
  }
  const auto& rows = scores.against_full->panels[panel].rows;
  return rows.size() > 1 ? &rows[1] : nullptr;
}

/// Why a panel has no intervals and no p; or only its changes from full have none.
std::string withheld_of(const study::CellScores& scores, std::size_t panel) {
  const std::string& own = scores.own.panels[panel].withheld;
  const bool compared =
      scores.against_full && panel < scores.against_full->panels.size() && own.empty();
  const std::string changes = compared ? scores.against_full->panels[panel].withheld : "";
  return changes.empty() ? own : "changes from full: " + changes;
}

/// Why rates have no intervals: one reason for each algorithm that is few.
std::string withheld_of(const study::H3Group& group) {
  std::string all;
  for (const statistics::Condition& condition : group.conditions) {
    if (condition.kind == statistics::ConditionKind::withheld) {
      all += (all.empty() ? "" : "; ") + condition.detail;
    }
  }
  return all;
}

TableCell words(const std::string& text) { return text.empty() ? TableCell{} : TableCell{text}; }

std::vector<TableCell> scores_row(const study::CellScores& scores, std::size_t at) {
  const study::H1Panel& panel = scores.own.panels[at];
  const study::H1Row empty;
  const study::H1Row& own = panel.rows.empty() ? empty : panel.rows.front();
  const study::H1Row* const against = row_against(scores, at);
  std::vector<TableCell> cells = {std::string(study::to_string(panel.kind)),
                                  integer_cell(panel.complete),
                                  integer_cell(panel.successes),
                                  integer_cell(panel.clusters),
                                  integer_cell(own.missing),
                                  estimate(own.auc),
                                  against != nullptr ? estimate(against->auc_gain) : TableCell{},
                                  against != nullptr ? p_cell(against->auc_p) : TableCell{}};
  add_rival(panel, &study::H1Row::auc_gain, &study::H1Row::auc_holm, cells);
  cells.push_back(estimate(own.c));
  cells.push_back(against != nullptr ? estimate(against->c_gain) : TableCell{});
  cells.push_back(against != nullptr ? p_cell(against->c_p) : TableCell{});
  add_rival(panel, &study::H1Row::c_gain, &study::H1Row::c_holm, cells);
  cells.push_back(words(withheld_of(scores, at)));
  return cells;
}

TableCell share(std::size_t part, std::size_t whole) {
  return whole == 0 ? TableCell{} : Number{static_cast<double>(part) / static_cast<double>(whole)};
}

std::vector<TableCell> named(const study::Cell& cell,
                             const std::string& status,
                             const std::vector<TableCell>& rest,
                             const Table& table) {
  std::vector<TableCell> cells = {cell.name, study::overrides_text(cell), status};
  cells.insert(cells.end(), rest.begin(), rest.end());
  cells.resize(table.columns.size());
  return cells;
}

std::vector<Column> name_columns() {
  return {text_column("cell", "cell"),
          text_column("parameters", "parameters"),
          text_column("status", "status")};
}

}  // namespace

std::vector<std::vector<TableCell>> cell_panels(const study::CellScores& scores) {
  std::vector<std::vector<TableCell>> rows;
  for (std::size_t panel = 0; panel < scores.own.panels.size(); ++panel) {
    rows.push_back(scores_row(scores, panel));
  }
  return rows;
}

std::vector<TableCell> cell_issuance(const study::CellIssuance& count) {
  return {integer_cell(count.successes),
          integer_cell(count.issued_successes),
          share(count.issued_successes, count.successes),
          integer_cell(count.failures),
          integer_cell(count.issued_failures),
          share(count.issued_failures, count.failures),
          integer_cell(count.spurious),
          integer_cell(count.spurious_failures),
          share(count.spurious_failures, count.spurious),
          integer_cell(count.lost),
          integer_cell(count.before_goal),
          integer_cell(count.falling)};
}

Table cells_table(const BatchNotes& notes) {
  const std::string level = interval_text(notes.interval, notes.level);
  Table table;
  table.name = "cells";
  table.title = "H1 under each cell's parameters";
  table.columns = name_columns();
  table.columns.insert(table.columns.end(),
                       {text_column("panel", "panel"),
                        integer_column("n", "n"),
                        integer_column("events", "successes"),
                        integer_column("clusters", "clusters"),
                        integer_column("missing", "missing"),
                        estimate_column("auc", "AUC [" + level + "]"),
                        estimate_column("auc_change", "change of AUC from full [" + level + "]"),
                        p_column("auc_change_p", "p"),
                        text_column("auc_rival", "strongest rival"),
                        estimate_column("auc_gain", "gain of AUC over it [" + level + "]"),
                        p_column("auc_gain_p_holm", "p Holm"),
                        estimate_column("c", "C [" + level + "]"),
                        estimate_column("c_change", "change of C from full [" + level + "]"),
                        p_column("c_change_p", "p"),
                        text_column("c_rival", "strongest rival"),
                        estimate_column("c_gain", "gain of C over it [" + level + "]"),
                        p_column("c_gain_p_holm", "p Holm"),
                        text_column("withheld", "withheld for")});
  table.footnotes = {
      "Changes are the cell minus the full method, on the trials that have both features, in the "
      "same resamples; p by clustered DeLong and the clustered jackknife of C, not adjusted over "
      "cells.",
      "The strongest rival is the one over which the cell's certificate gains least, among the "
      "cell's own contacts, dwell and bend variance; p adjusted by Holm over the six gains of the "
      "cell.",
      kWithheldNote,
      std::to_string(notes.replicates) + " resamples of whole clusters (" +
          (notes.cluster.empty() ? std::string("each trial its own") : notes.cluster) + ")."};
  return table;
}

Table cell_issuance_table() {
  Table table;
  table.name = "issuance";
  table.title = "Certificates issued under each cell's parameters";
  const auto share_column = [](std::string name, std::string heading) {
    return Column{std::move(name), std::move(heading), "", ColumnKind::number, 3};
  };
  table.columns = name_columns();
  table.columns.insert(table.columns.end(),
                       {integer_column("successes", "successes"),
                        integer_column("issued_successes", "issued"),
                        share_column("issued_successes_share", "share"),
                        integer_column("failures", "failures"),
                        integer_column("issued_failures", "issued"),
                        share_column("issued_failures_share", "share"),
                        integer_column("spurious", "not by full"),
                        integer_column("spurious_failures", "of those failed"),
                        share_column("spurious_failures_share", "share"),
                        integer_column("lost", "by full only"),
                        integer_column("before_goal", "before G"),
                        integer_column("falling", "T_t fell")});
  table.footnotes = {
      "'not by full': trials with a certificate here and none by the full method; 'before G': "
      "issued before the robot was inside G; 'T_t fell': trials whose T_t fell at some tick, which "
      "a lower bound never does."};
  return table;
}

std::vector<TableCell> cell_speed(const study::H3Table& h3) {
  if (h3.groups.empty() || h3.groups.front().cases.empty()) {
    return {};
  }
  const study::H3Group& all = h3.groups.front();
  const study::H3Case& one = all.cases.front();
  const TableCell retained = estimate_cell(one.retained, one.retained_interval);
  return {integer_cell(all.trials),
          integer_cell(all.successes),
          estimate(all.ungated),
          estimate(one.gated),
          estimate(one.gain),
          estimate(one.gain_share),
          estimate(one.recovered),
          integer_cell(one.lost),
          number_cell(one.lost_upper),
          one.non_inferior ? TableCell{std::string(*one.non_inferior ? "yes" : "no")} : TableCell{},
          retained,
          integer_cell(one.stalls),
          integer_cell(one.stalled_trials),
          words(withheld_of(all))};
}

Table cell_speed_table(const BatchNotes& notes) {
  const std::string level = interval_text(notes.interval, notes.level);
  Table table;
  table.name = "speed";
  table.title = "Speed gated by the margin under each cell's parameters (H3)";
  table.columns = name_columns();
  const auto rate = [](std::string name, std::string heading) {
    return Column{std::move(name), std::move(heading), "m/min", ColumnKind::estimate, 2};
  };
  table.columns.insert(table.columns.end(),
                       {integer_column("n", "n"),
                        integer_column("events", "successes"),
                        rate("ungated_m_per_min", "ungated"),
                        rate("gated_m_per_min", "gated [" + level + "]"),
                        rate("gain_m_per_min", "gain [" + level + "]"),
                        estimate_column("gain_share", "relative gain"),
                        estimate_column("gap_recovered", "share of gap"),
                        integer_column("lost", "lost"),
                        Column{"lost_upper", "bound", "", ColumnKind::number, 3},
                        text_column("non_inferior", "non-inferior"),
                        estimate_column("retained", "retained"),
                        integer_column("stalls", "stalls"),
                        integer_column("stalled_trials", "trials with stalls"),
                        text_column("withheld", "withheld for")});
  table.footnotes = {
      "All lightings together; 'tcert hypotheses h3' has each, and says how every column is made. "
      "A replay can only lose successes: it cannot see failures that speed would cause.",
      kWithheldNote};
  return table;
}

void add_cell(const study::Cell& cell,
              const std::string& status,
              const std::vector<std::vector<TableCell>>& rows,
              Table& table) {
  if (rows.empty()) {
    table.add_row(named(cell, status, {}, table));
  }
  for (const auto& row : rows) {
    table.add_row(named(cell, status, row, table));
  }
}

}  // namespace tcert
