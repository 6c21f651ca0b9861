#pragma once
/// \file
/// What the names of a file's columns say of it. Internal to check_csv.cpp.

#include <cstddef>
#include <string>
#include <vector>

namespace tcert::table {

struct ColumnRoles {
  std::size_t clock = 0;           ///< The first that is called as one; none: their number.
  std::vector<std::size_t> times;  ///< Columns of times, the clock among them.
  bool of_trials = false;          ///< Some column is one that only a table of trials has.
  bool of_stream = false;          ///< Some column is a sensor's.
};

[[nodiscard]] ColumnRoles column_roles(const std::vector<std::string>& names);

}  // namespace tcert::table
