#include "cli/runs/live/live.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "cli/runs/guard_options.hpp"
#include "cli/runs/interrupt.hpp"
#include "cli/runs/live/line_buffer.hpp"
#include "cli/runs/live/live_bundle.hpp"
#include "cli/runs/live/live_ticks.hpp"
#include "cli/runs/live/patient_output.hpp"
#include "cli/runs/live/producer.hpp"
#include "cli/runs/live/stall_watch.hpp"
#include "cli/runs/live/tick_source.hpp"

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

/// Lines of a producer as ticks for `take`, which returns false to end the run.
template <typename Take>
class LineFeed {
 public:
  LineFeed(TickSource& source, Take take) : source_(source), take_(take) {}

  void add(std::string_view bytes) { lines_.add(bytes); }
  void end() { lines_.end(); }

  /// Takes the lines that are whole. False if `take` does.
  [[nodiscard]] bool take_lines() {
    std::string line;
    while (lines_.next(line)) {
      for (const TickLine& tick : source_.take(line)) {
        if (!take_(tick)) {
          return false;
        }
      }
    }
    for (; too_long_ < lines_.too_long(); ++too_long_) {
      source_.reject("a line of more than 1 MiB");
    }
    return true;
  }

 private:
  TickSource& source_;
  Take take_;
  LineBuffer lines_;
  std::size_t too_long_ = 0;
};

/// Takes lines until the producer ends or an interrupt comes. `take` is given every tick; false
/// ends it too.
template <typename Take>
void follow(Producer& producer,
            TickSource& source,
            RowSink& rows,
            StallWatch& stall,
            int interrupt,
            Take take) {
  LineFeed feed(source, take);
  std::string bytes;
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
    feed.add(bytes);
    if (event == Producer::Event::left || event == Producer::Event::end) {
      feed.end();
    }
    if (!feed.take_lines() || event == Producer::Event::end) {
      return;
    }
  }
}

/// Rows for whoever reads stdout; a full disk behind it is said once, and the run goes on.
class SaidRows {
 public:
  SaidRows(RowSink& rows, StatusLines& status) : rows_(rows), status_(status) {}

  /// False if the run is to end.
  [[nodiscard]] bool put(std::string_view text) {
    const bool go_on = rows_.put(text);
    if (rows_.disk_error() != 0 && !std::exchange(is_full_said_, true)) {
      status_.say("tcert live: cannot write to stdout: " +
                  std::generic_category().message(rows_.disk_error()) +
                  "; the run goes on, rows that find no room are counted");
    }
    return go_on;
  }

 private:
  RowSink& rows_;
  StatusLines& status_;
  bool is_full_said_ = false;
};

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
  add_monitor_options(table, request.monitor);
  table.common();
  add_decimal_comma(table, request.logs.decimal_comma);
  table.parameters(request.logs.parameters);
  return table;
}

ExitCode live(const LiveRequest& request, Progress& progress) {
  require_known(request);
  const BundleInfo info = describe(request.bundle, progress);
  const bool listens = !request.listen.empty();
  const bool drops =
      request.slow_consumer == "drop" || (request.slow_consumer == "auto" && listens);
  LiveTicks ticks(
      request, info, drops ? LiveWitness::WhenLate::skip : LiveWitness::WhenLate::wait, progress);
  StatusLines status;
  const int interrupt = interrupt_descriptor();
  const std::unique_ptr<Producer> producer = open_producer(request.listen);
  if (listens) {
    status.say("tcert live: listening on " + producer->name());
  }
  RowSink rows(drops ? RowSink::WhenSlow::drop : RowSink::WhenSlow::wait, interrupt);
  SaidRows said(rows, status);
  TickSource source(ticks.robot(),
                    info,
                    {producer->name(), request.input_format, request.logs.decimal_comma, !listens},
                    status);
  StallWatch stall(request.stale_after_s, status);
  const auto take = [&](const TickLine& line) {
    stall.tick();
    return said.put(ticks.row_of(line, status));
  };
  bool has_reader = true;
  try {
    if (said.put(ticks.header())) {
      follow(*producer, source, rows, stall, interrupt, take);
      if (const auto tick = source.last()) {
        take(*tick);
      }
    }
    rows.finish(kLastRowsMs);
  } catch (const BrokenPipe&) {
    has_reader = false;  // whoever read the rows has had enough: the run ends as by a signal
  }
  const bool kept = ticks.close(status);
  source.report_ranges();
  report(source, *producer, rows, status, has_reader);
  const bool written = rows.disk_error() == 0 || rows.dropped() == 0;
  if (!kept || !written) {
    return exit_cannot_write;
  }
  return source.bad_lines() > 0 ? exit_rejected : exit_done;
}

}  // namespace tcert::cli
