#pragma once
/// \file
/// The cells of one row of a log, some of which are changed.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <table/bytes.hpp>
#include <table/csv_dialect.hpp>
#include <vector>

namespace tcert::perturb {

class PerturbedRow {
 public:
  explicit PerturbedRow(table::CsvDialect dialect) : dialect_(dialect) {}

  /// Reads the record at the cursor; false if it has fewer cells than `columns`, which are empty
  /// then.
  bool read(table::CsvCursor& cursor, std::size_t columns);

  [[nodiscard]] const std::string& text(std::size_t column) const { return cells_[column]; }
  [[nodiscard]] bool is_missing(std::size_t column) const;
  /// Of the cell; empty of none, and of what is no number.
  [[nodiscard]] std::optional<double> number(std::optional<std::size_t> column) const;
  /// The time in the cell; empty if there is none.
  [[nodiscard]] std::optional<std::int64_t> seconds(std::size_t column);

  void set(std::size_t column, double value);
  void set_seconds(std::size_t column, std::int64_t time_ns);
  void set_text(std::size_t column, std::string text);
  void blank(std::size_t column) { set_text(column, missing()); }
  void append_seconds(std::int64_t time_ns);
  /// The row is written anew though no cell of it was set.
  void touch() noexcept { changed_ = true; }

  /// Adds the row to `out`: `raw`, as it was, if nothing was changed.
  void write(std::string_view raw, std::string& out) const;

 private:
  [[nodiscard]] std::string in_dialect(std::string text) const;
  /// A missing cell; between spaces an empty one would be none.
  [[nodiscard]] std::string missing() const { return dialect_.separator == ' ' ? "NA" : ""; }

  table::CsvDialect dialect_;
  std::vector<std::string> cells_;
  table::Bytes padded_;
  bool changed_ = false;
};

}  // namespace tcert::perturb
