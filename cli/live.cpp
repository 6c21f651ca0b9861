#include <optional>
#include <string>
#include <tcert/certifier.hpp>
#include <tcert/guards.hpp>
#include <utility>

#include "cli/errors.hpp"
#include "cli/guard_options.hpp"
#include "cli/inputs.hpp"
#include "cli/line_source.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/result_folder.hpp"
#include "datasets/bundle_files.hpp"
#include "datasets/bundle_json.hpp"
#include "datasets/bytes.hpp"
#include "datasets/tick_line.hpp"
#include "reports/audit.hpp"
#include "reports/features_table.hpp"
#include "reports/series.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Certify ticks as they arrive: reads ticks on stdin, writes one row of the series per tick.

The rows are those that 'certify' writes for the same ticks, byte for byte; with --guards those that
'replay --series' writes, with the speed v_t and the guards G1-G3 at the end. A line that is not a
tick is reported on stderr and skipped; the exit code is then 3.

--audit FILE writes one row for every guard that began or ceased to trip,
with its cause, at once.

Usage: tcert live --bundle BUNDLE [options] < ticks

Example:
  robot_driver | tcert live --bundle results/corpus/bundle.json
  tcert live --bundle corpus --input-format jsonl --set beta_per_m=20 < ticks.jsonl
  robot_driver | tcert live --bundle corpus --guards --audit audit.csv --set speed_law=clip

Cost: about a microsecond of certifying per tick; memory does not grow with the run.
)";

struct LiveOptions {
  std::string bundle;
  std::string input_format = "auto";
  bool ray_margins = false;
  bool guards = false;
  std::string audit;
  std::string tracking_error;
};

CommandLine command_line(LiveOptions& o) {
  CommandLine line{"live", kText, uses_parameters, po::options_description("Options"), {}};
  line.own.add_options()("bundle",
                         po::value(&o.bundle)->value_name("PATH"),
                         "the bundle, or its bundle.json, that describes robot and course")(
      "input-format",
      po::value(&o.input_format)->value_name("WORD")->default_value(o.input_format),
      "of the ticks on stdin: csv (a header, then rows as in ticks.csv), jsonl, or auto to see")(
      "ray-margins", po::bool_switch(&o.ray_margins), "one more column a ray: its own margin")(
      "guards",
      po::bool_switch(&o.guards),
      "more columns: gated speed, robust margin, force limit, which guards trip")(
      "audit",
      po::value(&o.audit)->value_name("FILE"),
      "log of the guards: when each began and ceased to trip, and why");
  add_tracking_error_option(line.own, o.tracking_error);
  return line;
}

void require_known(const std::string& word) {
  if (word != "auto" && word != "csv" && word != "jsonl") {
    throw UsageError("--input-format: found '" + word + "', expected auto, csv or jsonl");
  }
}

/// Ticks of stdin, one after the other; what is not a tick is said, counted and skipped.
class TickSource {
 public:
  TickSource(const Robot& robot, const BundleInfo& info, std::string format)
      : robot_(robot),
        options_{"stdin", info.max_gap_s, info.trial_limit_s, {}},
        format_(std::move(format)) {
    if (const auto renames = info.columns.find("ticks.csv"); renames != info.columns.end()) {
      options_.rename = renames->second;
    }
  }

  /// \throws BadData if the first line is neither a header with the columns of the robot nor JSON.
  [[nodiscard]] std::optional<TickLine> next() {
    while (lines_.next(line_)) {
      ++number_;
      if (!parser_ && !start()) {
        continue;
      }
      const auto read = parser_->parse(line_, number_);
      bad_ += parser_->problems().empty() ? 0 : 1;
      say(parser_->problems());
      if (read) {
        return read;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::size_t bad_lines() const noexcept { return bad_; }

 private:
  /// True if the line, which is the first of its kind, is a tick already.
  bool start() {
    const auto first = line_.find_first_not_of(" \t\r");
    if (first == std::string::npos || line_[first] == '#') {
      return false;
    }
    DiagnosticGroups problems;
    parser_.emplace(robot_, line_, options_, problems);
    say(problems.take());
    const bool is_json = parser_->format() == TickLineFormat::json_lines;
    if (!parser_->ready() || (format_ == "csv" && is_json) || (format_ == "jsonl" && !is_json)) {
      throw BadData("stdin: the first line is not " +
                    std::string(format_ == "jsonl" ? "a JSON object" : "a header of ticks.csv"));
    }
    return is_json;
  }

  const Robot& robot_;
  TickLineOptions options_;
  std::string format_;
  LineSource lines_;
  std::optional<TickLineParser> parser_;
  std::string line_;
  std::size_t number_ = 0;
  std::size_t bad_ = 0;
};

/// Rows that are on disk, as far as the system goes, before the next tick is looked at.
class AuditLog {
 public:
  AuditLog(const std::string& path, const GuardParameters& parameters)
      : file_(path), parameters_(parameters) {
    file_.write(audit_header());
    file_.flush();
  }

  void add(const Tick& tick, const CertifiedTick& certified, const GuardedTick& guarded) {
    rows_.clear();
    append_audit_rows(rows_, tick, certified, guarded, parameters_);
    if (!rows_.empty()) {
      file_.write(rows_);
      file_.flush();
    }
  }

  void close() { file_.close(); }

 private:
  ResultFile file_;
  const GuardParameters& parameters_;
  std::string rows_;
};

BundleInfo describe(const std::string& path) {
  if (path.empty()) {
    throw UsageError("needs --bundle");
  }
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw NoInput("no bundle at '" + path + "'");
  }
  const bool is_json = std::filesystem::path(path).extension() == ".json";
  if (!is_json && !BundleFiles(path).contains("bundle.json")) {
    throw BadData("'" + path + "' holds no bundle.json: name a bundle or its bundle.json");
  }
  BytesResult bytes = is_json ? read_file(path) : BundleFiles(path).read("bundle.json");
  if (!bytes.bytes) {
    throw BadData("'" + path + "': " + bytes.problem);
  }
  DiagnosticGroups problems;
  auto info = parse_bundle_json(bytes.bytes->view(), problems);
  say(problems.take());
  if (!info) {
    throw BadData("'" + path + "' is not a bundle.json that can be used");
  }
  return std::move(*info);
}

int run(Arguments arguments) {
  LiveOptions options;
  CommonOptions common;
  if (!parse(command_line(options), common, arguments)) {
    return exit_done;
  }
  require_known(options.input_format);
  const BundleInfo info = describe(options.bundle);
  const ParameterSet parameters = effective_parameters(info.parameters, common);
  const Robot robot = effective_robot(info, parameters);
  Certifier certifier(robot, info.course, parameters.certificate);
  Guards guards(parameters.speed_law,
                parameters.guards,
                tracking_error_table(options.tracking_error, common));
  const SeriesFormat format{
      parameters.speed_law, options.ray_margins, synthetic_label(info), options.guards};
  std::optional<AuditLog> audit;
  if (!options.audit.empty()) {
    audit.emplace(options.audit, parameters.guards);
  }
  TickSource ticks(robot, info, options.input_format);
  print(series_header(format, robot));
  std::string row;
  while (const auto line = ticks.next()) {
    row.clear();
    const CertifiedTick certified = certifier.update(line->tick);
    const GuardedTick guarded = guards.update(line->tick, certified);
    append_series_row(row,
                      line->tick,
                      certified,
                      certifier.ray_margins(),
                      format,
                      guarded,
                      line->yaw_rate_cmd_rps);
    print(row);
    if (audit) {
      audit->add(line->tick, certified, guarded);
    }
  }
  if (audit) {
    audit->close();
  }
  if (ticks.bad_lines() > 0) {
    say("tcert live: " + std::to_string(ticks.bad_lines()) + " bad lines were skipped.");
  }
  return ticks.bad_lines() > 0 ? exit_rejected : exit_done;
}

}  // namespace

const Command kLive = {"live", "certify ticks from stdin as they arrive", run};

}  // namespace tcert::cli
