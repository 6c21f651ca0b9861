#include "cli/h3.hpp"

#include <memory>
#include <stdexcept>
#include <table/bytes.hpp>

#include "analysis/study/h3/hypothesis_h3.hpp"
#include "cli/certify_run.hpp"
#include "cli/data_file.hpp"
#include "cli/errors.hpp"
#include "cli/guard_options.hpp"
#include "cli/h1_options.hpp"
#include "cli/report_output.hpp"
#include "reports/features_table.hpp"
#include "reports/h3_table.hpp"
#include "reports/replay_table.hpp"

namespace tcert::cli {
namespace {

struct Study {
  table::DataTable table;
  std::optional<SyntheticLabel> synthetic;
  Manifest manifest;
  int exit_code = exit_done;
};

Study study_of_table(const H3CommandOptions& options,
                     const study::H3Options& h3,
                     const CommonOptions& common) {
  Study study;
  DataFile file = read_data_file(options.replays, study::columns_of(h3), common);
  study.table = std::move(file.table);
  study.synthetic = file.synthetic;
  study.manifest.command = "hypotheses";
  record(common, study.manifest);
  study.manifest.synthetic = study.synthetic;
  study.manifest.inputs = {{name_of(options.replays), digest_file(options.replays)}};
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

Study study_of_bundle(const H3CommandOptions& options,
                      const std::string& bundle,
                      const CommonOptions& common) {
  const OpenedBundle opened = open_for(bundle, common);
  const study::ReplaySetup setup = replay_setup(options.laws, opened.parameters, common);
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
  const CertifySummary summary = certify_trials(opened, common, nullptr, {}, {}, extra);
  study.table = read_back(replays);
  study.synthetic = synthetic_label(opened.bundle.info);
  study.manifest = manifest_of("hypotheses", opened, common, summary);
  if (const auto input = tracking_error_input(options.laws.tracking_error)) {
    study.manifest.inputs.push_back(*input);
  }
  study.exit_code = report(summary, opened, common);
  return study;
}

}  // namespace

void add_h3_options(po::options_description& own, H3CommandOptions& options) {
  own.add_options()("replays",
                    input(options.replays, "FILE"),
                    "h3: replay.csv of 'tcert replay' instead of a bundle")(
      "gated",
      po::value(&options.gated)->value_name("NAME")->default_value(options.gated),
      "h3: the algorithm that is gated")(
      "lead",
      po::value(&options.baseline)->value_name("NAME")->default_value(options.baseline),
      "h3: the algorithm whose lead is to be recovered")(
      "loss-margin",
      po::value(&options.loss_margin)->value_name("P")->default_value(options.loss_margin, "0.05"),
      "h3: share of trials that may be lost");
  add_replay_law_options(own, options.laws);
}

int run_h3(const H3CommandOptions& options, const H3Shared& shared, const CommonOptions& common) {
  if (shared.bundle.empty() == options.replays.empty()) {
    throw UsageError("h3 needs either BUNDLE or --replays FILE");
  }
  require_range("replicates", static_cast<double>(shared.replicates), 1, 1e6);
  require_range("loss-margin", options.loss_margin, 1e-9, 1.0 - 1e-9);
  require_range("level", shared.level, 1e-9, 1.0 - 1e-9);
  study::H3Options h3;
  h3.gated = options.gated;
  h3.baseline = options.baseline;
  h3.cluster = shared.cluster;
  h3.level = shared.level;
  h3.interval = interval_method(shared.interval);
  h3.loss_margin = options.loss_margin;
  h3.replicates = static_cast<std::size_t>(shared.replicates);
  h3.seed = static_cast<std::uint64_t>(common.seed);
  const ThreadLimit threads(common.threads);
  ReportOutput output(common, "hypotheses");
  Study study = options.replays.empty() ? study_of_bundle(options, shared.bundle, common)
                                        : study_of_table(options, h3, common);
  FitReport result;
  try {
    result = h3_report(study::hypothesis_h3(study.table, h3));
  } catch (const std::invalid_argument& error) {
    throw BadData(error.what());
  }
  result.synthetic = study.synthetic;
  study.manifest.seed = h3.seed;
  const bool failed = statistics::has_error(result.conditions);
  output.deliver(std::move(result), shared.table, std::move(study.manifest));
  return failed ? exit_bad_data : study.exit_code;
}

}  // namespace tcert::cli
