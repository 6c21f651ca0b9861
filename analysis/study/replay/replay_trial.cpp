#include "analysis/study/replay/replay_trial.hpp"

#include <utility>

#include "analysis/study/trials/study_tables.hpp"
#include "analysis/study/witness/prove_trial.hpp"

namespace tcert::study {

ActionSetup actions_of(const Robot& robot,
                       const ParameterSet& parameters,
                       const SpeedLaw& law,
                       const TrackingErrorTable& tracking_error) {
  return {
      {robot, parameters_of_ticks(parameters.certificate), law, parameters.guards, tracking_error},
      std::nullopt,
      {},
      parameters.fallback};
}

std::vector<ReplayedTrial> replay_trial(const StudiedTrial& trial,
                                        const BundleInfo& info,
                                        const ParameterSet& parameters,
                                        const ReplaySetup& setup) {
  const std::optional<double> latency_ms = known_median(trial.loop_latency_ms);
  const Robot robot = with_overrides(info.robot, parameters.robot);
  const bool replan = setup.replan && info.course.goal.has_value();
  std::optional<Certifier> certifier;
  if (replan) {
    certifier.emplace(robot, info.course, parameters_of_ticks(parameters.certificate));
  }
  std::vector<ReplayedTrial> replayed;
  for (const SpeedLaw& law : setup.laws) {
    ActionSetup of_law = actions_of(robot, parameters, law, setup.tracking_error);
    of_law.rules = setup.rules;
    if (setup.risk) {
      of_law.risk = parameters.risk;
    }
    TickActions actions(std::move(of_law));
    ReplayedTrial one;
    one.acted = act_trial(actions, trial.ticks, trial.series.ticks);
    one.record.trial = *trial.row;
    one.record.loop_latency_ms = latency_ms;
    one.record.law = law;
    one.record.replay = replay(trial.ticks, trial.series.ticks, one.acted, parameters.replay);
    one.record.kept =
        trial.row->success.value_or(false) && keeps_success(one.record.replay, info.trial_limit_s);
    if (replan) {
      RoutePlanner planner = route_planner(info.course,
                                           parameters.certificate,
                                           actions.guards(),
                                           parameters.guards,
                                           parameters.route);
      one.record.replans = replan_trial(*certifier, planner, trial.ticks, one.acted);
    }
    replayed.push_back(std::move(one));
  }
  return replayed;
}

}  // namespace tcert::study
