#include "cli/runs/drive_by_lines.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string_view>
#include <system_error>
#include <table/atomic_file.hpp>
#include <table/csv_write.hpp>
#include <utility>

#include "cli/runs/result_folder.hpp"
#include "cli/runs/unix_listener.hpp"
#include "datasets/bundle_json.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "datasets/corpus/write_bundle.hpp"
#include "datasets/driven/driven_trial.hpp"
#include "datasets/tick_table.hpp"
#include "datasets/trial_table.hpp"

namespace tcert::cli {
namespace {

constexpr std::size_t kLongestLine = 256;
constexpr const char* kCommand = "drive by lines";

std::string preface(const DrivenWorld& driven, const BundleInfo& info, const TickFormat& format) {
  const Bounds& bounds = driven.world.bounds;
  std::string robot = to_bundle_json(info);
  std::erase(robot, '\n');
  std::string text =
      "# robot " + robot + '\n' +
      fmt::format(
          "# box {} {} {} {}\n", bounds.low.x_m, bounds.low.y_m, bounds.high.x_m, bounds.high.y_m);
  for (std::size_t lobe = 0; lobe < driven.lobes.size(); ++lobe) {
    for (std::size_t lane = 0; lane < driven.lobes[lobe].size(); ++lane) {
      text += fmt::format("# lane {} {}", lobe, lane);
      for (const Point& point : driven.lobes[lobe][lane]) {
        text += fmt::format(" {} {}", point.x_m, point.y_m);
      }
      text += '\n';
    }
  }
  std::string header = format.header();
  header.pop_back();
  return text + header + ",goal_x_m,goal_y_m,travel_m,measured_mps,bump_bearing_rad,bump_force_n\n";
}

std::string row_of(const policies::Senses& senses, const TickFormat& format) {
  std::string row;
  format.append_row(row, senses.tick, kMissing, kMissing);
  row.pop_back();
  for (const double value : {senses.goal.x_m,
                             senses.goal.y_m,
                             senses.travel_m,
                             senses.speed_mps,
                             senses.bump ? senses.bump->bearing_rad : kMissing,
                             senses.bump ? senses.bump->force_n : kMissing}) {
    table::append_cell(row, value);
  }
  return row + '\n';
}

/// "0.15,-0.2", also with a blank behind the comma.
policies::Command command_of(std::string_view line, const std::string& from, double now_s) {
  if (line.ends_with('\r')) {
    line.remove_suffix(1);
  }
  policies::Command command;
  const char* const end = line.data() + line.size();
  const auto [comma, bad_speed] = std::from_chars(line.data(), end, command.speed_mps);
  if (bad_speed == std::errc{} && comma != end && *comma == ',') {
    const char* const second = comma + 1 != end && comma[1] == ' ' ? comma + 2 : comma + 1;
    const auto [rest, bad_rate] = std::from_chars(second, end, command.yaw_rate_rps);
    if (bad_rate == std::errc{} && rest == end && std::isfinite(command.speed_mps) &&
        std::isfinite(command.yaw_rate_rps)) {
      return command;
    }
  }
  std::string found(line);
  std::replace(found.begin(), found.end(), '\0', '?');  // which would end the message
  throw BadData(
      fmt::format("{}, at {:.2f} s: found '{}', expected two numbers with a comma "
                  "between, the speed in m/s and the yaw rate in rad/s: 0.15,-0.2",
                  from,
                  now_s,
                  found));
}

/// The two ends of the other process: stdout and stdin, or a connection.
class Lines {
 public:
  /// Waits for who connects, if there is something to listen on, and says on what.
  Lines(const std::string& listen, Progress& progress) {
    if (listen.empty()) {
      return;
    }
    if (!listen.starts_with("unix:")) {
      throw UsageError("--listen: found '" + listen + "', expected unix:PATH");
    }
    const UnixListener listener(listen.substr(5));
    progress.say("tcert drive: listening on " + listener.name());
    const int connection = listener.accept();
    own_out_.reset(connection < 0 ? nullptr : ::fdopen(connection, "w"));
    own_in_.reset(own_out_ ? ::fdopen(::dup(connection), "r") : nullptr);
    if (!own_in_) {
      throw NoInput("cannot listen on '" + listener.name() +
                    "': " + std::generic_category().message(errno));
    }
    out_ = own_out_.get();
    in_ = own_in_.get();
    name_ = listener.name();
  }

  void say(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), out_) != text.size() || std::fflush(out_) != 0) {
      throw table::WriteError("cannot write what is sensed: nobody reads " +
                              (name_ == "stdin" ? "stdout" : name_));
    }
  }

  /// \throws BadData if there is none.
  [[nodiscard]] policies::Command next_command(double now_s) {
    std::string line;
    int byte = std::fgetc(in_);
    for (; byte != EOF && byte != '\n' && line.size() < kLongestLine; byte = std::fgetc(in_)) {
      line += static_cast<char>(byte);
    }
    if (byte == EOF && line.empty()) {
      throw BadData(fmt::format(
          "{} ended at {:.2f} s, before the trial did: nothing is written", name_, now_s));
    }
    if (line.size() == kLongestLine) {
      line += "...";  // is no command
    }
    return command_of(line, name_, now_s);
  }

 private:
  struct Closing {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };

  std::unique_ptr<std::FILE, Closing> own_out_;
  std::unique_ptr<std::FILE, Closing> own_in_;
  std::FILE* out_ = stdout;
  std::FILE* in_ = stdin;
  std::string name_ = "stdin";
};

}  // namespace

ExitCode drive_by_lines(const DrivenDesign& design,
                        const std::string& listen,
                        const std::string& output,
                        Manifest manifest,
                        Progress& progress) {
  ResultFolder result(output, kCommand);  // before anything is driven
  SimulatedBundle bundle;
  bundle.info = driven_info(design.seed, design.parameters, design.native_rates);
  const TickFormat format(bundle.info.robot);
  DrivenRun run(design);
  Lines lines(listen, progress);
  lines.say(preface(design.world, bundle.info, format));
  while (const policies::Senses* const senses = run.next()) {
    lines.say(row_of(*senses, format));
    run.take(lines.next_command(run.now_s()));
  }
  const DrivenTrial driven = trial_of(run);
  bundle.extra_columns = driven_extra_columns();
  bundle.trials = 1;
  bundle.simulate = [&driven](std::uint64_t /*index*/) { return driven.trial; };
  write_simulated_bundle(result.staging(), bundle, {}, true);
  manifest.command = kCommand;
  result.commit(std::move(manifest));
  progress.sum_up(fmt::format("Driven by lines: {} after {:.1f} s. Bundle: {}",
                              to_string(driven.trial.row.end_reason),
                              driven.trial.row.time_s.value_or(0.0),
                              output));
  return exit_done;
}

}  // namespace tcert::cli
