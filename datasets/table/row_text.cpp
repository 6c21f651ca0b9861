#include <table/row_text.hpp>

#include <array>
#include <charconv>
#include <system_error>

namespace tcert::table {
namespace {

template <class Value>
void append_digits(std::string& text, Value value) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text += text.empty() ? "" : ",";
  text.append(digits.data(), end);
}

template <class Value>
Value parsed(std::string_view cell, const char* expected) {
  Value value{};
  const char* const end = cell.data() + cell.size();
  const auto [stop, error] = std::from_chars(cell.data(), end, value);
  if (error != std::errc{} || stop != end) {
    throw RowError("found '" + std::string(cell) + "', expected " + expected);
  }
  return value;
}

}  // namespace

void RowWriter::cell(double value) { append_digits(text_, value); }
void RowWriter::cell(std::uint64_t value) { append_digits(text_, value); }

double RowReader::number() { return parsed<double>(next(), "a number"); }

std::uint64_t RowReader::integer(std::uint64_t most) {
  const auto value = parsed<std::uint64_t>(next(), "a count");
  if (value > most) {
    throw RowError("found " + std::to_string(value) + ", expected at most " + std::to_string(most));
  }
  return value;
}

std::string_view RowReader::next() {
  if (rest_.empty()) {
    throw RowError("the line ends too early");
  }
  if (!is_first_) {
    rest_.remove_prefix(1);  // The comma at which the cell before ended.
  }
  is_first_ = false;
  const std::string_view cell = rest_.substr(0, rest_.find(','));
  rest_.remove_prefix(cell.size());
  return cell;
}

void RowReader::end() const {
  if (!rest_.empty()) {
    throw RowError("found '" + std::string(rest_.substr(0, 40)) + "' after the last cell");
  }
}

}  // namespace tcert::table
