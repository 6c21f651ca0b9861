#include "reports/series.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <table/csv_write.hpp>
#include <tcert/flag_word.hpp>

#include "reports/audit.hpp"

namespace tcert {
namespace {

struct SeriesColumn {
  std::string_view name;
  std::string_view unit;
  std::string_view doc;
};

constexpr auto kColumns = std::to_array<SeriesColumn>({
    {"time_s", "s", "of the tick, as the log counts it"},
    {"x_m", "m", "pose, in the frame of the log"},
    {"y_m", "m", "the same"},
    {"yaw_rad", "rad", "the same"},
    {"travel_m", "m", "signed way along the body axis, standing noise left out"},
    {"left_m", "m", "free distance that the rays prove on the left of the path"},
    {"right_m", "m", "the same on the right"},
    {"width_m", "m", "w_t: left and right together"},
    {"turn_radius_m", "m", "rho_t: radius of the path's curvature"},
    {"margin_m", "m", "m_t: the tick's margin, by width and turn radius"},
    {"edge_margin_m", "m", "least margin of the graph's edge that is being driven"},
    {"memory", "", "contact memory, 0 to 1"},
    {"corridor_value_m", "m", "V_t: bottleneck of the widest path from S to the present node"},
    {"certificate_m", "m", "T_t: bottleneck of the widest path from S to G; empty without one"},
    {"series_m", "m", "T_t where it is issued, before that V_t"},
    {"speed_law_mps", "m/s", "speed that the law allows at the margin"},
    {"contacts", "", "rays in contact at the tick"},
    {"new_contacts", "", "of them those that were free at the tick before"},
    {"nodes", "", "of the graph so far"},
    {"edges", "", "of the graph so far"},
    {"flags",
     "",
     "words with + between: stale, bad_input, missing_ray, break, capacity_exceeded, "
     "start_outside, goal_reached, memory_evicted"},
    {"issued", "", "1 once a certificate is issued, else 0"},
});

constexpr std::string_view kGuardColumns =
    ",gated_speed_mps,yaw_rate_cmd_rps,tracking_error_m,robust_margin_m,force_n,force_limit_n,"
    "triggers";

void append_cell(std::string& out, double value) {
  out += ',';
  if (std::isfinite(value)) {
    table::append_number(out, value);
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
  for (std::uint32_t flag = 1; flag != 0; flag <<= 1U) {
    if ((flags & flag) != 0) {
      out += separator;
      out += flag_word(flag);
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

std::vector<ColumnDoc> series_columns() {
  std::vector<ColumnDoc> columns;
  for (const SeriesColumn& one : kColumns) {
    columns.push_back({std::string(one.name), std::string(one.unit), std::string(one.doc)});
  }
  columns.push_back({"<ray>_margin_m", "m", "margin of each ray, with --ray-margins"});
  columns.push_back({"synthetic_seed", "", "seed of synthetic data; not in real data"});
  return columns;
}

std::string series_header(const SeriesFormat& format, const Robot& robot) {
  std::string header;
  for (const SeriesColumn& column : kColumns) {
    header += header.empty() ? "" : ",";
    header += column.name;
  }
  if (format.ray_margins) {
    for (const Ray& ray : robot.rays) {
      header += ',';
      table::append_text(header, ray.name + "_margin_m");
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
  table::append_seconds(out, tick.time_ns);
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
