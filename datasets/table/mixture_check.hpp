#pragma once
/// \file
/// What is wrong with the cells of one column of a file of which nothing is known: texts among its
/// numbers, words for missing cells. Internal to check_csv.cpp.

#include <cstddef>
#include <set>
#include <string>
#include <table/cell_reading.hpp>
#include <table/check_csv.hpp>
#include <table/diagnostic.hpp>
#include <table/mixed_cells.hpp>

namespace tcert::table {

class MixtureCheck {
 public:
  void take(const CellReading& reading, const std::string& cell, std::size_t line);

  /// Fills the counts of `column` and says what is wrong with them.
  void finish(const std::string& file, ColumnCheck& column, DiagnosticGroups& problems);

 private:
  struct Found {
    std::size_t line = 0;  ///< 0: nothing.
    std::string cell;
  };

  static void remember(Found& first, const std::string& cell, std::size_t line);
  static void count_distinct(std::set<std::string>& seen, const std::string& cell);

  /// True if its truth values are no texts.
  [[nodiscard]] bool holds_truths() const noexcept {
    return cells_.texts + cells_.missing_words == 0 && !other_numbers_;
  }
  /// The first cell that a column of numbers, or of truth values alone, would not hold.
  [[nodiscard]] const Found& first_stray() const noexcept;

  MixedCells cells_;
  bool other_numbers_ = false;  ///< Neither 0 nor 1.
  std::set<std::string> numbers_;
  std::set<std::string> texts_;
  Found first_truth_;
  Found first_word_;
  Found first_text_;  ///< Of the words too.
};

}  // namespace tcert::table
