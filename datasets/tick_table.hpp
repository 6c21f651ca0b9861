#pragma once
/// \file
/// ticks.csv: writing a table of ticks and reading it back, bit for bit.

#include <optional>
#include <span>
#include <string>
#include <table/bytes.hpp>
#include <table/csv.hpp>
#include <table/diagnostic.hpp>
#include <tcert/robot.hpp>
#include <vector>

#include "datasets/range_rule.hpp"
#include "datasets/ticks.hpp"

namespace tcert {

/// Writes rows of ticks.csv, for a bundle in which `keys` are declared of the rays. A force column
/// is written only for a ray that has any force reading, the command columns only if there is any
/// command.
class TickFormat {
 public:
  /// The columns that `ticks` needs. \pre ticks.rays is the number of rays of `robot`.
  TickFormat(const Robot& robot, const TickTable& ticks, std::span<const RangeKeys> keys = {});

  /// All columns, those of the footing if asked for: for ticks that are not known yet.
  explicit TickFormat(const Robot& robot,
                      std::span<const RangeKeys> keys = {},
                      bool has_footing = false);

  /// With its line end.
  [[nodiscard]] const std::string& header() const noexcept { return header_; }

  /// Appends row `i` with its line end. \pre i < ticks.size(); a table of the same robot.
  void append_row(std::string& out, const TickTable& ticks, std::size_t i) const;

  /// Appends one tick with its line end. \pre as many readings as the robot has rays.
  void append_row(std::string& out,
                  const Tick& tick,
                  double speed_cmd_mps,
                  double yaw_rate_cmd_rps) const;

 private:
  void name_columns(const Robot& robot);

  RangeRules rules_;
  std::vector<std::uint8_t> has_force_;    // per ray
  std::vector<std::uint8_t> has_bearing_;  // likewise
  bool has_command_ = false;
  bool has_footing_ = false;
  std::string header_;
};

/// Header and all rows.
[[nodiscard]] std::string to_ticks_csv(const Robot& robot,
                                       const TickTable& ticks,
                                       std::span<const RangeKeys> keys = {});

/// Rows that were read with tick_columns() as ticks; what their readings were goes to `counts`, one
/// a ray. `breaks_ns`, in order of time, start segments. A flag that is neither 0 nor 1 is an
/// error. \pre times of `rows` increase strictly.
[[nodiscard]] TickTable to_tick_table(const table::NumberTable& rows,
                                      const RangeRules& rules,
                                      std::span<const std::int64_t> breaks_ns,
                                      const std::string& file,
                                      std::vector<RangeCount>& counts,
                                      table::DiagnosticGroups& problems);

/// Reads a ticks.csv of a robot of which no key of a range is declared; empty iff it has an error.
/// A step of more than `max_gap_s` starts a segment.
[[nodiscard]] std::optional<TickTable> read_ticks_csv(const table::Bytes& bytes,
                                                      const Robot& robot,
                                                      const table::CsvOptions& csv,
                                                      double max_gap_s,
                                                      table::DiagnosticGroups& problems);

}  // namespace tcert
