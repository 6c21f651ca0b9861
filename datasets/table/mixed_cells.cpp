#include <table/mixed_cells.hpp>

#include <algorithm>
#include <cstdint>
#include <table/cell_reading.hpp>
#include <vector>

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

MixedCells count_mixed_cells(const Factor& text, char decimal_point) {
  std::vector<std::size_t> cells(text.levels.size(), 0);
  for (const std::uint32_t code : text.codes) {
    if (code != Factor::kMissing) {
      ++cells[code];
    }
  }
  MixedCells mixed;
  std::vector<CellMeaning> meaning;
  for (std::size_t level = 0; level < text.levels.size(); ++level) {
    meaning.push_back(read_cell(text.levels[level], decimal_point).meaning);
    switch (meaning.back()) {
      case CellMeaning::number:
        mixed.numbers += cells[level];
        ++mixed.distinct_numbers;
        break;
      case CellMeaning::truth:
        mixed.truths += cells[level];
        break;
      case CellMeaning::missing_word:
        mixed.missing_words += cells[level];
        break;
      case CellMeaning::missing:
      case CellMeaning::text:
        mixed.texts += cells[level];
        ++mixed.distinct_texts;
        break;
    }
  }
  const auto is_stray = [&](std::uint32_t code) {
    return code != Factor::kMissing && meaning[code] != CellMeaning::number &&
           (mixed.numbers > 0 || meaning[code] != CellMeaning::truth);
  };
  const auto first = std::find_if(text.codes.begin(), text.codes.end(), is_stray);
  mixed.distinct_numbers = std::min(mixed.distinct_numbers, MixedCells::kMostDistinct);
  mixed.distinct_texts = std::min(mixed.distinct_texts, MixedCells::kMostDistinct);
  mixed.first_row = static_cast<std::size_t>(first - text.codes.begin());
  return mixed;
}

}  // namespace tcert::table
