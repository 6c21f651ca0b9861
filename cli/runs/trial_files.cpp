#include "cli/runs/trial_files.hpp"

#include <federation/submap_text.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "analysis/study/federation/trial_submap.hpp"
#include "datasets/tick_table.hpp"
#include "reports/edges_table.hpp"
#include "reports/features_table.hpp"
#include "reports/witness_json.hpp"

namespace tcert::cli {
namespace {

std::string series_csv(const study::StudiedTrial& trial,
                       const SeriesFormat& format,
                       const Robot& robot) {
  std::string text = series_header(format, robot);
  const std::size_t rays = format.ray_margins ? trial.ticks.rays : 0;
  const std::span<const double> margins(trial.ray_margins);
  for (std::size_t i = 0; i < trial.ticks.size(); ++i) {
    append_series_row(
        text, trial.ticks[i], trial.series.ticks[i], margins.subspan(i * rays, rays), format);
  }
  return text;
}

std::string comment_line(const std::optional<SyntheticLabel>& label) {
  return label ? "# " + to_string(*label) + '\n' : std::string();
}

std::optional<WitnessedEdges> witnessed_edges(const study::StudiedTrial& trial,
                                              double merge_radius_m) {
  if (!trial.proof->edges) {
    return std::nullopt;
  }
  return WitnessedEdges{
      merge_radius_m, trial.series.nodes, trial.series.edges, trial.proof->edges->found};
}

}  // namespace

void write_trial_files(const study::StudiedTrial& trial,
                       const ResultFolder& folder,
                       const CertifyFiles& files,
                       const SeriesFormat& format,
                       const Robot& robot,
                       std::span<const RangeKeys> range_keys) {
  const std::string name = trial.row->trial_id + ".csv";
  if (files.series) {
    const witness::EdgePaths* const proofs =
        trial.proof && trial.proof->edges ? &trial.proof->edges->found : nullptr;
    folder.write(std::filesystem::path("series") / name, series_csv(trial, format, robot));
    folder.write(std::filesystem::path("edges") / name,
                 edges_csv(trial.series, proofs, format.synthetic));
  }
  if (files.ticks) {
    // A log, so it is labelled as those of the corpus are.
    folder.write(std::filesystem::path("ticks") / name,
                 comment_line(format.synthetic) + to_ticks_csv(robot, trial.ticks, range_keys));
  }
}

void write_witness(const study::StudiedTrial& trial,
                   const std::string& log_sha256,
                   const OpenedBundle& opened,
                   const Robot& robot,
                   const ResultFolder& folder) {
  if (!trial.proof || (!trial.proof->witness && !trial.proof->edges)) {
    return;
  }
  const study::ParameterSet& parameters = opened.parameters;
  const study::Proof& proof = *trial.proof;
  const WitnessDocument document{
      synthetic_label(opened.bundle.info),
      trial.row->trial_id,
      log_sha256,
      robot,
      proof.start,
      *opened.bundle.info.course.goal,
      parameters.witness.pose_bridge_s,
      witness::free_space_options(parameters.witness, parameters.certificate),
      proof.cells,
      proof.witness ? proof.witness->path : witness::Path{},
      proof.witness ? proof.witness->checked : witness::Checked{},
      witnessed_edges(trial, parameters.certificate.merge_radius_m)};
  folder.write(std::filesystem::path("witness") / (trial.row->trial_id + ".json"),
               to_json(document));
}

void write_submap(const study::StudiedTrial& trial,
                  const std::string& log_sha256,
                  const OpenedBundle& opened,
                  const Robot& robot,
                  const ResultFolder& folder) {
  const study::EdgeProofs* const proofs =
      trial.proof && trial.proof->edges ? &*trial.proof->edges : nullptr;
  Course course = opened.bundle.info.course;
  if (proofs != nullptr) {
    course.start = trial.proof->start;
  }
  federation::Submap submap;
  submap.agent = federation::agent_of(robot);
  if (const auto label = synthetic_label(opened.bundle.info)) {
    submap.synthetic = label->seed ? std::to_string(*label->seed) : "-";
  }
  submap.sources = {study::source_of_trial(trial.series.nodes,
                                           trial.series.edges,
                                           proofs,
                                           course,
                                           robot,
                                           opened.parameters.certificate.clearance)};
  submap.sources.front().name = study::source_name(trial.row->trial_id, log_sha256);
  folder.write(std::filesystem::path("submaps") / (trial.row->trial_id + ".csv"),
               federation::to_text(federation::in_order(std::move(submap))));
}

}  // namespace tcert::cli
