#pragma once
/// \file
/// What one cell of any table says: the one rule of every reader of this program.
///
/// Numbers and infinities are those that R's read.csv() takes: signs, exponents, hexadecimal,
/// Inf and Infinity in any case, a number beyond the largest double as Inf. Missing is an empty
/// cell, NA, and what C's printf() writes for a value that is not a number, in any case and with
/// any sign: nan, -nan, NaN, nan(ind). Truth values are TRUE, True, true, T and FALSE, False,
/// false, F. Every other cell is a text. Unlike R, digits without their exponent (1e) are a text:
/// a number that was cut short.

#include <string_view>

namespace tcert::table {

enum class CellMeaning {
  number,  ///< Finite or infinite.
  missing,
  truth,
  missing_word,  ///< A text that other programs write for a missing cell: null, None, N/A, -.
  text,
};

struct CellReading {
  CellMeaning meaning = CellMeaning::text;
  double value = 0.0;  ///< Of a number; 0 or 1 of a truth value; NaN of all others.
};

/// Outer blanks do not count. O(length).
[[nodiscard]] CellReading read_cell(std::string_view cell, char decimal_point = '.');

/// An empty cell, NA, nan: the value is not there.
[[nodiscard]] bool is_missing_cell(std::string_view cell) noexcept;

/// The sentence that ends a refusal: how a missing cell is written.
inline constexpr std::string_view kHowMissingIsWritten = "a missing cell is empty, NA or nan";

}  // namespace tcert::table
