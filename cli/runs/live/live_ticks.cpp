#include "cli/runs/live/live_ticks.hpp"

#include "analysis/study/replay/replay_trial.hpp"
#include "cli/runs/guard_options.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/live/live_bundle.hpp"
#include "cli/runs/result_folder.hpp"
#include "reports/audit.hpp"
#include "reports/features_table.hpp"

namespace tcert::cli {

namespace {

ActionSetup actions_of(const LiveRequest& request,
                       const Robot& robot,
                       const study::ParameterSet& parameters,
                       Progress& progress) {
  ActionSetup setup = study::actions_of(
      robot,
      parameters,
      parameters.speed_law,
      tracking_error_table(request.tracking_error, request.logs.decimal_comma, progress));
  setup.rules = rules_of(request.monitor);
  if (request.monitor.risk) {
    setup.risk = parameters.risk;
  }
  return setup;
}

}  // namespace

LiveTicks::LiveTicks(const LiveRequest& request,
                     const BundleInfo& info,
                     LiveWitness::WhenLate when_late,
                     Progress& progress)
    : parameters_(effective_parameters(info.parameters, request.logs.parameters)),
      robot_(effective_robot(info, parameters_)),
      format_{parameters_.speed_law, request.ray_margins, synthetic_label(info), request.guards},
      runtime_(runtime_of(info.course, actions_of(request, robot_, parameters_, progress))) {
  format_.risk = request.monitor.risk;
  format_.validity = parameters_.certificate.obstacle_speed_mps > 0.0;
  format_.rules = names_of(runtime_.actions().monitor().rules());
  if (parameters_.certificate.clearance == ClearanceReading::witness) {
    witness_.emplace(robot_, info.course, parameters_, when_late);
  }
  if (!request.audit.empty()) {
    require_apart(request.bundle, request.audit);
    audit_.emplace(request.audit, parameters_.guards, format_.rules);
  }
  if (!request.record.empty()) {
    record_.emplace(request.record, info_of_record(info, robot_, parameters_));
  }
}

const std::string& LiveTicks::row_of(const TickLine& line, StatusLines& status) {
  const RuntimeTick now = runtime_.update(line.tick, {line.speed_cmd_mps, line.yaw_rate_cmd_rps});
  CertifiedTick certified = now.certified;
  if (witness_) {
    witness_->take(line.tick, certified);
  }
  if (record_) {
    record_->add(line, certified, status);
  }
  if (audit_) {
    audit_->add(line.tick, certified, now.acted, status);
  }
  row_.clear();
  append_series_row(row_,
                    line.tick,
                    certified,
                    runtime_.certifier().ray_margins(),
                    format_,
                    now.acted,
                    line.yaw_rate_cmd_rps);
  return row_;
}

bool LiveTicks::close(StatusLines& status) {
  const bool audited = !audit_ || audit_->close(status);
  if (const std::string missing = words_of_signals(runtime_.actions().monitor().never_known());
      !missing.empty()) {
    status.say("tcert live: no tick had " + missing + ": rules that speak of it could not alarm.");
  }
  const bool recorded = !record_ || record_->close(status);
  if (witness_) {
    status.say("tcert live: " + witness_->conclude());
  }
  return audited && recorded;
}

}  // namespace tcert::cli
