#pragma once
/// \file
/// Whether a column that holds numbers and texts is one of numbers, spoiled, or one of names.

#include <cstddef>
#include <table/factor.hpp>

namespace tcert::table {

/// How many cells of a column are what, by read_cell(); missing ones are not counted.
struct MixedCells {
  /// Distinct cells are counted up to here, by every reader, so that all of them judge alike: more
  /// need not be told apart.
  static constexpr std::size_t kMostDistinct = 1000;

  std::size_t numbers = 0;
  std::size_t distinct_numbers = 0;  ///< As written; up to kMostDistinct.
  std::size_t truths = 0;
  std::size_t missing_words = 0;  ///< null, N/A, -, ...
  std::size_t texts = 0;
  std::size_t distinct_texts = 0;  ///< Likewise.
  std::size_t first_row = 0;  ///< 0-based, of the first cell that is no number and not missing; of
                              ///< the first that is no truth value if there are no numbers.

  /// A column of numbers or truth values that another program wrote its word for a missing cell
  /// into: beside them there are such words and nothing else.
  [[nodiscard]] bool has_missing_words() const noexcept {
    return missing_words > 0 && texts == 0 && numbers + truths > 0;
  }
  /// A column of numbers with stray texts, be they typing errors or words for a missing cell. It is
  /// taken for one if there are four numbers or more for each text; or if there are more distinct
  /// numbers than distinct texts, and the numbers hardly repeat (as the levels of a factor would)
  /// or there are ten and more of them.
  [[nodiscard]] bool is_spoiled() const noexcept;
};

/// Of a column of text. O(rows + levels).
[[nodiscard]] MixedCells count_mixed_cells(const Factor& text, char decimal_point);

}  // namespace tcert::table
