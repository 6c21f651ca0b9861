#include <statistics/model/variable.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <statistics/model/stray_text.hpp>
#include <string_view>
#include <table/cell_reading.hpp>
#include <table/csv_write.hpp>
#include <table/nearest_name.hpp>
#include <table/not_a_number.hpp>
#include <utility>

namespace tcert::statistics {
namespace {

struct Function {
  std::string_view name;
  double (*value)(double);
};

constexpr std::array<Function, 9> kFunctions{{{"log", [](double x) { return std::log(x); }},
                                              {"log2", [](double x) { return std::log2(x); }},
                                              {"log10", [](double x) { return std::log10(x); }},
                                              {"log1p", [](double x) { return std::log1p(x); }},
                                              {"exp", [](double x) { return std::exp(x); }},
                                              {"sqrt", [](double x) { return std::sqrt(x); }},
                                              {"abs", [](double x) { return std::abs(x); }},
                                              {"I", [](double x) { return x; }},
                                              {"as.numeric", [](double x) { return x; }}}};

struct Arithmetic {
  std::string_view sign;
  double (*value)(double, double);
  bool is_comparison;
};

constexpr std::array<Arithmetic, 11> kArithmetic{{
    {"+", [](double a, double b) { return a + b; }, false},
    {"-", [](double a, double b) { return a - b; }, false},
    {"*", [](double a, double b) { return a * b; }, false},
    {"/", [](double a, double b) { return a / b; }, false},
    {"^", [](double a, double b) { return b == 2.0 ? a * a : std::pow(a, b); }, false},
    {"==", [](double a, double b) { return a == b ? 1.0 : 0.0; }, true},
    {"!=", [](double a, double b) { return a != b ? 1.0 : 0.0; }, true},
    {"<", [](double a, double b) { return a < b ? 1.0 : 0.0; }, true},
    {"<=", [](double a, double b) { return a <= b ? 1.0 : 0.0; }, true},
    {">", [](double a, double b) { return a > b ? 1.0 : 0.0; }, true},
    {">=", [](double a, double b) { return a >= b ? 1.0 : 0.0; }, true},
}};

template <class Table>
auto find_by(const Table& table, std::string_view name) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const auto& one) {
    if constexpr (requires { one.sign; }) {
      return one.sign == name;
    } else {
      return one.name == name;
    }
  });
  return found == table.end() ? nullptr : &*found;
}

/// The number of 15 significant digits that R prints for `value`; 0 for -0.
double as_printed(double value) {
  if (value == 0.0 || !std::isfinite(value)) {
    return value == 0.0 ? 0.0 : value;
  }
  constexpr int kDigits = 15;
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(
      text.data(), text.data() + text.size(), value, std::chars_format::scientific, kDigits - 1);
  double printed = value;
  std::from_chars(text.data(), end, printed);
  return printed;
}

/// Levels by value; numbers that print alike are one, as in R's factor().
table::Factor levels_by_value(const std::vector<double>& numbers) {
  std::vector<double> distinct;
  std::copy_if(numbers.begin(), numbers.end(), std::back_inserter(distinct), [](double x) {
    return !std::isnan(x);
  });
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  table::Factor factor;
  std::vector<std::uint32_t> level_of;  // of each distinct number
  double last = 0.0;
  for (const double value : distinct) {
    const double printed = as_printed(value);
    if (factor.levels.empty() || printed != last) {
      factor.levels.emplace_back();
      table::append_number(factor.levels.back(), printed);
    }
    last = printed;
    level_of.push_back(static_cast<std::uint32_t>(factor.levels.size() - 1));
  }
  factor.codes.reserve(numbers.size());
  for (const double x : numbers) {
    const auto place = std::lower_bound(distinct.begin(), distinct.end(), x) - distinct.begin();
    factor.codes.push_back(std::isnan(x) ? table::Factor::kMissing
                                         : level_of[static_cast<std::size_t>(place)]);
  }
  return factor;
}

/// The levels FALSE and TRUE that occur.
table::Factor levels_of_truth(const std::vector<double>& numbers) {
  table::Factor factor = levels_by_value(numbers);
  for (std::string& level : factor.levels) {
    level = level == "0" ? "FALSE" : "TRUE";
  }
  return factor;
}

void put_first(table::Factor& factor, const std::string& level, const std::string& column) {
  const auto found = std::find(factor.levels.begin(), factor.levels.end(), level);
  if (found == factor.levels.end()) {
    std::string known;
    for (const std::string& one : factor.levels) {
      known += (known.empty() ? "" : ", ") + one;
    }
    throw FormulaError("column '" + column + "' has no level '" + level + "', only " + known);
  }
  const auto chosen = static_cast<std::uint32_t>(found - factor.levels.begin());
  std::rotate(factor.levels.begin(), found, found + 1);
  for (std::uint32_t& code : factor.codes) {
    if (code != table::Factor::kMissing && code <= chosen) {
      code = code == chosen ? 0 : code + 1;
    }
  }
}

class Evaluation {
 public:
  Evaluation(const table::DataTable& table, References references)
      : table_(table), references_(std::move(references)) {}

  Variable value(const Expression& expression) {
    switch (expression.kind) {
      case Expression::Kind::number:
        return {Variable::Kind::number, std::vector<double>(table_.rows, expression.value), {}};
      case Expression::Kind::text:
        throw FormulaError("a text is only compared with a column: column == \"" + expression.name +
                           "\"");
      case Expression::Kind::column:
        return column(expression.name);
      case Expression::Kind::call:
        return call(expression);
    }
    return {};
  }

 private:
  [[nodiscard]] const table::DataColumn& find(const std::string& name) const {
    const table::DataColumn* const found = table_.find(name);
    if (found == nullptr) {
      const auto nearest = table::nearest_name(name, table_.header);
      throw FormulaError("no column '" + name + "' in " + table_.file +
                         (nearest ? "; did you mean '" + *nearest + "'?" : ""));
    }
    return *found;
  }

  void apply_reference(const std::string& column, table::Factor& factor) const {
    if (const auto level = references_.find(column); level != references_.end()) {
      const table::DataColumn* const data = table_.find(column);
      const bool is_truth = data != nullptr && data->is_truth;
      put_first(factor, is_truth ? truth_word(level->second) : level->second, column);
    }
  }

  /// TRUE or FALSE for any spelling of them; other words stay.
  static std::string truth_word(const std::string& word) {
    const table::CellReading reading = table::read_cell(word);
    return reading.meaning != table::CellMeaning::truth ? word
           : reading.value == 1.0                       ? "TRUE"
                                                        : "FALSE";
  }

  /// TRUE and FALSE, in a comparison also T and F, where no column is called so.
  [[nodiscard]] bool is_truth_constant(const Expression& expression, bool compared) const {
    const std::string& name = expression.name;
    return expression.kind == Expression::Kind::column &&
           (name == "TRUE" || name == "FALSE" || (compared && (name == "T" || name == "F"))) &&
           table_.find(name) == nullptr;
  }

  [[nodiscard]] Variable truth_constant(const std::string& name) const {
    return {Variable::Kind::truth,
            std::vector<double>(table_.rows, name.front() == 'T' ? 1.0 : 0.0),
            {}};
  }

  [[nodiscard]] Variable column(const std::string& name) const {
    if (is_truth_constant({Expression::Kind::column, 0.0, name, {}}, false)) {
      return truth_constant(name);
    }
    const table::DataColumn& data = find(name);
    if (data.is_truth && references_.count(name) == 0) {
      return {Variable::Kind::truth, data.numbers, {}};
    }
    if (!data.is_text && !data.is_truth) {
      return {Variable::Kind::number, data.numbers, {}};
    }
    Variable variable{
        Variable::Kind::factor, {}, data.is_truth ? levels_of_truth(data.numbers) : data.text};
    apply_reference(name, variable.factor);
    return variable;
  }

  std::vector<double> numbers(const Expression& expression, const Expression& of) {
    if (is_truth_constant(expression, of.is_call("==") || of.is_call("!="))) {
      return truth_constant(expression.name).numbers;
    }
    // A reference level turns truth values into a factor; as numbers they stay what they are.
    Variable variable = Evaluation(table_, {}).value(expression);
    if (variable.kind == Variable::Kind::factor) {
      refuse_text(expression, of);
    }
    return std::move(variable.numbers);
  }

  [[noreturn]] void refuse_text(const Expression& expression, const Expression& of) const {
    std::string problem =
        "'" + to_string(of) + "' needs numbers, but '" + to_string(expression) + "' holds text";
    const table::DataColumn* const data =
        expression.kind == Expression::Kind::column ? table_.find(expression.name) : nullptr;
    if (data != nullptr && data->is_text && data->mixed.is_spoiled()) {
      problem += ": " + stray_cell(table_, *data);
    } else if (data != nullptr && data->is_text &&
               std::any_of(of.arguments.begin(), of.arguments.end(), [&](const Expression& one) {
                 return is_truth_constant(one, true);
               })) {
      problem += ", not TRUE and FALSE; write " + expression.name + " == \"" +
                 data->text.levels.back() + "\" for the text that counts as TRUE";
    }
    throw FormulaError(problem);
  }

  Variable call(const Expression& call) {
    if (call.name == "strata") {
      return stratum(call);
    }
    if (call.arguments.size() == 1) {
      const Expression& only = call.arguments.front();
      if (call.name == "(") {
        return value(only);
      }
      if (call.name == "factor" || call.name == "as.factor") {
        return factor(only);
      }
      if (call.name == "scale") {
        return scaled(call);
      }
      if (call.name == "-" || call.name == "+") {
        std::vector<double> x = numbers(only, call);
        for (double& one : x) {
          one = call.name == "-" ? -one : one;
        }
        return {Variable::Kind::number, std::move(x), {}};
      }
      if (const Function* const function = find_by(kFunctions, call.name)) {
        return applied(call, *function);
      }
    }
    if (call.arguments.size() == 2) {
      if (const Arithmetic* const arithmetic = find_by(kArithmetic, call.name)) {
        return combined(call, *arithmetic);
      }
    }
    if (call.name == ":") {
      return {Variable::Kind::factor,
              {},
              crossed({factor(call.arguments[0]).factor, factor(call.arguments[1]).factor}, ":")};
    }
    if (find_by(kFunctions, call.name) != nullptr || call.name == "scale" ||
        call.name == "factor") {
      throw FormulaError("'" + to_string(call) + "': " + call.name +
                         "() takes one argument, found " + std::to_string(call.arguments.size()) +
                         (call.name == "log" ? "; log2(x), log10(x) or log(x) / log(b)" : ""));
    }
    throw FormulaError("'" + to_string(call) +
                       "' is not known here; known: log, log2, log10, log1p, exp, sqrt, abs, I, "
                       "scale, factor, as.numeric and arithmetic");
  }

  Variable factor(const Expression& argument) {
    Variable variable = value(argument);
    if (variable.kind != Variable::Kind::factor) {
      variable.factor = variable.kind == Variable::Kind::truth ? levels_of_truth(variable.numbers)
                                                               : levels_by_value(variable.numbers);
      variable.numbers = {};
      variable.kind = Variable::Kind::factor;
      if (argument.kind == Expression::Kind::column) {
        apply_reference(argument.name, variable.factor);
      }
    }
    return variable;
  }

  /// The levels of strata() as survival names them: "M3" where all arguments are text, "a, M3" of
  /// several, else "sex=1, arm=A".
  Variable stratum(const Expression& call) {
    bool all_text = true;
    std::vector<table::Factor> factors;
    for (const Expression& argument : call.arguments) {
      all_text = all_text && value(argument).kind == Variable::Kind::factor;
      factors.push_back(factor(argument).factor);
    }
    for (std::size_t k = 0; k < factors.size() && !all_text; ++k) {
      for (std::string& level : factors[k].levels) {
        level.insert(0, to_string(call.arguments[k]) + '=');
      }
    }
    return {Variable::Kind::factor, {}, crossed(factors, ", ")};
  }

  Variable applied(const Expression& call, const Function& function) {
    if (call.name == "I") {
      return value(call.arguments.front());
    }
    std::vector<double> x = numbers(call.arguments.front(), call);
    std::transform(x.begin(), x.end(), x.begin(), function.value);
    return {Variable::Kind::number, std::move(x), {}};
  }

  Variable scaled(const Expression& call) {
    std::vector<double> x = numbers(call.arguments.front(), call);
    double sum = 0.0;
    double known = 0.0;
    for (const double one : x) {
      sum += std::isnan(one) ? 0.0 : one;
      known += std::isnan(one) ? 0.0 : 1.0;
    }
    const double mean = sum / known;
    double squares = 0.0;
    for (const double one : x) {
      squares += std::isnan(one) ? 0.0 : (one - mean) * (one - mean);
    }
    const double sd = std::sqrt(squares / (known - 1.0));
    for (double& one : x) {
      one = (one - mean) / sd;
    }
    return {Variable::Kind::number, std::move(x), {}};
  }

  /// A word for a missing cell differs from every text, and would count as one of them. Compared
  /// with itself it is meant. \throws FormulaError with its place.
  void refuse_missing_words(const Expression& call,
                            const table::Factor& factor,
                            const std::string& text) const {
    std::vector<bool> is_missing_word;
    for (const std::string& level : factor.levels) {
      is_missing_word.push_back(level != text && table::read_cell(level).meaning ==
                                                     table::CellMeaning::missing_word);
    }
    const auto found =
        std::find_if(factor.codes.begin(), factor.codes.end(), [&](std::uint32_t code) {
          return code != table::Factor::kMissing && is_missing_word[code];
        });
    if (found == factor.codes.end()) {
      return;
    }
    const auto row = static_cast<std::size_t>(found - factor.codes.begin());
    std::string place = "row " + std::to_string(row + 1) + " of " + table_.file;
    if (row < table_.lines.size()) {
      place += " (line " + std::to_string(table_.lines[row]) + ")";
    }
    const std::string& word = factor.levels[*found];
    throw FormulaError("'" + to_string(call) + "': found '" + word + "' in " + place + ", which " +
                       "would count as another text than '" + text + "'; " +
                       std::string(table::kHowMissingIsWritten) + "; if '" + word +
                       "' is a name, compare with it or call it something else");
  }

  /// A factor compared with a text.
  Variable compared(const Expression& call, const Expression& subject, std::string text) {
    if (call.name != "==" && call.name != "!=") {
      throw FormulaError("'" + to_string(call) + "': texts are equal or not, nothing else");
    }
    const Variable what = Evaluation(table_, {}).value(subject);
    if (what.kind == Variable::Kind::truth) {
      text = truth_word(text);
      if (text != "TRUE" && text != "FALSE") {
        throw FormulaError("'" + to_string(call) + "': '" + to_string(subject) +
                           "' is TRUE or FALSE");
      }
    }
    const Variable names = factor(subject);
    refuse_missing_words(call, names.factor, text);
    Variable result{Variable::Kind::truth, std::vector<double>(table_.rows, table::kNaN), {}};
    for (std::size_t row = 0; row < table_.rows; ++row) {
      if (!names.is_missing(row)) {
        const bool equal = names.factor.levels[names.factor.codes[row]] == text;
        result.numbers[row] = equal == (call.name == "==") ? 1.0 : 0.0;
      }
    }
    return result;
  }

  /// An unquoted word that is no column but a level of the other side lacks its quotes.
  void require_known_word(const Expression& call,
                          const Expression& left,
                          const Expression& right) const {
    if (left.kind != Expression::Kind::column || right.kind != Expression::Kind::column ||
        table_.find(right.name) != nullptr) {
      return;
    }
    const table::DataColumn* const subject = table_.find(left.name);
    if (subject == nullptr || !subject->is_text) {
      return;
    }
    const auto& levels = subject->text.levels;
    if (std::find(levels.begin(), levels.end(), right.name) != levels.end()) {
      throw FormulaError("no column '" + right.name + "' in " + table_.file +
                         "; for the text write " + left.name + ' ' + call.name + " \"" +
                         right.name + '"');
    }
  }

  Variable combined(const Expression& call, const Arithmetic& arithmetic) {
    const Expression& left = call.arguments[0];
    const Expression& right = call.arguments[1];
    if (right.kind == Expression::Kind::text) {
      return compared(call, left, right.name);
    }
    if (arithmetic.is_comparison) {
      require_known_word(call, left, right);
    }
    std::vector<double> a = numbers(left, call);
    const std::vector<double> b = numbers(right, call);
    for (std::size_t row = 0; row < a.size(); ++row) {
      const bool missing = std::isnan(a[row]) || std::isnan(b[row]);
      a[row] = missing ? table::kNaN : arithmetic.value(a[row], b[row]);
    }
    return {arithmetic.is_comparison ? Variable::Kind::truth : Variable::Kind::number,
            std::move(a),
            {}};
  }

  const table::DataTable& table_;
  References references_;
};

}  // namespace

Variable evaluate(const Expression& expression,
                  const table::DataTable& table,
                  const References& references) {
  return Evaluation(table, references).value(expression);
}

table::Factor evaluate_factor(const Expression& expression, const table::DataTable& table) {
  const Expression as_factor{Expression::Kind::call, 0.0, "factor", {expression}};
  return evaluate(as_factor, table).factor;
}

table::Factor crossed(const std::vector<table::Factor>& factors, const std::string& separator) {
  if (factors.size() == 1) {
    return factors.front();
  }
  const std::size_t rows = factors.front().rows();
  std::vector<std::uint64_t> key(rows, 0);
  std::vector<bool> missing(rows, false);
  for (const table::Factor& factor : factors) {
    for (std::size_t row = 0; row < rows; ++row) {
      missing[row] = missing[row] || factor.codes[row] == table::Factor::kMissing;
      key[row] = key[row] * factor.levels.size() + (missing[row] ? 0 : factor.codes[row]);
    }
  }
  std::vector<std::uint64_t> distinct;
  for (std::size_t row = 0; row < rows; ++row) {
    if (!missing[row]) {
      distinct.push_back(key[row]);
    }
  }
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());

  table::Factor cross;
  for (std::uint64_t one : distinct) {
    std::vector<std::uint64_t> codes(factors.size());
    for (std::size_t k = factors.size(); k > 0; --k) {
      codes[k - 1] = one % factors[k - 1].levels.size();
      one /= factors[k - 1].levels.size();
    }
    std::string name = factors.front().levels[codes.front()];
    for (std::size_t k = 1; k < factors.size(); ++k) {
      name += separator;
      name += factors[k].levels[codes[k]];
    }
    cross.levels.push_back(std::move(name));
  }
  for (std::size_t row = 0; row < rows; ++row) {
    const auto at = std::lower_bound(distinct.begin(), distinct.end(), key[row]);
    cross.codes.push_back(missing[row] ? table::Factor::kMissing
                                       : static_cast<std::uint32_t>(at - distinct.begin()));
  }
  return cross;
}

table::Factor on_rows(const table::Factor& factor, const std::vector<std::size_t>& rows) {
  std::vector<std::uint32_t> new_code(factor.levels.size(), table::Factor::kMissing);
  for (const std::size_t row : rows) {
    if (factor.codes[row] != table::Factor::kMissing) {
      new_code[factor.codes[row]] = 0;
    }
  }
  table::Factor kept;
  for (std::size_t level = 0; level < new_code.size(); ++level) {
    if (new_code[level] != table::Factor::kMissing) {
      new_code[level] = static_cast<std::uint32_t>(kept.levels.size());
      kept.levels.push_back(factor.levels[level]);
    }
  }
  kept.codes.reserve(rows.size());
  for (const std::size_t row : rows) {
    const std::uint32_t code = factor.codes[row];
    kept.codes.push_back(code == table::Factor::kMissing ? code : new_code[code]);
  }
  return kept;
}

}  // namespace tcert::statistics
