#include <algorithm>
#include <array>
#include <functional>
#include <statistics/model/expression.hpp>
#include <string_view>

#include "analysis/study/h1/hypothesis_h1.hpp"
#include "analysis/study/h2/hypothesis_h2.hpp"
#include "cli/certify_run.hpp"
#include "cli/data_file.hpp"
#include "cli/errors.hpp"
#include "cli/feature_data.hpp"
#include "cli/h1_options.hpp"
#include "cli/h3.hpp"
#include "cli/inputs.hpp"
#include "cli/options.hpp"
#include "cli/outcome_column.hpp"
#include "cli/output.hpp"
#include "cli/report_output.hpp"
#include "reports/features_table.hpp"
#include "reports/h1_table.hpp"
#include "reports/h2_table.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Test a hypothesis of the paper on a bundle or on any table of trials.

h1: does the early certificate margin tell successes from failures, and fast trials from slow ones,
and better than contacts, dwell and bend variance do? AUC, C and hazard ratios of each, of the rivals
together and with the margin added, with bootstrap intervals and tests by whole clusters (days);
AUC and C also of pairs of trials of one algorithm and lighting alone (--within), which shows how much
of a gain is between groups. Twice: with the early window as the paper has it, and with the time window alone (landmark), from
which conclusions are to be drawn.

h2: is it as good in every lighting (or other --group)? AUC, C, odds and hazard ratios of each group,
whether they are equivalent at a margin (two one-sided tests of all pairs, clusters shared between
groups), the smallest margin that would do, the margin that had 80 % power, tests of difference and
interaction. Panels and clusters as in h1.

A table needs the columns of --success and of the predictors; others that are named must be there, and
those that are usual may be absent or empty. 'column:smaller' after --predictor or in
--baselines means that smaller values speak for success. Without --features' own landmark columns
(tc_landmark, ...) there is one panel, unless --landmark is given, which needs times.

Intervals are expanded percentiles of the bootstrap: with 22 days the paper's BCa covers less than it
says (--interval bca; the files hold both, and plain percentiles). With fewer than 10 clusters, or 10
outcomes of a class, p-values and intervals are withheld: NA; the estimates stand.

h3: does gating the speed by the margin recover the lead of the camera baseline without losing
successes? Every trial is replayed at each speed law and beta; rates of advance, gain, share of the
gap (the baseline's lead at one mix of lightings), successes lost and retained, stalls, the Pareto
front; by lighting.

With --output DIR/ (it ends with /, or is a folder): every table as CSV, JSON, text, Markdown and
LaTeX, the curves behind the figures as CSV and JSON, report.json, manifest.json.
text and md have the main tables, json every number; csv has the first table, or that of --table: h1, h1_within,
h1_time, h1_time_within, h1_mixed, h1_intervals, h1_case_level, h1_incidence, h1_incidence_curve, h1_roc,
h1_calibration, h1_recalibration, h1_closed_form, h1_within_closed_form, h1_folds; h2, h2_within,
h2_equality, h2_pairs, h2_interaction, h2_intervals, h2_closed_form, h2_covariance; h3, h3_baseline,
h3_intervals.

Usage: tcert hypotheses (h1 | h2) (BUNDLE | --features FILE) [options]
       tcert hypotheses h3 (BUNDLE | --replays FILE) [options]

Example:
  tcert hypotheses h1 corpus
  tcert hypotheses h1 --features results/features.csv --format md --output tables/h1.md
  tcert hypotheses h1 --features barn.csv --predictor m1 --baselines m2,m3:smaller --cluster world \
    --strata planner --time time_s
  tcert hypotheses h1 --features runs.csv --success 'status=goal,done' --predictor margin_m --strata ''
  tcert hypotheses h2 corpus --margin 0.05 --output h2/
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
                   {{"a hypothesis: h1, h2 or h3", &o.hypothesis},
                    {"BUNDLE", &o.bundle, false, OptionRole::input}}};
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
  record(common, study.manifest);
  study.manifest.synthetic = study.file.synthetic;
  study.manifest.inputs = {{name_of(options.features), digest_file(options.features)}};
  return study;
}

Study study_of_bundle(const HypothesesOptions& options, const CommonOptions& common) {
  const OpenedBundle opened = open_for(options.bundle, common);
  FeatureData features(opened.bundle);
  Study study;
  const CertifySummary summary = certify_trials(
      opened, common, nullptr, {}, [&](study::TrialRecord&& trial) { features.add(trial); });
  study.file.path = options.bundle;
  study.file.table = features.table();
  study.file.synthetic = synthetic_label(opened.bundle.info);
  study.manifest = manifest_of("hypotheses", opened, common, summary);
  study.exit_code = report(summary, opened, common);
  return study;
}

void say_conditions(const std::vector<study::H1Panel>& panels) {
  for (const study::H1Panel& panel : panels) {
    for (const statistics::Condition& condition : panel.conditions) {
      say("tcert hypotheses: " + std::string(study::to_string(panel.kind)) +
          " panel: " + statistics::to_string(condition));
    }
  }
}

/// What a hypothesis reads of a table, and what it says of it.
struct Hypothesis {
  std::vector<std::string> columns;
  std::function<FitReport(const table::DataTable&)> test;
};

Hypothesis hypothesis_of(const HypothesesOptions& options, const CommonOptions& common) {
  if (options.hypothesis == "h1") {
    const study::H1Options h1 = h1_options(options, common);
    return {study::columns_of(h1), [h1](const table::DataTable& table) {
              const study::H1Table tested = study::hypothesis_h1(table, h1);
              say_conditions(tested.panels);
              return h1_report(tested);
            }};
  }
  if (options.hypothesis == "h2") {
    const study::H2Options h2 = h2_options(options, common);
    return {study::columns_of(h2), [h2](const table::DataTable& table) {
              return h2_report(study::hypothesis_h2(table, h2));
            }};
  }
  throw UsageError("unknown hypothesis '" + options.hypothesis + "', expected h1, h2 or h3");
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

/// \throws UsageError for an option of h1 and h2 that would do nothing to h3.
void require_h3_options(const CommonOptions& common) {
  constexpr std::array<std::string_view, 14> kOfTrials = {"features",
                                                          "predictor",
                                                          "baselines",
                                                          "success",
                                                          "time",
                                                          "strata",
                                                          "within",
                                                          "landmark",
                                                          "limit",
                                                          "no-time-rounding",
                                                          "folds",
                                                          "group",
                                                          "margin",
                                                          "permutations"};
  for (const std::string& name : common.given) {
    if (std::find(kOfTrials.begin(), kOfTrials.end(), name) != kOfTrials.end()) {
      throw UsageError("--" + name + " is for h1 and h2, not for h3");
    }
  }
}

int run(Arguments arguments) {
  HypothesesOptions options;
  H3CommandOptions h3_options;
  CommonOptions common;
  if (!parse(command_line(options, h3_options), common, arguments)) {
    return exit_done;
  }
  if (options.hypothesis == "h3") {
    require_h3_options(common);
    return run_h3(h3_options,
                  {options.bundle,
                   options.cluster,
                   options.table,
                   options.level,
                   options.replicates,
                   options.interval},
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
  ReportOutput output(common, "hypotheses");
  Study study = options.features.empty() ? study_of_bundle(options, common)
                                         : study_of_table(options, hypothesis.columns, common);
  FitReport result;
  try {
    refuse_missing_words(hypothesis.columns, study.file.table);
    const OutcomeTexts texts =
        code_outcome_column(outcome_column(options.success), study.file.table);
    result = hypothesis.test(study.file.table);
    name_outcome_texts(texts, result);
  } catch (const statistics::FormulaError& error) {
    throw UsageError(error.what());
  }
  result.synthetic = study.file.synthetic;
  study.manifest.seed = static_cast<std::uint64_t>(common.seed);
  const bool failed = statistics::has_error(result.conditions);
  output.deliver(std::move(result), options.table, std::move(study.manifest));
  return failed ? exit_bad_data : study.exit_code;
}

}  // namespace

const Command kHypotheses = {"hypotheses", "test a hypothesis of the paper: h1, h2, h3", run};

}  // namespace tcert::cli
