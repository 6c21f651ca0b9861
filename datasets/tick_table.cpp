#include "datasets/tick_table.hpp"

#include <algorithm>
#include <cmath>
#include <table/csv_write.hpp>
#include <tcert/footing.hpp>

#include "datasets/stream_clock.hpp"
#include "datasets/tick_columns.hpp"

namespace tcert {

namespace {

bool has_any(const TickTable& ticks, std::size_t ray, double RayReading::*member) {
  for (std::size_t i = ray; i < ticks.readings.size(); i += ticks.rays) {
    if (!std::isnan(ticks.readings[i].*member)) {
      return true;
    }
  }
  return false;
}

bool has_any(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double v) { return !std::isnan(v); });
}

double value_or_missing(const std::vector<double>& values, std::size_t i) {
  return i < values.size() ? values[i] : kMissing;
}

}  // namespace

TickFormat::TickFormat(const Robot& robot, const TickTable& ticks, std::span<const RangeKeys> keys)
    : rules_(robot, keys),
      has_command_(has_any(ticks.speed_cmd_mps) || has_any(ticks.yaw_rate_cmd_rps)),
      has_footing_(!ticks.footing.empty()) {
  for (std::size_t k = 0; k < robot.rays.size(); ++k) {
    has_force_.push_back(has_any(ticks, k, &RayReading::fsr_n) ? 1 : 0);
    has_bearing_.push_back(has_any(ticks, k, &RayReading::bearing_rad) ? 1 : 0);
  }
  name_columns(robot);
}

TickFormat::TickFormat(const Robot& robot, std::span<const RangeKeys> keys, bool has_footing)
    : rules_(robot, keys),
      has_force_(robot.rays.size(), 1),
      has_bearing_(robot.rays.size(), 1),
      has_command_(true),
      has_footing_(has_footing) {
  name_columns(robot);
}

void TickFormat::name_columns(const Robot& robot) {
  header_ = "time_s,x_m,y_m,yaw_rad";
  header_ += has_footing_ ? ",pitch_rad,roll_rad,step_m,slip" : "";
  for (std::size_t k = 0; k < robot.rays.size(); ++k) {
    header_ += ',' + value_column(robot.rays[k]);
    if (has_force_[k] != 0) {
      header_ += ',' + force_column(robot.rays[k]);
    }
    if (has_bearing_[k] != 0) {
      header_ += ',' + bearing_column(robot.rays[k]);
    }
  }
  header_ += has_command_ ? ",speed_cmd_mps,yaw_rate_cmd_rps" : "";
  header_ += ",stale,segment_start\n";
}

void TickFormat::append_row(std::string& out, const TickTable& ticks, std::size_t i) const {
  append_row(out,
             ticks[i],
             value_or_missing(ticks.speed_cmd_mps, i),
             value_or_missing(ticks.yaw_rate_cmd_rps, i));
}

void TickFormat::append_row(std::string& out,
                            const Tick& tick,
                            double speed_cmd_mps,
                            double yaw_rate_cmd_rps) const {
  table::append_seconds(out, tick.time_ns);
  table::append_cell(out, tick.pose.position.x_m);
  table::append_cell(out, tick.pose.position.y_m);
  table::append_cell(out, tick.pose.yaw_rad);
  if (has_footing_) {
    for (const double value :
         {tick.footing.pitch_rad, tick.footing.roll_rad, tick.footing.step_m, tick.footing.slip}) {
      table::append_cell(out, value);
    }
  }
  for (std::size_t k = 0; k < has_force_.size(); ++k) {
    table::append_cell(out, rules_.stated(k, tick.rays[k].value));
    if (has_force_[k] != 0) {
      table::append_cell(out, tick.rays[k].fsr_n);
    }
    if (has_bearing_[k] != 0) {
      table::append_cell(out, tick.rays[k].bearing_rad);
    }
  }
  if (has_command_) {
    table::append_cell(out, speed_cmd_mps);
    table::append_cell(out, yaw_rate_cmd_rps);
  }
  out += tick.stale ? ",1" : ",0";
  out += tick.segment_start ? ",1\n" : ",0\n";
}

std::string to_ticks_csv(const Robot& robot,
                         const TickTable& ticks,
                         std::span<const RangeKeys> keys) {
  const TickFormat format(robot, ticks, keys);
  std::string out = format.header();
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    format.append_row(out, ticks, i);
  }
  return out;
}

TickTable to_tick_table(const table::NumberTable& rows,
                        const RangeRules& rules,
                        std::span<const std::int64_t> breaks_ns,
                        const std::string& file,
                        std::vector<RangeCount>& counts,
                        table::DiagnosticGroups& problems) {
  const std::size_t rays = rules.rays();
  counts.resize(rays);
  TickTable ticks;
  ticks.rays = rays;
  ticks.time_ns = rows.time_ns;
  ticks.readings.resize(rows.rows() * rays);
  auto next_break = breaks_ns.begin();
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    TickRow row;
    const auto values = std::span(rows.values).subspan(i * rows.columns, rows.columns);
    const char* bad_flag = interpret_tick(
        values, rules, std::span(ticks.readings).subspan(i * rays, rays), counts, row);
    if (bad_flag != nullptr) {
      problems.add({table::Severity::error, file, rows.lines[i], bad_flag, "", "0 or 1", 1});
    }
    bool breaks_here = row.segment_start;
    for (; next_break != breaks_ns.end() && *next_break <= rows.time_ns[i]; ++next_break) {
      breaks_here = true;
    }
    ticks.poses.push_back(row.pose);
    ticks.footing.push_back(row.footing);
    ticks.stale.push_back(row.stale ? 1 : 0);
    ticks.segment_start.push_back(breaks_here ? 1 : 0);
    ticks.speed_cmd_mps.push_back(row.speed_cmd_mps);
    ticks.yaw_rate_cmd_rps.push_back(row.yaw_rate_cmd_rps);
  }
  if (std::ranges::none_of(ticks.footing, is_measured)) {
    ticks.footing.clear();
  }
  return ticks;
}

std::optional<TickTable> read_ticks_csv(const table::Bytes& bytes,
                                        const Robot& robot,
                                        const table::CsvOptions& csv,
                                        double max_gap_s,
                                        table::DiagnosticGroups& problems) {
  const table::NumberOptions columns = tick_columns(robot);
  auto rows = table::read_numbers(bytes, csv, columns, problems);
  if (!rows) {
    return std::nullopt;
  }
  put_in_order(
      *rows, max_gap_s, {csv.file, columns.time_column, false, EqualTimes::forbidden}, problems);
  const ClockLimits limits{max_gap_s, std::nullopt};
  const auto breaks = find_breaks(*rows, csv.file, columns.time_column, limits, problems);
  std::vector<RangeCount> counts;
  TickTable ticks = to_tick_table(*rows, RangeRules(robot, {}), breaks, csv.file, counts, problems);
  if (problems.has_error()) {
    return std::nullopt;
  }
  return ticks;
}

}  // namespace tcert
