#include <functional>

#include "analysis/h1/hypothesis_h1.hpp"
#include "analysis/h2/hypothesis_h2.hpp"
#include "analysis/model/expression.hpp"
#include "cli/certify_run.hpp"
#include "cli/data_file.hpp"
#include "cli/errors.hpp"
#include "cli/feature_data.hpp"
#include "cli/h1_options.hpp"
#include "cli/h3.hpp"
#include "cli/inputs.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/result_folder.hpp"
#include "reports/features_table.hpp"
#include "reports/h1_table.hpp"
#include "reports/h2_table.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Test a hypothesis of the paper on a bundle or on any table of trials.

h1: does the early certificate margin tell successes from failures, and fast trials from slow ones,
and better than contacts, dwell and bend variance do? AUC, C and hazard ratios of each, of the rivals
together and with the margin added, with bootstrap intervals and tests by whole clusters (days).
Twice: with the early window as the paper has it, and with the time window alone (landmark), from
which conclusions are to be drawn.

h2: is it as good in every lighting (or other --group)? AUC, C, odds and hazard ratios of each group,
whether they are equivalent at a margin (two one-sided tests of all pairs, clusters shared between
groups), the smallest margin that would do, the margin that had 80 % power, tests of difference and
interaction. Panels and clusters as in h1.

A table needs the columns of --success and of the predictors. 'column:smaller' after --predictor or in
--baselines means that smaller values speak for success. Without --features' own landmark columns
(tc_landmark, ...) there is one panel, unless --landmark is given.

h3: does gating the speed by the margin recover the lead of the camera baseline without losing
successes? Every trial is replayed at each speed law and beta; rates of advance, gain, share of the
gap, successes lost and retained, stalls, the Pareto front; by lighting.

text and md have the main tables; json has every number of a hypothesis; csv has its first table, or that of --table: h1, h1_time,
h1_case_level, h1_incidence, h1_closed_form, h1_folds; h2, h2_equality, h2_pairs, h2_interaction,
h2_closed_form, h2_covariance; h3.

Usage: tcert hypotheses (h1 | h2) (BUNDLE | --features FILE) [options]
       tcert hypotheses h3 (BUNDLE | --replays FILE) [options]

Example:
  tcert hypotheses h1 corpus
  tcert hypotheses h1 --features results/features.csv --format md --output tables/h1.md
  tcert hypotheses h1 --features barn.csv --predictor m1 --baselines m2,m3:smaller --cluster world \
    --strata planner --time time_s
  tcert hypotheses h2 corpus --margin 0.05
  tcert hypotheses h2 --features barn.csv --predictor m1 --group planner --cluster world --strata ''
  tcert hypotheses h3 corpus --betas 5,10,20

Cost: that of 'tcert certify' for a bundle; some seconds per 1,000 trials and 2,000 resamples.
)";

struct Study {
  DataFile file;
  Manifest manifest;
  int exit_code = exit_done;
};

CommandLine command_line(HypothesesOptions& o, H3CommandOptions& h3) {
  CommandLine line{"hypotheses",
                   kText,
                   uses_parameters | uses_output | uses_format | uses_seed | uses_threads |
                       uses_trials | uses_logs,
                   po::options_description("Options"),
                   {{"a hypothesis: h1, h2 or h3", &o.hypothesis}, {"BUNDLE", &o.bundle, false}}};
  add_h1_options(line.own, o);
  add_h3_options(line.own, h3);
  return line;
}

Study study_of_table(const HypothesesOptions& options,
                     const std::vector<std::string>& columns,
                     const CommonOptions& common) {
  Study study;
  study.file = read_data_file(options.features, columns, common);
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

/// What a hypothesis reads of a table, and what it says of it.
struct Hypothesis {
  std::vector<std::string> columns;
  std::function<FitReport(const DataTable&)> test;
};

Hypothesis hypothesis_of(const HypothesesOptions& options, const CommonOptions& common) {
  if (options.hypothesis == "h1") {
    const H1Options h1 = h1_options(options, common);
    return {columns_of(h1),
            [h1](const DataTable& table) { return h1_report(hypothesis_h1(table, h1)); }};
  }
  if (options.hypothesis == "h2") {
    const H2Options h2 = h2_options(options, common);
    return {columns_of(h2),
            [h2](const DataTable& table) { return h2_report(hypothesis_h2(table, h2)); }};
  }
  throw UsageError("unknown hypothesis '" + options.hypothesis + "', expected h1, h2 or h3");
}

int run(Arguments arguments) {
  HypothesesOptions options;
  H3CommandOptions h3_options;
  CommonOptions common;
  if (!parse(command_line(options, h3_options), common, arguments)) {
    return exit_done;
  }
  if (options.hypothesis == "h3") {
    return run_h3(
        h3_options,
        {options.bundle, options.cluster, options.table, options.level, options.replicates},
        common);
  }
  const Hypothesis hypothesis = hypothesis_of(options, common);
  if (options.bundle.empty() == options.features.empty()) {
    throw UsageError("needs either BUNDLE or --features FILE");
  }
  if (!options.features.empty()) {
    require_table_options(common);
  }
  const ThreadLimit threads(common.threads);
  Study study = options.features.empty() ? study_of_bundle(options, common)
                                         : study_of_table(options, hypothesis.columns, common);
  FitReport result;
  try {
    result = hypothesis.test(study.file.table);
  } catch (const FormulaError& error) {
    throw UsageError(error.what());
  }
  result.synthetic = study.file.synthetic;
  require_table(result, options.table);
  const std::string text = render(result, common.table_format(), options.table);
  if (common.output.empty()) {
    print(text);
  } else {
    study.manifest.seed = static_cast<std::uint64_t>(common.seed);
    write_with_manifest(common.output, text, std::move(study.manifest));
  }
  return has_error(result.conditions) ? exit_bad_data : study.exit_code;
}

}  // namespace

const Command kHypotheses = {"hypotheses", "test a hypothesis of the paper: h1, h2, h3", run};

}  // namespace tcert::cli
