#include "datasets/import/draft_parts.hpp"

#include <table/nearest_name.hpp>
#include <utility>

namespace tcert::recording {
namespace {

/// Where a person must fill in: "robot.body_width_m, course.goal.disc.{x_m, y_m}".
void collect_nulls(const OrderedJson& value, const std::string& path, std::string& nulls) {
  std::string here;
  std::size_t count = 0;
  for (const auto& [key, member] : value.items()) {
    if (member.is_null()) {
      here += (count++ == 0 ? "" : ", ") + key;
    }
  }
  if (count > 0) {
    nulls += (nulls.empty() ? "" : ", ") + path + (path.empty() ? "" : ".") +
             (count > 1 ? "{" + here + "}" : here);
  }
  const std::string before = path.empty() ? "" : path + '.';
  for (const auto& [key, member] : value.items()) {
    if (member.is_structured()) {
      const std::string step = member.is_object() ? member.value("name", key) : key;
      collect_nulls(member, before + step, nulls);
    }
  }
}

}  // namespace

OrderedJson frame_of_map() {
  return {{"format", "tcert-map"},
          {"version", 1},
          {"robot", {{"body_width_m", nullptr}}},
          {"course",
           {{"start", {{"disc", {{"x_m", nullptr}, {"y_m", nullptr}, {"radius_m", 0.5}}}}},
            {"goal", {{"disc", {{"x_m", nullptr}, {"y_m", nullptr}, {"radius_m", 0.5}}}}}}}};
}

DraftedMap finished(const OrderedJson& map, std::vector<std::string> remarks) {
  std::string nulls;
  collect_nulls(map, "", nulls);
  remarks.insert(remarks.begin(),
                 "replace each null: " + nulls +
                     " (leave 'course' out and there is no certificate, only the on-policy "
                     "corridor value)");
  return {map.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n",
          std::move(remarks)};
}

bool is_called(const std::string& name, std::string_view part) {
  return table::case_folded(name).find(part) != std::string::npos;
}

OrderedJson frame_of_ray(const std::string& name, std::string_view kind) {
  return {{"name", name},
          {"kind", kind},
          {"mount_x_m", nullptr},
          {"mount_y_m", nullptr},
          {"bearing_deg", nullptr},
          {"reach_m", nullptr}};
}

std::string ray_name(const std::string& column, std::size_t number) {
  static const std::vector<std::string> words{
      "range", "dist", "distance", "sonar", "tof", "lidar",   "bend",   "flex",
      "angle", "mm",   "cm",       "m",     "deg", "rad",     "sensor", "value",
      "data",  "fsr",  "force",    "n",     "g",   "pressure"};
  std::string name;
  std::string word;
  for (const char c : table::case_folded(column) + '_') {
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
      word += c;
      continue;
    }
    if (!word.empty() && std::ranges::find(words, word) == words.end()) {
      name += (name.empty() ? "" : "_") + word;
    }
    word.clear();
  }
  return name.empty() ? "ray" + std::to_string(number + 1) : name;
}

}  // namespace tcert::recording
