#include "analysis/study/trials/study.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <utility>

#include "analysis/study/trials/certified_ground.hpp"
#include "analysis/study/witness/felt_samples.hpp"
#include "analysis/study/witness/witness_series.hpp"
#include "datasets/tick_limit.hpp"

namespace tcert::study {
namespace {

std::vector<double> latencies_of(const TrialLog& log) { return log.control.loop_latency_ms; }

std::vector<double> speeds_of(const TrialLog& log) {
  return log.merged ? log.merged->speed_cmd_mps : log.control.speed_cmd_mps;
}

/// As certify_trial, keeping the margin of every ray at every tick.
std::vector<double> ray_margins_of(Certifier& certifier, const TickTable& ticks) {
  certifier.reset();
  std::vector<double> margins;
  margins.reserve(ticks.size() * ticks.rays);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    certifier.update(ticks[i]);
    const auto now = certifier.ray_margins();
    margins.insert(margins.end(), now.begin(), now.end());
  }
  return margins;
}

/// \pre all but the proof is there.
void add_proof(const TrialLog& log,
               const Robot& robot,
               const Course& course,
               const ParameterSet& parameters,
               const StudyOptions& options,
               StudiedTrial& trial) {
  const CertificateParameters certificate = parameters_of_ticks(parameters.certificate);
  const witness::WitnessParameters& of_witness = parameters.witness;
  trial.proof = prove(witness_samples(log, robot, of_witness, certificate),
                      robot,
                      course,
                      of_witness,
                      certificate,
                      options.witness_edges ? &trial.series : nullptr);
  if (parameters.certificate.clearance != ClearanceReading::witness) {
    return;
  }
  if (of_witness.witness_every > 0) {
    trial.looks = witness_looks(felt_samples(log, robot, of_witness.pose_bridge_s),
                                trial.series.ticks,
                                robot,
                                course,
                                of_witness,
                                certificate);
    keep_best(trial.looks, robot, course, *trial.proof);
  }
  certify_by_witness(trial);
}

}  // namespace

std::optional<TrialLog> read_studied(const Bundle& bundle,
                                     const TrialRow& row,
                                     const StudyOptions& options,
                                     StudiedTrial& trial) {
  trial.row = &row;
  TrialResult read = read_trial(bundle, row, options.read);
  trial.diagnostics = std::move(read.diagnostics);
  trial.rejected = !read.log.has_value();
  if (read.log) {
    trial.log_bytes = read.log->bytes;
    trial.speed_cmd_mps = speeds_of(*read.log);
    trial.loop_latency_ms = latencies_of(*read.log);
  }
  return std::move(read.log);
}

void study_trials(const Bundle& bundle,
                  std::span<const std::size_t> trials,
                  const ParameterSet& parameters,
                  const StudyOptions& options,
                  const TrialWork& work) {
  validate(parameters);
  const Robot robot = with_overrides(bundle.info.robot, parameters.robot);
  const bool by_witness = parameters.certificate.clearance == ClearanceReading::witness;
  const CertificateParameters certificate = parameters_of_ticks(parameters.certificate);
  const auto make = [&] { return Certifier(robot, bundle.info.course, certificate); };
  // Made here once so that parameters out of range are reported before any trial is read.
  (void)make();
  tbb::enumerable_thread_specific<Certifier> certifiers(make);
  in_order(trials.size(), options.threads, [&](std::size_t i) {
    StudiedTrial trial;
    std::optional<TrialLog> log = read_studied(bundle, bundle.trials[trials[i]], options, trial);
    reject_too_many_ticks(log, parameters.resample.tick_s, trial.row->trial_id, trial.diagnostics);
    trial.rejected = !log;
    if (log) {
      trial.ticks = resample(*log, parameters.resample);
      if (options.ground != nullptr) {
        trial.ticks = options.ground->ticks_on(trial.ticks);
      }
      Certifier& certifier = certifiers.local();
      trial.series = certify_trial(certifier, trial.ticks);
      if (options.ray_margins) {
        trial.ray_margins = ray_margins_of(certifier, trial.ticks);
      }
      trial.features =
          early_features(robot, trial.ticks, trial.series.ticks, parameters.early_window);
      trial.not_issued = why_not_issued(bundle.info.course, trial.ticks, trial.series);
      if (by_witness || options.witness) {
        add_proof(*log, robot, bundle.info.course, parameters, options, trial);
      }
    }
    return work(std::move(trial));
  });
}

}  // namespace tcert::study
