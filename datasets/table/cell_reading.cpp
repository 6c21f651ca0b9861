#include <table/cell_reading.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <table/decimal.hpp>
#include <table/nearest_name.hpp>
#include <table/not_a_number.hpp>
#include <table/trimmed.hpp>

namespace tcert::table {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Case-folded.
constexpr std::array<std::string_view, 27> kMissingWords = {
    "na",   "n/a", "n.a.", "n.a", "#n/a",    "#na",       "<na>",    "null",   "<null>",
    "none", "nil", "nat",  "\\n", "missing", "undefined", "-",       "--",     "---",
    ".",    "..",  "...",  "?",   "1.#ind",  "-1.#ind",   "1.#qnan", "\u2013", "\u2014"};

char lower(char c) noexcept { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }

bool starts_with_folded(std::string_view text, std::string_view word) noexcept {
  return text.size() >= word.size() &&
         std::equal(
             word.begin(), word.end(), text.begin(), [](char a, char b) { return a == lower(b); });
}

std::string_view without_sign(std::string_view text) noexcept {
  return text.starts_with('-') || text.starts_with('+') ? text.substr(1) : text;
}

/// nan, -NaN, nan(ind), nan(snan): what strtod() reads as not a number.
bool is_nan(std::string_view text) noexcept {
  const std::string_view word = without_sign(text);
  if (!starts_with_folded(word, "nan")) {
    return false;
  }
  const std::string_view rest = word.substr(3);
  return rest.empty() || (rest.size() >= 2 && rest.front() == '(' && rest.back() == ')');
}

bool is_missing(std::string_view text) noexcept {
  return text.empty() || text == "NA" || is_nan(text);
}

std::optional<bool> truth_of(std::string_view text) noexcept {
  if (text == "TRUE" || text == "True" || text == "true" || text == "T") {
    return true;
  }
  if (text == "FALSE" || text == "False" || text == "false" || text == "F") {
    return false;
  }
  return std::nullopt;
}

bool has_digit(std::string_view text) noexcept {
  return std::any_of(text.begin(), text.end(), decimal_detail::is_digit);
}

/// The magnitude of what follows the sign.
std::optional<double> magnitude(std::string_view text) {
  if (text.empty() || text.front() == '-' || text.front() == '+') {
    return std::nullopt;
  }
  const bool hexadecimal = starts_with_folded(text, "0x");
  const std::string_view digits = hexadecimal ? text.substr(2) : text;
  const char* const end = digits.data() + digits.size();
  double value = 0.0;
  const auto [stop, error] = std::from_chars(
      digits.data(), end, value, hexadecimal ? std::chars_format::hex : std::chars_format::general);
  if (error == std::errc::invalid_argument || stop != end) {
    return std::nullopt;
  }
  if (error == std::errc::result_out_of_range) {
    // from_chars does not say on which side it left the range.
    const bool below =
        !hexadecimal && decimal_detail::scan_long_number(digits.data(), end, '.', value) == end;
    return below ? 0.0 : kInfinity;
  }
  const bool is_infinite_word = std::isinf(value) && !has_digit(digits);
  return std::isnan(value) || (hexadecimal && is_infinite_word) ? std::nullopt
                                                                : std::optional(value);
}

std::optional<double> number_of(std::string_view text, char decimal_point) {
  std::string with_point;
  if (decimal_point != '.') {
    if (text.find('.') != std::string_view::npos) {
      return std::nullopt;
    }
    with_point = text;
    std::ranges::replace(with_point, decimal_point, '.');
    text = with_point;
  }
  const std::optional<double> size = magnitude(without_sign(text));
  return size && text.starts_with('-') ? std::optional(-*size) : size;
}

}  // namespace

CellReading read_cell(std::string_view cell, char decimal_point) {
  const std::string_view text = trimmed(cell);
  if (is_missing(text)) {
    return {CellMeaning::missing, kNaN};
  }
  if (const auto value = number_of(text, decimal_point)) {
    return {CellMeaning::number, *value};
  }
  if (const auto truth = truth_of(text)) {
    return {CellMeaning::truth, *truth ? 1.0 : 0.0};
  }
  const bool stands_for_missing =
      std::ranges::find(kMissingWords, case_folded(text)) != kMissingWords.end();
  return {stands_for_missing ? CellMeaning::missing_word : CellMeaning::text, kNaN};
}

bool is_missing_cell(std::string_view cell) noexcept { return is_missing(trimmed(cell)); }

}  // namespace tcert::table
