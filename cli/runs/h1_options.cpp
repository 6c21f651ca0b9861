#include "cli/runs/h1_options.hpp"

#include <algorithm>
#include <utility>

#include "cli/runs/data_file.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/outcome_column.hpp"
#include "cli/runs/time_rounding_option.hpp"

namespace tcert::cli {
namespace {

/// "m3", "m3:larger", "m3:smaller"; a predictor of the paper keeps its own direction and landmark.
study::H1Predictor predictor_of(const std::string& option, const std::string& word) {
  const auto colon = word.find(':');
  const std::string column = word.substr(0, colon);
  study::H1Predictor predictor{column, statistics::HigherMeans::success, ""};
  for (const study::H1Predictor& known : study::paper_predictors()) {
    if (known.column == column) {
      predictor = known;
    }
  }
  if (colon != std::string::npos) {
    const std::string direction = word.substr(colon + 1);
    if (direction != "larger" && direction != "smaller") {
      throw UsageError("--" + option + ": found '" + word +
                       "', expected COLUMN, COLUMN:larger or COLUMN:smaller");
    }
    predictor.higher =
        direction == "larger" ? statistics::HigherMeans::success : statistics::HigherMeans::failure;
  }
  return predictor;
}

std::vector<study::H1Predictor> predictors_of(const HypothesesRequest& request) {
  if (request.predictor.empty() && request.baselines.empty()) {
    return study::paper_predictors();
  }
  std::vector<study::H1Predictor> predictors;
  predictors.push_back(request.predictor.empty() ? study::paper_predictors().front()
                                                 : predictor_of("predictor", request.predictor));
  for (const std::string& word : words_of(request.baselines)) {
    predictors.push_back(predictor_of("baselines", word));
  }
  return predictors;
}

double number_of(const std::string& option, const std::string& text) {
  const std::vector<double> numbers = numbers_of(option, text);
  if (numbers.size() != 1 || !(numbers[0] > 0.0)) {
    throw UsageError("--" + option + ": found '" + text + "', expected seconds above 0");
  }
  return numbers[0];
}

}  // namespace

statistics::BootstrapMethod interval_method(const std::string& name) {
  if (name == "expanded") {
    return statistics::BootstrapMethod::expanded;
  }
  if (name == "percentile") {
    return statistics::BootstrapMethod::percentile;
  }
  if (name == "bca") {
    return statistics::BootstrapMethod::bca;
  }
  throw UsageError("--interval: found '" + name + "', expected expanded, percentile or bca");
}

study::H1Options h1_options(const HypothesesRequest& request) {
  if (!(request.level > 0.0 && request.level < 1.0)) {
    throw UsageError("--level: expected a value between 0 and 1");
  }
  study::H1Options h1;
  h1.predictors = predictors_of(request);
  h1.success = outcome_column(request.success).column;
  h1.time = request.time;
  h1.cluster = request.cluster;
  h1.strata = request.strata;
  h1.interval = interval_method(request.interval);
  // A default may be absent; what was asked for may not.
  const study::H1Options defaults;
  for (const auto& [name, usual] : {std::pair(h1.time, defaults.time),
                                    std::pair(h1.cluster, defaults.cluster),
                                    std::pair(h1.strata, defaults.strata)}) {
    if (!name.empty() && name != usual) {
      h1.required.push_back(name);
    }
  }
  const bool asked = request.within.has_value();
  h1.within = asked ? words_of(*request.within) : std::vector<std::string>{request.strata};
  if (!asked && request.strata != "lighting") {
    h1.within.emplace_back("lighting");
  }
  std::erase(h1.within, "");
  if (asked) {
    h1.required.insert(h1.required.end(), h1.within.begin(), h1.within.end());
  }
  h1.landmark_s = effective_parameters({}, request.logs.parameters).early_window.time_s;
  if (!request.landmark.empty()) {
    h1.landmark_s = number_of("landmark", request.landmark);
    h1.always_landmark = true;
  }
  if (!request.limit.empty()) {
    h1.limit_s = number_of("limit", request.limit);
  }
  h1.round_times = !request.no_time_rounding;
  h1.level = request.level;
  h1.replicates = static_cast<std::size_t>(request.replicates);
  h1.folds = static_cast<std::size_t>(request.folds);
  h1.seed = static_cast<std::uint64_t>(request.seed);
  return h1;
}

study::H2Options h2_options(const HypothesesRequest& request) {
  if (!request.baselines.empty()) {
    throw UsageError("--baselines: h2 has none; name one --predictor");
  }
  if (request.group.empty()) {
    throw UsageError("--group: h2 needs a column of groups");
  }
  if (!(request.margin > 0.0 && request.margin < 1.0)) {
    throw UsageError("--margin: expected a value between 0 and 1");
  }
  study::H2Options h2;
  h2.trials = h1_options(request);
  h2.trials.predictors.resize(1);
  h2.trials.group = request.group;
  h2.margin = request.margin;
  h2.permutations = static_cast<std::size_t>(request.permutations);
  return h2;
}

}  // namespace tcert::cli
