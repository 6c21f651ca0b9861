#include <algorithm>

#include "analysis/hypotheses_h1.hpp"
#include "cli/certify_run.hpp"
#include "cli/errors.hpp"
#include "cli/inputs.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/result_folder.hpp"
#include "datasets/csv.hpp"
#include "reports/features_table.hpp"
#include "reports/h1_table.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Test a hypothesis of the paper on a bundle or on a table of features.

h1: does the early certificate margin tell successes from failures, and better than contacts, dwell
and bend variance do? AUC with DeLong intervals, with the early window as the paper has it and with
the time window alone (landmark), from which conclusions are to be drawn.

Usage: tcert hypotheses h1 (BUNDLE | --features FILE) [options]

Example:
  tcert hypotheses h1 corpus
  tcert hypotheses h1 --features results/features.csv --format md --output tables/h1.md

Cost: that of 'tcert certify' for a bundle; next to nothing for a table of features.
)";

struct HypothesesOptions {
  std::string hypothesis;
  std::string bundle;
  std::string features;
};

struct Study {
  std::vector<FeatureRow> trials;
  std::optional<SyntheticLabel> synthetic;
  double landmark_s = 0.0;
  Manifest manifest;
  int exit_code = exit_done;
};

CommandLine command_line(HypothesesOptions& o) {
  CommandLine line{
      "hypotheses",
      kText,
      uses_parameters | uses_output | uses_format | uses_threads | uses_trials | uses_logs,
      po::options_description("Options"),
      {{"a hypothesis: h1", &o.hypothesis}, {"BUNDLE", &o.bundle, false}}};
  line.own.add_options()("features",
                         po::value(&o.features)->value_name("FILE"),
                         "a table of features instead of a bundle; needs a column success");
  return line;
}

/// The label that features.csv carries in a column of its own.
std::optional<SyntheticLabel> label_of(const FeatureTable& table) {
  const auto& names = table.extra_columns;
  const auto found = std::find(names.begin(), names.end(), "synthetic_seed");
  if (found == names.end() || table.rows.empty()) {
    return std::nullopt;
  }
  const std::string& seed =
      table.rows.front().trial.extra[static_cast<std::size_t>(found - names.begin())];
  const bool is_number = !seed.empty() && seed.size() < 20 &&
                         seed.find_first_not_of("0123456789") == std::string::npos;
  return is_number ? SyntheticLabel{std::stoull(seed)} : SyntheticLabel{};
}

Study study_of_table(const HypothesesOptions& options, const CommonOptions& common) {
  std::error_code error;
  if (!std::filesystem::exists(options.features, error)) {
    throw NoInput("no table at '" + options.features + "'");
  }
  CsvOptions csv;
  csv.decimal_comma = common.decimal_comma;
  TextTableResult text = read_text_table(std::filesystem::path(options.features), {"success"}, csv);
  say(text.diagnostics);
  if (!text.table) {
    throw BadData("'" + options.features + "' is not a table of features");
  }
  FeatureTableResult table = to_feature_table(*text.table, options.features);
  say(table.diagnostics);
  if (!table.table) {
    throw BadData("'" + options.features + "' is not a table of features");
  }
  const ParameterSet parameters = effective_parameters({}, common);
  Study study;
  study.synthetic = label_of(*table.table);
  study.trials = std::move(table.table->rows);
  study.landmark_s = parameters.early_window.time_s;
  study.manifest.command = "hypotheses";
  study.manifest.options = common.effective;
  study.manifest.synthetic = study.synthetic;
  study.manifest.inputs = {{name_of(options.features), digest_file(options.features)}};
  return study;
}

Study study_of_bundle(const HypothesesOptions& options, const CommonOptions& common) {
  const OpenedBundle opened = open_for(options.bundle, common);
  Study study;
  const CertifySummary summary =
      certify_trials(opened, common, nullptr, {}, [&](TrialRecord&& trial) {
        study.trials.push_back(std::move(trial.row));
      });
  study.synthetic = synthetic_label(opened.bundle.info);
  study.landmark_s = opened.parameters.early_window.time_s;
  study.manifest = manifest_of("hypotheses", opened, common, summary);
  study.exit_code = report(summary, opened, common);
  return study;
}

int run(Arguments arguments) {
  HypothesesOptions options;
  CommonOptions common;
  if (!parse(command_line(options), common, arguments)) {
    return exit_done;
  }
  if (options.hypothesis != "h1") {
    throw UsageError("unknown hypothesis '" + options.hypothesis + "', expected h1");
  }
  if (options.bundle.empty() == options.features.empty()) {
    throw UsageError("needs either BUNDLE or --features FILE");
  }
  Study study =
      options.features.empty() ? study_of_bundle(options, common) : study_of_table(options, common);
  const H1Table h1 = hypothesis_h1(study.trials, {study.landmark_s});
  Table table = h1_table(h1);
  table.synthetic = study.synthetic;
  const std::string text = render(table, common.table_format());
  if (common.output.empty()) {
    print(text);
  } else {
    write_with_manifest(common.output, text, std::move(study.manifest));
  }
  return study.exit_code;
}

}  // namespace

const Command kHypotheses = {"hypotheses", "test a hypothesis of the paper: h1", run};

}  // namespace tcert::cli
