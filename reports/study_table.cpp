#include "reports/study_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "reports/columns_of.hpp"
#include "reports/paper_names.hpp"
#include "reports/table_one.hpp"

namespace tcert {
namespace {

using study::StudyGroup;

struct SpeedRow : RowOf<StudyGroup> {
  std::string grouped_by;
  const std::string& name;
};

ColumnsOf<SpeedRow> speed_columns(bool published) {
  ColumnsOf<SpeedRow> columns;
  columns.text("grouped_by", "grouped by", &SpeedRow::grouped_by)
      .text("group", "group", [](auto& r) { return shown_group(r.name); })
      .integer("trials", "trials", &StudyGroup::trials)
      .fixed("speed_mps", "speed", "m/s", 3, [](auto& r) { return r.of.speed_cmd_mps.median(); });
  if (published) {
    columns.fixed("published_speed_mps", "published", "m/s", 3, [](auto& r) {
      return study::published_speed_mps(r.name);
    });
  }
  return columns;
}

Table speed_table(const study::StudyRecord& study) {
  const bool published = study.is_of_paper();
  const ColumnsOf<SpeedRow> columns = speed_columns(published);
  Table table = columns.table("speed", "Median commanded speed");
  for (const StudyGroup& group : study.by_algorithm()) {
    table.add_row(columns.row({{group}, "algorithm", group.algorithm}));
  }
  for (const StudyGroup& group : study.by_lighting()) {
    table.add_row(columns.row({{group}, "lighting", group.lighting}));
  }
  table.n = static_cast<std::int64_t>(study.all().trials);
  table.footnotes = {"Medians of all control samples, pooled."};
  if (published) {
    table.footnotes.emplace_back(
        "Published: section 4.1 of the paper, of its own trials; where a range is printed, its "
        "middle.");
    table.footnotes.push_back(paper_names_text());
  }
  if (const std::string latency = latency_line(study); !latency.empty()) {
    table.footnotes.push_back(latency);
  }
  return table;
}

}  // namespace

std::string latency_line(const study::StudyRecord& study) {
  const std::optional<double> median = study.all().loop_latency_ms.median();
  if (!median) {
    return "";
  }
  std::vector<double> medians;
  for (const StudyGroup& cell : study.by_cell()) {
    if (const auto of_cell = cell.loop_latency_ms.median()) {
      medians.push_back(*of_cell);
    }
  }
  std::string line = fmt::format("Policy-loop latency: median {} ms", fixed(*median, 1));
  if (medians.size() > 1) {
    const auto [least, most] = std::minmax_element(medians.begin(), medians.end());
    const std::string low = fixed(*least, 1);
    const std::string high = fixed(*most, 1);
    line += low == high ? fmt::format("; {} in each of the {} cells", low, medians.size())
                        : fmt::format("; {} to {} over the {} cells", low, high, medians.size());
  }
  line += ".";
  if (study.is_of_paper()) {
    line +=
        fmt::format(" The paper prints {} ms in every cell.", fixed(study::kPublishedLatencyMs, 1));
  }
  return line;
}

std::vector<Table> study_tables(const study::StudyRecord& study) {
  return {table_one(study), speed_table(study), study_cells_table(study)};
}

}  // namespace tcert
