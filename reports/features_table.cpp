#include "reports/features_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "datasets/nearest_name.hpp"
#include "datasets/trial_table.hpp"
#include "reports/series.hpp"

namespace tcert {
namespace {

TableCell cell_of(const std::optional<double>& value) {
  return value ? TableCell{Number{*value, std::trunc(*value) == *value ? 0 : kColumnDecimals}}
               : TableCell{};
}
TableCell cell_of(const std::optional<bool>& value) {
  return value ? TableCell{std::int64_t{*value ? 1 : 0}} : TableCell{};
}

TableCell text_or_missing(std::string_view text) {
  return text.empty() ? TableCell{} : TableCell{std::string(text)};
}

Column text_column(std::string name, std::string heading) {
  return {std::move(name), std::move(heading), "", ColumnKind::text};
}

}  // namespace

std::optional<SyntheticLabel> synthetic_label(const BundleInfo& info) {
  return info.synthetic ? std::optional(SyntheticLabel{info.seed}) : std::nullopt;
}

Table features_table(const Bundle& bundle) {
  Table table;
  table.name = "features";
  table.title = "Features of each trial";
  table.synthetic = synthetic_label(bundle.info);
  table.columns = {text_column("trial_id", "trial"),
                   text_column("algorithm", "algorithm"),
                   text_column("lighting", "lighting"),
                   text_column("day", "day"),
                   text_column("batch", "batch"),
                   {"success", "success", "", ColumnKind::integer},
                   {"time_s", "time", "s", ColumnKind::number, 1},
                   {"distance_m", "distance", "m", ColumnKind::number, 2},
                   text_column("end_reason", "end")};
  for (const FeatureColumn& column : feature_columns()) {
    const std::string name(column.name);
    table.columns.push_back({name, name, std::string(column.unit), ColumnKind::number});
  }
  table.columns.push_back({"median_speed_cmd_mps", "commanded speed", "m/s", ColumnKind::number});
  table.columns.push_back({"median_loop_latency_ms", "latency", "ms", ColumnKind::number});
  for (const std::string& name : bundle.extra_columns) {
    // A column of the log that is called like a feature must not shadow it.
    const bool taken = std::any_of(table.columns.begin(), table.columns.end(), [&](const auto& c) {
      return case_folded(c.name) == case_folded(name);
    });
    table.columns.push_back(text_column(taken ? "trials_" + name : name, name));
  }
  return table;
}

std::vector<TableCell> features_row(const TrialRecord& trial) {
  const TrialRow& row = trial.row.trial;
  std::vector<TableCell> cells = {text_or_missing(row.trial_id),
                                  text_or_missing(row.algorithm),
                                  text_or_missing(row.lighting),
                                  text_or_missing(row.day),
                                  text_or_missing(row.batch),
                                  cell_of(row.success),
                                  cell_of(row.time_s),
                                  cell_of(row.distance_m),
                                  text_or_missing(to_string(row.end_reason))};
  for (const FeatureColumn& column : feature_columns()) {
    cells.push_back(cell_of(column.get(trial.row.features)));
  }
  cells.push_back(cell_of(trial.median_speed_cmd_mps));
  cells.push_back(cell_of(trial.median_loop_latency_ms));
  for (const std::string& extra : row.extra) {
    cells.push_back(text_or_missing(extra));
  }
  return cells;
}

Table certificates_table(const Bundle& bundle) {
  Table table;
  table.name = "certificates";
  table.title = "Certificate of each trial";
  table.synthetic = synthetic_label(bundle.info);
  const auto number = [](std::string name, std::string heading, std::string unit, int decimals) {
    return Column{
        std::move(name), std::move(heading), std::move(unit), ColumnKind::number, decimals};
  };
  const auto integer = [](std::string name, std::string heading) {
    return Column{std::move(name), std::move(heading), "", ColumnKind::integer};
  };
  table.columns = {text_column("trial_id", "trial"),
                   integer("success", "success"),
                   integer("issued", "issued"),
                   number("issued_s", "issued at", "s", 1),
                   number("certificate_m", "T_t", "m", 3),
                   number("corridor_value_m", "V_t", "m", 3),
                   integer("bottleneck_edge", "bottleneck edge"),
                   number("bottleneck_x_m", "x", "m", 2),
                   number("bottleneck_y_m", "y", "m", 2),
                   number("bottleneck_yaw_rad", "yaw", "rad", 2),
                   number("bottleneck_margin_m", "margin", "m", 3),
                   number("bottleneck_width_m", "width", "m", 3),
                   number("bottleneck_turn_radius_m", "turn radius", "m", 2),
                   integer("ticks", "ticks"),
                   integer("nodes", "nodes"),
                   integer("edges", "edges"),
                   text_column("flags", "flags"),
                   text_column("log_sha256", "SHA-256 of the log")};
  return table;
}

std::vector<TableCell> certificates_row(const StudiedTrial& trial, const std::string& log_sha256) {
  const auto& ticks = trial.series.ticks;
  const CertifiedTick last = ticks.empty() ? CertifiedTick{} : ticks.back();
  std::uint32_t flags = 0;
  for (const CertifiedTick& tick : ticks) {
    flags |= tick.flags;
  }
  std::vector<TableCell> cells = {text_or_missing(trial.row->trial_id),
                                  cell_of(trial.row->success),
                                  std::int64_t{last.issued ? 1 : 0},
                                  cell_of(trial.features.issued_s),
                                  cell_of(trial.features.certificate_m),
                                  Number{last.corridor_value_m}};
  if (const auto& b = trial.series.bottleneck) {
    cells.insert(cells.end(),
                 {std::int64_t{b->edge},
                  Number{b->pose.position.x_m},
                  Number{b->pose.position.y_m},
                  Number{b->pose.yaw_rad},
                  Number{b->margin_m},
                  Number{b->width_m},
                  Number{b->turn_radius_m}});
  } else {
    cells.insert(cells.end(), 7, TableCell{});
  }
  cells.insert(cells.end(),
               {static_cast<std::int64_t>(ticks.size()),
                std::int64_t{last.nodes},
                std::int64_t{last.edges},
                text_or_missing(flag_words(flags)),
                text_or_missing(log_sha256)});
  return cells;
}

}  // namespace tcert
