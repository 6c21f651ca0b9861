#pragma once
/// \file
/// Reading cells of a table by the names of their columns.

#include <cstddef>
#include <string>
#include <string_view>
#include <table/data_table.hpp>

#include "reports/table.hpp"

namespace tcert {

/// Text of a cell; empty if it is missing or there is no such column.
[[nodiscard]] std::string text_at(const Table& table, std::size_t row, std::string_view column);
[[nodiscard]] std::string text_at(const table::DataTable& table,
                                  std::size_t row,
                                  std::string_view column);

/// A number of any kind, x_low and x_high of an estimate x; NaN if it is missing or not there.
[[nodiscard]] double number_at(const Table& table, std::size_t row, std::string_view column);
[[nodiscard]] double number_at(const table::DataTable& table,
                               std::size_t row,
                               std::string_view column);

}  // namespace tcert
