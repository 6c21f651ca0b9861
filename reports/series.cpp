#include "reports/series.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <table/csv_write.hpp>
#include <tcert/flag_word.hpp>
#include <utility>
#include <variant>

#include "reports/audit.hpp"

namespace tcert {
namespace {

/// What a row is written from.
struct SeriesRow {
  const Tick& tick;
  const CertifiedTick& certified;
  const SpeedLaw& speed_law;
  const ActedTick& acted;
  double yaw_rate_cmd_rps;
};

using Number = double (*)(const SeriesRow&);
using Words = void (*)(std::string& out, const SeriesRow&);
using C = CertifiedTick;
using G = GuardedTick;

struct SeriesColumn {
  std::string_view name;
  std::string_view unit;
  std::string_view doc;
  std::variant<double C::*, std::uint32_t C::*, double G::*, Number, Words> value;
};

// A comma ends each cell; that of the last one makes room for the end of the line.

void append_number(std::string& out, double value) {
  if (std::isfinite(value)) {
    table::append_number(out, value);
  }
  out += ',';
}

void append_count(std::string& out, std::uint32_t value) {
  std::array<char, 10> digits{};
  auto* const end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  out.append(digits.data(), end);
  out += ',';
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

struct CellWriter {
  std::string& out;
  const SeriesRow& row;

  void operator()(double C::*value) const { append_number(out, row.certified.*value); }
  void operator()(std::uint32_t C::*value) const { append_count(out, row.certified.*value); }
  void operator()(double G::*value) const { append_number(out, row.acted.guarded.*value); }
  void operator()(Number value) const { append_number(out, value(row)); }
  void operator()(Words value) const {
    value(out, row);
    out += ',';
  }
};

using R = const SeriesRow&;

constexpr auto kColumns = std::to_array<SeriesColumn>({
    {"time_s",
     "s",
     "of the tick, by the clock of the log, which need not begin at 0",
     [](std::string& out, R r) { table::append_seconds(out, r.tick.time_ns); }},
    {"x_m", "m", "pose, in the frame of the log", [](R r) { return r.tick.pose.position.x_m; }},
    {"y_m", "m", "the same", [](R r) { return r.tick.pose.position.y_m; }},
    {"yaw_rad", "rad", "the same", [](R r) { return r.tick.pose.yaw_rad; }},
    {"travel_m",
     "m",
     "way driven so far, forwards or backwards, in steps of travel_deadband_m or more; never falls",
     &C::travel_m},
    {"left_m", "m", "free distance that the rays prove on the left of the path", &C::left_m},
    {"right_m", "m", "the same on the right", &C::right_m},
    {"width_m", "m", "w_t: left and right together", &C::width_m},
    {"turn_radius_m", "m", "rho_t: radius of the path's curvature", &C::turn_radius_m},
    {"margin_m", "m", "m_t: the tick's margin, by width and turn radius", &C::margin_m},
    {"edge_margin_m",
     "m",
     "least margin of the graph's edge that is being driven",
     &C::edge_margin_m},
    {"memory", "", "contact memory, 0 to 1", &C::memory},
    {"corridor_value_m",
     "m",
     "V_t: bottleneck of the widest path from S to the present node",
     &C::corridor_value_m},
    {"certificate_m",
     "m",
     "T_t: bottleneck of the widest path from S to G; empty until a path joins them",
     &C::certificate_m},
    {"series_m",
     "m",
     "T_t as soon as there is one, though it be 0 or less; before that V_t",
     [](R r) { return series_value(r.certified); }},
    {"speed_law_mps",
     "m/s",
     "speed that the law allows at the margin",
     [](R r) { return gated(r.speed_law, r.certified.margin_m); }},
    {"contacts", "", "rays in contact at the tick", &C::contacts},
    {"new_contacts", "", "of them those that were free at the tick before", &C::new_contacts},
    {"nodes", "", "of the graph so far", &C::nodes},
    {"edges", "", "of the graph so far", &C::edges},
    {"flags",
     "",
     "words with + between: stale, bad_input, missing_ray, break, capacity_exceeded, "
     "start_outside, goal_reached, memory_evicted, across_heading",
     [](std::string& out, R r) { append_flags(out, r.certified.flags); }},
    {"issued",
     "",
     "1 from the first tick on at which T_t is above 0, else 0",
     [](std::string& out, R r) { out += r.certified.issued ? '1' : '0'; }},
});

/// Those of `SeriesFormat::guards`.
constexpr auto kGuardColumns = std::to_array<SeriesColumn>({
    {"gated_speed_mps", "m/s", "v_t: speed that law and guards allow; 0 is a halt", &G::speed_mps},
    {"yaw_rate_cmd_rps",
     "rad/s",
     "commanded, as the log has it",
     [](R r) { return r.yaw_rate_cmd_rps; }},
    {"tracking_error_m",
     "m",
     "r_TE: bound on the error at the speed granted, or refused",
     &G::tracking_error_m},
    {"robust_margin_m",
     "m",
     "V_rob: V_t less r_TE, twice of it off a width; empty without a corridor",
     &G::robust_margin_m},
    {"force_n", "N", "largest force of any ray; empty if none states one", &G::force_n},
    {"force_limit_n",
     "N",
     "the largest force that is allowed at the robust margin",
     &G::force_limit_n},
    {"triggers",
     "",
     "guards that trip, words with + between",
     [](std::string& out, R r) { out += trigger_words(r.acted.guarded.triggers); }},
});

/// What a column holds is known when this is compiled.
template <const auto& columns, std::size_t... I>
void append_cells(const CellWriter& cell, std::index_sequence<I...> /*all*/) {
  (cell(std::get<columns[I].value.index()>(columns[I].value)), ...);
}

template <const auto& columns>
void append_cells(std::string& out, const SeriesRow& row) {
  append_cells<columns>(CellWriter{out, row}, std::make_index_sequence<columns.size()>());
}

}  // namespace

std::vector<ColumnDoc> series_columns() {
  std::vector<ColumnDoc> columns;
  columns.reserve(kColumns.size() + kGuardColumns.size() + 2);
  for (const SeriesColumn& one : kColumns) {
    columns.push_back({std::string(one.name), std::string(one.unit), std::string(one.doc)});
  }
  columns.push_back({"<ray>_margin_m", "m", "margin of each ray, with --ray-margins"});
  for (const SeriesColumn& one : kGuardColumns) {
    columns.push_back({std::string(one.name),
                       std::string(one.unit),
                       std::string(one.doc) + " (live --guards, replay --series)"});
  }
  columns.push_back(
      {"risk_ahead", "", "chance of a collision over risk_ahead_m straight ahead (--risk)"});
  columns.push_back({"valid_for_s",
                     "s",
                     "for how long T_t stays above 0 if nothing more is felt (obstacle_speed_mps)"});
  columns.push_back({"alarms", "", "rules that alarm, words with + between (--monitor)"});
  columns.push_back(synthetic_seed_doc());
  return columns;
}

std::string series_header(const SeriesFormat& format, const Robot& robot) {
  std::string header;
  for (const SeriesColumn& column : kColumns) {
    (header += column.name) += ',';
  }
  if (format.ray_margins) {
    for (const Ray& ray : robot.rays) {
      table::append_text(header, ray.name + "_margin_m");
      header += ',';
    }
  }
  if (format.guards) {
    for (const SeriesColumn& column : kGuardColumns) {
      (header += column.name) += ',';
    }
  }
  header += format.risk ? "risk_ahead," : "";
  header += format.validity ? "valid_for_s," : "";
  header += format.rules.empty() ? "" : "alarms,";
  header += format.synthetic ? "synthetic_seed," : "";
  header.back() = '\n';
  return header;
}

void append_series_row(std::string& out,
                       const Tick& tick,
                       const CertifiedTick& certified,
                       std::span<const double> ray_margins,
                       const SeriesFormat& format,
                       const ActedTick& acted,
                       double yaw_rate_cmd_rps) {
  const SeriesRow row{tick, certified, format.speed_law, acted, yaw_rate_cmd_rps};
  append_cells<kColumns>(out, row);
  if (format.ray_margins) {
    for (const double margin : ray_margins) {
      append_number(out, is_evidence(certified.flags) ? margin : kMissing);
    }
  }
  if (format.guards) {
    append_cells<kGuardColumns>(out, row);
  }
  if (format.risk) {
    append_number(out, acted.risk_ahead);
  }
  if (format.validity) {
    append_number(out, certified.valid_for_s);
  }
  if (!format.rules.empty()) {
    out += alarm_words(acted.alarms, format.rules);
    out += ',';
  }
  if (format.synthetic) {
    out += format.synthetic->seed ? std::to_string(*format.synthetic->seed) : "";
    out += ',';
  }
  out.back() = '\n';
}

std::vector<std::string> names_of(const std::vector<Rule>& rules) {
  std::vector<std::string> names;
  for (const Rule& rule : rules) {
    names.push_back(rule.name);
  }
  return names;
}

std::string flag_words(std::uint32_t flags) {
  std::string words;
  append_flags(words, flags);
  return words;
}

}  // namespace tcert
