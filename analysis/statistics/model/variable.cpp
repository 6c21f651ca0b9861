#include <span>
#include <statistics/model/variable.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <statistics/model/factor_levels.hpp>
#include <statistics/model/number_functions.hpp>
#include <statistics/model/stray_text.hpp>
#include <statistics/model/text_comparison.hpp>
#include <table/nearest_name.hpp>
#include <table/not_a_number.hpp>
#include <utility>

namespace tcert::statistics {
namespace {

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
  void apply_reference(const std::string& column, table::Factor& factor) const {
    if (const auto level = references_.find(column); level != references_.end()) {
      const table::DataColumn* const data = table_.find(column);
      const bool is_truth = data != nullptr && data->is_truth;
      put_first(factor, is_truth ? truth_word(level->second) : level->second, column);
    }
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
    const table::DataColumn& data = named_column(table_, name);
    if (data.is_truth && !references_.contains(name)) {
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
      return call_of_one(call, call.arguments.front());
    }
    if (const auto* const sign = find_number_operator(call.name);
        sign != nullptr && call.arguments.size() == 2) {
      return combined(call, *sign);
    }
    if (call.name == ":") {
      return {Variable::Kind::factor,
              {},
              crossed({factor(call.arguments[0]).factor, factor(call.arguments[1]).factor}, ":")};
    }
    refuse_call(call);
  }

  Variable call_of_one(const Expression& call, const Expression& only) {
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
      if (call.name == "-") {
        std::transform(x.begin(), x.end(), x.begin(), std::negate<>());
      }
      return {Variable::Kind::number, std::move(x), {}};
    }
    if (const auto* const function = find_number_function(call.name)) {
      return applied(call, *function);
    }
    refuse_call(call);
  }

  [[noreturn]] static void refuse_call(const Expression& call) {
    if (find_number_function(call.name) != nullptr || call.name == "scale" ||
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
      name_levels(factors[k], to_string(call.arguments[k]));
    }
    return {Variable::Kind::factor, {}, crossed(factors, ", ")};
  }

  Variable applied(const Expression& call, const NumberFunction& function) {
    if (call.name == "I") {
      return value(call.arguments.front());
    }
    std::vector<double> x = numbers(call.arguments.front(), call);
    std::transform(x.begin(), x.end(), x.begin(), function.value);
    return {Variable::Kind::number, std::move(x), {}};
  }

  Variable scaled(const Expression& call) {
    std::vector<double> x = numbers(call.arguments.front(), call);
    const std::span<const double> learned(x.data(), table_.learned > 0 ? table_.learned : x.size());
    double sum = 0.0;
    double known = 0.0;
    for (const double one : learned) {
      sum += std::isnan(one) ? 0.0 : one;
      known += std::isnan(one) ? 0.0 : 1.0;
    }
    const double mean = sum / known;
    double squares = 0.0;
    for (const double one : learned) {
      squares += std::isnan(one) ? 0.0 : (one - mean) * (one - mean);
    }
    const double sd = std::sqrt(squares / (known - 1.0));
    for (double& one : x) {
      one = (one - mean) / sd;
    }
    return {Variable::Kind::number, std::move(x), {}};
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
    return compared_with_text(call, factor(subject).factor, text, table_);
  }

  Variable combined(const Expression& call, const NumberOperator& sign) {
    const Expression& left = call.arguments[0];
    const Expression& right = call.arguments[1];
    if (right.kind == Expression::Kind::text) {
      return compared(call, left, right.name);
    }
    if (sign.is_comparison) {
      require_known_word(call, table_);
    }
    std::vector<double> a = numbers(left, call);
    const std::vector<double> b = numbers(right, call);
    for (std::size_t row = 0; row < a.size(); ++row) {
      const bool missing = std::isnan(a[row]) || std::isnan(b[row]);
      a[row] = missing ? table::kNaN : sign.value(a[row], b[row]);
    }
    return {sign.is_comparison ? Variable::Kind::truth : Variable::Kind::number, std::move(a), {}};
  }

  const table::DataTable& table_;
  References references_;
};

}  // namespace

const table::DataColumn& named_column(const table::DataTable& table, const std::string& name) {
  const table::DataColumn* const found = table.find(name);
  if (found == nullptr) {
    const auto nearest = table::nearest_name(name, table.header);
    throw FormulaError("no column '" + name + "' in " + table.file +
                       (nearest ? "; did you mean '" + *nearest + "'?" : ""));
  }
  return *found;
}

Variable evaluate(const Expression& expression,
                  const table::DataTable& table,
                  const References& references) {
  return Evaluation(table, references).value(expression);
}

table::Factor evaluate_factor(const Expression& expression, const table::DataTable& table) {
  const Expression as_factor{Expression::Kind::call, 0.0, "factor", {expression}};
  return evaluate(as_factor, table).factor;
}

}  // namespace tcert::statistics
