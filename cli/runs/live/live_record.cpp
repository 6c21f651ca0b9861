#include "cli/runs/live/live_record.hpp"

#include <utility>

namespace tcert::cli {

BundleInfo info_of_record(BundleInfo info, const Robot& robot, study::ParameterSet parameters) {
  info.robot = robot;
  info.provenance = "recorded by tcert live; described by: " + info.provenance;
  info.parameters.clear();
  parameters.robot = {};
  const study::ParameterSet defaults;
  for (const study::ParameterInfo& parameter : study::parameter_table()) {
    if (std::string value = parameter.get(parameters); value != parameter.get(defaults)) {
      info.parameters.emplace(parameter.key, std::move(value));
    }
  }
  return info;
}

LiveRecord::LiveRecord(const std::string& folder, BundleInfo info)
    : folder_(folder), recorder_(std::in_place, folder, std::move(info), "live") {}

void LiveRecord::add(const TickLine& line, const CertifiedTick& certified, StatusLines& status) {
  if (!recorder_) {
    ++lost_;
    return;
  }
  first_ns_ = first_ns_.value_or(line.tick.time_ns);
  last_ns_ = line.tick.time_ns;
  if (!goal_ns_ && (certified.flags & flag_goal_reached) != 0) {
    goal_ns_ = last_ns_;
  }
  try {
    recorder_->add(line.tick, line.speed_cmd_mps, line.yaw_rate_cmd_rps, line.has_footing);
  } catch (const table::WriteError& error) {
    give_up(error, status);
    ++lost_;
  }
}

bool LiveRecord::close(StatusLines& status) {
  if (!recorder_) {
    status.say("tcert live: " + std::to_string(lost_) + " ticks were not recorded.");
    return false;
  }
  if (recorder_->ticks() == 0) {
    status.say("tcert live: no tick, nothing recorded.");
    return true;
  }
  TrialRow row;
  row.time_s = static_cast<double>(goal_ns_.value_or(last_ns_) - *first_ns_) / 1e9;
  if (goal_ns_) {
    row.success = true;
    row.end_reason = EndReason::goal;
  }
  try {
    const std::size_t ticks = recorder_->ticks();
    recorder_->close(std::move(row));
    status.say("tcert live: " + std::to_string(ticks) + " ticks recorded in '" + folder_ + "'.");
  } catch (const table::WriteError& error) {
    give_up(error, status);
    return false;
  }
  return true;
}

void LiveRecord::give_up(const table::WriteError& error, StatusLines& status) {
  status.say(std::string("tcert live: recording ended, the run goes on: ") + error.what() +
             "; what there is lies in '" + recorder_->staging().string() + "'");
  recorder_.reset();
}

}  // namespace tcert::cli
