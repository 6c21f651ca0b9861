#include "reports/features_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <table/nearest_name.hpp>

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

struct Described {
  Column column;
  std::string_view doc;
};

Column text_column(std::string name, std::string heading) {
  return {std::move(name), std::move(heading), "", ColumnKind::text};
}

Column integer_column(std::string name, std::string heading) {
  return {std::move(name), std::move(heading), "", ColumnKind::integer};
}

Column number_column(std::string name, std::string heading, std::string unit, int decimals) {
  return {std::move(name), std::move(heading), std::move(unit), ColumnKind::number, decimals};
}

/// Of the trial's row in trials.csv.
std::vector<Described> trial_columns() {
  return {{text_column("trial_id", "trial"), "name of the trial, as in trials.csv"},
          {text_column("algorithm", "algorithm"), "what controlled the robot"},
          {text_column("lighting", "lighting"), "as in trials.csv"},
          {text_column("day", "day"), "trials of one day share a cluster"},
          {text_column("batch", "batch"), "as in trials.csv"},
          {integer_column("success", "success"), "1 if the trial succeeded, 0 if it failed"},
          {number_column("time_s", "time", "s", 1), "to egress, or to the end of a failed trial"},
          {number_column("distance_m", "distance", "m", 2), "driven, as in trials.csv"},
          {text_column("end_reason", "end"), "how the trial ended"}};
}

/// Of its control samples.
std::vector<Described> control_columns() {
  return {{number_column("median_speed_cmd_mps", "commanded speed", "m/s", 3),
           "median of the speed commands"},
          {number_column("median_loop_latency_ms", "latency", "ms", 3),
           "median of the control loop's latency"}};
}

std::vector<Described> certificate_columns() {
  return {{text_column("trial_id", "trial"), "name of the trial, as in trials.csv"},
          {integer_column("success", "success"), "1 if the trial succeeded, 0 if it failed"},
          {integer_column("issued", "issued"), "1 if a certificate was issued, else 0"},
          {number_column("issued_s", "issued at", "s", 1),
           "when it was issued, seconds since the first tick"},
          {number_column("certificate_m", "T_t", "m", 3),
           "bottleneck margin of the widest path from S to G at the last tick"},
          {number_column("corridor_value_m", "V_t", "m", 3),
           "bottleneck margin of the widest path from S to the last node"},
          {integer_column("bottleneck_edge", "bottleneck edge"),
           "number of the edge that decides the certificate"},
          {number_column("bottleneck_x_m", "x", "m", 2), "pose of the bottleneck"},
          {number_column("bottleneck_y_m", "y", "m", 2), "the same"},
          {number_column("bottleneck_yaw_rad", "yaw", "rad", 2), "the same"},
          {number_column("bottleneck_margin_m", "margin", "m", 3), "margin there"},
          {number_column("bottleneck_width_m", "width", "m", 3), "width there"},
          {number_column("bottleneck_turn_radius_m", "turn radius", "m", 2), "turn radius there"},
          {integer_column("ticks", "ticks"), "of the log"},
          {integer_column("nodes", "nodes"), "of the graph at the end"},
          {integer_column("edges", "edges"), "of the graph at the end"},
          {text_column("flags", "flags"), "every flag that any tick had, + between"},
          {text_column("log_sha256", "SHA-256 of the log"), "digest of the log's files"}};
}

void append_docs(const std::vector<Described>& columns, std::vector<ColumnDoc>& docs) {
  for (const Described& one : columns) {
    docs.push_back({one.column.name, one.column.unit, std::string(one.doc)});
  }
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
  for (const Described& one : trial_columns()) {
    table.columns.push_back(one.column);
  }
  for (const study::FeatureColumn& column : study::feature_columns()) {
    const std::string name(column.name);
    table.columns.push_back({name, name, std::string(column.unit), ColumnKind::number});
  }
  for (const Described& one : control_columns()) {
    table.columns.push_back(one.column);
  }
  std::set<std::string> taken;
  for (const Column& column : table.columns) {
    taken.insert(table::case_folded(column.name));
  }
  for (const std::string& name : bundle.extra_columns) {
    // A column of the log that is called like a feature must not shadow it.
    const bool is_taken = taken.count(table::case_folded(name)) != 0;
    table.columns.push_back(text_column(is_taken ? "trials_" + name : name, name));
    taken.insert(table::case_folded(table.columns.back().name));
  }
  return table;
}

std::vector<TableCell> features_row(const study::TrialRecord& trial) {
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
  for (const study::FeatureColumn& column : study::feature_columns()) {
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
  for (const Described& one : certificate_columns()) {
    table.columns.push_back(one.column);
  }
  return table;
}

std::vector<ColumnDoc> feature_column_docs() {
  std::vector<ColumnDoc> docs;
  append_docs(trial_columns(), docs);
  for (const study::FeatureColumn& column : study::feature_columns()) {
    docs.push_back(
        {std::string(column.name), std::string(column.unit), std::string(column.meaning)});
  }
  append_docs(control_columns(), docs);
  docs.push_back({"...", "", "further columns of trials.csv, as they are"});
  docs.push_back({"synthetic_seed", "", "seed of synthetic data; not in real data"});
  return docs;
}

std::vector<ColumnDoc> certificate_column_docs() {
  std::vector<ColumnDoc> docs;
  append_docs(certificate_columns(), docs);
  docs.push_back({"synthetic_seed", "", "seed of synthetic data; not in real data"});
  return docs;
}

std::vector<TableCell> certificates_row(const study::StudiedTrial& trial,
                                        const std::string& log_sha256) {
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
