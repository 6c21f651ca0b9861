#include "cli/h1_options.hpp"

#include <algorithm>
#include <utility>

#include "cli/data_file.hpp"
#include "cli/errors.hpp"
#include "cli/inputs.hpp"
#include "cli/outcome_column.hpp"
#include "cli/time_rounding_option.hpp"

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

std::vector<study::H1Predictor> predictors_of(const HypothesesOptions& options) {
  if (options.predictor.empty() && options.baselines.empty()) {
    return study::paper_predictors();
  }
  std::vector<study::H1Predictor> predictors;
  predictors.push_back(options.predictor.empty() ? study::paper_predictors().front()
                                                 : predictor_of("predictor", options.predictor));
  for (const std::string& word : words_of(options.baselines)) {
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

void add_h1_options(po::options_description& own, HypothesesOptions& o) {
  const auto text = [](std::string& value, const char* name) {
    return po::value(&value)->value_name(name);
  };
  auto add = own.add_options();
  add("features", input(o.features, "FILE"), "a table of trials instead of a bundle");
  add("predictor",
      text(o.predictor, "COLUMN"),
      "the predictor under test; tc_early unless given; ':smaller' turns its direction");
  add("baselines",
      text(o.baselines, "COLUMNS"),
      "its rivals, comma between; those of the paper unless predictors are given");
  add("success",
      text(o.success, "COLUMN[=WORDS]")->default_value(o.success),
      "outcome: 0 or 1, true or false, success or failure, ok or fail; status=goal,done names the "
      "words that count as success, and all others are failures");
  add("time",
      text(o.time, "COLUMN")->default_value(o.time),
      "time to egress, or to the end of a failed trial; without it there is no C");
  add("cluster",
      text(o.cluster, "COLUMN")->default_value(o.cluster),
      "trials that share a value are not independent; '' for none");
  add("strata",
      text(o.strata, "COLUMN")->default_value(o.strata),
      "of the stratified hazard ratio; '' for none");
  add("within",
      text(o.within, "COLUMNS"),
      "AUC and C of pairs of trials that agree in these, comma between; --strata and lighting "
      "unless "
      "given, where the table has them; '' for none");
  add("landmark",
      text(o.landmark, "S"),
      "start of the landmark panel; the time window of the features unless given");
  add("limit",
      text(o.limit, "S"),
      "trial limit: failures stay at risk to it, longer trials are censored there; the longest "
      "time unless given");
  add_time_rounding_option(own, o.no_time_rounding);
  add("replicates",
      po::value(&o.replicates)->value_name("R")->default_value(o.replicates),
      "of the bootstrap; more for stable third digits");
  add("folds",
      po::value(&o.folds)->value_name("K")->default_value(o.folds),
      "of the cross-validation, of whole clusters");
  add("interval",
      text(o.interval, "METHOD")->default_value(o.interval),
      "of the bootstrap: expanded (percentiles that make up for few clusters), percentile or bca; "
      "the "
      "files hold all three");
  add("level",
      po::value(&o.level)->value_name("P")->default_value(o.level, "0.95"),
      "of the intervals");
  add("group", text(o.group, "COLUMN")->default_value(o.group), "h2: the groups that are compared");
  add("margin",
      po::value(&o.margin)->value_name("M")->default_value(o.margin, "0.05"),
      "h2: differences of AUC or C below it do not matter; state it before looking");
  add("permutations",
      po::value(&o.permutations)->value_name("R")->default_value(o.permutations),
      "h2: of the groups' names, for the expected max - min");
  add("table", text(o.table, "NAME"), "print only this table; a wrong name lists them");
}

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

study::H1Options h1_options(const HypothesesOptions& options, const CommonOptions& common) {
  require_range("replicates", static_cast<double>(options.replicates), 1, 1e6);
  require_range("folds", static_cast<double>(options.folds), 2, 1000);
  if (!(options.level > 0.0 && options.level < 1.0)) {
    throw UsageError("--level: expected a value between 0 and 1");
  }
  study::H1Options h1;
  h1.predictors = predictors_of(options);
  h1.success = outcome_column(options.success).column;
  h1.time = options.time;
  h1.cluster = options.cluster;
  h1.strata = options.strata;
  h1.interval = interval_method(options.interval);
  // A default may be absent; what was asked for may not.
  const study::H1Options defaults;
  for (const auto& [name, usual] : {std::pair(h1.time, defaults.time),
                                    std::pair(h1.cluster, defaults.cluster),
                                    std::pair(h1.strata, defaults.strata)}) {
    if (!name.empty() && name != usual) {
      h1.required.push_back(name);
    }
  }
  const bool asked =
      std::find(common.given.begin(), common.given.end(), "within") != common.given.end();
  h1.within = asked ? words_of(options.within) : std::vector<std::string>{options.strata};
  if (!asked && options.strata != "lighting") {
    h1.within.emplace_back("lighting");
  }
  std::erase(h1.within, "");
  if (asked) {
    h1.required.insert(h1.required.end(), h1.within.begin(), h1.within.end());
  }
  h1.landmark_s = effective_parameters({}, common).early_window.time_s;
  if (!options.landmark.empty()) {
    h1.landmark_s = number_of("landmark", options.landmark);
    h1.always_landmark = true;
  }
  if (!options.limit.empty()) {
    h1.limit_s = number_of("limit", options.limit);
  }
  h1.round_times = !options.no_time_rounding;
  h1.level = options.level;
  h1.replicates = static_cast<std::size_t>(options.replicates);
  h1.folds = static_cast<std::size_t>(options.folds);
  h1.seed = static_cast<std::uint64_t>(common.seed);
  return h1;
}

study::H2Options h2_options(const HypothesesOptions& options, const CommonOptions& common) {
  require_range("permutations", static_cast<double>(options.permutations), 1, 1e6);
  if (!options.baselines.empty()) {
    throw UsageError("--baselines: h2 has none; name one --predictor");
  }
  if (options.group.empty()) {
    throw UsageError("--group: h2 needs a column of groups");
  }
  if (!(options.margin > 0.0 && options.margin < 1.0)) {
    throw UsageError("--margin: expected a value between 0 and 1");
  }
  study::H2Options h2;
  h2.trials = h1_options(options, common);
  h2.trials.predictors.resize(1);
  h2.trials.group = options.group;
  h2.margin = options.margin;
  h2.permutations = static_cast<std::size_t>(options.permutations);
  return h2;
}

}  // namespace tcert::cli
