#include "reports/witness_check.hpp"

#include "analysis/study/witness/prove_trial.hpp"
#include "reports/features_table.hpp"

namespace tcert {
namespace {

/// All that a document states before its path and its cells.
std::string head_of(WitnessDocument document) {
  document.path.clear();
  document.cells = {};
  return to_json(document);
}

}  // namespace

std::string fault_of_witness(const WitnessDocument& document,
                             const BundleInfo& info,
                             const study::ParameterSet& parameters,
                             const TrialLog& log,
                             const std::string& log_sha256) {
  if (!info.course.goal) {
    return "the bundle has no goal";
  }
  if (document.log_sha256 != log_sha256) {
    return "it is of another log";
  }
  const Robot robot = study::with_overrides(info.robot, parameters.robot);
  const witness::Samples samples =
      study::witness_samples(log, robot, parameters.witness, parameters.certificate);
  if (samples.size() == 0) {
    return "its log holds no touch with a pose";
  }
  WitnessDocument of_run = document;
  of_run.synthetic = synthetic_label(info);
  of_run.robot = robot;
  of_run.rule = witness::free_space_options(parameters.witness, parameters.certificate);
  of_run.pose_bridge_s = parameters.witness.pose_bridge_s;
  of_run.start = witness::start_of(robot, info.course, samples);
  of_run.goal = *info.course.goal;
  if (head_of(of_run) != head_of(document)) {
    return "it states another robot, course, rule or label than the run";
  }
  const witness::FreeCells cells =
      witness::free_space(robot, {of_run.start, of_run.goal}, samples, document.rule);
  if (!(cells == document.cells)) {
    return "the free space built from the log is another";
  }
  const witness::Checked checked =
      witness::check(document.path, cells, of_run.start, of_run.goal, robot);
  if (!checked.refused.empty()) {
    return "the checker refuses it: " + checked.refused;
  }
  const witness::Checked& stated = document.stated;
  const bool is_as_stated =
      checked.margin_m == stated.margin_m && checked.clearance_m == stated.clearance_m &&
      checked.turn_radius_m == stated.turn_radius_m && checked.bottleneck == stated.bottleneck;
  return is_as_stated ? "" : "the checker measures another margin";
}

}  // namespace tcert
