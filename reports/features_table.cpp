#include "reports/features_table.hpp"

#include <cmath>
#include <set>
#include <string>
#include <table/nearest_name.hpp>

#include "datasets/trial_table.hpp"
#include "reports/columns_of.hpp"
#include "reports/series.hpp"

namespace tcert {
namespace {

using study::TrialRecord;

/// A whole number has no decimals in print.
TableCell short_cell(const std::optional<double>& value) {
  return value ? TableCell{Number{*value, std::trunc(*value) == *value ? 0 : kColumnDecimals}}
               : TableCell{};
}

ColumnsOf<TrialRow> name_columns() {
  return ColumnsOf<TrialRow>()
      .text("trial_id", "trial", [](auto& r) { return not_empty(r.trial_id); })
      .doc("name of the trial, as in trials.csv");
}

ColumnsOf<TrialRow> success_columns() {
  return ColumnsOf<TrialRow>()
      .integer("success", "success", &TrialRow::success)
      .doc("1 if the trial succeeded, 0 if it failed");
}

/// Of the trial's row in trials.csv.
ColumnsOf<TrialRow> trial_columns() {
  const auto whole = [](const TrialRow& r) -> const TrialRow* { return &r; };
  return name_columns()
      .text("algorithm", "algorithm", [](auto& r) { return not_empty(r.algorithm); })
      .doc("what controlled the robot")
      .text("lighting", "lighting", [](auto& r) { return not_empty(r.lighting); })
      .doc("as in trials.csv")
      .text("day", "day", [](auto& r) { return not_empty(r.day); })
      .doc("trials of one day share a cluster")
      .text("batch", "batch", [](auto& r) { return not_empty(r.batch); })
      .doc("as in trials.csv")
      .part(success_columns(), whole)
      .add(fixed_column("time_s", "time", "s", 1), [](auto& r) { return short_cell(r.time_s); })
      .doc("how long the trial took: to egress, or to the end of a failed trial; no clock")
      .add(fixed_column("distance_m", "distance", "m", 2),
           [](auto& r) { return short_cell(r.distance_m); })
      .doc("driven, as in trials.csv")
      .text("end_reason",
            "end",
            [](auto& r) { return not_empty(std::string(to_string(r.end_reason))); })
      .doc("how the trial ended");
}

/// But for those of trials.csv that are the bundle's own.
ColumnsOf<TrialRecord> feature_columns() {
  ColumnsOf<TrialRecord> columns;
  columns.part(trial_columns(), [](auto& r) { return &r.row.trial; });
  for (const study::FeatureColumn& feature : study::feature_columns()) {
    const std::string name(feature.name);
    columns
        .add(fixed_column(name, name, std::string(feature.unit)),
             [get = feature.get](auto& r) { return short_cell(get(r.row.features)); })
        .doc(std::string(feature.meaning));
  }
  columns
      .add(fixed_column("median_speed_cmd_mps", "commanded speed", "m/s"),
           [](auto& r) { return short_cell(r.median_speed_cmd_mps); })
      .doc("median of the speed commands")
      .add(fixed_column("median_loop_latency_ms", "latency", "ms"),
           [](auto& r) { return short_cell(r.median_loop_latency_ms); })
      .doc("median of the control loop's latency");
  return columns;
}

struct CertifiedTrial {
  const study::StudiedTrial& trial;
  const std::string& log_sha256;

  [[nodiscard]] CertifiedTick last() const {
    return trial.series.ticks.empty() ? CertifiedTick{} : trial.series.ticks.back();
  }
  [[nodiscard]] std::uint32_t flags() const {
    std::uint32_t flags = 0;
    for (const CertifiedTick& tick : trial.series.ticks) {
      flags |= tick.flags;
    }
    return flags;
  }
};

ColumnsOf<Bottleneck> bottleneck_columns() {
  return ColumnsOf<Bottleneck>()
      .integer("bottleneck_edge", "bottleneck edge", &Bottleneck::edge)
      .doc("number of the edge that decides the certificate")
      .fixed("bottleneck_x_m", "x", "m", 2, [](auto& b) { return b.pose.position.x_m; })
      .doc("pose of the bottleneck")
      .fixed("bottleneck_y_m", "y", "m", 2, [](auto& b) { return b.pose.position.y_m; })
      .doc("the same")
      .fixed("bottleneck_yaw_rad", "yaw", "rad", 2, [](auto& b) { return b.pose.yaw_rad; })
      .doc("the same")
      .fixed("bottleneck_margin_m", "margin", "m", 3, &Bottleneck::margin_m)
      .doc("margin there")
      .fixed("bottleneck_width_m", "width", "m", 3, &Bottleneck::width_m)
      .doc("width there")
      .fixed("bottleneck_turn_radius_m", "turn radius", "m", 2, &Bottleneck::turn_radius_m)
      .doc("turn radius there");
}

std::optional<double> x_of(const std::optional<Point>& p) {
  return p ? std::optional(p->x_m) : std::nullopt;
}

std::optional<double> y_of(const std::optional<Point>& p) {
  return p ? std::optional(p->y_m) : std::nullopt;
}

ColumnsOf<study::Proof> witness_columns() {
  const auto place = [](const study::Proof& proof) {
    return proof.witness ? std::optional(proof.witness->checked.bottleneck) : std::nullopt;
  };
  return ColumnsOf<study::Proof>()
      .add(fixed_column("witness_m", "witness", "m"),
           [](auto& r) { return short_cell(r.certificate_m()); })
      .doc("margin of the witness, a path that was found and checked; empty if there is none")
      .add(fixed_column("witness_x_m", "x", "m", 2),
           [=](auto& r) { return short_cell(x_of(place(r))); })
      .doc("where on the witness its margin is decided")
      .add(fixed_column("witness_y_m", "y", "m", 2),
           [=](auto& r) { return short_cell(y_of(place(r))); })
      .doc("the same");
}

ColumnsOf<study::EdgeProofs> edge_proof_columns() {
  return ColumnsOf<study::EdgeProofs>()
      .integer("edges_proved", "edges proved", [](auto& r) { return r.proven(); })
      .doc("edges of the graph whose path has a margin above 0 (--witness-edges)")
      .add(fixed_column("chain_m", "chain", "m"), [](auto& r) { return short_cell(r.chain_m); })
      .doc("margin of the widest chain of such paths from S to G; empty if there is none");
}

ColumnsOf<CertifiedTrial> certificate_columns(WitnessColumns witness) {
  ColumnsOf<CertifiedTrial> columns;
  columns.part(name_columns(), [](auto& r) { return r.trial.row; })
      .part(success_columns(), [](auto& r) { return r.trial.row; })
      .integer("issued", "issued", [](auto& r) { return r.last().issued; })
      .doc("1 if T_t was above 0 at any tick, else 0")
      .add(fixed_column("issued_s", "issued at", "s", 1),
           [](auto& r) { return short_cell(r.trial.features.issued_s); })
      .doc("when it was issued, seconds since the first tick")
      .add(fixed_column("certificate_m", "T_t", "m"),
           [](auto& r) { return short_cell(r.trial.features.certificate_m); })
      .doc("T_t at the last tick; empty if no path joined S and G")
      .fixed("corridor_value_m", "V_t", "m", 3, [](auto& r) { return r.last().corridor_value_m; })
      .doc("V_t at the last tick; empty without a path from S")
      .part(bottleneck_columns(), [](auto& r) { return r.trial.series.bottleneck; })
      .integer("ticks", "ticks", [](auto& r) { return r.trial.series.ticks.size(); })
      .doc("of the log")
      .integer("nodes", "nodes", [](auto& r) { return r.last().nodes; })
      .doc("of the graph at the end")
      .integer("edges", "edges", [](auto& r) { return r.last().edges; })
      .doc("of the graph at the end")
      .text("flags", "flags", [](auto& r) { return not_empty(flag_words(r.flags())); })
      .doc("every flag that any tick had, + between")
      .text("log_sha256", "SHA-256 of the log", [](auto& r) { return not_empty(r.log_sha256); })
      .doc("digest of the log's files");
  if (witness != WitnessColumns::no) {
    columns.part(witness_columns(), [](auto& r) -> const study::Proof* {
      return r.trial.proof ? &*r.trial.proof : nullptr;
    });
  }
  if (witness == WitnessColumns::with_edges) {
    columns.part(edge_proof_columns(), [](auto& r) -> const study::EdgeProofs* {
      return r.trial.proof && r.trial.proof->edges ? &*r.trial.proof->edges : nullptr;
    });
  }
  return columns;
}

}  // namespace

std::optional<SyntheticLabel> synthetic_label(const BundleInfo& info) {
  return info.synthetic ? std::optional(SyntheticLabel{info.seed}) : std::nullopt;
}

Table features_table(const Bundle& bundle) {
  Table table = feature_columns().table("features", "Features of each trial");
  table.synthetic = synthetic_label(bundle.info);
  std::set<std::string> taken;
  for (const Column& column : table.columns) {
    taken.insert(table::case_folded(column.name));
  }
  for (const std::string& name : bundle.extra_columns) {
    // A column of the log that is called like a feature must not shadow it.
    const bool is_taken = taken.contains(table::case_folded(name));
    table.columns.push_back(text_column(is_taken ? "trials_" + name : name, name));
    taken.insert(table::case_folded(table.columns.back().name));
  }
  return table;
}

std::vector<TableCell> features_row(const TrialRecord& trial) {
  static const ColumnsOf<TrialRecord> columns = feature_columns();
  std::vector<TableCell> cells = columns.row(trial);
  for (const std::string& extra : trial.row.trial.extra) {
    cells.push_back(text_cell(not_empty(extra)));
  }
  return cells;
}

Table certificates_table(const Bundle& bundle, WitnessColumns witness) {
  Table table = certificate_columns(witness).table("certificates", "Certificate of each trial");
  table.synthetic = synthetic_label(bundle.info);
  return table;
}

std::vector<ColumnDoc> feature_column_docs() {
  std::vector<ColumnDoc> docs = feature_columns().docs();
  docs.push_back({"...", "", "further columns of trials.csv, as they are"});
  docs.push_back(synthetic_seed_doc());
  return docs;
}

std::vector<ColumnDoc> certificate_column_docs() {
  std::vector<ColumnDoc> docs = certificate_columns(WitnessColumns::with_edges).docs();
  docs.push_back(synthetic_seed_doc());
  return docs;
}

std::vector<TableCell> certificates_row(const study::StudiedTrial& trial,
                                        const std::string& log_sha256,
                                        WitnessColumns witness) {
  static const ColumnsOf<CertifiedTrial> plain = certificate_columns(WitnessColumns::no);
  static const ColumnsOf<CertifiedTrial> full = certificate_columns(WitnessColumns::yes);
  static const ColumnsOf<CertifiedTrial> most = certificate_columns(WitnessColumns::with_edges);
  const ColumnsOf<CertifiedTrial>& columns = witness == WitnessColumns::no    ? plain
                                             : witness == WitnessColumns::yes ? full
                                                                              : most;
  return columns.row({trial, log_sha256});
}

}  // namespace tcert
