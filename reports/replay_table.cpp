#include "reports/replay_table.hpp"

#include <algorithm>

#include "reports/fit/cells.hpp"

namespace tcert {
namespace {

Column number(std::string name, std::string unit, int decimals) {
  std::string heading = name;
  return {std::move(name), std::move(heading), std::move(unit), ColumnKind::number, decimals};
}

Column text(std::string name) { return text_column(name, name); }
Column integer(std::string name) { return integer_column(name, name); }

TableCell truth(bool value) { return integer_cell(value ? 1 : 0); }

}  // namespace

Table replay_table() {
  Table table;
  table.name = "replay";
  table.title = "Replays at gated speed, path unchanged";
  table.columns = {text("trial_id"),
                   text("algorithm"),
                   text("lighting"),
                   text("day"),
                   integer("success"),
                   text("speed_law"),
                   number("beta_per_m", "1/m", 1),
                   number("length_m", "m", 2),
                   number("logged_time_s", "s", 1),
                   number("gated_time_s", "s", 1),
                   number("slow_s", "s", 1),
                   number("rate_m_per_min", "m/min", 2),
                   number("gated_rate_m_per_min", "m/min", 2),
                   number("speed_cmd_mps", "m/s", 3),
                   number("gated_speed_cmd_mps", "m/s", 3),
                   number("loop_latency_ms", "ms", 2),
                   integer("stalls"),
                   number("stall_m", "m", 2),
                   number("creep_m", "m", 2),
                   integer("margin_trips"),
                   integer("force_trips"),
                   integer("replan_trips"),
                   integer("kept"),
                   integer("replans"),
                   integer("replans_without_route"),
                   integer("route_changes"),
                   integer("expansions"),
                   integer("scratch_expansions")};
  return table;
}

std::vector<TableCell> replay_row(const study::ReplayRecord& record) {
  const study::Replay& r = record.replay;
  std::vector<TableCell> cells = {record.trial.trial_id,
                                  record.trial.algorithm,
                                  record.trial.lighting,
                                  record.trial.day,
                                  record.trial.success ? truth(*record.trial.success) : TableCell{},
                                  std::string(study::to_string(record.law.kind)),
                                  Number{record.law.beta_per_m},
                                  Number{r.length_m},
                                  Number{r.time_s},
                                  Number{r.gated_time_s},
                                  Number{r.slow_s},
                                  number_cell(study::rate_of_advance(r.length_m, r.time_s)),
                                  number_cell(study::rate_of_advance(r.length_m, r.gated_time_s)),
                                  number_cell(r.speed_cmd_mps),
                                  number_cell(r.gated_speed_cmd_mps),
                                  number_cell(record.loop_latency_ms),
                                  integer_cell(r.stalls),
                                  Number{r.stall_m},
                                  Number{r.creep_m},
                                  integer_cell(r.margin_trips),
                                  integer_cell(r.force_trips),
                                  integer_cell(r.replan_trips),
                                  record.trial.success ? truth(record.kept) : TableCell{}};
  if (const auto& replans = record.replans) {
    cells.insert(cells.end(),
                 {integer_cell(replans->replans),
                  integer_cell(replans->without_route),
                  integer_cell(replans->route_changes),
                  integer_cell(replans->expansions),
                  integer_cell(replans->scratch_expansions)});
  } else {
    cells.resize(cells.size() + 5);
  }
  return cells;
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
  total.length_m += record.replay.length_m;
  total.time_s += record.replay.time_s;
  total.gated_time_s += record.replay.gated_time_s;
  total.stalls += record.replay.stalls;
  total.margin_trips += record.replay.margin_trips;
  total.force_trips += record.replay.force_trips;
  total.replan_trips += record.replay.replan_trips;
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
  Table table;
  table.name = "replay_totals";
  table.title = "Replays at gated speed, path unchanged: all trials together";
  table.columns = {text_column("speed_law", "law"),
                   number("beta_per_m", "1/m", 1),
                   integer_column("trials", "trials"),
                   integer_column("successes", "successes"),
                   integer_column("kept", "kept"),
                   number("rate_m_per_min", "", 2),
                   number("gated_rate_m_per_min", "", 2),
                   integer_column("stalls", "stalls"),
                   integer_column("margin_trips", "margin"),
                   integer_column("force_trips", "G2"),
                   integer_column("replan_trips", "G3"),
                   integer_column("replans", "replans"),
                   integer_column("replans_without_route", "without route"),
                   integer_column("route_changes", "route changes"),
                   integer_column("expansions", "expansions"),
                   integer_column("scratch_expansions", "from scratch")};
  table.columns[5].heading = "m/min";
  table.columns[6].heading = "m/min gated";
  for (const Total& total : totals_) {
    const auto counted = [&](std::uint64_t count) {
      return total.replanned ? integer_cell(count) : TableCell{};
    };
    table.add_row({std::string(study::to_string(total.law.kind)),
                   Number{total.law.beta_per_m},
                   integer_cell(total.trials),
                   integer_cell(total.successes),
                   integer_cell(total.kept),
                   number_cell(study::rate_of_advance(total.length_m, total.time_s)),
                   number_cell(study::rate_of_advance(total.length_m, total.gated_time_s)),
                   integer_cell(total.stalls),
                   integer_cell(total.margin_trips),
                   integer_cell(total.force_trips),
                   integer_cell(total.replan_trips),
                   counted(total.replans.replans),
                   counted(total.replans.without_route),
                   counted(total.replans.route_changes),
                   counted(total.replans.expansions),
                   counted(total.replans.scratch_expansions)});
  }
  table.footnotes = {
      "kept: successes without a stall and within the trial limit. A replay can only lose "
      "successes; it cannot see failures that speed would cause.",
      "margin, G2, G3: times that the speed law, the force guard and the replan guard began to "
      "trip; they halt or are only stated, as the parameter 'guard_mode' says."};
  return table;
}

}  // namespace tcert
