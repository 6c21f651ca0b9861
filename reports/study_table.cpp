#include "reports/study_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tcert {
namespace {

TableCell number_or_missing(const std::optional<double>& value) {
  return value ? TableCell{Number{*value}} : TableCell{};
}

TableCell integer(std::size_t value) { return static_cast<std::int64_t>(value); }

std::string named(const std::string& name) { return name.empty() ? "(none)" : name; }

TableCell share(std::size_t part, std::size_t whole) {
  return whole == 0 ? TableCell{} : Number{static_cast<double>(part) / static_cast<double>(whole)};
}

std::int64_t sum_of_trials(std::span<const study::StudyGroup> groups) {
  std::int64_t sum = 0;
  for (const study::StudyGroup& group : groups) {
    sum += static_cast<std::int64_t>(group.trials);
  }
  return sum;
}

void add_group(Table& table,
               const char* kind,
               const std::string& name,
               const study::StudyGroup& group) {
  table.add_row({std::string(kind),
                 named(name),
                 integer(group.trials),
                 number_or_missing(group.speed_cmd_mps.median()),
                 number_or_missing(study::published_speed_mps(name)),
                 number_or_missing(group.loop_latency_ms.median())});
}

}  // namespace

Table success_table(std::span<const study::StudyGroup> cells) {
  Table table;
  table.name = "table1";
  table.title = "Successes by algorithm and lighting";
  table.columns = {{"algorithm", "algorithm", "", ColumnKind::text},
                   {"lighting", "lighting", "", ColumnKind::text},
                   {"successes", "successes", "", ColumnKind::integer},
                   {"trials", "trials", "", ColumnKind::integer},
                   {"share", "share", "", ColumnKind::number, 3}};
  std::size_t trials = 0;
  std::size_t successes = 0;
  for (const study::StudyGroup& cell : cells) {
    trials += cell.known;
    successes += cell.successes;
    table.add_row({named(cell.algorithm),
                   named(cell.lighting),
                   integer(cell.successes),
                   integer(cell.known),
                   share(cell.successes, cell.known)});
  }
  table.add_row({std::string("all"),
                 std::string("all"),
                 integer(successes),
                 integer(trials),
                 share(successes, trials)});
  table.n = static_cast<std::int64_t>(trials);
  return table;
}

Table speed_table(std::span<const study::StudyGroup> algorithms,
                  std::span<const study::StudyGroup> lightings) {
  Table table;
  table.name = "speed";
  table.title = "Median commanded speed and policy-loop latency";
  table.columns = {{"grouped_by", "grouped by", "", ColumnKind::text},
                   {"group", "group", "", ColumnKind::text},
                   {"trials", "trials", "", ColumnKind::integer},
                   {"speed_mps", "speed", "m/s", ColumnKind::number, 3},
                   {"published_speed_mps", "published", "m/s", ColumnKind::number, 3},
                   {"latency_ms", "latency", "ms", ColumnKind::number, 2}};
  for (const study::StudyGroup& group : algorithms) {
    add_group(table, "algorithm", group.algorithm, group);
  }
  for (const study::StudyGroup& group : lightings) {
    add_group(table, "lighting", group.lighting, group);
  }
  table.n = sum_of_trials(algorithms);
  table.footnotes = {
      "Medians of all control samples, pooled. Published: section 4.1 of the paper, where "
      "a "
      "range is printed its middle; latency there is " +
      fixed(study::kPublishedLatencyMs, 1) + " ms in every cell."};
  return table;
}

Table latency_table(std::span<const study::StudyGroup> cells) {
  Table table;
  table.name = "latency";
  table.title = "Median policy-loop latency by algorithm and lighting";
  table.columns = {{"algorithm", "algorithm", "", ColumnKind::text},
                   {"lighting", "lighting", "", ColumnKind::text},
                   {"trials", "trials", "", ColumnKind::integer},
                   {"latency_ms", "latency", "ms", ColumnKind::number, 2},
                   {"published_latency_ms", "published", "ms", ColumnKind::number, 1}};
  for (const study::StudyGroup& cell : cells) {
    table.add_row({named(cell.algorithm),
                   named(cell.lighting),
                   integer(cell.trials),
                   number_or_missing(cell.loop_latency_ms.median()),
                   Number{study::kPublishedLatencyMs}});
  }
  table.n = sum_of_trials(cells);
  return table;
}

std::vector<Table> study_tables(const study::StudyRecord& study) {
  const std::vector<study::StudyGroup> cells = study.by_cell();
  return {success_table(cells),
          speed_table(study.by_algorithm(), study.by_lighting()),
          latency_table(cells)};
}

}  // namespace tcert
