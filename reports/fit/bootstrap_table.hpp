#pragma once
/// \file
/// Bootstrap intervals as a table.

#include <cstddef>
#include <statistics/resampling/bootstrap.hpp>
#include <string>

#include "reports/fit/fit_report.hpp"

namespace tcert {

class BootstrapTable {
 public:
  explicit BootstrapTable(double level);

  /// One row: the value, bias, standard error, acceleration, and all intervals.
  void add(const std::string& name, const statistics::BootstrapResult& result, std::size_t value);

  /// Adds the table and the conditions met to `report`.
  void append_to(FitReport& report) const;

 private:
  double level_;
  Table table_;
  statistics::Conditions conditions_;
};

}  // namespace tcert
