#include "reports/experiment/cell_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/findings.hpp"

namespace tcert {
namespace {

using Row = std::vector<TableCell>;

/// A table read by the names of its columns.
class Named {
 public:
  explicit Named(const Table& table) : table_(table) {}

  template <class Value>
  [[nodiscard]] const Value* get(const Row& row, std::string_view column) const {
    const auto found = std::ranges::find(table_.columns, column, &Column::name);
    return std::get_if<Value>(&row[static_cast<std::size_t>(found - table_.columns.begin())]);
  }
  [[nodiscard]] std::string text(const Row& row, std::string_view column) const {
    const auto* const found = get<std::string>(row, column);
    return found == nullptr ? "" : *found;
  }
  [[nodiscard]] std::int64_t count(const Row& row, std::string_view column) const {
    const auto* const found = get<std::int64_t>(row, column);
    return found == nullptr ? 0 : *found;
  }
  [[nodiscard]] const Table& table() const noexcept { return table_; }

 private:
  const Table& table_;
};

/// "a (-0.112 [-0.150, -0.075]), b (...) and 3 more".
std::string some(const std::vector<std::string>& parts) {
  constexpr std::size_t kShown = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, parts.size()); ++i) {
    text += (i == 0 ? "" : ", ") + parts[i];
  }
  return parts.size() <= kShown ? text : text + fmt::format(" and {} more", parts.size() - kShown);
}

/// "AUC in 2 of 7 cells: a (-0.112 [...]), b (...)": where the interval of the change is without 0,
/// the largest change first. Empty if no change has an interval.
std::string changes(const Named& cells,
                    std::string_view panel,
                    const char* symbol,
                    std::string_view column) {
  std::vector<std::pair<double, std::string>> changed;
  std::size_t compared = 0;
  std::size_t known = 0;
  for (const Row& row : cells.table().rows) {
    const auto* const change = cells.get<Estimate>(row, column);
    if (cells.text(row, "panel") != panel || change == nullptr || !std::isfinite(change->value)) {
      continue;
    }
    ++compared;
    known += std::isfinite(change->low) && std::isfinite(change->high) ? 1 : 0;
    if (change->low > 0.0 || change->high < 0.0) {
      const statistics::Interval interval{change->low, change->high, 0.0};
      changed.emplace_back(
          -std::abs(change->value),
          fmt::format("{} ({})", cells.text(row, "cell"), in_words(change->value, interval, 4)));
    }
  }
  std::ranges::stable_sort(changed, {}, &std::pair<double, std::string>::first);
  std::vector<std::string> names;
  names.reserve(changed.size());
  for (auto& [size, name] : changed) {
    names.push_back(std::move(name));
  }
  const std::string count = fmt::format("{} in {} of {} cells", symbol, names.size(), compared);
  return known == 0 ? "" : names.empty() ? count : count + ": " + some(names);
}

/// Of the landmark panel, from which conclusions are drawn; of the other one if there is none.
void add_changes(const Named& cells, std::vector<Finding>& findings) {
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

void add_issuance(const Named& issuance, std::vector<Finding>& findings) {
  std::vector<std::string> wrong;
  std::vector<std::string> falling;
  for (const Row& row : issuance.table().rows) {
    const std::string name = issuance.text(row, "cell");
    if (const std::int64_t spurious = issuance.count(row, "spurious_failures"); spurious > 0) {
      wrong.push_back(fmt::format("{} ({})", name, spurious));
    }
    if (const std::int64_t falls = issuance.count(row, "falling"); falls > 0) {
      falling.push_back(fmt::format("{} ({})", name, falls));
    }
  }
  findings.push_back({"Certificates in trials that failed",
                      "",
                      wrong.empty() ? "no cell issues any beside the full method's."
                                    : "beside the full method's, by cell: " + some(wrong) + "."});
  if (!falling.empty()) {
    findings.push_back(
        {"T_t fell, which a lower bound never does", "", "trials by cell: " + some(falling) + "."});
  }
}

}  // namespace

Table cell_findings(const Table& cells, const Table& issuance) {
  std::vector<Finding> findings;
  add_changes(Named(cells), findings);
  add_issuance(Named(issuance), findings);
  return findings_table(findings);
}

}  // namespace tcert
