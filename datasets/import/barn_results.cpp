#include "datasets/import/barn_results.hpp"

#include <algorithm>
#include <table/cell_reading.hpp>
#include <vector>

namespace tcert {
namespace {

constexpr std::size_t kLeastWords = 5;
constexpr std::size_t kMostWords = 6;

bool is_result_word(std::string_view word) {
  const table::CellMeaning meaning = table::read_cell(word).meaning;
  return meaning == table::CellMeaning::number || meaning == table::CellMeaning::truth;
}

bool has_result_words(const std::vector<std::string>& words) {
  return words.size() >= kLeastWords && words.size() <= kMostWords;
}

}  // namespace

bool is_barn_results(std::string_view text) {
  table::CsvCursor cursor = table::csv_begin(text);
  std::vector<std::string> words;
  return table::skip_to_record(cursor) && table::scan_record(cursor, ' ', words) &&
         has_result_words(words) && std::ranges::all_of(words, is_result_word);
}

std::string planner_of_file(std::string_view path) {
  std::string_view name = path.substr(path.find_last_of('/') + 1);
  name = name.substr(0, name.find('.'));
  if (name == "out") {
    return "";
  }
  if (name.ends_with("_out") || name.ends_with("-out")) {
    name.remove_suffix(4);
  }
  return std::string(name);
}

table::TextTable read_barn_results(const table::Bytes& bytes,
                                   const std::string& file,
                                   const std::string& planner,
                                   table::DiagnosticGroups& problems) {
  table::TextTable result;
  result.columns = {"planner", "world", "success", "collided", "timeout", "time_s"};
  const std::string_view text = bytes.view();
  table::CsvCursor cursor = table::csv_begin(text);
  std::vector<std::string> words;
  while (table::skip_to_record(cursor)) {
    const std::size_t line = cursor.line;
    static_cast<void>(table::scan_record(cursor, ' ', words));
    if (has_result_words(words)) {
      result.cells.push_back(planner);
      result.cells.insert(result.cells.end(), words.begin(), words.begin() + kLeastWords);
      result.lines.push_back(line);
      continue;
    }
    const bool cut_short =
        cursor.at == cursor.end && !text.ends_with('\n') && words.size() < kLeastWords;
    problems.add({cut_short ? table::Severity::warning : table::Severity::error,
                  file,
                  line,
                  "",
                  std::to_string(words.size()) + (words.size() == 1 ? " word" : " words"),
                  "world success collided timeout time nav_metric, the last one or not; the line "
                  "is left out",
                  1});
  }
  return result;
}

}  // namespace tcert
