#include "cli/terrain_config.hpp"

#include <boost/program_options.hpp>
#include <charconv>
#include <cmath>
#include <set>
#include <sstream>
#include <vector>

#include "cli/errors.hpp"
#include "cli/options.hpp"
#include "datasets/bytes.hpp"

namespace tcert::cli {
namespace {

struct NumberKey {
  const char* name;
  std::optional<double> TerrainConfig::*field;
};
constexpr NumberKey kNumbers[] = {
    {"environment.THRESHOLD", &TerrainConfig::threshold},
    {"environment.SIMPLIFICATION_CONSTANT", &TerrainConfig::simplification},
    {"robot.ROBOT_RADIUS", &TerrainConfig::robot_radius},
    {"optimization.NUM_EXPANDERS", &TerrainConfig::expanders},
    {"optimization.KERNEL_VARIANCE", &TerrainConfig::kernel_variance},
    {"optimization.KERNEL_LENGTHSCALE", &TerrainConfig::kernel_lengthscale},
    {"optimization.BETA", &TerrainConfig::beta},
    {"optimization.LIPSCHITZ", &TerrainConfig::lipschitz},
    {"display.BUFFER_SIZE", &TerrainConfig::buffer_size}};

struct WordKey {
  const char* name;
  std::optional<std::string> TerrainConfig::*field;
};
constexpr WordKey kWords[] = {{"environment.FILENAME", &TerrainConfig::filename},
                              {"environment.MODE", &TerrainConfig::mode},
                              {"robot.MODE", &TerrainConfig::mode}};

[[nodiscard]] std::string without_quotes(std::string text) {
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
      text.back() == text.front()) {
    text = text.substr(1, text.size() - 2);
  }
  return text;
}

[[nodiscard]] double number_of(const std::string& path,
                               const std::string& key,
                               const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    throw UsageError(path + ": " + key + ": found '" + text + "', expected a number");
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
      config.*number.field = number_of(path, key, value);
      return;
    }
    known.emplace_back(number.name);
  }
  for (const WordKey& word : kWords) {
    if (key == word.name) {
      config.*word.field = value;
      return;
    }
    known.emplace_back(word.name);
  }
  throw UsageError(path + ": unknown key '" + key + "'" + did_you_mean(key, known));
}

}  // namespace

TerrainConfig read_terrain_config(const std::string& path) {
  const BytesResult bytes = read_raw_file(path);
  if (!bytes.bytes) {
    throw NoInput("cannot read the config file '" + path + "': " + bytes.problem);
  }
  std::istringstream file{std::string(bytes.bytes->view())};
  TerrainConfig config;
  std::set<std::string> seen;
  try {
    const po::options_description none;
    for (const auto& option : po::parse_config_file(file, none, true).options) {
      const std::string text = option.value.empty() ? "" : without_quotes(option.value.front());
      if (!seen.insert(option.string_key).second) {
        throw UsageError(path + ": key '" + option.string_key + "' is given twice");
      }
      take(config, path, option.string_key, text);
    }
  } catch (const po::error& error) {
    throw UsageError(path + ": " + error.what());
  }
  return config;
}

}  // namespace tcert::cli
