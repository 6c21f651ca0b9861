#include "reports/witness_check.hpp"

#include "analysis/study/witness/felt_samples.hpp"

namespace tcert {

std::string fault_of_witness(const WitnessDocument& document,
                             const BundleInfo& info,
                             const TrialLog& log,
                             const std::string& log_sha256) {
  if (!info.course.goal) {
    return "the bundle has no goal";
  }
  if (document.log_sha256 != log_sha256) {
    return "it is of another log";
  }
  const Robot& robot = document.robot;
  witness::Samples samples = study::felt_samples(log, robot, document.pose_bridge_s);
  witness::drop_glitches(samples, robot, document.rule.strips.lost_share);
  if (samples.size() == 0) {
    return "its log holds no touch with a pose";
  }
  WitnessDocument of_bundle = document;
  of_bundle.robot.rays = info.robot.rays;
  of_bundle.start = witness::start_of(robot, info.course, samples);
  of_bundle.goal = *info.course.goal;
  if (to_json(of_bundle) != to_json(document)) {
    return "it states other rays, or another course, than the bundle";
  }
  const witness::FreeCells cells =
      witness::free_space(robot, {document.start, document.goal}, samples, document.rule);
  if (!(cells == document.cells)) {
    return "the free space built from the log is another";
  }
  const witness::Checked checked =
      witness::check(document.path, cells, document.start, document.goal, robot);
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
