#include "reports/replay_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/columns_of.hpp"
#include "reports/findings.hpp"

namespace tcert {
namespace {

using study::Replay;

ColumnsOf<SpeedLaw> law_columns() {
  return ColumnsOf<SpeedLaw>()
      .text("speed_law", "law", [](auto& law) { return std::string(study::to_string(law.kind)); })
      .fixed("beta_per_m", "beta_per_m", "1/m", 1, &SpeedLaw::beta_per_m);
}

ColumnsOf<Replay> rate_columns(const char* unit) {
  return ColumnsOf<Replay>()
      .fixed("rate_m_per_min",
             "m/min",
             unit,
             2,
             [](auto& r) { return study::rate_of_advance(r.length_m, r.time_s); })
      .fixed("gated_rate_m_per_min", "m/min gated", unit, 2, [](auto& r) {
        return study::rate_of_advance(r.length_m, r.gated_time_s);
      });
}

ColumnsOf<Replay> trip_columns() {
  return ColumnsOf<Replay>()
      .integer("margin_trips", "margin trips", &Replay::margin_trips)
      .integer("force_trips", "G2 trips", &Replay::force_trips)
      .integer("replan_trips", "G3 trips", &Replay::replan_trips);
}

ColumnsOf<study::ReplanSummary> replan_columns() {
  using Replans = study::ReplanSummary;
  return ColumnsOf<Replans>()
      .integer("replans", "replans", &Replans::replans)
      .integer("replans_without_route", "without route", &Replans::without_route)
      .integer("route_changes", "route changes", &Replans::route_changes)
      .integer("expansions", "expansions", &Replans::expansions)
      .integer("scratch_expansions", "from scratch", &Replans::scratch_expansions);
}

ColumnsOf<TrialRow> replayed_trial_columns() {
  return ColumnsOf<TrialRow>()
      .text("trial_id", "trial", &TrialRow::trial_id)
      .text("algorithm", "algorithm", &TrialRow::algorithm)
      .text("lighting", "lighting", &TrialRow::lighting)
      .text("day", "day", &TrialRow::day)
      .integer("success", "success", &TrialRow::success);
}

ColumnsOf<study::ReplayRecord> replay_columns() {
  using Record = study::ReplayRecord;
  const auto times =
      ColumnsOf<Replay>()
          .fixed("length_m", "length", "m", 2, &Replay::length_m)
          .fixed("logged_time_s", "logged time", "s", 1, &Replay::time_s)
          .fixed("gated_time_s", "gated time", "s", 1, &Replay::gated_time_s)
          .fixed("slow_s", "slow", "s", 1, &Replay::slow_s)
          .part(rate_columns("m/min"), [](auto& r) { return &r; })
          .fixed("speed_cmd_mps", "commanded", "m/s", 3, &Replay::speed_cmd_mps)
          .fixed("gated_speed_cmd_mps", "commanded gated", "m/s", 3, &Replay::gated_speed_cmd_mps);
  const auto stalls = ColumnsOf<Replay>()
                          .integer("stalls", "stalls", &Replay::stalls)
                          .fixed("stall_m", "in stalls", "m", 2, &Replay::stall_m)
                          .fixed("creep_m", "creeping", "m", 2, &Replay::creep_m)
                          .part(trip_columns(), [](auto& r) { return &r; });
  return ColumnsOf<Record>()
      .part(replayed_trial_columns(), [](auto& r) { return &r.trial; })
      .part(law_columns(), [](auto& r) { return &r.law; })
      .part(times, [](auto& r) { return &r.replay; })
      .fixed("loop_latency_ms", "latency", "ms", 2, &Record::loop_latency_ms)
      .part(stalls, [](auto& r) { return &r.replay; })
      .integer("kept", "kept", [](auto& r) { return when(r.trial.success.has_value(), r.kept); })
      .part(replan_columns(), &Record::replans);
}

}  // namespace

Table replay_table() {
  return replay_columns().table("replay", "Replays at gated speed, path unchanged");
}

std::vector<TableCell> replay_row(const study::ReplayRecord& record) {
  static const ColumnsOf<study::ReplayRecord> columns = replay_columns();
  return columns.row(record);
}

void ReplayTotals::add(const study::ReplayRecord& record) {
  const auto same = [&](const Total& total) {
    return total.law.kind == record.law.kind && total.law.beta_per_m == record.law.beta_per_m;
  };
  auto found = std::find_if(totals_.begin(), totals_.end(), same);
  if (found == totals_.end()) {
    totals_.emplace_back();
    found = totals_.end() - 1;
    found->law = record.law;
  }
  Total& total = *found;
  ++total.trials;
  total.successes += record.trial.success.value_or(false) ? 1 : 0;
  total.kept += record.kept ? 1 : 0;
  total.sum.length_m += record.replay.length_m;
  total.sum.time_s += record.replay.time_s;
  total.sum.gated_time_s += record.replay.gated_time_s;
  total.sum.stalls += record.replay.stalls;
  total.sum.margin_trips += record.replay.margin_trips;
  total.sum.force_trips += record.replay.force_trips;
  total.sum.replan_trips += record.replay.replan_trips;
  if (record.replans) {
    total.replanned = true;
    total.replans.replans += record.replans->replans;
    total.replans.without_route += record.replans->without_route;
    total.replans.route_changes += record.replans->route_changes;
    total.replans.expansions += record.replans->expansions;
    total.replans.scratch_expansions += record.replans->scratch_expansions;
  }
}

Table ReplayTotals::table() const {
  Table table =
      ColumnsOf<Total>()
          .part(law_columns(), [](auto& r) { return &r.law; })
          .integer("trials", "trials", &Total::trials)
          .integer("successes", "successes", &Total::successes)
          .integer("kept", "kept", &Total::kept)
          .part(rate_columns(""), [](auto& r) { return &r.sum; })
          .integer("stalls", "stalls", [](auto& r) { return r.sum.stalls; })
          .part(trip_columns(), [](auto& r) { return &r.sum; })
          .part(replan_columns(), [](auto& r) { return r.replanned ? &r.replans : nullptr; })
          .table("replay_totals",
                 "Replays at gated speed, path unchanged: all trials together",
                 totals_);
  table.footnotes = {
      "kept: successes without a stall and within the trial limit. A replay can only lose "
      "successes; it cannot see failures that speed would cause.",
      "margin, G2, G3: times that the speed law, the force guard and the replan guard began to "
      "trip; they halt or are only stated, as the parameter 'guard_mode' says."};
  return table;
}

Table ReplayTotals::findings() const {
  std::vector<Finding> findings;
  for (const Total& total : totals_) {
    findings.push_back(
        {fmt::format("{} of beta {:g} 1/m", study::to_string(total.law.kind), total.law.beta_per_m),
         "",
         fmt::format(
             "{} of {} successes kept; {} m/min, as logged {}.",
             total.kept,
             total.successes,
             in_words(study::rate_of_advance(total.sum.length_m, total.sum.gated_time_s), {}, 2),
             in_words(study::rate_of_advance(total.sum.length_m, total.sum.time_s), {}, 2))});
  }
  return findings_table(findings,
                        {"All trials together; 'hypotheses h3' compares successes alone."});
}

}  // namespace tcert
