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

std::int64_t sum_of_trials(std::span<const GroupMedian> groups) {
  std::int64_t sum = 0;
  for (const GroupMedian& group : groups) {
    sum += static_cast<std::int64_t>(group.trials);
  }
  return sum;
}

TableCell published_speed(const std::string& name) {
  const auto speeds = published_speeds();
  const auto found = std::find_if(
      speeds.begin(), speeds.end(), [&](const PublishedSpeed& one) { return one.name == name; });
  return found == speeds.end() ? TableCell{} : Number{found->speed_cmd_mps};
}

void add_group(Table& table, const char* kind, const std::string& name, const GroupMedian& group) {
  table.add_row({std::string(kind),
                 named(name),
                 integer(group.trials),
                 number_or_missing(group.speed_cmd_mps),
                 published_speed(name),
                 number_or_missing(group.loop_latency_ms)});
}

}  // namespace

Table success_table(std::span<const CellCount> cells) {
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
  for (const CellCount& cell : cells) {
    trials += cell.trials;
    successes += cell.successes;
    table.add_row({named(cell.algorithm),
                   named(cell.lighting),
                   integer(cell.successes),
                   integer(cell.trials),
                   share(cell.successes, cell.trials)});
  }
  table.add_row({std::string("all"),
                 std::string("all"),
                 integer(successes),
                 integer(trials),
                 share(successes, trials)});
  table.n = static_cast<std::int64_t>(trials);
  return table;
}

Table speed_table(std::span<const GroupMedian> algorithms, std::span<const GroupMedian> lightings) {
  Table table;
  table.name = "speed";
  table.title = "Median commanded speed and policy-loop latency";
  table.columns = {{"grouped_by", "grouped by", "", ColumnKind::text},
                   {"group", "group", "", ColumnKind::text},
                   {"trials", "trials", "", ColumnKind::integer},
                   {"speed_mps", "speed", "m/s", ColumnKind::number, 3},
                   {"published_speed_mps", "published", "m/s", ColumnKind::number, 3},
                   {"latency_ms", "latency", "ms", ColumnKind::number, 2}};
  for (const GroupMedian& group : algorithms) {
    add_group(table, "algorithm", group.algorithm, group);
  }
  for (const GroupMedian& group : lightings) {
    add_group(table, "lighting", group.lighting, group);
  }
  table.n = sum_of_trials(algorithms);
  table.footnotes = {
      "Medians over trials of each trial's own median. Published: section 4.1 of the paper, where "
      "a "
      "range is printed its middle; latency there is " +
      fixed(kPublishedLatencyMs, 1) + " ms in every cell."};
  return table;
}

Table latency_table(std::span<const GroupMedian> cells) {
  Table table;
  table.name = "latency";
  table.title = "Median policy-loop latency by algorithm and lighting";
  table.columns = {{"algorithm", "algorithm", "", ColumnKind::text},
                   {"lighting", "lighting", "", ColumnKind::text},
                   {"trials", "trials", "", ColumnKind::integer},
                   {"latency_ms", "latency", "ms", ColumnKind::number, 2},
                   {"published_latency_ms", "published", "ms", ColumnKind::number, 1}};
  for (const GroupMedian& cell : cells) {
    table.add_row({named(cell.algorithm),
                   named(cell.lighting),
                   integer(cell.trials),
                   number_or_missing(cell.loop_latency_ms),
                   Number{kPublishedLatencyMs}});
  }
  table.n = sum_of_trials(cells);
  return table;
}

}  // namespace tcert
