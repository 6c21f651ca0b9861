#include "cli/runs/terrain_config.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <set>
#include <table/bytes.hpp>
#include <terrain/limits.hpp>
#include <vector>

#include "cli/runs/errors.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {
namespace {

struct NumberKey {
  const char* name;
  std::optional<double> TerrainConfig::*field;
  std::string_view limit;  ///< Of the option that it stands for.
  bool whole = false;
};
constexpr std::string_view kCell;  // a cell's coordinate
constexpr std::array<NumberKey, 14> kNumbers{
    {{"environment.THRESHOLD", &TerrainConfig::threshold, "threshold"},
     {"environment.SIMPLIFICATION_CONSTANT", &TerrainConfig::simplification, "simplification"},
     {"robot.ROBOT_RADIUS", &TerrainConfig::robot_radius, "robot-radius"},
     {"robot.STARTING_X", &TerrainConfig::start_x, kCell, true},
     {"robot.STARTING_Y", &TerrainConfig::start_y, kCell, true},
     {"robot.GOAL_X", &TerrainConfig::goal_x, kCell, true},
     {"robot.GOAL_Y", &TerrainConfig::goal_y, kCell, true},
     {"optimization.NUM_EXPANDERS", &TerrainConfig::expanders, "expanders", true},
     {"optimization.KERNEL_VARIANCE", &TerrainConfig::kernel_variance, "kernel-variance"},
     {"optimization.KERNEL_LENGTHSCALE", &TerrainConfig::kernel_lengthscale, "kernel-length-scale"},
     {"optimization.BETA", &TerrainConfig::beta, "beta"},
     {"optimization.LIPSCHITZ", &TerrainConfig::lipschitz, "lipschitz"},
     {"display.FRAMECOUNT", &TerrainConfig::frames, "frames", true},
     {"display.BUFFER_SIZE", &TerrainConfig::buffer_size, "expanders"}}};

struct WordKey {
  const char* name;
  std::optional<std::string> TerrainConfig::*field;
};
constexpr std::string_view kOldMode = "environment.MODE";
constexpr std::array<WordKey, 3> kWords{{{"environment.FILENAME", &TerrainConfig::filename},
                                         {"environment.MODE", &TerrainConfig::mode},
                                         {"robot.MODE", &TerrainConfig::mode}}};

[[nodiscard]] std::string without_quotes(std::string text) {
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
      text.back() == text.front()) {
    text = text.substr(1, text.size() - 2);
  }
  return text;
}

[[nodiscard]] double number_of(const std::string& path,
                               const NumberKey& key,
                               const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    throw UsageError(path + ": " + key.name + ": found '" + text + "', expected a number");
  }
  const terrain::Limit limit = key.limit == kCell
                                   ? terrain::Limit{"", 0.0, terrain::kMostSide - 1.0}
                                   : terrain::limit_of(key.limit);
  if (!terrain::is_within(limit, value) || (key.whole && value != std::floor(value))) {
    throw UsageError(fmt::format("{}: {}: found '{}', expected a {}number from {:g} to {:g}",
                                 path,
                                 key.name,
                                 text,
                                 key.whole ? "whole " : "",
                                 limit.low,
                                 limit.high));
  }
  return value;
}

void take(TerrainConfig& config,
          const std::string& path,
          const std::string& key,
          const std::string& value) {
  std::vector<std::string> known;
  for (const NumberKey& number : kNumbers) {
    if (key == number.name) {
      config.*number.field = number_of(path, number, value);
      return;
    }
    known.emplace_back(number.name);
  }
  for (const WordKey& word : kWords) {
    if (key == word.name) {
      if (key == kOldMode && value == "semnav") {
        config.notes.push_back(key + " = semnav has no effect here: there is no such mode");
        return;
      }
      if (word.field == &TerrainConfig::mode && value != "navigate" && value != "explore") {
        throw UsageError(fmt::format("{}: {}: found '{}', expected navigate or explore{}",
                                     path,
                                     key,
                                     value,
                                     did_you_mean(value, {"navigate", "explore"})));
      }
      config.*word.field = value;
      return;
    }
    known.emplace_back(word.name);
  }
  throw UsageError(path + ": unknown key '" + key + "'" + did_you_mean(key, known));
}

[[nodiscard]] std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
  return text.substr(0, text.find_last_not_of(kBlank) + 1);
}

/// Every KEY = value of the text, in its order, the key after its section and a dot.
void read_lines(const std::string& path,
                std::string_view text,
                const std::function<void(const std::string& key, const std::string& value)>& take) {
  std::string section;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view whole = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::string_view line = trimmed(whole.substr(0, whole.find('#')));
    const std::size_t equals = line.find('=');
    if (line.empty()) {
      continue;
    }
    if (line.front() == '[' && line.back() == ']') {
      section = std::string(line.substr(1, line.size() - 2));
      section += section.empty() || section.back() == '.' ? "" : ".";
    } else if (equals != std::string_view::npos) {
      take(section + std::string(trimmed(line.substr(0, equals))),
           std::string(trimmed(line.substr(equals + 1))));
    } else {
      throw UsageError(path + ": found '" + std::string(line) +
                       "', expected [section] or KEY = value");
    }
  }
}

/// "X,Y" of two keys that come together.
[[nodiscard]] std::optional<std::string> cell_of(const std::string& path,
                                                 const std::string& names,
                                                 const std::optional<double>& x,
                                                 const std::optional<double>& y) {
  if (x.has_value() != y.has_value()) {
    throw UsageError(path + ": expected both of " + names + ", or neither");
  }
  return x ? std::optional(fmt::format("{:.0f},{:.0f}", *x, *y)) : std::nullopt;
}

}  // namespace

TerrainConfig read_terrain_config(const std::string& path) {
  const table::BytesResult bytes = table::read_raw_file(path);
  if (!bytes.bytes) {
    throw NoInput("cannot read the config file '" + path + "': " + bytes.problem);
  }
  TerrainConfig config;
  std::set<std::string> seen;
  read_lines(path, bytes.bytes->view(), [&](const std::string& key, const std::string& value) {
    if (!seen.insert(key).second) {
      throw UsageError(path + ": key '" + key + "' is given twice");
    }
    take(config, path, key, without_quotes(value));
  });
  config.start =
      cell_of(path, "robot.STARTING_X and robot.STARTING_Y", config.start_x, config.start_y);
  config.goal = cell_of(path, "robot.GOAL_X and robot.GOAL_Y", config.goal_x, config.goal_y);
  return config;
}

}  // namespace tcert::cli
