#include "cli/runs/live/live.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <tcert/certifier.hpp>
#include <tcert/guards.hpp>
#include <utility>

#include "cli/runs/guard_options.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/interrupt.hpp"
#include "cli/runs/live/line_buffer.hpp"
#include "cli/runs/live/live_audit.hpp"
#include "cli/runs/live/live_bundle.hpp"
#include "cli/runs/live/live_record.hpp"
#include "cli/runs/live/live_witness.hpp"
#include "cli/runs/live/patient_output.hpp"
#include "cli/runs/live/producer.hpp"
#include "cli/runs/live/stall_watch.hpp"
#include "cli/runs/live/tick_source.hpp"
#include "cli/runs/result_folder.hpp"
#include "datasets/tick_line.hpp"
#include "reports/features_table.hpp"
#include "reports/series.hpp"

namespace tcert::cli {
namespace {

void require_known(const LiveRequest& o) {
  if (o.input_format != "auto" && o.input_format != "csv" && o.input_format != "jsonl") {
    throw UsageError("--input-format: found '" + o.input_format + "', expected auto, csv or jsonl");
  }
  if (o.slow_consumer != "auto" && o.slow_consumer != "wait" && o.slow_consumer != "drop") {
    throw UsageError("--slow-consumer: found '" + o.slow_consumer +
                     "', expected auto, wait or drop");
  }
}

constexpr int kLastRowsMs = 2000;

/// Takes lines until the producer ends or an interrupt comes. `take` is given every tick; false
/// ends it too.
template <typename Take>
void follow(Producer& producer,
            TickSource& source,
            RowSink& rows,
            StallWatch& stall,
            int interrupt,
            Take take) {
  LineBuffer lines;
  std::string bytes;
  std::string line;
  std::size_t too_long = 0;
  const auto take_lines = [&] {
    while (lines.next(line)) {
      for (const TickLine& tick : source.take(line)) {
        if (!take(tick)) {
          return false;
        }
      }
    }
    for (; too_long < lines.too_long(); ++too_long) {
      source.reject("a line of more than 1 MiB");
    }
    return true;
  };
  for (;;) {
    std::array<pollfd, 3> wait{{{interrupt, POLLIN, 0},
                                {producer.descriptor(), POLLIN, 0},
                                {rows.waits_for_reader() ? STDOUT_FILENO : -1, POLLOUT, 0}}};
    ::poll(wait.data(), wait.size(), stall.left_ms());
    if (wait[0].revents != 0) {
      return;
    }
    if (wait[2].revents != 0) {
      rows.drain();
    }
    stall.look();
    if (wait[1].revents == 0) {
      continue;
    }
    const Producer::Event event = producer.receive(bytes);
    if (event == Producer::Event::came) {
      source.restart();
    }
    lines.add(bytes);
    if (event == Producer::Event::left || event == Producer::Event::end) {
      lines.end();
    }
    if (!take_lines() || event == Producer::Event::end) {
      return;
    }
  }
}

/// What there is to say at the end; nothing if all went well.
void report(const TickSource& source,
            const Producer& producer,
            const RowSink& rows,
            StatusLines& status,
            bool has_reader) {
  const auto say = [&](std::size_t count, const char* what) {
    if (count > 0) {
      status.say("tcert live: " + std::to_string(count) + what);
    }
  };
  say(source.bad_lines(), " bad lines were skipped.");
  say(producer.lost(), " datagrams were lost by the system before they were read.");
  say(rows.dropped(),
      rows.disk_error() != 0 ? " rows were lost: the disk had no room for them. No tick was."
                             : " rows were dropped: whoever reads them is too slow. No tick was.");
  if (rows.cut_off()) {
    status.say("tcert live: the last row was cut off: nobody read on.");
  }
  say(status.dropped(), " lines of status were dropped.");
  if (!has_reader) {
    status.say("tcert live: nobody reads the rows any more; ended.");
  }
}

}  // namespace

OptionTable options_of(LiveRequest& request) {
  OptionTable table(request.given);
  table.add("bundle",
            request.bundle,
            "PATH",
            "the bundle, or its bundle.json, that describes robot and course");
  table.add("input-format",
            request.input_format,
            "WORD",
            "of the ticks: csv (a header, then rows as in ticks.csv), jsonl, or auto to see");
  table.add("ray-margins", request.ray_margins, "one more column a ray: its own margin");
  table.add("guards",
            request.guards,
            "more columns: gated speed, robust margin, force limit, which guards trip");
  table.add_output("audit",
                   request.audit,
                   "FILE",
                   "log of the guards: when each began and ceased to trip, and why");
  table.add("listen",
            request.listen,
            "WHERE",
            "take ticks from unix:PATH or udp:PORT (port 0: any that is free) in place of stdin");
  table.add("record",
            request.record,
            "DIR",
            "write the ticks as a bundle; DIR must not be there, or be empty");
  table
      .add("stale-after",
           request.stale_after_s,
           "S",
           "say on stderr when no tick has come for so long; 0: never")
      .within(0.0, 1e6);
  table.add("slow-consumer",
            request.slow_consumer,
            "WORD",
            "when rows are not read: wait, so that the writer of the ticks waits too; drop rows, "
            "never ticks; or auto: wait for stdin, drop with --listen");
  add_tracking_error_option(table, request.tracking_error);
  table.common();
  add_decimal_comma(table, request.logs.decimal_comma);
  table.parameters(request.logs.parameters);
  return table;
}

ExitCode live(const LiveRequest& request, Progress& progress) {
  const LiveRequest& options = request;
  require_known(options);
  const BundleInfo info = describe(options.bundle, progress);
  const study::ParameterSet parameters =
      effective_parameters(info.parameters, options.logs.parameters);
  const Robot robot = effective_robot(info, parameters);
  Certifier certifier =
      certifier_of(robot, info.course, study::parameters_of_ticks(parameters.certificate));
  Guards guards(parameters.speed_law,
                parameters.guards,
                tracking_error_table(options.tracking_error, options.logs.decimal_comma, progress));
  const SeriesFormat format{
      parameters.speed_law, options.ray_margins, synthetic_label(info), options.guards};
  std::optional<LiveAudit> audit;
  if (!options.audit.empty()) {
    require_apart(options.bundle, options.audit);
    audit.emplace(options.audit, parameters.guards);
  }
  std::optional<LiveRecord> record;
  if (!options.record.empty()) {
    record.emplace(options.record, info_of_record(info, robot, parameters));
  }
  StatusLines status;
  const int interrupt = interrupt_descriptor();
  const std::unique_ptr<Producer> producer = open_producer(options.listen);
  const bool listens = !options.listen.empty();
  if (listens) {
    status.say("tcert live: listening on " + producer->name());
  }
  const bool drops =
      options.slow_consumer == "drop" || (options.slow_consumer == "auto" && listens);
  std::optional<LiveWitness> witness;
  if (parameters.certificate.clearance == ClearanceReading::witness) {
    using WhenLate = LiveWitness::WhenLate;
    witness.emplace(robot, info.course, parameters, drops ? WhenLate::skip : WhenLate::wait);
  }
  RowSink rows(drops ? RowSink::WhenSlow::drop : RowSink::WhenSlow::wait, interrupt);
  TickSource source(robot,
                    info,
                    {producer->name(), options.input_format, options.logs.decimal_comma, !listens},
                    status);
  StallWatch stall(options.stale_after_s, status);
  std::string row;
  bool is_full_said = false;
  const auto put = [&](std::string_view text) {
    const bool go_on = rows.put(text);
    if (rows.disk_error() != 0 && !std::exchange(is_full_said, true)) {
      status.say("tcert live: cannot write to stdout: " +
                 std::generic_category().message(rows.disk_error()) +
                 "; the run goes on, rows that find no room are counted");
    }
    return go_on;
  };
  const auto take = [&](const TickLine& line) {
    stall.tick();
    CertifiedTick certified = certifier.update(line.tick);
    const GuardedTick guarded = guards.update(line.tick, certified);
    if (witness) {
      witness->take(line.tick, certified);
    }
    if (record) {
      record->add(line, certified, status);
    }
    row.clear();
    append_series_row(
        row, line.tick, certified, certifier.ray_margins(), format, guarded, line.yaw_rate_cmd_rps);
    const bool go_on = put(row);
    if (audit) {
      audit->add(line.tick, certified, guarded, status);
    }
    return go_on;
  };
  bool has_reader = true;
  try {
    if (put(series_header(format, robot))) {
      follow(*producer, source, rows, stall, interrupt, take);
      if (const auto tick = source.last()) {
        take(*tick);
      }
    }
    rows.finish(kLastRowsMs);
  } catch (const BrokenPipe&) {
    has_reader = false;  // whoever read the rows has had enough: the run ends as by a signal
  }
  const bool audited = !audit || audit->close(status);
  const bool recorded = !record || record->close(status);
  source.report_ranges();
  if (witness) {
    status.say("tcert live: " + witness->conclude());
  }
  report(source, *producer, rows, status, has_reader);
  const bool written = rows.disk_error() == 0 || rows.dropped() == 0;
  if (!recorded || !audited || !written) {
    return exit_cannot_write;
  }
  return source.bad_lines() > 0 ? exit_rejected : exit_done;
}

}  // namespace tcert::cli
