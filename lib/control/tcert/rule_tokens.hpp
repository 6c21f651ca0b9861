#pragma once
/// \file
/// The words of one line of rules. Internal to rule_formula.cpp.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace tcert {

inline constexpr std::string_view kRuleBlank = " \t\r";

[[nodiscard]] inline bool is_rule_word(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Words, numbers and marks of one line. \throws std::invalid_argument, with line and column.
class RuleTokens {
 public:
  RuleTokens(std::string_view line, std::size_t number) : line_(line), number_(number) { next(); }

  [[nodiscard]] std::string_view now() const noexcept { return now_; }
  /// The next thing in the line is a word, too.
  [[nodiscard]] bool is_followed_by_word() const noexcept {
    const std::size_t next = line_.find_first_not_of(kRuleBlank, at_ + now_.size());
    return next < line_.size() && is_rule_word(line_[next]);
  }
  [[nodiscard]] bool at_end() const noexcept { return now_.empty(); }
  [[nodiscard]] bool is_number() const noexcept {
    return !now_.empty() && ((now_[0] >= '0' && now_[0] <= '9') || now_[0] == '.');
  }
  [[nodiscard]] bool take(std::string_view word) {
    if (now_ != word) {
      return false;
    }
    next();
    return true;
  }
  void expect(std::string_view word) {
    if (!take(word)) {
      refuse("'" + std::string(word) + "'");
    }
  }
  double take_number(const char* expected) {
    double value = 0.0;
    const char* const end = now_.data() + now_.size();
    const auto read = std::from_chars(now_.data(), end, value);
    if (!is_number() || read.ec != std::errc() || read.ptr != end || !std::isfinite(value)) {
      refuse(expected);
    }
    next();
    return value;
  }
  void next() {
    at_ = std::min(line_.find_first_not_of(kRuleBlank, at_ + now_.size()), line_.size());
    std::size_t length = 0;
    while (at_ + length < line_.size() && is_part(length)) {
      ++length;
    }
    if (length == 0 && at_ < line_.size()) {
      const bool has_equal = (line_[at_] == '<' || line_[at_] == '>') && at_ + 1 < line_.size() &&
                             line_[at_ + 1] == '=';
      length = has_equal ? 2 : 1;
    }
    now_ = line_.substr(at_, length);
  }
  [[noreturn]] void refuse(const std::string& expected) const {
    throw std::invalid_argument("rules, line " + std::to_string(number_) + ", column " +
                                std::to_string(at_ + 1) + ": found " +
                                (now_.empty() ? "the end" : "'" + std::string(now_) + "'") +
                                ", expected " + expected);
  }

 private:
  // Of a number a point, and the sign of its exponent, too.
  [[nodiscard]] bool is_part(std::size_t length) const noexcept {
    const char c = line_[at_ + length];
    if (is_rule_word(c) || c == '.') {
      return true;
    }
    const char first = line_[at_];
    const bool in_number = length > 0 && ((first >= '0' && first <= '9') || first == '.');
    const char before = length > 0 ? line_[at_ + length - 1] : ' ';
    return in_number && (c == '+' || c == '-') && (before == 'e' || before == 'E');
  }

  std::string_view line_;
  std::size_t number_;
  std::size_t at_ = 0;
  std::string_view now_ = line_.substr(0, 0);
};

}  // namespace tcert
