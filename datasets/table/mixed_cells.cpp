#include <table/mixed_cells.hpp>

namespace tcert::table {

bool MixedCells::is_spoiled() const noexcept {
  if (has_missing_words()) {
    return true;
  }
  const std::size_t strays = texts + truths;
  if (numbers == 0 || strays + missing_words == 0) {
    return false;
  }
  constexpr std::size_t kNumbersPerText = 4;
  constexpr std::size_t kFewNumbers = 3;
  constexpr std::size_t kManyNumbers = 10;
  const bool hardly_repeat = distinct_numbers >= kFewNumbers && 2 * distinct_numbers > numbers;
  const bool look_measured =
      distinct_numbers > distinct_texts && (hardly_repeat || distinct_numbers >= kManyNumbers);
  return numbers >= kNumbersPerText * strays || look_measured;
}

}  // namespace tcert::table
