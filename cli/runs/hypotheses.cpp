#include "cli/runs/hypotheses.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <statistics/model/expression.hpp>
#include <string_view>

#include "analysis/study/h1/hypothesis_h1.hpp"
#include "analysis/study/h2/hypothesis_h2.hpp"
#include "cli/runs/certify_trials.hpp"
#include "cli/runs/data_file.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/feature_data.hpp"
#include "cli/runs/h1_options.hpp"
#include "cli/runs/h3.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/outcome_column.hpp"
#include "cli/runs/report_output.hpp"
#include "cli/runs/thread_limit.hpp"
#include "cli/runs/watched_stages.hpp"
#include "reports/features_table.hpp"
#include "reports/h1_table.hpp"
#include "reports/h2_table.hpp"

namespace tcert::cli {
namespace {

struct H1Study {
  DataFile file;
  Manifest manifest;
  ExitCode code = exit_done;
};

H1Study h1_study_of_table(const HypothesesRequest& request,
                          const std::vector<std::string>& columns,
                          Progress& progress) {
  H1Study study;
  study.file = read_data_file(request.features, columns, request.logs.decimal_comma, progress);
  study.manifest = manifest_of("hypotheses", study.file, written(request));
  return study;
}

H1Study h1_study_of_bundle(const HypothesesRequest& request, Progress& progress) {
  const OpenedBundle opened = open_for(request.bundle, request.logs, progress);
  FeatureData features(opened.bundle);
  H1Study study;
  const CertifySummary summary = certify_trials(
      opened, request.threads, progress, nullptr, {}, [&](study::TrialRecord&& trial) {
        features.add(trial);
      });
  study.file.path = request.bundle;
  study.file.table = features.table();
  study.file.synthetic = synthetic_label(opened.bundle.info);
  study.manifest = manifest_of("hypotheses", opened, written(request), summary);
  study.code = conclude(summary, opened, progress);
  return study;
}

/// What a hypothesis reads of a table, and what it says of it.
struct Hypothesis {
  std::vector<std::string> columns;
  std::function<FitReport(const table::DataTable&)> test;
};

Hypothesis hypothesis_of(const HypothesesRequest& request, Progress& progress) {
  if (request.hypothesis == "h1") {
    const study::H1Options h1 = h1_options(request);
    return {study::columns_of(h1), [h1, &progress](const table::DataTable& table) {
              WatchedStages stages(progress);
              return h1_report(study::hypothesis_h1(table, h1, stages.watch()));
            }};
  }
  if (request.hypothesis == "h2") {
    const study::H2Options h2 = h2_options(request);
    return {study::columns_of(h2), [h2, &progress](const table::DataTable& table) {
              WatchedStages stages(progress);
              return h2_report(study::hypothesis_h2(table, h2, stages.watch()));
            }};
  }
  throw UsageError("unknown hypothesis '" + request.hypothesis + "', expected h1, h2 or h3");
}

/// What would do nothing to a table that is made already. \throws UsageError.
void require_table_options(const HypothesesRequest& request) {
  for (const char* const name : {"trials", "strict", "repair"}) {
    if (is_given(request.given, name)) {
      throw UsageError("--" + std::string(name) + " is for a bundle, not for --features");
    }
  }
  if (!request.logs.parameters.of_flags.empty()) {
    throw UsageError(
        "--set " + request.logs.parameters.of_flags.front().first +
        ": parameters are for a bundle, not for --features; the landmark of a table is "
        "set by --landmark");
  }
}

/// \throws UsageError for an option of h1 and h2 that would do nothing to h3.
void require_h3_options(const HypothesesRequest& request) {
  constexpr std::array kOfTrials = {"features",
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
  for (const char* const name : kOfTrials) {
    if (is_given(request.given, name)) {
      throw UsageError("--" + std::string(name) + " is for h1 and h2, not for h3");
    }
  }
}

/// \throws UnfitData if no row has a group.
void require_groups(const table::DataTable& table, const std::string& group) {
  const table::DataColumn* const column = table.find(group);
  const bool is_empty =
      column != nullptr && column->text.levels.empty() &&
      std::ranges::all_of(column->numbers, [](double x) { return std::isnan(x); });
  if (is_empty) {
    throw UnfitData("no trial has a value of '" + group +
                    "', whose groups H2 compares; --group names another column");
  }
}

/// \throws UsageError if the output would replace what is read.
void require_inputs_apart(const HypothesesRequest& request) {
  for (const std::string* const input :
       {&request.features, &request.replays, &request.laws.tracking_error}) {
    if (!input->empty() && !request.output.path.empty()) {
      require_apart(*input, request.output.path);
    }
  }
}

}  // namespace

ExitCode hypotheses(const HypothesesRequest& request, Progress& progress) {
  require_inputs_apart(request);
  if (request.hypothesis == "h3") {
    require_h3_options(request);
    return hypothesis_3(request, progress);
  }
  const Hypothesis hypothesis = hypothesis_of(request, progress);
  if (request.bundle.empty() == request.features.empty()) {
    throw UsageError("needs either BUNDLE or --features FILE");
  }
  if (!request.features.empty()) {
    require_table_options(request);
  }
  const ThreadLimit limit(request.threads);
  ReportOutput output(request.output, "hypotheses");
  H1Study study = request.features.empty()
                      ? h1_study_of_bundle(request, progress)
                      : h1_study_of_table(request, hypothesis.columns, progress);
  FitReport report;
  try {
    refuse_missing_words(hypothesis.columns, study.file.table);
    if (request.hypothesis == "h2") {
      require_groups(study.file.table, request.group);
    }
    const OutcomeTexts texts =
        code_outcome_column(outcome_column(request.success), study.file.table);
    report = hypothesis.test(study.file.table);
    name_outcome_texts(texts, report, progress);
  } catch (const statistics::FormulaError& error) {
    throw UnfitData(error.what());
  }
  report.synthetic = study.file.synthetic;
  study.manifest.seed = static_cast<std::uint64_t>(request.seed);
  const ExitCode code = statistics::has_error(report.conditions) ? exit_bad_data : study.code;
  output.deliver(std::move(report), request.table, std::move(study.manifest), progress);
  return code;
}

}  // namespace tcert::cli
