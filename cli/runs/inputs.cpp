#include "cli/runs/inputs.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "cli/runs/data_file.hpp"
#include "cli/runs/errors.hpp"

namespace tcert::cli {
namespace {

/// \throws UsageError for a pattern that chooses nothing.
std::vector<std::size_t> choose(const Bundle& bundle, const std::string& list) {
  std::vector<std::size_t> chosen;
  const std::vector<std::string> patterns = words_of(list);
  std::vector<bool> used(patterns.size(), false);
  for (std::size_t t = 0; t < bundle.trials.size(); ++t) {
    bool wanted = patterns.empty();
    for (std::size_t p = 0; p < patterns.size(); ++p) {
      if (matches(patterns[p], bundle.trials[t].trial_id)) {
        used[p] = true;
        wanted = true;
      }
    }
    if (wanted) {
      chosen.push_back(t);
    }
  }
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused != used.end()) {
    std::vector<std::string> ids;
    for (const TrialRow& trial : bundle.trials) {
      ids.push_back(trial.trial_id);
    }
    const std::string& pattern = patterns[static_cast<std::size_t>(unused - used.begin())];
    throw UsageError("--trials: no trial '" + pattern + "'" + did_you_mean(pattern, ids));
  }
  return chosen;
}

template <class Error>
void apply(const Settings& settings, study::ParameterSet& parameters, const std::string& source) {
  for (const auto& [key, value] : settings) {
    try {
      study::set_parameter(parameters, key, value);
    } catch (const std::invalid_argument& error) {
      throw Error(source + error.what());
    }
  }
}

}  // namespace

OpenedBundle open_for(const std::string& path,
                      const LogOptions& logs,
                      Progress& progress,
                      SayDiagnostics say_diagnostics) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw NoInput("no bundle at '" + path + "'");
  }
  BundleResult result = open_bundle(path, {logs.decimal_comma});
  if (say_diagnostics == SayDiagnostics::yes || !result.bundle) {
    progress.say(result.diagnostics);
  }
  if (!result.bundle) {
    throw BadData("'" + path + "' is not a bundle that can be used");
  }
  if (logs.strict && table::has_error(result.diagnostics)) {
    throw BadData("'" + path + "' has trials that are rejected, and --strict was asked for");
  }
  OpenedBundle opened;
  opened.bundle = std::move(*result.bundle);
  opened.diagnostics = std::move(result.diagnostics);
  opened.parameters = effective_parameters(opened.bundle.info.parameters, logs.parameters);
  (void)effective_robot(opened.bundle.info, opened.parameters);
  opened.trials = choose(opened.bundle, logs.trials);
  opened.logs = logs;
  return opened;
}

study::ParameterSet effective_parameters(const std::map<std::string, std::string>& of_bundle,
                                         const ParameterChanges& changes) {
  study::ParameterSet parameters;
  apply<BadData>(Settings(of_bundle.begin(), of_bundle.end()), parameters, "bundle.json: ");
  apply<UsageError>(changes.of_file, parameters, "");
  apply<UsageError>(changes.of_flags, parameters, "");
  try {
    study::validate(parameters);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  return parameters;
}

Robot effective_robot(const BundleInfo& info, const study::ParameterSet& parameters) {
  Robot robot = study::with_overrides(info.robot, parameters.robot);
  try {
    validate(robot, parameters.certificate);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  return robot;
}

Settings as_settings(const study::ParameterSet& parameters, const Robot& robot) {
  const Robot effective = study::with_overrides(robot, parameters.robot);
  study::ParameterSet shown = parameters;
  shown.robot = {effective.body_width_m,
                 effective.min_turn_radius_m,
                 effective.tracking_buffer_m,
                 effective.curvature_buffer_per_m};
  Settings settings;
  for (const study::ParameterInfo& parameter : study::parameter_table()) {
    if (parameter.stage == study::Stage::drive) {
      continue;  // of no log that is there already
    }
    settings.emplace_back(parameter.key, parameter.get(shown));
  }
  return settings;
}

bool matches(std::string_view pattern, std::string_view name) noexcept {
  std::size_t p = 0;
  std::size_t n = 0;
  std::size_t star = std::string_view::npos;
  std::size_t resume = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = n;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
      ++p;
      ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++resume;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

}  // namespace tcert::cli
