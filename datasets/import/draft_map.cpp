#include "datasets/import/draft_map.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <table/clock_column.hpp>
#include <table/name_words.hpp>
#include <table/nearest_name.hpp>
#include <utility>

#include "datasets/import/column_guess.hpp"
#include "datasets/import/draft_parts.hpp"

namespace tcert::recording {
namespace {

/// As TUM has them, without a header: time, x, y, z and a quaternion.
bool is_plain_trajectory(const table::CsvCheck& check) {
  return check.header_line == 0 && check.columns.size() == 8;
}

/// The columns of a group that are something to a bundle, by role; the first of each but rays.
struct Columns {
  std::map<ColumnRole, std::vector<std::pair<std::string, std::string>>> by_role;  // name, unit

  explicit Columns(const table::CsvCheck& check) {
    if (is_plain_trajectory(check)) {
      for (const auto& [role, column] : {std::pair(ColumnRole::x, "#2"),
                                         std::pair(ColumnRole::y, "#3"),
                                         std::pair(ColumnRole::quaternion_x, "#5"),
                                         std::pair(ColumnRole::quaternion_y, "#6"),
                                         std::pair(ColumnRole::quaternion_z, "#7"),
                                         std::pair(ColumnRole::quaternion_w, "#8")}) {
        by_role[role].emplace_back(column, "");
      }
      return;
    }
    for (const table::ColumnCheck& column : check.columns) {
      const ColumnGuess guess = guess_column(column.name, column.least, column.largest);
      if (guess.role != ColumnRole::other && !table::is_clock_name(column.name)) {
        by_role[guess.role].emplace_back(column.name, guess.unit);
      }
    }
  }

  [[nodiscard]] bool has(ColumnRole role) const { return by_role.contains(role); }
  [[nodiscard]] bool has_turn() const {
    return has(ColumnRole::yaw) || (has(ColumnRole::quaternion_x) && has(ColumnRole::quaternion_w));
  }
  [[nodiscard]] bool has_pose() const {
    return has(ColumnRole::x) && has(ColumnRole::y) && has_turn();
  }
  [[nodiscard]] bool has_rays() const { return has(ColumnRole::bend) || has(ColumnRole::range); }

  [[nodiscard]] OrderedJson value(ColumnRole role) const {
    const auto& [name, unit] = by_role.at(role).front();
    return value_of_column(name, unit);
  }

  static OrderedJson value_of_column(const std::string& name, const std::string& unit) {
    return unit.empty() ? OrderedJson(name) : OrderedJson{{"column", name}, {"unit", unit}};
  }
};

/// Of a file without a clock by its name: its first column, if that has a unit of time.
OrderedJson time_by_unit(const table::CsvCheck& check) {
  if (check.columns.empty() || check.columns.front().numbers != check.rows) {
    return nullptr;
  }
  const std::string& name = check.columns.front().name;
  const auto words = table::name_words(name);
  const auto unit = words.empty() ? std::nullopt : table::time_unit_of_word(words.back());
  return unit ? OrderedJson{{"column", name}, {"unit", table::name_of(*unit)}} : nullptr;
}

OrderedJson time_of(const table::CsvCheck& check) {
  if (is_plain_trajectory(check)) {
    return {{"column", "#1"}, {"unit", "s"}};
  }
  if (!check.clock) {
    return time_by_unit(check);
  }
  const std::string& unit = check.clock->unit;
  std::vector<std::string> names;
  for (const table::ColumnCheck& column : check.columns) {
    names.push_back(column.name);
  }
  const auto clock = table::clock_named(names, check.clock->column);
  if (clock && clock->nanoseconds) {
    return {{"column", {names[clock->column], names[*clock->nanoseconds]}}};
  }
  return {{"column", check.clock->column}, {"unit", unit == "dates" ? "iso" : unit}};
}

OrderedJson stream_of(const CsvGroup& group) {
  OrderedJson stream = OrderedJson::object();
  if (!group.pattern.empty()) {  // else the source is the file
    stream["file"] = group.pattern;
  }
  stream["time"] = time_of(group.check);
  if (stream["time"].is_null()) {
    stream.erase("time");
  }
  return stream;
}

OrderedJson rays_of(const Columns& columns) {
  OrderedJson rays = OrderedJson::array();
  std::map<std::string, std::pair<std::string, std::string>> forces;  // by ray
  if (columns.has(ColumnRole::force)) {
    for (const auto& column : columns.by_role.at(ColumnRole::force)) {
      forces[ray_name(column.first, 0)] = column;
    }
  }
  for (const ColumnRole role : {ColumnRole::bend, ColumnRole::range}) {
    if (!columns.has(role)) {
      continue;
    }
    const bool bends = role == ColumnRole::bend;
    for (const auto& [column, unit] : columns.by_role.at(role)) {
      const std::string name = ray_name(column, rays.size());
      OrderedJson ray = frame_of_ray(name, bends ? "bend" : "range");
      ray[bends ? "bend_rad" : "range_m"] = Columns::value_of_column(column, unit);
      if (bends) {
        ray["calibration"] = {{"bend_rad", nullptr}, {"clearance_m", nullptr}};
      }
      if (const auto force = forces.find(name); force != forces.end()) {
        ray["fsr_n"] = Columns::value_of_column(force->second.first, force->second.second);
      }
      rays.push_back(std::move(ray));
    }
  }
  return rays;
}

/// A column of a table of trials that is called like one of `words`.
std::optional<std::string> called(const table::CsvCheck& check,
                                  std::initializer_list<std::string_view> words) {
  for (const std::string_view word : words) {
    for (const table::ColumnCheck& column : check.columns) {
      if (table::case_folded(column.name) == word) {
        return column.name;
      }
    }
  }
  return std::nullopt;
}

OrderedJson trials_of(const CsvGroup& group) {
  OrderedJson trials{{"table", group.pattern}};
  const auto add = [&](const char* key, std::initializer_list<std::string_view> words) {
    if (const auto column = called(group.check, words)) {
      trials[key] = *column;
    }
  };
  add("id", {"trial_id", "trial", "run", "run_id", "id", "name", "file", "log"});
  add("success", {"success", "outcome", "result", "status", "reached", "ok", "finished"});
  add("time_s", {"time_s", "duration_s", "time", "duration", "elapsed"});
  add("algorithm", {"algorithm", "controller", "planner", "method"});
  add("lighting", {"lighting", "light"});
  add("day", {"day", "date", "session"});
  return trials;
}

/// What a group knows of a pose; null for what it does not.
OrderedJson pose_of(const CsvGroup& group, const Columns& columns) {
  OrderedJson pose = stream_of(group);
  pose["x_m"] = columns.value(ColumnRole::x);
  pose["y_m"] = columns.value(ColumnRole::y);
  pose["yaw_rad"] = nullptr;
  if (columns.has(ColumnRole::yaw)) {
    pose["yaw_rad"] = columns.value(ColumnRole::yaw);
  } else if (columns.has_turn()) {
    OrderedJson quaternion = OrderedJson::array();
    for (const ColumnRole role : {ColumnRole::quaternion_x,
                                  ColumnRole::quaternion_y,
                                  ColumnRole::quaternion_z,
                                  ColumnRole::quaternion_w}) {
      quaternion.push_back(columns.has(role) ? OrderedJson(columns.by_role.at(role).front().first)
                                             : OrderedJson(nullptr));
    }
    pose["yaw_rad"] = {{"quaternion", quaternion}};
  }
  return pose;
}

/// "no file has x, y and a heading" once the best that there is has been taken.
void add_pose(std::span<const CsvGroup> groups,
              OrderedJson& map,
              std::vector<std::string>& remarks) {
  for (const bool whole : {true, false}) {
    for (const CsvGroup& group : groups) {
      const Columns columns(group.check);
      const bool has_place = columns.has(ColumnRole::x) && columns.has(ColumnRole::y);
      if (!group.is_of_trials && (whole ? columns.has_pose() : has_place)) {
        map["pose"] = pose_of(group, columns);
        if (!whole) {
          remarks.emplace_back("no column is called as a heading: name one under 'pose'");
        }
        return;
      }
    }
  }
  map["pose"] = {{"file", nullptr}, {"x_m", nullptr}, {"y_m", nullptr}, {"yaw_rad", nullptr}};
  remarks.emplace_back("no file has columns of x, y and a heading: name them under 'pose'");
}

/// Names the columns of numbers that no name told what they are: one of them may be what is
/// missing.
void add_unplaced(std::span<const CsvGroup> groups, std::vector<std::string>& remarks) {
  constexpr std::size_t kMostNames = 12;
  std::string names;
  std::size_t count = 0;
  for (const CsvGroup& group : groups) {
    const OrderedJson time = group.is_of_trials ? nullptr : time_of(group.check);
    for (const table::ColumnCheck& column : group.check.columns) {
      const bool is_placed =
          guess_column(column.name, column.least, column.largest).role != ColumnRole::other ||
          table::is_clock_name(column.name) || (time.is_object() && time["column"] == column.name);
      if (!group.is_of_trials && column.numbers > 0 && !is_placed && count++ < kMostNames) {
        names += (names.empty() ? "'" : ", '") + column.name + "'";
      }
    }
  }
  if (count > 0) {
    remarks.emplace_back("what is measured in " + names +
                         (count > kMostNames ? " and others" : "") +
                         " is not known from the name: a heading, or a ray?");
  }
}

}  // namespace

DraftedMap draft_map(std::span<const CsvGroup> groups) {
  OrderedJson map = frame_of_map();
  std::vector<std::string> remarks;
  add_pose(groups, map, remarks);
  const CsvGroup* outcomes = nullptr;
  OrderedJson rays = OrderedJson::array();
  for (const CsvGroup& group : groups) {
    if (group.is_of_trials) {
      outcomes = outcomes == nullptr ? &group : outcomes;
      continue;
    }
    const Columns columns(group.check);
    if (columns.has_rays()) {
      OrderedJson stream = stream_of(group);
      stream["no_return"] = {"inf"};
      stream["rays"] = rays_of(columns);
      rays.push_back(std::move(stream));
    }
    const bool commands = columns.has(ColumnRole::speed) && columns.has(ColumnRole::yaw_rate);
    const bool is_command =
        is_called(group.pattern, "cmd") || is_called(group.pattern, "control") ||
        is_called(group.pattern, "command") ||
        (commands && is_called(columns.by_role.at(ColumnRole::speed)[0].first, "cmd"));
    if (commands && is_command && !map.contains("control")) {
      map["control"] = stream_of(group);
      map["control"]["speed_cmd_mps"] = columns.value(ColumnRole::speed);
      map["control"]["yaw_rate_cmd_rps"] = columns.value(ColumnRole::yaw_rate);
    }
  }
  map["rays"] = rays.size() == 1 ? rays.front() : rays;
  if (rays.empty()) {
    remarks.emplace_back("no column is a range or a bend: list rays under 'rays'");
  }
  if (rays.empty() || map["pose"]["yaw_rad"].is_null()) {
    add_unplaced(groups, remarks);
  }
  if (outcomes != nullptr) {
    map["trials"] = trials_of(*outcomes);
    remarks.emplace_back(
        "look at 'trials': which column names the trial, and which words are a success ('success': "
        "{\"column\": ..., \"true\": [...]})");
  } else {
    remarks.emplace_back(
        "no table of outcomes was found: 'trials' names one, else outcomes are not known");
  }
  return finished(map, std::move(remarks));
}

}  // namespace tcert::recording
