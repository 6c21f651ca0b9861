#include "reports/series.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "datasets/csv_write.hpp"
#include "reports/audit.hpp"

namespace tcert {
namespace {

constexpr std::array<std::pair<TickFlag, std::string_view>, 7> kFlagWords = {{
    {flag_stale, "stale"},
    {flag_bad_input, "bad_input"},
    {flag_missing_ray, "missing_ray"},
    {flag_break, "break"},
    {flag_capacity_exceeded, "capacity_exceeded"},
    {flag_start_outside, "start_outside"},
    {flag_goal_reached, "goal_reached"},
}};

constexpr std::string_view kColumns =
    "time_s,x_m,y_m,yaw_rad,travel_m,left_m,right_m,width_m,turn_radius_m,margin_m,edge_margin_m,"
    "memory,corridor_value_m,certificate_m,series_m,speed_law_mps,contacts,new_contacts,nodes,"
    "edges,flags,issued";

constexpr std::string_view kGuardColumns =
    ",gated_speed_mps,yaw_rate_cmd_rps,tracking_error_m,robust_margin_m,force_n,force_limit_n,"
    "triggers";

void append_cell(std::string& out, double value) {
  out += ',';
  if (std::isfinite(value)) {
    append_number(out, value);
  }
}

void append_cell(std::string& out, std::uint32_t value) {
  std::array<char, 10> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  out += ',';
  out.append(digits.data(), end);
}

void append_flags(std::string& out, std::uint32_t flags) {
  std::string_view separator;
  for (const auto& [flag, word] : kFlagWords) {
    if ((flags & flag) != 0) {
      out += separator;
      out += word;
      separator = "+";
    }
  }
}

bool is_evidence(std::uint32_t flags) { return (flags & (flag_stale | flag_bad_input)) == 0; }

/// No margin, no statement about speed: NA, which is not the same as "stop".
double gated(const SpeedLaw& law, double margin_m) {
  return std::isnan(margin_m) ? kMissing : gated_speed(law, margin_m);
}

}  // namespace

std::string series_header(const SeriesFormat& format, const Robot& robot) {
  std::string header(kColumns);
  if (format.ray_margins) {
    for (const Ray& ray : robot.rays) {
      header += ',';
      append_text(header, ray.name + "_margin_m");
    }
  }
  if (format.guards) {
    header += kGuardColumns;
  }
  header += format.synthetic ? ",synthetic_seed\n" : "\n";
  return header;
}

void append_series_row(std::string& out,
                       const Tick& tick,
                       const CertifiedTick& certified,
                       std::span<const double> ray_margins,
                       const SeriesFormat& format,
                       const GuardedTick& guarded,
                       double yaw_rate_cmd_rps) {
  append_seconds(out, tick.time_ns);
  for (const double value : {tick.pose.position.x_m,
                             tick.pose.position.y_m,
                             tick.pose.yaw_rad,
                             certified.travel_m,
                             certified.left_m,
                             certified.right_m,
                             certified.width_m,
                             certified.turn_radius_m,
                             certified.margin_m,
                             certified.edge_margin_m,
                             certified.memory,
                             certified.corridor_value_m,
                             certified.certificate_m,
                             series_value(certified),
                             gated(format.speed_law, certified.margin_m)}) {
    append_cell(out, value);
  }
  for (const std::uint32_t count :
       {certified.contacts, certified.new_contacts, certified.nodes, certified.edges}) {
    append_cell(out, count);
  }
  out += ',';
  append_flags(out, certified.flags);
  out += certified.issued ? ",1" : ",0";
  if (format.ray_margins) {
    for (const double margin : ray_margins) {
      append_cell(out, is_evidence(certified.flags) ? margin : kMissing);
    }
  }
  if (format.guards) {
    for (const double value : {guarded.speed_mps,
                               yaw_rate_cmd_rps,
                               guarded.tracking_error_m,
                               guarded.robust_margin_m,
                               guarded.force_n,
                               guarded.force_limit_n}) {
      append_cell(out, value);
    }
    out += ',' + trigger_words(guarded.triggers);
  }
  if (format.synthetic) {
    out += ',';
    out += format.synthetic->seed ? std::to_string(*format.synthetic->seed) : "";
  }
  out += '\n';
}

std::string flag_words(std::uint32_t flags) {
  std::string words;
  append_flags(words, flags);
  return words;
}

}  // namespace tcert
