#pragma once
/// \file
/// Ticks one line at a time, as they arrive on a pipe: rows of CSV or JSON Lines.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <table/csv.hpp>
#include <table/diagnostic.hpp>
#include <table/flat_json.hpp>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>
#include <vector>

#include "datasets/tick_columns.hpp"

namespace tcert {

/// A tick that was read, with what was commanded. The readings belong to the parser and stay valid
/// until its next line.
struct TickLine {
  Tick tick;
  double speed_cmd_mps = kMissing;
  double yaw_rate_cmd_rps = kMissing;
  bool is_after_gap = false;   ///< More than max_gap_s since the row before: it starts a segment.
  bool starts_anyway = false;  ///< By its own word, or because its producer came back.
  bool has_footing = false;    ///< The stream has a column of it; any object may.
  bool is_too_late = false;    ///< The first beyond ten times the trial limit: it starts one, too.
};

enum class TickLineFormat { csv, json_lines };

struct TickLineOptions {
  std::string file = "stdin";             ///< Its name in diagnostics.
  double max_gap_s = 1.0;                 ///< A longer step starts a segment, as it does in a file.
  std::optional<double> trial_limit_s{};  ///< Ten times later a segment starts, as in a file.
  std::map<std::string, std::string> rename{};  ///< Foreign column name -> ours, of CSV.
  bool decimal_comma = false;                   ///< Of CSV whose separator is the semicolon.
  std::vector<RangeKeys> range_keys{};          ///< Of the rays, as in bundle.json.
};

/// Reads lines of ticks.csv, or objects with the same keys of which null or none is missing; of a
/// range "inf" and Infinity, as Python writes it, are the same. The same line gives the same tick
/// as reading the whole file does. Allocates nothing for a good CSV line of plain numbers once it
/// has seen one of that length.
class TickLineParser {
 public:
  /// For a stream whose first line is `first_line`: a line that begins with '{' is the first tick
  /// of JSON Lines, any other the header of CSV, whose problems are added to `problems`.
  TickLineParser(const Robot& robot,
                 std::string_view first_line,
                 TickLineOptions options,
                 table::DiagnosticGroups& problems);

  /// Begins another stream of the same run, whose first line is `first_line`: a producer that came
  /// back. Times must go on rising, and its first tick starts a segment.
  void restart(std::string_view first_line, table::DiagnosticGroups& problems);

  /// Forgets rows: the next time is compared with `time_ns`, as if that were the last one.
  void go_back_to(std::int64_t time_ns) noexcept;

  [[nodiscard]] TickLineFormat format() const noexcept { return format_; }

  /// True if the header had no error; always true for JSON Lines.
  [[nodiscard]] bool ready() const noexcept { return ready_; }

  /// Reads one line, with or without its line end. Nothing for a blank or comment line and for a
  /// bad one; what is wrong with that is in problems(). `line` is its 1-based number. \pre ready().
  [[nodiscard]] std::optional<TickLine> parse(std::string_view text, std::size_t line);

  /// What the readings of each ray were, over all lines.
  [[nodiscard]] const std::vector<RangeCount>& range_counts() const noexcept { return counts_; }

  /// Of the last line; empty if it was good, blank or a comment.
  [[nodiscard]] const std::vector<table::Diagnostic>& problems() const noexcept {
    return problems_;
  }

 private:
  [[nodiscard]] bool parse_csv(std::string_view text);
  [[nodiscard]] bool parse_json(std::string_view text);
  void take_json_value(std::size_t position, const table::FlatMember& member);
  [[nodiscard]] std::optional<TickLine> to_tick();
  [[nodiscard]] bool is_too_late(std::int64_t time_ns) const noexcept;
  void reject(std::string column, std::string_view value, std::string expectation);

  TickLineOptions options_;
  TickLineFormat format_ = TickLineFormat::csv;
  table::NumberOptions columns_;
  std::vector<std::string> names_;  // of the columns by position: of the header, or of the keys
  table::RowPlan plan_;
  bool ready_ = true;
  table::Bytes padded_;
  table::RowProblems row_problems_;
  std::vector<double> row_;
  RangeRules rules_;
  std::vector<RayReading> readings_;
  std::vector<RangeCount> counts_;
  std::int64_t time_ns_ = 0;
  std::optional<std::int64_t> first_ns_;
  std::optional<std::int64_t> last_ns_;
  bool ran_too_long_ = false;
  bool has_footing_ = false;
  bool restarted_ = false;
  std::size_t line_ = 0;
  std::vector<table::Diagnostic> problems_;
};

}  // namespace tcert
