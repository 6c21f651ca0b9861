#include <statistics/model/expression.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>

namespace tcert::statistics {
namespace {

/// Binary operators with their binding strength, R's order; '^' binds to the right.
struct Operator {
  std::string_view sign;
  int strength;
};

constexpr std::array<Operator, 17> kOperators{{{"==", 5},
                                               {"!=", 5},
                                               {"<=", 5},
                                               {">=", 5},
                                               {"<", 5},
                                               {">", 5},
                                               {"~", 1},
                                               {"||", 2},
                                               {"|", 2},
                                               {"&", 3},
                                               {"+", 6},
                                               {"-", 6},
                                               {"*", 7},
                                               {"/", 7},
                                               {"%in%", 8},
                                               {":", 9},
                                               {"^", 11}}};
constexpr int kNotStrength = 4;
constexpr int kUnaryStrength = 10;
constexpr int kDeepest = 200;
constexpr int kMostOperators = 1000;  // A chain of them is as deep a tree.

bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }
bool starts_name(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.' ||
         static_cast<unsigned char>(c) >= 0x80U;
}

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Expression parse() {
    Expression whole = binary(0);
    skip_blanks();
    if (at_ < text_.size()) {
      fail("unexpected '" + std::string(1, text_[at_]) + "'");
    }
    return whole;
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw FormulaError("formula '" + std::string(text_) + "': " + problem + " at character " +
                       std::to_string(at_ + 1));
  }

  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n')) {
      ++at_;
    }
  }

  [[nodiscard]] char peek() {
    skip_blanks();
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  const Operator* operator_here() {
    skip_blanks();
    const auto* const found =
        std::find_if(kOperators.begin(), kOperators.end(), [&](const Operator& one) {
          return text_.substr(at_).starts_with(one.sign);
        });
    return found == kOperators.end() ? nullptr : found;
  }

  Expression binary(int weakest) {
    if (++depth_ > kDeepest) {
      fail("nested too deeply");
    }
    Expression left = unary();
    for (const Operator* op = operator_here(); op != nullptr && op->strength > weakest;
         op = operator_here()) {
      if (++operators_ > kMostOperators) {
        fail("more than " + std::to_string(kMostOperators) + " operators");
      }
      at_ += op->sign.size();
      const bool to_the_right = op->sign == "^";
      Expression right = binary(to_the_right ? op->strength - 1 : op->strength);
      Expression call{Expression::Kind::call, 0.0, std::string(op->sign), {}};
      call.arguments.push_back(std::move(left));
      call.arguments.push_back(std::move(right));
      left = std::move(call);
    }
    --depth_;
    return left;
  }

  Expression unary() {
    const char c = peek();
    const bool is_not = c == '!' && text_.substr(at_, 2) != "!=";
    if (c == '-' || c == '+' || c == '~' || is_not) {
      ++at_;
      Expression call{Expression::Kind::call, 0.0, std::string(1, c), {}};
      call.arguments.push_back(binary(c == '~' ? 1 : is_not ? kNotStrength : kUnaryStrength));
      return call;
    }
    return primary();
  }

  Expression primary() {
    const char c = peek();
    if (c == '(') {
      return {Expression::Kind::call, 0.0, "(", arguments()};
    }
    if (c == '"' || c == '\'' || c == '`') {
      const std::string quoted = quoted_text(c);
      return {c == '`' ? Expression::Kind::column : Expression::Kind::text, 0.0, quoted, {}};
    }
    if (is_digit(c) || (c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) {
      return number();
    }
    if (!starts_name(c)) {
      fail(c == '\0' ? "it ends too early" : "expected a column, a number or a call");
    }
    std::string name;
    while (at_ < text_.size() && (starts_name(text_[at_]) || is_digit(text_[at_]))) {
      name += text_[at_++];
    }
    if (name == ".") {
      fail("'.' is not known here, name the columns: y ~ a + b; found");
    }
    if (peek() == '(') {
      return {Expression::Kind::call, 0.0, name, arguments()};
    }
    return {Expression::Kind::column, 0.0, name, {}};
  }

  Expression number() {
    double value = 0.0;
    const char* const begin = text_.data() + at_;
    const auto [stop, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error != std::errc{}) {
      fail("expected a number");
    }
    at_ += static_cast<std::size_t>(stop - begin);
    return {Expression::Kind::number, value, "", {}};
  }

  std::string quoted_text(char quote) {
    const std::size_t end = text_.find(quote, at_ + 1);
    if (end == std::string_view::npos) {
      fail("a quote that is never closed");
    }
    std::string inside(text_.substr(at_ + 1, end - at_ - 1));
    at_ = end + 1;
    return inside;
  }

  /// A value, or NAME = value: a call of "=" with the name, which is no column.
  Expression argument() {
    Expression value = binary(0);
    if (peek() != '=') {
      return value;
    }
    if (value.kind != Expression::Kind::column) {
      fail("a named argument is NAME = value");
    }
    ++at_;
    value.kind = Expression::Kind::text;
    return {Expression::Kind::call, 0.0, "=", {std::move(value), binary(0)}};
  }

  std::vector<Expression> arguments() {
    std::vector<Expression> list;
    ++at_;
    if (peek() == ')') {
      fail("expected an argument");
    }
    while (true) {
      list.push_back(argument());
      const char c = peek();
      if (c != ',' && c != ')') {
        fail("expected ',' or ')'");
      }
      ++at_;
      if (c == ')') {
        return list;
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int operators_ = 0;
};

std::string number_text(double value) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

bool is_operator(std::string_view name) {
  return std::any_of(
      kOperators.begin(), kOperators.end(), [&](const Operator& one) { return one.sign == name; });
}

/// R writes a name in backticks that could not stand without.
std::string column_text(const std::string& name) {
  const bool dotted_digit = name.size() > 1 && name[0] == '.' && is_digit(name[1]);
  const bool plain =
      !name.empty() && starts_name(name.front()) && name.front() != '_' && !dotted_digit &&
      std::all_of(name.begin(), name.end(), [](char c) { return starts_name(c) || is_digit(c); });
  return plain ? name : '`' + name + '`';
}

std::string call_text(const Expression& call) {
  if (call.name == "=" && call.arguments.size() == 2) {
    return call.arguments[0].name + " = " + to_string(call.arguments[1]);
  }
  const bool is_sign = is_operator(call.name) || call.name == "!";
  if (is_sign && call.arguments.size() == 1) {
    return call.name + to_string(call.arguments[0]);
  }
  if (is_sign && call.arguments.size() == 2) {
    const bool tight = call.name == "^" || call.name == ":" || call.name == "/";
    const std::string sign = tight ? call.name : ' ' + call.name + ' ';
    return to_string(call.arguments[0]) + sign + to_string(call.arguments[1]);
  }
  std::string text = call.name == "(" ? "(" : call.name + "(";
  for (const Expression& argument : call.arguments) {
    text += (&argument == &call.arguments.front() ? "" : ", ") + to_string(argument);
  }
  return text + ")";
}

}  // namespace

std::string to_string(const Expression& expression) {
  switch (expression.kind) {
    case Expression::Kind::number:
      return number_text(expression.value);
    case Expression::Kind::text:
      return '"' + expression.name + '"';
    case Expression::Kind::column:
      return column_text(expression.name);
    case Expression::Kind::call:
      return call_text(expression);
  }
  return {};
}

void collect_columns(const Expression& expression, std::vector<std::string>& names) {
  if (expression.kind == Expression::Kind::column &&
      std::find(names.begin(), names.end(), expression.name) == names.end()) {
    names.push_back(expression.name);
  }
  for (const Expression& argument : expression.arguments) {
    collect_columns(argument, names);
  }
}

Expression parse_expression(std::string_view text) { return Parser(text).parse(); }

}  // namespace tcert::statistics
