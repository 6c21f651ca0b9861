#include "reports/experiment/cells_table.hpp"

#include <utility>

#include "reports/columns_of.hpp"
#include "reports/h1_intervals.hpp"

namespace tcert {
namespace {

using study::CellIssuance;
using study::H1Row;
using study::H1Score;
using study::H3Case;
using study::H3Group;

const char* const kWithheldNote =
    "Withheld for: why intervals and p-values are NA though their estimates are there.";

/// The rival over which the certificate gains least; null without a rival that has a gain.
const H1Row* strongest_rival(const study::H1Panel& panel, H1Score H1Row::*gain) {
  const H1Row* strongest = nullptr;
  for (const H1Row& row : panel.rows) {
    const bool counts = row.kind == study::H1RowKind::rival && (row.*gain).value;
    if (counts && (strongest == nullptr || *(row.*gain).value < *(strongest->*gain).value)) {
      strongest = &row;
    }
  }
  return strongest;
}

/// Gains of the cell over the full method; NA for the full method itself.
const H1Row* row_against(const study::CellScores& scores, std::size_t panel) {
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
std::string withheld_of(const H3Group& group) {
  std::string all;
  for (const statistics::Condition& condition : group.conditions) {
    if (condition.kind == statistics::ConditionKind::withheld) {
      all += (all.empty() ? "" : "; ") + condition.detail;
    }
  }
  return all;
}

struct NamedCell {
  const study::Cell& cell;
  std::string status;
};

ColumnsOf<NamedCell> name_columns() {
  return ColumnsOf<NamedCell>()
      .text("cell", "cell", [](auto& r) { return r.cell.name; })
      .text("parameters", "parameters", [](auto& r) { return study::overrides_text(r.cell); })
      .text("status", "status", &NamedCell::status);
}

/// A panel of a cell's scores.
struct CellPanel {
  const study::CellScores& scores;
  std::size_t at;

  [[nodiscard]] const study::H1Panel& panel() const { return scores.own.panels[at]; }
  [[nodiscard]] const H1Row* own() const {
    return panel().rows.empty() ? nullptr : &panel().rows.front();
  }
  [[nodiscard]] const H1Row* against() const { return row_against(scores, at); }
};

/// Of AUC or of C: the score, its change from the full method, its gain over the strongest rival.
ColumnsOf<CellPanel> score_columns(const std::string& name,
                                   const std::string& symbol,
                                   const std::string& level,
                                   H1Score H1Row::*score,
                                   H1Score H1Row::*gain,
                                   std::optional<double> H1Row::*p,
                                   std::optional<double> H1Row::*holm) {
  const auto own = ColumnsOf<H1Row>().estimate(name, symbol + " [" + level + "]", score);
  const auto change =
      ColumnsOf<H1Row>()
          .estimate(name + "_change", "change of " + symbol + " from full [" + level + "]", gain)
          .p(name + "_change_p", "p", p);
  const auto rival =
      ColumnsOf<H1Row>()
          .text(name + "_rival", "strongest rival", &H1Row::name)
          .estimate(name + "_gain", "gain of " + symbol + " over it [" + level + "]", gain)
          .p(name + "_gain_p_holm", "p Holm", holm);
  return ColumnsOf<CellPanel>()
      .part(own, &CellPanel::own)
      .part(change, &CellPanel::against)
      .part(rival, [gain](auto& r) { return strongest_rival(r.panel(), gain); });
}

ColumnsOf<CellPanel> cell_panel_columns(const std::string& level) {
  const auto whole = [](const CellPanel& r) { return &r; };
  return ColumnsOf<CellPanel>()
      .text("panel", "panel", [](auto& r) { return std::string(to_string(r.panel().kind)); })
      .integer("n", "n", [](auto& r) { return r.panel().complete; })
      .integer("events", "successes", [](auto& r) { return r.panel().successes; })
      .integer("clusters", "clusters", [](auto& r) { return r.panel().clusters; })
      .integer(
          "missing", "missing", [](auto& r) { return r.own() != nullptr ? r.own()->missing : 0; })
      .part(
          score_columns(
              "auc", "AUC", level, &H1Row::auc, &H1Row::auc_gain, &H1Row::auc_p, &H1Row::auc_holm),
          whole)
      .part(score_columns("c", "C", level, &H1Row::c, &H1Row::c_gain, &H1Row::c_p, &H1Row::c_holm),
            whole)
      .text("withheld", "withheld for", [](auto& r) {
        return not_empty(withheld_of(r.scores, r.at));
      });
}

ColumnsOf<CellIssuance> issuance_columns() {
  using Count = CellIssuance;
  return ColumnsOf<Count>()
      .integer("successes", "successes", &Count::successes)
      .integer("issued_successes", "issued", &Count::issued_successes)
      .fixed("issued_successes_share",
             "share",
             [](auto& r) { return share(r.issued_successes, r.successes); })
      .integer("failures", "failures", &Count::failures)
      .integer("issued_failures", "issued", &Count::issued_failures)
      .fixed("issued_failures_share",
             "share",
             [](auto& r) { return share(r.issued_failures, r.failures); })
      .integer("spurious", "not by full", &Count::spurious)
      .integer("spurious_failures", "of those failed", &Count::spurious_failures)
      .fixed("spurious_failures_share",
             "share",
             [](auto& r) { return share(r.spurious_failures, r.spurious); })
      .integer("lost", "by full only", &Count::lost)
      .integer("before_goal", "before G", &Count::before_goal)
      .integer("falling", "T_t fell", &Count::falling);
}

/// Of all lightings together and their first case.
ColumnsOf<H3Group> speed_columns(const std::string& level) {
  const auto first =
      ColumnsOf<H3Case>()
          .estimate("gated_m_per_min", "gated [" + level + "]", "m/min", 2, &H3Case::gated)
          .estimate("gain_m_per_min", "gain [" + level + "]", "m/min", 2, &H3Case::gain)
          .estimate("gain_share", "relative gain", &H3Case::gain_share)
          .estimate("gap_recovered", "share of gap", &H3Case::recovered)
          .integer("lost", "lost", &H3Case::lost)
          .fixed("lost_upper", "bound", &H3Case::lost_upper)
          .yes_or_no("non_inferior", "non-inferior", &H3Case::non_inferior)
          .estimate("retained",
                    "retained",
                    [](auto& r) { return Estimated(r.retained, r.retained_interval); })
          .integer("stalls", "stalls", &H3Case::stalls)
          .integer("stalled_trials", "trials with stalls", &H3Case::stalled_trials);
  return ColumnsOf<H3Group>()
      .integer("n", "n", &H3Group::trials)
      .integer("events", "successes", &H3Group::successes)
      .estimate("ungated_m_per_min", "ungated", "m/min", 2, &H3Group::ungated)
      .part(first, [](auto& group) { return &group.cases.front(); })
      .text("withheld", "withheld for", [](auto& group) { return not_empty(withheld_of(group)); });
}

template <class Row>
Table table_of_cells(std::string name, std::string title, const ColumnsOf<Row>& behind_the_name) {
  Table table = name_columns().table(std::move(name), std::move(title));
  behind_the_name.append_to(table.columns);
  return table;
}

}  // namespace

std::vector<std::vector<TableCell>> cell_panels(const study::CellScores& scores) {
  const ColumnsOf<CellPanel> columns = cell_panel_columns("");
  std::vector<std::vector<TableCell>> rows;
  for (std::size_t panel = 0; panel < scores.own.panels.size(); ++panel) {
    rows.push_back(columns.row({scores, panel}));
  }
  return rows;
}

std::vector<TableCell> cell_issuance(const CellIssuance& count) {
  return issuance_columns().row(count);
}

std::vector<TableCell> cell_speed(const study::H3Table& h3) {
  const bool has_case = !h3.groups.empty() && !h3.groups.front().cases.empty();
  return has_case ? speed_columns("").row(h3.groups.front()) : std::vector<TableCell>{};
}

Table cells_table(const CellNotes& notes) {
  Table table = table_of_cells("cells",
                               "H1 under each cell's parameters",
                               cell_panel_columns(interval_text(notes.interval, notes.level)));
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
  Table table = table_of_cells(
      "issuance", "Certificates issued under each cell's parameters", issuance_columns());
  table.footnotes = {
      "'not by full': trials with a certificate here and none by the full method; 'before G': "
      "issued before the robot was inside G; 'T_t fell': trials whose T_t fell at some tick, which "
      "a lower bound never does."};
  return table;
}

Table cell_speed_table(const CellNotes& notes) {
  Table table = table_of_cells("speed",
                               "Speed gated by the margin under each cell's parameters (H3)",
                               speed_columns(interval_text(notes.interval, notes.level)));
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
  const auto add = [&](const std::vector<TableCell>& behind_the_name) {
    std::vector<TableCell> cells = name_columns().row({cell, status});
    cells.insert(cells.end(), behind_the_name.begin(), behind_the_name.end());
    cells.resize(table.columns.size());
    table.add_row(std::move(cells));
  };
  if (rows.empty()) {
    add({});
  }
  for (const auto& row : rows) {
    add(row);
  }
}

}  // namespace tcert
