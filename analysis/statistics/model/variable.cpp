#include <statistics/model/variable.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <statistics/model/basis_functions.hpp>
#include <statistics/model/call_arguments.hpp>
#include <statistics/model/cut_into.hpp>
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
    if (variable.kind == Variable::Kind::basis) {
      throw FormulaError("'" + to_string(expression) +
                         "' has several columns; it stands by itself");
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
    if (call.name == "ns" || call.name == "poly") {
      return basis(call);
    }
    if (call.name == "cut") {
      return cut_factor(call);
    }
    if (call.name == "ifelse") {
      return chosen(call);
    }
    if (call.name == "pmin" || call.name == "pmax") {
      return extreme(call);
    }
    if (call.name == "%in%") {
      return contained(call);
    }
    if ((call.name == "&" || call.name == "|") && call.arguments.size() == 2) {
      return joined_truth(call);
    }
    if (call.name == "!" && call.arguments.size() == 1) {
      return negated(call);
    }
    if (call.name == "log" && call.arguments.size() == 2) {
      return log_to_base(call);
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

  /// What only the rows of the fit may teach, and known ones alone.
  [[nodiscard]] std::vector<double> learned(const std::vector<double>& x) const {
    std::vector<double> known;
    for (std::size_t row = 0; row < (table_.learned > 0 ? table_.learned : x.size()); ++row) {
      if (!std::isnan(x[row])) {
        known.push_back(x[row]);
      }
    }
    return known;
  }

  Variable basis(const Expression& call) {
    const CallArguments arguments(call,
                                  call.name == "ns"
                                      ? std::vector<std::string>{"x", "df", "knots"}
                                      : std::vector<std::string>{"x", "degree", "raw"});
    const std::vector<double> x = numbers(arguments.required("x"), call);
    const std::vector<double> known = learned(x);
    std::vector<std::vector<double>> columns;
    if (call.name == "ns") {
      const NaturalSpline spline(
          known, arguments.whole("df"), arguments.numbers("knots"), to_string(call));
      columns = spline.columns(x);
    } else {
      const auto degree = arguments.whole("degree").value_or(1);
      columns = arguments.truth("raw", false)
                    ? powers(x, degree, to_string(call))
                    : orthogonal_powers(known, x, degree, to_string(call));
    }
    Variable variable{Variable::Kind::basis, columns.front(), {}};
    variable.basis = std::move(columns);
    return variable;
  }

  Variable cut_factor(const Expression& call) {
    const CallArguments arguments(call, {"x", "breaks", "labels", "include.lowest", "right"});
    const std::vector<double> x = numbers(arguments.required("x"), call);
    return {Variable::Kind::factor,
            {},
            cut_into(x,
                     learned(x),
                     arguments.numbers("breaks"),
                     arguments.texts("labels"),
                     arguments.truth("include.lowest", false),
                     arguments.truth("right", true),
                     to_string(call))};
  }

  Variable chosen(const Expression& call) {
    const CallArguments arguments(call, {"test", "yes", "no"});
    const std::vector<double> test = numbers(arguments.required("test"), call);
    const Expression& yes = arguments.required("yes");
    const Expression& no = arguments.required("no");
    if (yes.kind == Expression::Kind::text && no.kind == Expression::Kind::text) {
      table::Factor factor;
      const std::string& first = std::min(yes.name, no.name);
      const std::string& last = std::max(yes.name, no.name);
      for (const double one : test) {
        factor.codes.push_back(std::isnan(one) ? table::Factor::kMissing
                               : (one != 0.0 ? yes.name : no.name) == first ? 0U
                                                                            : 1U);
      }
      factor.levels =
          first == last ? std::vector<std::string>{first} : std::vector<std::string>{first, last};
      return {Variable::Kind::factor, {}, std::move(factor)};
    }
    std::vector<double> x = numbers(yes, call);
    const std::vector<double> other = numbers(no, call);
    for (std::size_t row = 0; row < x.size(); ++row) {
      x[row] = std::isnan(test[row]) ? table::kNaN : test[row] != 0.0 ? x[row] : other[row];
    }
    return {Variable::Kind::number, std::move(x), {}};
  }

  Variable extreme(const Expression& call) {
    if (call.arguments.size() < 2) {
      throw FormulaError("'" + to_string(call) + "': " + call.name +
                         "() takes two arguments or more");
    }
    std::vector<double> x = numbers(call.arguments.front(), call);
    for (std::size_t k = 1; k < call.arguments.size(); ++k) {
      const std::vector<double> other = numbers(call.arguments[k], call);
      for (std::size_t row = 0; row < x.size(); ++row) {
        const bool missing = std::isnan(x[row]) || std::isnan(other[row]);
        const bool takes = call.name == "pmin" ? other[row] < x[row] : other[row] > x[row];
        x[row] = missing ? table::kNaN : takes ? other[row] : x[row];
      }
    }
    return {Variable::Kind::number, std::move(x), {}};
  }

  /// Missing is in no list, as in R.
  Variable contained(const Expression& call) {
    const Expression& list = call.arguments[1];
    const std::vector<Expression> members =
        list.is_call("c") ? list.arguments : std::vector<Expression>{list};
    const Variable what = Evaluation(table_, {}).value(call.arguments[0]);
    std::vector<double> x(table_.rows, 0.0);
    for (const Expression& member : members) {
      const bool is_text = member.kind == Expression::Kind::text;
      if (is_text != (what.kind == Variable::Kind::factor) || (!is_text && !constant_of(member))) {
        throw FormulaError("'" + to_string(call) + "': %in% takes c() of " +
                           (what.kind == Variable::Kind::factor ? "texts" : "numbers"));
      }
      for (std::size_t row = 0; row < x.size(); ++row) {
        const bool same = is_text ? what.factor.codes[row] != table::Factor::kMissing &&
                                        what.factor.levels[what.factor.codes[row]] == member.name
                                  : what.numbers[row] == *constant_of(member);
        x[row] = same ? 1.0 : x[row];
      }
    }
    return {Variable::Kind::truth, std::move(x), {}};
  }

  /// R's three values: FALSE & NA is FALSE, TRUE | NA is TRUE.
  Variable joined_truth(const Expression& call) {
    const double decides = call.name == "&" ? 0.0 : 1.0;
    std::vector<double> a = numbers(call.arguments[0], call);
    const std::vector<double> b = numbers(call.arguments[1], call);
    for (std::size_t row = 0; row < a.size(); ++row) {
      const auto truth = [](double x) { return std::isnan(x) ? x : x != 0.0 ? 1.0 : 0.0; };
      const double left = truth(a[row]);
      const double right = truth(b[row]);
      a[row] = left == decides || right == decides     ? decides
               : std::isnan(left) || std::isnan(right) ? table::kNaN
                                                       : 1.0 - decides;
    }
    return {Variable::Kind::truth, std::move(a), {}};
  }

  Variable negated(const Expression& call) {
    std::vector<double> x = numbers(call.arguments.front(), call);
    for (double& one : x) {
      one = std::isnan(one) ? one : one == 0.0 ? 1.0 : 0.0;
    }
    return {Variable::Kind::truth, std::move(x), {}};
  }

  Variable log_to_base(const Expression& call) {
    const CallArguments arguments(call, {"x", "base"});
    const std::optional<double> base = constant_of(arguments.required("base"));
    if (!base || !(*base > 0.0) || *base == 1.0) {
      throw FormulaError("'" + to_string(call) + "': the base is a number above 0, and not 1");
    }
    std::vector<double> x = numbers(arguments.required("x"), call);
    for (double& one : x) {
      one = *base == 2.0    ? std::log2(one)
            : *base == 10.0 ? std::log10(one)
                            : std::log(one) / std::log(*base);
    }
    return {Variable::Kind::number, std::move(x), {}};
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
                         (call.name == "log" ? ", or log(x, base = 2)" : ""));
    }
    throw FormulaError(
        "'" + to_string(call) +
        "' is not known here; known: log, log2, log10, log1p, exp, sqrt, sin, cos, tan, abs, "
        "pmin, pmax, ifelse, cut, ns, poly, I, scale, factor, as.numeric, arithmetic, "
        "comparisons, & | ! and %in%");
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
