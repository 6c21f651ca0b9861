#pragma once
/// \file
/// The times of a file's clock, one after the other. Internal to check_csv.cpp.

#include <cstddef>
#include <optional>
#include <string>
#include <table/check_csv.hpp>
#include <table/diagnostic.hpp>
#include <vector>

namespace tcert::table {

class ClockWatch {
 public:
  ClockWatch(std::string file, std::string column, double max_gap_s);

  void take(double time_s, std::size_t line);

  /// Whether so few steps go back that these may be the times of a stream.
  [[nodiscard]] bool goes_forward() const noexcept;

  /// Empty if no step increases. Its problems count if the file turned out to be a stream.
  [[nodiscard]] std::optional<ClockCheck> finish(DiagnosticGroups& problems);

 private:
  void add_problem(Severity severity, std::size_t line, std::string found, std::string expectation);

  std::string file_;
  std::string column_;
  double max_gap_s_;
  double first_time_s_ = 0.0;
  std::optional<double> last_time_s_;
  std::vector<double> steps_s_;  // those that increase
  std::size_t steps_ = 0;
  std::size_t steps_back_ = 0;
  DiagnosticGroups problems_;
};

}  // namespace tcert::table
