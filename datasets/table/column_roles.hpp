#pragma once
/// \file
/// What the names of a file's columns say of it. Internal to check_csv.cpp.

#include <cstddef>
#include <optional>
#include <string>
#include <table/clock_column.hpp>
#include <vector>

namespace tcert::table {

struct ColumnRoles {
  std::optional<ClockColumn> clock;  ///< The first that is called as one.
  std::vector<std::size_t> times;    ///< Columns of times, the clock among them.
  bool of_trials = false;            ///< Some column is one that only a table of trials has.
  bool of_stream = false;            ///< Some column is a sensor's.
  bool may_be_stream = false;        ///< Some column is called as other programs call a sensor's.
};

/// `clock` is the column that is the clock whatever it is called; empty: by its name.
[[nodiscard]] ColumnRoles column_roles(const std::vector<std::string>& names,
                                       const std::string& clock = {});

}  // namespace tcert::table
