#pragma once
/// \file
/// One row of numbers: the hot path of every log that is read.

#include <cstddef>
#include <cstdint>
#include <string>
#include <table/csv_dialect.hpp>
#include <vector>

namespace tcert::table {

enum class CellKind : std::uint8_t {
  ignored,
  seconds,           ///< Exact decimal -> integer nanoseconds.
  optional_seconds,  ///< The same, or missing, which is kNoTime.
  number,            ///< Finite; a missing cell is an error.
  optional_number,   ///< Finite or missing.
  optional_range,    ///< The same, or infinite.
  optional_flag,     ///< The same, or a truth value, which is 1 or 0.
};

/// What to do with the field at one position of a row.
struct CellPlan {
  CellKind kind = CellKind::ignored;
  std::size_t slot = 0;  ///< Index into the row's values, of a time into its times.
};

struct RowPlan {
  CsvDialect dialect;
  std::vector<CellPlan> cells;  ///< By position in the file.
};

/// A time that is missing.
inline constexpr std::int64_t kNoTime = INT64_MIN;

struct CellProblem {
  std::size_t cell = 0;  ///< Position in the file.
  std::string value;     ///< As found.
};

/// What is wrong with one row.
struct RowProblems {
  std::vector<CellProblem> cells;
  std::size_t fields = 0;  ///< Found; 0 if their number is right.
  bool open_quote = false;

  [[nodiscard]] bool empty() const noexcept { return cells.empty() && fields == 0 && !open_quote; }
};

/// Reads the record at the cursor: the slots of `times_ns` and `values` whose columns the file has.
/// True if it was good; otherwise `problems` says what was wrong, all of it, and the values are to
/// be forgotten. Fields beyond the header are allowed if they are empty. \pre the cursor is at a
/// record of a Bytes.
[[nodiscard]] bool scan_row(const RowPlan& plan,
                            CsvCursor& cursor,
                            std::int64_t* times_ns,
                            double* values,
                            RowProblems& problems);

}  // namespace tcert::table
