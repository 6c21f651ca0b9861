#include "cli/runs/guard_options.hpp"

#include <stdexcept>
#include <string_view>
#include <table/text_file.hpp>

#include "analysis/study/replay/tracking_error_grid.hpp"
#include "cli/runs/data_file.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/result_folder.hpp"

namespace tcert::cli {

namespace {

std::optional<ManifestFile> input_of_file(const std::string& path) {
  if (path.empty()) {
    return std::nullopt;
  }
  return ManifestFile{std::filesystem::path(path).filename().string(), digest_file(path)};
}

}  // namespace

void add_tracking_error_option(OptionTable& table, std::string& path) {
  table.add_input(
      "tracking-error",
      path,
      "FILE",
      "a table speed_mps, acceleration_mps2 (or speed_left_mps and hold_s), disturbance, radius_m: "
      "a full grid that never falls, as 'calibrate tracking' writes it; unless given a declared "
      "one, for a control loop of 20 ms");
}

void add_monitor_options(OptionTable& table, MonitorOptions& options) {
  table.add(
      "monitor", options.watch, "watch rules at every tick: the default ones, 'tcert help rules'");
  table.add_input("rules", options.rules, "FILE", "likewise, those of a file");
  table.add("risk",
            options.risk,
            "keep the risk field of what was touched; states the chance of a collision ahead");
}

std::vector<Rule> rules_of(const MonitorOptions& options) {
  if (options.rules.empty()) {
    return options.watch ? parse_rules(default_rules()) : std::vector<Rule>{};
  }
  const table::BytesResult file = table::read_text_file(options.rules);
  if (!file.bytes) {
    throw NoInput("'" + options.rules + "': expected a readable file: " + file.problem);
  }
  try {
    std::string_view text = file.bytes->view();
    text.remove_prefix(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
    std::vector<Rule> rules = parse_rules(text);
    if (rules.empty()) {
      throw std::invalid_argument("found no rule, expected lines 'name: formula'");
    }
    return rules;
  } catch (const std::invalid_argument& error) {
    throw BadData("'" + options.rules + "': " + error.what());
  }
}

TrackingErrorTable tracking_error_table(const std::string& path,
                                        bool decimal_comma,
                                        Progress& progress) {
  if (path.empty()) {
    return TrackingErrorTable();
  }
  const DataFile file = read_data_file(path, {}, decimal_comma, progress);
  try {
    return TrackingErrorTable(study::tracking_error_grid(file.table));
  } catch (const std::invalid_argument& error) {
    throw BadData("'" + path + "': " + error.what());
  }
}

std::optional<ManifestFile> tracking_error_input(const std::string& path) {
  return input_of_file(path);
}

std::optional<ManifestFile> rules_input(const MonitorOptions& options) {
  return input_of_file(options.rules);
}

void require_apart(const MonitorOptions& options, const std::string& output) {
  if (!options.rules.empty()) {
    require_apart(options.rules, output);
  }
}

}  // namespace tcert::cli
