#pragma once
/// \file
/// Lines of one or more streams as ticks of one run.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tcert/robot.hpp>
#include <vector>

#include "cli/runs/live/patient_output.hpp"
#include "datasets/bundle.hpp"
#include "datasets/jump_watch.hpp"
#include "datasets/tick_line.hpp"

namespace tcert::cli {

/// What is not a tick is said, counted and skipped.
class TickSource {
 public:
  struct Options {
    std::string name;              ///< Of the producer, in messages.
    std::string format;            ///< auto, csv or jsonl.
    bool decimal_comma = false;    ///< Of CSV whose separator is the semicolon.
    bool must_begin_well = false;  ///< A first line that is neither header nor tick is the end.
  };

  TickSource(const Robot& robot, const BundleInfo& info, Options options, StatusLines& status);

  /// The next line begins a stream.
  void restart() noexcept { began_ = false; }

  /// The ticks that may be used now, in order: mostly that of the line; none after a gap, until the
  /// next tick says that the clock did go on. Valid until the next call.
  /// \throws BadData for a first line that is not what it must be, if it must begin well.
  [[nodiscard]] std::span<const TickLine> take(std::string_view line);

  /// At the end of the run: the tick that waited for the next one.
  [[nodiscard]] std::optional<TickLine> last() { return jumps_.last(); }

  /// A line that is none of a tick, said and counted.
  void reject(const std::string& problem);

  /// At the end: what readings of ranges may mean something else than a distance.
  void report_ranges();

  [[nodiscard]] std::size_t bad_lines() const noexcept { return bad_; }

 private:
  [[nodiscard]] bool begin(std::string_view line);
  void say(const std::vector<table::Diagnostic>& problems);

  const Robot& robot_;
  Options options_;
  TickLineOptions lines_;
  StatusLines& status_;
  std::optional<TickLineParser> parser_;
  JumpWatch jumps_;
  bool began_ = false;
  std::size_t number_ = 0;
  std::size_t bad_ = 0;
};

}  // namespace tcert::cli
