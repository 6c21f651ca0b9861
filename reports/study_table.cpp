#include "reports/study_table.hpp"

#include <cstdint>

#include "reports/columns_of.hpp"

namespace tcert {
namespace {

using study::StudyGroup;

std::string named(const std::string& name) { return name.empty() ? "(none)" : name; }

std::int64_t sum_of_trials(std::span<const StudyGroup> groups) {
  std::int64_t sum = 0;
  for (const StudyGroup& group : groups) {
    sum += static_cast<std::int64_t>(group.trials);
  }
  return sum;
}

ColumnsOf<StudyGroup> cell_columns() {
  return ColumnsOf<StudyGroup>()
      .text("algorithm", "algorithm", [](auto& cell) { return named(cell.algorithm); })
      .text("lighting", "lighting", [](auto& cell) { return named(cell.lighting); });
}

ColumnsOf<StudyGroup> latency_columns() {
  return ColumnsOf<StudyGroup>().fixed(
      "latency_ms", "latency", "ms", 2, [](auto& r) { return r.loop_latency_ms.median(); });
}

Table success_table(std::span<const StudyGroup> cells) {
  const auto columns =
      cell_columns()
          .integer("successes", "successes", &StudyGroup::successes)
          .integer("trials", "trials", &StudyGroup::known)
          .fixed("share", "share", [](auto& cell) { return share(cell.successes, cell.known); });
  Table table = columns.table("table1", "Successes by algorithm and lighting", cells);
  StudyGroup all;
  all.algorithm = all.lighting = "all";
  for (const StudyGroup& cell : cells) {
    all.known += cell.known;
    all.successes += cell.successes;
  }
  table.add_row(columns.row(all));
  table.n = static_cast<std::int64_t>(all.known);
  return table;
}

Table speed_table(std::span<const StudyGroup> algorithms, std::span<const StudyGroup> lightings) {
  struct Row : RowOf<StudyGroup> {
    std::string grouped_by;
    const std::string& name;
  };
  const auto columns =
      ColumnsOf<Row>()
          .text("grouped_by", "grouped by", &Row::grouped_by)
          .text("group", "group", [](auto& r) { return named(r.name); })
          .integer("trials", "trials", &StudyGroup::trials)
          .fixed(
              "speed_mps", "speed", "m/s", 3, [](auto& r) { return r.of.speed_cmd_mps.median(); })
          .fixed("published_speed_mps",
                 "published",
                 "m/s",
                 3,
                 [](auto& r) { return study::published_speed_mps(r.name); })
          .part(latency_columns(), [](auto& r) { return &r.of; });
  Table table = columns.table("speed", "Median commanded speed and policy-loop latency");
  for (const StudyGroup& group : algorithms) {
    table.add_row(columns.row({{group}, "algorithm", group.algorithm}));
  }
  for (const StudyGroup& group : lightings) {
    table.add_row(columns.row({{group}, "lighting", group.lighting}));
  }
  table.n = sum_of_trials(algorithms);
  table.footnotes = {
      "Medians of all control samples, pooled. Published: section 4.1 of the paper, where "
      "a "
      "range is printed its middle; latency there is " +
      fixed(study::kPublishedLatencyMs, 1) + " ms in every cell."};
  return table;
}

Table latency_table(std::span<const StudyGroup> cells) {
  Table table =
      cell_columns()
          .integer("trials", "trials", &StudyGroup::trials)
          .part(latency_columns(), [](auto& cell) { return &cell; })
          .fixed("published_latency_ms",
                 "published",
                 "ms",
                 1,
                 [](auto&) { return study::kPublishedLatencyMs; })
          .table("latency", "Median policy-loop latency by algorithm and lighting", cells);
  table.n = sum_of_trials(cells);
  return table;
}

}  // namespace

std::vector<Table> study_tables(const study::StudyRecord& study) {
  const std::vector<StudyGroup> cells = study.by_cell();
  return {success_table(cells),
          speed_table(study.by_algorithm(), study.by_lighting()),
          latency_table(cells)};
}

}  // namespace tcert
