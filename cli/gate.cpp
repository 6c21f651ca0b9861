#include "analysis/study/gate/gate_study.hpp"

#include <memory>

#include "cli/certify_run.hpp"
#include "cli/data_file.hpp"
#include "cli/errors.hpp"
#include "cli/inputs.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/report_output.hpp"
#include "reports/features_table.hpp"
#include "reports/gate_report.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(The bottleneck micro-study: is the chance to pass a gate even where the margin is 0?

Fits logit Pr(success) = alpha + beta m to passes through gates about as wide as the body, m the
smallest margin felt in the pass. Prints the slope with Wald and profile intervals; the 50 % point
-alpha / beta with Fieller's, the profile and the bootstrap set, each bounded or named unbounded, and
whether it covers 0; the calibration; and the least certificate before the gate as second predictor.

With --output DIR/ (it ends with /, or is a folder): every table in every format, and the curve.
json has every number; csv has the table of the 50 % point, or that of --table: gate_slope,
gate_calibration, gate_model, gate_passes, gate_curve.

Usage: tcert gate BUNDLE [options]

Example:
  tcert simulate --micro-study --output gates
  tcert gate gates --output gate/

Cost: a second for 60 passes.
)";

struct GateOptions {
  std::string bundle;
  std::string table;
  double level = 0.95;
  std::int64_t replicates = 1999;
};

CommandLine command_line(GateOptions& o) {
  CommandLine line{"gate",
                   kText,
                   uses_parameters | uses_output | uses_format | uses_seed | uses_threads |
                       uses_trials | uses_logs,
                   po::options_description("Options"),
                   {{"BUNDLE", &o.bundle, true, OptionRole::input}}};
  line.own.add_options()("level",
                         po::value(&o.level)->value_name("P")->default_value(o.level, "0.95"),
                         "of the intervals")(
      "replicates",
      po::value(&o.replicates)->value_name("R")->default_value(o.replicates),
      "of the bootstrap; 0 leaves it out")("table",
                                           po::value(&o.table)->value_name("NAME"),
                                           "print only this table; a wrong name lists them");
  return line;
}

int run(Arguments arguments) {
  GateOptions options;
  CommonOptions common;
  if (!parse(command_line(options), common, arguments)) {
    return exit_done;
  }
  require_range("replicates", static_cast<double>(options.replicates), 0, 1e6);
  require_range("level", options.level, 1e-9, 1.0 - 1e-9);
  const OpenedBundle opened = open_for(options.bundle, common);
  if (!common.output.empty()) {
    require_apart(options.bundle, common.output);
  }
  ReportOutput output(common, "gate");
  const double approach_m = effective_robot(opened.bundle.info, opened.parameters).body_width_m;
  std::vector<study::GateRow> rows;
  const auto extra = [&](const study::StudiedTrial& trial) -> std::function<void()> {
    const study::GateRow row{
        trial.row->trial_id, trial.row->success, study::gate_pass(trial.series.ticks, approach_m)};
    return [&rows, row] { rows.push_back(row); };
  };
  const CertifySummary summary = certify_trials(opened, common, nullptr, {}, {}, extra);
  study::EvenChanceOptions study_options;
  study_options.level = options.level;
  study_options.replicates = static_cast<std::size_t>(options.replicates);
  study_options.seed = static_cast<std::uint64_t>(common.seed);
  const ThreadLimit threads(common.threads);
  FitReport result = gate_report(study::gate_study(std::move(rows), study_options));
  result.synthetic = synthetic_label(opened.bundle.info);
  Manifest manifest = manifest_of("gate", opened, common, summary);
  manifest.seed = study_options.seed;
  const bool failed = statistics::has_error(result.conditions);
  output.deliver(std::move(result), options.table, std::move(manifest));
  return failed ? exit_bad_data : report(summary, opened, common);
}

}  // namespace

const Command kGate = {"gate", "the bottleneck micro-study: the margin of an even chance", run};

}  // namespace tcert::cli
