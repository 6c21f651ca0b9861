#include <table/csv_write.hpp>

#include <array>
#include <charconv>
#include <cmath>

namespace tcert::table {

namespace {

constexpr std::uint64_t kNanosecondsPerSecond = 1'000'000'000;

bool needs_quotes(std::string_view text) noexcept {
  return !text.empty() && (text.find_first_of("\",;\t\r\n") != std::string_view::npos ||
                           text.front() == ' ' || text.back() == ' ' || text.front() == '#');
}

}  // namespace

void append_number(std::string& out, double value) {
  if (std::isnan(value)) {
    return;
  }
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  out.append(digits.data(), end);
}

std::string number_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

void append_cell(std::string& out, double value) {
  out += ',';
  append_number(out, value);
}

void append_seconds(std::string& out, std::int64_t time_ns) {
  const bool negative = time_ns < 0;
  const auto bits = static_cast<std::uint64_t>(time_ns);
  const std::uint64_t magnitude = negative ? 0 - bits : bits;
  if (negative) {
    out += '-';
  }
  out += std::to_string(magnitude / kNanosecondsPerSecond);
  std::uint64_t rest = magnitude % kNanosecondsPerSecond;
  if (rest == 0) {
    return;
  }
  std::array<char, 9> digits{};
  for (std::size_t i = digits.size(); i-- > 0;) {
    digits[i] = static_cast<char>('0' + rest % 10);
    rest /= 10;
  }
  std::string_view fraction(digits.data(), digits.size());
  fraction = fraction.substr(0, fraction.find_last_not_of('0') + 1);
  out += '.';
  out += fraction;
}

void append_text(std::string& out, std::string_view text) {
  if (needs_quotes(text)) {
    append_quoted(out, text);
  } else {
    out += text;
  }
}

void append_quoted(std::string& out, std::string_view text) {
  out += '"';
  for (const char c : text) {
    out += c;
    if (c == '"') {
      out += c;
    }
  }
  out += '"';
}

}  // namespace tcert::table
