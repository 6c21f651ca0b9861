#include "analysis/h1/hypothesis_h1.hpp"
#include "analysis/model/expression.hpp"
#include "cli/certify_run.hpp"
#include "cli/data_file.hpp"
#include "cli/errors.hpp"
#include "cli/feature_data.hpp"
#include "cli/h1_options.hpp"
#include "cli/inputs.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/result_folder.hpp"
#include "reports/features_table.hpp"
#include "reports/h1_table.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Test a hypothesis of the paper on a bundle or on any table of trials.

h1: does the early certificate margin tell successes from failures, and fast trials from slow ones,
and better than contacts, dwell and bend variance do? AUC, C and hazard ratios of each, of the rivals
together and with the margin added, with bootstrap intervals and tests by whole clusters (days).
Twice: with the early window as the paper has it, and with the time window alone (landmark), from
which conclusions are to be drawn.

A table needs the columns of --success and of the predictors. 'column:smaller' after --predictor or in
--baselines means that smaller values speak for success. Without --features' own landmark columns
(tc_landmark, ...) there is one panel, unless --landmark is given.

text and md have the two tables, of success and of time; json has every number, incidences by quartile of the predictor, closed-form errors and folds; csv has
the table of success, or that of --table: h1, h1_time, h1_case_level, h1_incidence, h1_closed_form,
h1_folds.

Usage: tcert hypotheses h1 (BUNDLE | --features FILE) [options]

Example:
  tcert hypotheses h1 corpus
  tcert hypotheses h1 --features results/features.csv --format md --output tables/h1.md
  tcert hypotheses h1 --features barn.csv --predictor m1 --baselines m2,m3:smaller --cluster world \
    --strata planner --time time_s

Cost: that of 'tcert certify' for a bundle; some seconds per 1,000 trials and 2,000 resamples.
)";

struct Study {
  DataFile file;
  Manifest manifest;
  int exit_code = exit_done;
};

CommandLine command_line(HypothesesOptions& o) {
  CommandLine line{"hypotheses",
                   kText,
                   uses_parameters | uses_output | uses_format | uses_seed | uses_threads |
                       uses_trials | uses_logs,
                   po::options_description("Options"),
                   {{"a hypothesis: h1", &o.hypothesis}, {"BUNDLE", &o.bundle, false}}};
  add_h1_options(line.own, o);
  return line;
}

Study study_of_table(const HypothesesOptions& options,
                     const H1Options& h1,
                     const CommonOptions& common) {
  Study study;
  study.file = read_data_file(options.features, columns_of(h1), common);
  study.manifest.command = "hypotheses";
  study.manifest.options = common.effective;
  study.manifest.synthetic = study.file.synthetic;
  study.manifest.inputs = {{name_of(options.features), digest_file(options.features)}};
  return study;
}

Study study_of_bundle(const HypothesesOptions& options, const CommonOptions& common) {
  const OpenedBundle opened = open_for(options.bundle, common);
  FeatureData features(opened.bundle);
  Study study;
  const CertifySummary summary = certify_trials(
      opened, common, nullptr, {}, [&](TrialRecord&& trial) { features.add(trial); });
  study.file.path = options.bundle;
  study.file.table = features.table();
  study.file.synthetic = synthetic_label(opened.bundle.info);
  study.manifest = manifest_of("hypotheses", opened, common, summary);
  study.exit_code = report(summary, opened, common);
  return study;
}

/// What would do nothing to a table that is made already. \throws UsageError.
void require_table_options(const CommonOptions& common) {
  for (const std::string& name : common.given) {
    if (name == "trials" || name == "strict" || name == "repair") {
      throw UsageError("--" + name + " is for a bundle, not for --features");
    }
  }
  if (!common.flag_parameters.empty()) {
    throw UsageError(
        "--set " + common.flag_parameters.front().first +
        ": parameters are for a bundle, not for --features; the landmark of a table is "
        "set by --landmark");
  }
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
  if (!options.features.empty()) {
    require_table_options(common);
  }
  const H1Options h1 = h1_options(options, common);
  const ThreadLimit threads(common.threads);
  Study study = options.features.empty() ? study_of_bundle(options, common)
                                         : study_of_table(options, h1, common);
  FitReport result;
  try {
    result = h1_report(hypothesis_h1(study.file.table, h1));
  } catch (const FormulaError& error) {
    throw UsageError(error.what());
  }
  result.synthetic = study.file.synthetic;
  require_table(result, options.table);
  const std::string text = render(result, common.table_format(), options.table);
  if (common.output.empty()) {
    print(text);
  } else {
    study.manifest.seed = h1.seed;
    write_with_manifest(common.output, text, std::move(study.manifest));
  }
  return has_error(result.conditions) ? exit_bad_data : study.exit_code;
}

}  // namespace

const Command kHypotheses = {"hypotheses", "test a hypothesis of the paper: h1", run};

}  // namespace tcert::cli
