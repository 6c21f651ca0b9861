#include <table/csv_dialect.hpp>

#include <algorithm>
#include <cstring>
#include <map>

namespace tcert::table {

namespace {

constexpr std::size_t kSampledRecords = 50;

const char* line_end(const CsvCursor& cursor) noexcept {
  const auto length = static_cast<std::size_t>(cursor.end - cursor.at);
  const void* found = std::memchr(cursor.at, '\n', length);
  return found == nullptr ? cursor.end : static_cast<const char*>(found);
}

void step_over_line_end(CsvCursor& cursor) noexcept {
  if (cursor.at < cursor.end) {
    ++cursor.at;
    ++cursor.line;
  }
}

bool is_space(char c) noexcept { return c == ' ' || c == '\t'; }

std::string_view without_padding(std::string_view text) noexcept {
  while (!text.empty() && (is_space(text.back()) || text.back() == '\r')) {
    text.remove_suffix(1);
  }
  while (!text.empty() && is_space(text.front())) {
    text.remove_prefix(1);
  }
  return text;
}

void skip_spaces(CsvCursor& cursor, char separator) noexcept {
  while (cursor.at < cursor.end && is_space(*cursor.at) &&
         (*cursor.at != separator || separator == ' ')) {
    ++cursor.at;
  }
}

/// Moves past what ends the field at the cursor; true if it was the line's end.
bool step_over_separator(CsvCursor& cursor, char separator) noexcept {
  if (separator == ' ') {
    skip_spaces(cursor, separator);
  }
  if (cursor.at < cursor.end && *cursor.at == '\r' &&
      (cursor.at + 1 == cursor.end || cursor.at[1] == '\n')) {
    ++cursor.at;
  }
  if (cursor.at == cursor.end || *cursor.at == '\n') {
    step_over_line_end(cursor);
    return true;
  }
  cursor.at += separator == ' ' ? 0 : 1;
  return false;
}

/// The text between the quotes; the cursor is left after the closing one.
bool scan_quoted(CsvCursor& cursor, std::string& text) {
  text.clear();
  for (++cursor.at; cursor.at < cursor.end; ++cursor.at) {
    if (*cursor.at == '"') {
      ++cursor.at;
      if (cursor.at == cursor.end || *cursor.at != '"') {
        return true;
      }
    }
    cursor.line += *cursor.at == '\n' ? 1 : 0;
    text += *cursor.at;
  }
  return false;
}

const char* plain_field_end(const CsvCursor& cursor, char separator) noexcept {
  const char* p = cursor.at;
  if (separator == ' ') {
    while (p < cursor.end && !is_space(*p) && *p != '\n') {
      ++p;
    }
  } else {
    while (p < cursor.end && *p != separator && *p != '\n') {
      ++p;
    }
  }
  return p;
}

}  // namespace

CsvCursor csv_begin(std::string_view text) noexcept {
  CsvCursor cursor{text.data(), text.data() + text.size(), 1};
  if (text.starts_with("\xEF\xBB\xBF")) {
    cursor.at += 3;
  }
  return cursor;
}

bool skip_to_record(CsvCursor& cursor) noexcept {
  while (cursor.at < cursor.end) {
    if (static_cast<unsigned char>(*cursor.at) > '#') {
      return true;  // as nearly all lines: they begin with a digit or a sign
    }
    const char* const end = line_end(cursor);
    const std::string_view line(cursor.at, static_cast<std::size_t>(end - cursor.at));
    if (!without_padding(line).empty() && line.front() != '#') {
      return true;
    }
    cursor.at = end;
    step_over_line_end(cursor);
  }
  return false;
}

CsvField scan_field(CsvCursor& cursor, char separator, std::string& unquoted) {
  skip_spaces(cursor, separator);
  CsvField field;
  if (cursor.at < cursor.end && *cursor.at == '"') {
    field.open_quote = !scan_quoted(cursor, unquoted);
    // Text after the closing quote belongs to the field, as most readers take it.
    const char* const tail_end = plain_field_end(cursor, separator);
    const std::string_view tail(cursor.at, static_cast<std::size_t>(tail_end - cursor.at));
    unquoted += without_padding(tail);
    cursor.at = tail_end;
    field.text = unquoted;
  } else {
    const char* const end = plain_field_end(cursor, separator);
    field.text = without_padding({cursor.at, static_cast<std::size_t>(end - cursor.at)});
    cursor.at = end;
  }
  field.ends_record = step_over_separator(cursor, separator);
  return field;
}

bool scan_record(CsvCursor& cursor, char separator, std::vector<std::string>& fields) {
  std::string unquoted;
  std::size_t count = 0;
  CsvField field;
  do {
    field = scan_field(cursor, separator, unquoted);
    if (count == fields.size()) {
      fields.emplace_back();
    }
    fields[count++] = field.text;
  } while (!field.ends_record);
  fields.resize(count);
  return !field.open_quote;
}

std::string_view separator_name(char separator) noexcept {
  switch (separator) {
    case ',':
      return "comma";
    case ';':
      return "semicolon";
    case '\t':
      return "tab";
    case '|':
      return "vertical bar";
    case ' ':
      return "spaces";
    default:
      return "other";
  }
}

char detect_separator(std::string_view text, char decimal_point) {
  char best = ',';
  std::size_t most_records = 0;
  std::vector<std::string> record;
  for (const char separator : kCsvSeparators) {
    if (separator == decimal_point) {
      continue;
    }
    std::map<std::size_t, std::size_t> records_by_fields;
    CsvCursor cursor = csv_begin(text);
    for (std::size_t i = 0; i < kSampledRecords && skip_to_record(cursor); ++i) {
      scan_record(cursor, separator, record);
      ++records_by_fields[record.size()];
    }
    records_by_fields.erase(1);
    const auto modal = std::ranges::max_element(
        records_by_fields, {}, [](const auto& entry) { return entry.second; });
    if (modal != records_by_fields.end() && modal->second > most_records) {
      best = separator;
      most_records = modal->second;
    }
  }
  return best;
}

}  // namespace tcert::table
