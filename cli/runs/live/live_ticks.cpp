#include "cli/runs/live/live_ticks.hpp"

#include "cli/runs/guard_options.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/live/live_bundle.hpp"
#include "cli/runs/result_folder.hpp"
#include "reports/features_table.hpp"

namespace tcert::cli {

LiveTicks::LiveTicks(const LiveRequest& request,
                     const BundleInfo& info,
                     LiveWitness::WhenLate when_late,
                     Progress& progress)
    : parameters_(effective_parameters(info.parameters, request.logs.parameters)),
      robot_(effective_robot(info, parameters_)),
      format_{parameters_.speed_law, request.ray_margins, synthetic_label(info), request.guards},
      certifier_(
          certifier_of(robot_, info.course, study::parameters_of_ticks(parameters_.certificate))),
      guards_(parameters_.speed_law,
              parameters_.guards,
              tracking_error_table(request.tracking_error, request.logs.decimal_comma, progress)) {
  if (parameters_.certificate.clearance == ClearanceReading::witness) {
    witness_.emplace(robot_, info.course, parameters_, when_late);
  }
  if (!request.audit.empty()) {
    require_apart(request.bundle, request.audit);
    audit_.emplace(request.audit, parameters_.guards);
  }
  if (!request.record.empty()) {
    record_.emplace(request.record, info_of_record(info, robot_, parameters_));
  }
}

const std::string& LiveTicks::row_of(const TickLine& line, StatusLines& status) {
  CertifiedTick certified = certifier_.update(line.tick);
  const GuardedTick guarded = guards_.update(line.tick, certified);
  if (witness_) {
    witness_->take(line.tick, certified);
  }
  if (record_) {
    record_->add(line, certified, status);
  }
  if (audit_) {
    audit_->add(line.tick, certified, guarded, status);
  }
  row_.clear();
  append_series_row(row_,
                    line.tick,
                    certified,
                    certifier_.ray_margins(),
                    format_,
                    guarded,
                    line.yaw_rate_cmd_rps);
  return row_;
}

bool LiveTicks::close(StatusLines& status) {
  const bool audited = !audit_ || audit_->close(status);
  const bool recorded = !record_ || record_->close(status);
  if (witness_) {
    status.say("tcert live: " + witness_->conclude());
  }
  return audited && recorded;
}

}  // namespace tcert::cli
