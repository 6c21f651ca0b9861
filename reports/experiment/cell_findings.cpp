#include "reports/experiment/cell_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <statistics/basics/condition_groups.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/cells_by_name.hpp"
#include "reports/findings.hpp"

namespace tcert {
namespace {

/// "AUC in 2 of 7 cells: a (-0.112 [...]), b (...)": where the interval of the change is without 0,
/// the largest change first. Empty if no change has an interval.
std::string changes(const Table& cells,
                    std::string_view panel,
                    const char* symbol,
                    const std::string& column) {
  std::vector<std::pair<double, std::string>> changed;
  std::size_t compared = 0;
  std::size_t known = 0;
  for (std::size_t row = 0; row < cells.rows.size(); ++row) {
    const double change = number_at(cells, row, column);
    if (text_at(cells, row, "panel") != panel || !std::isfinite(change)) {
      continue;
    }
    ++compared;
    const statistics::Interval interval{number_at(cells, row, column + "_low"),
                                        number_at(cells, row, column + "_high")};
    known += std::isfinite(interval.low) && std::isfinite(interval.high) ? 1 : 0;
    if (interval.low > 0.0 || interval.high < 0.0) {
      changed.emplace_back(
          -std::abs(change),
          fmt::format("{} ({})", text_at(cells, row, "cell"), in_words(change, interval, 4)));
    }
  }
  std::ranges::stable_sort(changed, {}, &std::pair<double, std::string>::first);
  std::vector<std::string> names;
  names.reserve(changed.size());
  for (auto& [size, name] : changed) {
    names.push_back(std::move(name));
  }
  const std::string count = fmt::format("{} in {} of {} cells", symbol, names.size(), compared);
  return known == 0 ? "" : names.empty() ? count : count + ": " + statistics::some_of(names);
}

/// Of the landmark panel, from which conclusions are drawn; of the other one if there is none.
void add_changes(const Table& cells, std::vector<Finding>& findings) {
  for (const char* const panel : {"landmark", "paper"}) {
    const std::string auc = changes(cells, panel, "AUC", "auc_change");
    const std::string c = changes(cells, panel, "C", "c_change");
    if (!auc.empty() || !c.empty()) {
      findings.push_back(
          {fmt::format("Early certificate, {} panel", panel),
           "",
           fmt::format("against the full method the interval of the change, not adjusted over "
                       "cells, is without 0 for {}{}{}.",
                       auc,
                       auc.empty() || c.empty() ? "" : "; for ",
                       c)});
      return;
    }
  }
}

/// "A2 (77), A1+A2 (77)": the cells in which `column` counts any.
std::vector<std::string> counted(const Table& issuance, std::string_view column) {
  std::vector<std::string> cells;
  for (std::size_t row = 0; row < issuance.rows.size(); ++row) {
    if (const double count = number_at(issuance, row, column); count > 0.0) {
      cells.push_back(fmt::format("{} ({})", text_at(issuance, row, "cell"), count));
    }
  }
  return cells;
}

void add_issuance(const Table& issuance, std::vector<Finding>& findings) {
  bool any = false;
  for (std::size_t row = 0; row < issuance.rows.size(); ++row) {
    any = any || text_at(issuance, row, "status") == "done";
  }
  if (!any) {
    return;
  }
  const std::vector<std::string> wrong = counted(issuance, "spurious_failures");
  const std::vector<std::string> falling = counted(issuance, "falling");
  findings.push_back(
      {"Certificates in trials that failed",
       "",
       wrong.empty() ? "no cell issues any beside the full method's."
                     : "beside the full method's, by cell: " + statistics::some_of(wrong) + "."});
  if (!falling.empty()) {
    findings.push_back({"T_t fell, which a lower bound never does",
                        "",
                        "trials by cell: " + statistics::some_of(falling) + "."});
  }
}

/// What the paper's names stand for, where a cell has one.
void add_names(const Table& issuance, std::vector<Finding>& findings) {
  for (std::size_t row = 0; row < issuance.rows.size(); ++row) {
    if (text_at(issuance, row, "cell") == "A1") {
      findings.push_back({"Ablations",
                          "",
                          "A1 is without the memory of contacts, A2 takes unknown space for free, "
                          "A3 leaves the turn radius out."});
      return;
    }
  }
}

}  // namespace

Table cell_findings(const Table& cells, const Table& issuance) {
  std::vector<Finding> findings;
  add_names(issuance, findings);
  add_changes(cells, findings);
  add_issuance(issuance, findings);
  return findings_table(findings);
}

}  // namespace tcert
