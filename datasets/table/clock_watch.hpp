#pragma once
/// \file
/// The times of a file's clock, one after the other. Internal to check_csv.cpp.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <table/check_csv.hpp>
#include <table/clock_column.hpp>
#include <table/diagnostic.hpp>
#include <vector>

namespace tcert::table {

class ClockWatch {
 public:
  /// `column` is the name of `clock`.
  ClockWatch(std::string file, std::string column, const ClockColumn& clock, double max_gap_s);

  /// The cells of one row. A date counts as its time; a cell that is neither it nor a number not at
  /// all.
  void take(const std::vector<std::string>& fields, char decimal_point, std::size_t line);

  /// Whether so few steps go back that these may be the times of a stream. The clock is of a stream
  /// in any case if its times are dates.
  [[nodiscard]] bool goes_forward() const noexcept;

  /// Empty if no step increases. What it says counts if the file turned out to be a stream.
  [[nodiscard]] std::optional<ClockCheck> finish(DiagnosticGroups& problems) const;

 private:
  void report_steps(double scale, DiagnosticGroups& problems) const;
  [[nodiscard]] std::string unit_in_words(const TimeUnitGuess& guess) const;

  std::string file_;
  std::string column_;
  ClockColumn clock_;
  double max_gap_s_;
  std::size_t dates_ = 0;
  std::vector<double> times_;  // in the file's unit; of dates in seconds
  std::vector<std::size_t> lines_;
};

}  // namespace tcert::table
