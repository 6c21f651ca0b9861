#include "reports/table_one.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "reports/columns_of.hpp"
#include "reports/paper_names.hpp"

namespace tcert {
namespace {

using study::StudyGroup;

constexpr const char* kAll = "all";

/// "52/60 (86.7 %)".
TableCell success_cell(std::size_t successes, std::size_t known) {
  const std::optional<double> part = share(successes, known);
  return part ? TableCell(fmt::format("{}/{} ({} %)", successes, known, fixed(100.0 * *part, 1)))
              : TableCell();
}

/// The outcomes of one algorithm under one lighting; no trials if there is no such cell.
StudyGroup cell_of(const std::vector<StudyGroup>& cells,
                   const StudyGroup& algorithm,
                   const StudyGroup& lighting) {
  const auto found = std::find_if(cells.begin(), cells.end(), [&](const StudyGroup& cell) {
    return cell.algorithm == algorithm.algorithm && cell.lighting == lighting.lighting;
  });
  return found == cells.end() ? StudyGroup{} : *found;
}

}  // namespace

std::string shown_group(const std::string& name) { return name.empty() ? "(none)" : name; }

Table table_one(const study::StudyRecord& study) {
  const std::vector<StudyGroup> cells = study.by_cell();
  const std::vector<StudyGroup> algorithms = study.by_algorithm();
  const std::vector<StudyGroup> lightings = study.by_lighting();
  const bool sum_lightings = lightings.size() > 1;
  Table table;
  table.name = "table1";
  table.title = "Successes by algorithm and lighting";
  table.columns.push_back(text_column("algorithm", "algorithm"));
  for (const StudyGroup& lighting : lightings) {
    table.columns.push_back(
        text_column("successes_" + lighting.lighting, shown_group(lighting.lighting)));
  }
  if (sum_lightings) {
    table.columns.push_back(text_column("successes_of_all_lightings", kAll));
  }
  for (const StudyGroup& algorithm : algorithms) {
    std::vector<TableCell> row = {shown_group(algorithm.algorithm)};
    for (const StudyGroup& lighting : lightings) {
      const StudyGroup cell = cell_of(cells, algorithm, lighting);
      row.push_back(success_cell(cell.successes, cell.known));
    }
    if (sum_lightings) {
      row.push_back(success_cell(algorithm.successes, algorithm.known));
    }
    table.add_row(std::move(row));
  }
  const StudyGroup all = study.all();
  if (algorithms.size() > 1) {
    std::vector<TableCell> row = {std::string(kAll)};
    for (const StudyGroup& lighting : lightings) {
      row.push_back(success_cell(lighting.successes, lighting.known));
    }
    if (sum_lightings) {
      row.push_back(success_cell(all.successes, all.known));
    }
    table.add_row(std::move(row));
  }
  table.n = static_cast<std::int64_t>(all.known);
  table.footnotes = {
      "Successes / trials with a known outcome (share). The same as numbers, a row a cell: "
      "study_cells."};
  if (study.is_of_paper()) {
    table.footnotes.push_back(paper_names_text());
  }
  return table;
}

Table study_cells_table(const study::StudyRecord& study) {
  const auto columns =
      ColumnsOf<StudyGroup>()
          .text("algorithm", "algorithm", [](auto& cell) { return shown_group(cell.algorithm); })
          .text("lighting", "lighting", [](auto& cell) { return shown_group(cell.lighting); })
          .integer("trials", "trials", &StudyGroup::trials)
          .integer("known_outcomes", "outcome known", &StudyGroup::known)
          .integer("successes", "successes", &StudyGroup::successes)
          .fixed("share", "share", [](auto& cell) { return share(cell.successes, cell.known); })
          .fixed("speed_mps", "speed", "m/s", 3, [](auto& c) { return c.speed_cmd_mps.median(); })
          .fixed(
              "latency_ms", "latency", "ms", 2, [](auto& c) { return c.loop_latency_ms.median(); });
  Table table = columns.table(
      "study_cells", "Trials, speed and latency by algorithm and lighting", study.by_cell());
  StudyGroup all = study.all();
  all.algorithm = all.lighting = kAll;
  table.add_row(columns.row(all));
  table.n = static_cast<std::int64_t>(all.trials);
  table.footnotes = {
      "Speed: median commanded speed; latency: median time of the policy loop; of all control "
      "samples of the cell, pooled."};
  return table;
}

}  // namespace tcert
