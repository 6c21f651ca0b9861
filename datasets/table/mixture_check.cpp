#include <table/mixture_check.hpp>

#include <utility>

namespace tcert::table {

void MixtureCheck::remember(Found& first, const std::string& cell, std::size_t line) {
  if (first.line == 0) {
    first = {line, cell};
  }
}

void MixtureCheck::count_distinct(std::set<std::string>& seen, const std::string& cell) {
  if (seen.size() < MixedCells::kMostDistinct) {
    seen.insert(cell);
  }
}

void MixtureCheck::take(const CellReading& reading, const std::string& cell, std::size_t line) {
  switch (reading.meaning) {
    case CellMeaning::number:
      ++cells_.numbers;
      other_numbers_ = other_numbers_ || (reading.value != 0.0 && reading.value != 1.0);
      count_distinct(numbers_, cell);
      return;
    case CellMeaning::truth:
      ++cells_.truths;
      remember(first_truth_, cell, line);
      return;
    case CellMeaning::missing_word:
      ++cells_.missing_words;
      remember(first_word_, cell, line);
      remember(first_text_, cell, line);
      return;
    case CellMeaning::text:
      ++cells_.texts;
      count_distinct(texts_, cell);
      remember(first_text_, cell, line);
      return;
    case CellMeaning::missing:
      return;
  }
}

const MixtureCheck::Found& MixtureCheck::first_stray() const noexcept {
  const bool truth_is_stray = cells_.numbers > 0 && !holds_truths() && first_truth_.line != 0 &&
                              (first_text_.line == 0 || first_truth_.line < first_text_.line);
  return truth_is_stray ? first_truth_ : first_text_;
}

void MixtureCheck::finish(const std::string& file,
                          ColumnCheck& column,
                          DiagnosticGroups& problems) {
  cells_.distinct_numbers = numbers_.size();
  cells_.distinct_texts = texts_.size();
  column.numbers = cells_.numbers;
  column.texts = cells_.texts + cells_.missing_words;
  (holds_truths() ? column.truths : column.texts) += cells_.truths;
  const auto add =
      [&](Severity severity, const Found& found, std::string expectation, std::size_t count) {
        problems.add({severity,
                      file,
                      found.line,
                      column.name,
                      shortened(found.cell),
                      std::move(expectation),
                      count});
      };
  const bool of_numbers = cells_.numbers > 0;
  const std::string missing = " (" + std::string(kHowMissingIsWritten) + ")";
  if (cells_.is_spoiled()) {
    add(Severity::error,
        first_stray(),
        (of_numbers ? "a number, as in its " + std::to_string(cells_.numbers)
                    : "TRUE or FALSE, as in its " + std::to_string(cells_.truths)) +
            " other cells" + missing,
        column.texts - (of_numbers ? 0 : cells_.truths));
    return;
  }
  if (of_numbers && column.texts > 0) {
    add(Severity::warning,
        first_stray(),
        "numbers throughout or names throughout: its " + std::to_string(cells_.numbers) +
            " numbers are read as names",
        column.texts);
  }
  if (cells_.missing_words > 0) {
    add(Severity::warning,
        first_word_,
        "a name: this word is read as one" + missing,
        cells_.missing_words);
  }
}

}  // namespace tcert::table
