#include "cli/runs/h3.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <table/bytes.hpp>
#include <table/read_data_table.hpp>

#include "analysis/study/driven/paired_arms.hpp"
#include "analysis/study/h3/hypothesis_h3.hpp"
#include "cli/runs/certify_trials.hpp"
#include "cli/runs/data_file.hpp"
#include "cli/runs/guard_options.hpp"
#include "cli/runs/h1_options.hpp"
#include "cli/runs/report_output.hpp"
#include "cli/runs/thread_limit.hpp"
#include "cli/runs/watched_stages.hpp"
#include "reports/features_table.hpp"
#include "reports/h3_driven_table.hpp"
#include "reports/h3_table.hpp"
#include "reports/replay_table.hpp"

namespace tcert::cli {
namespace {

struct Study {
  table::DataTable table;
  std::optional<SyntheticLabel> synthetic;
  Manifest manifest;
  ExitCode code = exit_done;
  std::vector<TrialRow> trials;  ///< Of a bundle, as the next.
  std::vector<std::string> extra_columns;
};

/// The names in the column, each once.
std::string algorithms_of(const table::DataTable& table) {
  std::string names;
  const table::DataColumn* const column = table.find("algorithm");
  if (column != nullptr && column->is_text) {
    for (const std::string& name : column->text.levels) {
      names += (names.empty() ? "" : ", ") + name;
    }
  }
  return names.empty() ? "none" : names;
}

Study study_of_table(const HypothesesRequest& request,
                     const study::H3Options& h3,
                     Progress& progress) {
  Study study;
  DataFile file =
      read_data_file(request.replays, study::columns_of(h3), request.logs.decimal_comma, progress);
  study.manifest = manifest_of("hypotheses", file, written(request));
  study.table = std::move(file.table);
  study.synthetic = file.synthetic;
  return study;
}

// Written as CSV and read again, so that a bundle and its replay.csv give the same numbers.
table::DataTable read_back(const Table& replays) {
  table::CsvOptions csv;
  csv.file = "replay.csv";
  table::DataTableResult read =
      table::read_data_table(table::Bytes::copy_of(render(replays, TableFormat::csv)), {}, csv);
  if (!read.table) {
    throw std::logic_error("the replays cannot be read back: " +
                           table::to_string(read.diagnostics.front()));
  }
  return std::move(*read.table);
}

Study study_of_bundle(const HypothesesRequest& request, Progress& progress) {
  const OpenedBundle opened = open_for(request.bundle, request.logs, progress);
  const study::ReplaySetup setup =
      replay_setup(request.laws, opened.parameters, request.logs.decimal_comma, progress);
  Table replays = replay_table();
  const auto extra = [&](const study::StudiedTrial& trial) -> std::function<void()> {
    auto rows = std::make_shared<std::vector<std::vector<TableCell>>>();
    for (const study::ReplayedTrial& one :
         study::replay_trial(trial, opened.bundle.info, opened.parameters, setup)) {
      rows->push_back(replay_row(one.record));
    }
    return [&replays, rows] {
      for (std::vector<TableCell>& row : *rows) {
        replays.add_row(std::move(row));
      }
    };
  };
  Study study;
  const CertifySummary summary =
      certify_trials(opened, request.threads, progress, nullptr, {}, {}, extra);
  study.table = read_back(replays);
  study.synthetic = synthetic_label(opened.bundle.info);
  study.manifest = manifest_of("hypotheses", opened, written(request), summary);
  if (const auto input = tracking_error_input(request.laws.tracking_error)) {
    study.manifest.inputs.push_back(*input);
  }
  study.code = conclude(summary, opened, progress);
  study.trials = opened.bundle.trials;
  study.extra_columns = opened.bundle.extra_columns;
  return study;
}

/// What a replay of the gated algorithm leaves out of a driven bundle.
void say_driven_arms(const HypothesesRequest& request, const Study& study, Progress& progress) {
  const auto arm = std::ranges::find_if(study.trials, [&](const TrialRow& row) {
    return row.algorithm.starts_with(request.gated + "+");
  });
  if (!request.driven && arm != study.trials.end()) {
    progress.say("this bundle has arms that drove the same worlds, such as '" + arm->algorithm +
                 "': --driven compares them. What follows re-times the logs of '" + request.gated +
                 "' and sees none of them");
  }
}

study::PairedArms driven_arms(const HypothesesRequest& request, const Study& study) {
  study::PairedOptions paired;
  paired.base = request.gated;
  paired.lead = request.lead;
  paired.level = request.level;
  paired.loss_margin = request.loss_margin;
  paired.replicates = static_cast<std::size_t>(request.replicates);
  paired.seed = static_cast<std::uint64_t>(request.seed);
  return study::compare_arms(study.trials, study.extra_columns, paired);
}

study::H3Beta beta_of(const HypothesesRequest& request) {
  study::H3Beta beta;
  beta.asked = is_given(request.given, "beta");
  beta.folds = static_cast<std::size_t>(request.folds);
  if (request.beta == "folds") {
    beta.per_m.reset();
    return beta;
  }
  const std::vector<double> number = numbers_of("beta", request.beta);
  if (number.size() != 1) {
    throw UsageError("--beta: found '" + request.beta + "', expected one number or folds");
  }
  beta.per_m = number.front();
  return beta;
}

}  // namespace

ExitCode hypothesis_3(const HypothesesRequest& request, Progress& progress) {
  if (request.bundle.empty() == request.replays.empty()) {
    throw UsageError("h3 needs either BUNDLE or --replays FILE");
  }
  if (request.driven && request.bundle.empty()) {
    throw UsageError("--driven needs a BUNDLE, as 'tcert drive' writes it, not --replays");
  }
  for (const char* const name : {"cluster", "interval"}) {
    if (request.driven && is_given(request.given, name)) {
      throw UsageError("--" + std::string(name) +
                       " does nothing to --driven: days are clusters, and intervals of rates are "
                       "expanded percentiles");
    }
  }
  require_range("level", request.level, request.driven ? 0.5 + 1e-9 : 1e-9, 1.0 - 1e-9);
  study::H3Options h3;
  if (request.gated == request.lead) {
    throw UsageError("--gated and --lead: found '" + request.gated +
                     "' for both, expected two algorithms");
  }
  h3.gated = request.gated;
  h3.baseline = request.lead;
  h3.cluster = request.cluster;
  h3.level = request.level;
  h3.interval = interval_method(request.interval);
  h3.loss_margin = request.loss_margin;
  h3.true_loss = request.true_loss.value_or(request.loss_margin / 5.0);
  if (h3.true_loss >= h3.loss_margin) {
    throw UsageError("--true-loss: expected a value below --loss-margin");
  }
  h3.beta = beta_of(request);
  h3.replicates = static_cast<std::size_t>(request.replicates);
  h3.seed = static_cast<std::uint64_t>(request.seed);
  const ThreadLimit limit(request.threads);
  ReportOutput output(request.output, "hypotheses");
  Study study = request.replays.empty() ? study_of_bundle(request, progress)
                                        : study_of_table(request, h3, progress);
  FitReport report;
  try {
    WatchedStages stages(progress);
    const study::H3Table tested = study::hypothesis_h3(study.table, h3, stages.watch());
    if (tested.groups.empty()) {
      throw UnfitData("no trial of '" + h3.gated + "' or '" + h3.baseline +
                      "', which --gated and --lead name; algorithms of the table: " +
                      algorithms_of(study.table));
    }
    say_driven_arms(request, study, progress);
    report =
        request.driven ? h3_driven_report(driven_arms(request, study), tested) : h3_report(tested);
  } catch (const std::invalid_argument& error) {
    throw BadData(error.what());
  }
  report.synthetic = study.synthetic;
  study.manifest.seed = h3.seed;
  const ExitCode code = statistics::has_error(report.conditions) ? exit_bad_data : study.code;
  output.deliver(std::move(report), request.table, std::move(study.manifest), progress);
  return code;
}

}  // namespace tcert::cli
