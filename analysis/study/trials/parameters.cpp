#include "analysis/study/trials/parameters.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <table/nearest_name.hpp>
#include <vector>

namespace tcert::study {

std::string_view to_string(Stage stage) noexcept {
  constexpr std::array<std::string_view, 6> kWords = {
      "resample", "certify", "witness", "features", "control", "drive"};
  return kWords[static_cast<std::size_t>(stage)];
}

void set_parameter(ParameterSet& parameters, std::string_view key, std::string_view value) {
  const auto table = parameter_table();
  const auto info = std::find_if(
      table.begin(), table.end(), [&](const ParameterInfo& one) { return one.key == key; });
  if (info == table.end()) {
    std::vector<std::string> keys;
    for (const ParameterInfo& one : table) {
      keys.emplace_back(one.key);
    }
    const auto nearest = table::nearest_name(key, keys);
    throw std::invalid_argument("unknown parameter '" + std::string(key) + "'" +
                                (nearest ? "; did you mean '" + *nearest + "'?" : ""));
  }
  if (!info->set(parameters, value)) {
    throw std::invalid_argument(std::string(key) + ": found '" + std::string(value) +
                                "', expected " + info->accepts);
  }
}

void validate(const ParameterSet& parameters) {
  validate(parameters.certificate);
  require_fields(parameters.witness);
  validate(parameters.speed_law);
  validate(parameters.early_window);
  validate(parameters.guards);
  validate(parameters.risk);
  validate(parameters.fallback);
  validate(parameters.route);
  validate(parameters.replay);
  require_fields(parameters.unsafe);
  validate(parameters.resample);
  validate(parameters.drive);
  policies::validate(parameters.policy);
}

Robot with_overrides(Robot robot, const RobotOverrides& overrides) {
#define TCERT_NUMBER(type, member, ...) robot.member = overrides.member.value_or(robot.member);
#include <tcert/parameters/robot.def>
  return robot;
}

}  // namespace tcert::study
