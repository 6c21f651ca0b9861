#include <optional>

#include "analysis/h1/hypothesis_h1.hpp"
#include "analysis/trials/study_tables.hpp"
#include "cli/certify_run.hpp"
#include "cli/data_file.hpp"
#include "cli/errors.hpp"
#include "cli/feature_data.hpp"
#include "cli/inputs.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/result_folder.hpp"
#include "cli/simulated.hpp"
#include "reports/features_table.hpp"
#include "reports/h1_table.hpp"
#include "reports/study_table.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(From end to end: logs, certificates, features, tables.

Without a BUNDLE it makes the synthetic corpus in DIR/corpus, unless it is there already. It
certifies every trial into DIR/certificates, prints the tables, and writes them to DIR/tables as
text, Markdown, CSV and JSON.

Usage: tcert reproduce [BUNDLE] --output DIR [options]

Example:
  tcert reproduce --output results
  tcert reproduce my-logs --output results --set body_width_m=0.5

Cost: a few seconds and about 150 MB for the 660 trials.
)";

struct ReproduceOptions {
  std::string bundle;
  double effect = 1.0;
  bool no_series = false;
};

CommandLine command_line(ReproduceOptions& o) {
  CommandLine line{"reproduce",
                   kText,
                   uses_parameters | uses_output | uses_format | uses_seed | uses_threads |
                       uses_trials | uses_logs,
                   po::options_description("Options"),
                   {{"BUNDLE", &o.bundle, false}}};
  line.own.add_options()("effect",
                         po::value(&o.effect)->value_name("E")->default_value(o.effect),
                         "of the corpus, as for 'tcert simulate'; 0 makes a null corpus")(
      "no-series", po::bool_switch(&o.no_series), "leave certificates/series out, to save space");
  return line;
}

std::string corpus_for(const ReproduceOptions& options, const CommonOptions& common) {
  const auto folder = std::filesystem::path(common.output) / "corpus";
  SimulatedCorpus corpus;
  corpus.options.seed = static_cast<std::uint64_t>(common.seed);
  corpus.options.effect = options.effect;
  if (!is_there(corpus, folder)) {
    write_corpus(corpus, folder, common);
  }
  return folder.string();
}

std::vector<Table> tables_of(const StudyRecord& study, const H1Table& h1) {
  const std::vector<StudyGroup> cells = study.by_cell();
  return {success_table(cells),
          speed_table(study.by_algorithm(), study.by_lighting()),
          latency_table(cells),
          issuance_table(h1),
          tc_early_table(h1),
          h1_success_table(h1),
          h1_time_table(h1),
          h1_mixed_table(h1)};
}

void write_tables(const std::vector<Table>& tables, const ResultFolder& folder) {
  for (const Table& table : tables) {
    folder.write(table.name + ".txt", render(table, TableFormat::text));
    folder.write(table.name + ".md", render(table, TableFormat::markdown));
    folder.write(table.name + ".csv", render(table, TableFormat::csv));
    folder.write(table.name + ".json", render(table, TableFormat::json));
  }
}

int run(Arguments arguments) {
  ReproduceOptions options;
  CommonOptions common;
  if (!parse(command_line(options), common, arguments)) {
    return exit_done;
  }
  require_range("effect", options.effect, 0, 2);
  if (common.output.empty()) {
    throw UsageError("needs --output DIR");
  }
  const bool own_corpus = options.bundle.empty();
  const std::filesystem::path output = common.output;
  const OpenedBundle opened =
      open_for(own_corpus ? corpus_for(options, common) : options.bundle, common);

  for (const char* part : {"certificates", "tables"}) {
    require_apart(opened.bundle.path, output / part);
  }
  ResultFolder certificates(output / "certificates", "reproduce");
  ResultFolder table_folder(output / "tables", "reproduce");
  StudyRecord study;
  FeatureData features(opened.bundle);
  const CertifySummary summary =
      certify_trials(opened, common, &certificates, {!options.no_series}, [&](TrialRecord&& trial) {
        features.add(trial);
        study.add(std::move(trial));
      });
  Manifest manifest = manifest_of("reproduce", opened, common, summary);
  if (own_corpus) {
    manifest.seed = static_cast<std::uint64_t>(common.seed);
  }
  certificates.commit(manifest);

  H1Options h1_options;
  h1_options.landmark_s = opened.parameters.early_window.time_s;
  h1_options.seed = static_cast<std::uint64_t>(common.seed);
  const ThreadLimit threads(common.threads);
  const H1Table h1 = hypothesis_h1(features.table(), h1_options);
  std::vector<Table> tables = tables_of(study, h1);
  for (Table& table : tables) {
    table.synthetic = synthetic_label(opened.bundle.info);
    print(render(table, common.table_format()) + '\n');
  }
  write_tables(tables, table_folder);
  FitReport document = h1_report(h1);
  document.synthetic = synthetic_label(opened.bundle.info);
  table_folder.write("h1_all.json", render(document, TableFormat::json));
  table_folder.commit(std::move(manifest));
  if (!common.quiet) {
    say("Bundle:       " + opened.bundle.path.string() + "\nCertificates: " +
        (output / "certificates").string() + "\nTables:       " + (output / "tables").string());
  }
  return report(summary, opened, common);
}

}  // namespace

const Command kReproduce = {"reproduce", "from logs to the tables of the paper, end to end", run};

}  // namespace tcert::cli
