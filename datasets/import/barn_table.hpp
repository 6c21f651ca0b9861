#pragma once
/// \file
/// A table of the BARN challenge, with the places of its problems.

#include <optional>
#include <string>
#include <string_view>
#include <table/csv.hpp>
#include <table/diagnostic.hpp>
#include <vector>

namespace tcert {

/// A table and the name of its file in diagnostics.
struct BarnTable {
  table::TextTable table;
  std::string file;
};

/// The cells of a table by the names of its columns. What it is made from must outlive it.
class BarnSource {
 public:
  BarnSource(const BarnTable& table, table::DiagnosticGroups& problems)
      : table_(table.table), file_(table.file), problems_(problems) {}

  [[nodiscard]] const std::string& file() const noexcept { return file_; }
  [[nodiscard]] std::size_t rows() const noexcept { return table_.rows(); }
  [[nodiscard]] bool has(std::string_view column) const noexcept {
    return table_.find(column).has_value();
  }
  /// \pre has(column).
  [[nodiscard]] const std::string& cell(std::size_t row, std::string_view column) const {
    return table_.at(row, table_.find(column).value());
  }

  /// True if all columns are there; the missing ones are errors.
  [[nodiscard]] bool require(const std::vector<std::string>& columns) const;

  /// Says what is wrong with a cell.
  void add(table::Severity severity,
           std::size_t row,
           std::string_view column,
           std::string expectation) const;

 private:
  const table::TextTable& table_;
  const std::string& file_;
  table::DiagnosticGroups& problems_;
};

/// Empty unless the cell is a finite number.
[[nodiscard]] std::optional<double> finite_number(std::string_view cell);

/// Empty unless the cell is a whole number, 0 or more.
[[nodiscard]] std::optional<long> barn_world(std::string_view cell);

}  // namespace tcert
