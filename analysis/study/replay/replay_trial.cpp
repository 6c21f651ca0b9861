#include "analysis/study/replay/replay_trial.hpp"

#include "analysis/study/trials/study_tables.hpp"

namespace tcert::study {
std::vector<ReplayedTrial> replay_trial(const StudiedTrial& trial,
                                        const BundleInfo& info,
                                        const ParameterSet& parameters,
                                        const ReplaySetup& setup) {
  const std::optional<double> latency_ms = known_median(trial.loop_latency_ms);
  const bool replan = setup.replan && info.course.goal.has_value();
  std::optional<Certifier> certifier;
  if (replan) {
    certifier.emplace(with_overrides(info.robot, parameters.robot),
                      info.course,
                      parameters_of_ticks(parameters.certificate));
  }
  std::vector<ReplayedTrial> replayed;
  for (const SpeedLaw& law : setup.laws) {
    Guards guards(law, parameters.guards, setup.tracking_error);
    ReplayedTrial one;
    one.guarded = guard_trial(guards, trial.ticks, trial.series.ticks);
    one.record.trial = *trial.row;
    one.record.loop_latency_ms = latency_ms;
    one.record.law = law;
    one.record.replay = replay(trial.ticks, trial.series.ticks, one.guarded, parameters.replay);
    one.record.kept =
        trial.row->success.value_or(false) && keeps_success(one.record.replay, info.trial_limit_s);
    if (replan) {
      RoutePlanner planner = route_planner(
          info.course, parameters.certificate, guards, parameters.guards, parameters.route);
      one.record.replans = replan_trial(*certifier, planner, trial.ticks, one.guarded);
    }
    replayed.push_back(std::move(one));
  }
  return replayed;
}

}  // namespace tcert::study
