#include <statistics/model/model_frame.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <statistics/model/design_matrix.hpp>
#include <statistics/model/factor_levels.hpp>
#include <statistics/model/frame_checks.hpp>
#include <statistics/model/outcome_coding.hpp>
#include <statistics/model/stray_text.hpp>
#include <table/cell_reading.hpp>

namespace tcert::statistics {
namespace {

constexpr std::size_t kMostGroups = 1000;  ///< A curve each; a test is cubic in their number.

/// The column in which an expression of names has them: x, (x) and I(x) of x.
const Expression& inside(const Expression& expression) {
  const bool wraps =
      (expression.is_call("(") || expression.is_call("I")) && expression.arguments.size() == 1;
  return wraps ? inside(expression.arguments.front()) : expression;
}

/// Everything that the formula and the options name, evaluated on all rows of the table.
class FrameBuilder {
 public:
  FrameBuilder(const Formula& formula, const table::DataTable& table, const FrameOptions& options)
      : formula_(formula), table_(table), options_(options) {}

  ModelFrame build() {
    frame_.formula = formula_.text;
    frame_.response = to_string(formula_.response);
    evaluate_all();
    find_complete_rows();
    take_outcome();
    take_right_side();
    take_the_rest();
    return std::move(frame_);
  }

 private:
  struct Used {
    std::string name;
    Variable value;
  };

  const Variable& use(std::vector<Used>& list, const Expression& expression) {
    list.push_back({to_string(expression), evaluate(expression, table_, options_.reference)});
    return list.back().value;
  }

  void use_variable(const Expression& expression, std::vector<NamedVariable>& list) {
    const bool known = std::any_of(list.begin(), list.end(), [&](const NamedVariable& one) {
      return one.expression == expression;
    });
    if (!known) {
      refuse_stray_text(expression);
      list.push_back({expression, evaluate(expression, table_, options_.reference)});
    }
  }

  void use_numbers(std::vector<Used>& list, const Expression& expression) {
    if (use(list, expression).kind == Variable::Kind::factor) {
      throw FormulaError(not_numbers(table_, list.back().name));
    }
  }

  void use_column(std::vector<Used>& list, const std::string& column) {
    if (!column.empty()) {
      use_factor(list, {Expression::Kind::column, 0.0, column, {}});
    }
  }

  void use_factor(std::vector<Used>& list, const Expression& expression) {
    refuse_missing_words(table_, text_column(expression));
    list.push_back(
        {to_string(expression), {Variable::Kind::factor, {}, evaluate_factor(expression, table_)}});
  }

  [[nodiscard]] const table::DataColumn* text_column(const Expression& expression) const {
    const Expression& name = inside(expression);
    const table::DataColumn* const column =
        name.kind == Expression::Kind::column ? table_.find(name.name) : nullptr;
    return column != nullptr && column->is_text ? column : nullptr;
  }

  /// Stray texts would otherwise make a factor of a column of numbers.
  void refuse_stray_text(const Expression& expression) const {
    if (options_.right_side == RightSide::groups) {
      refuse_missing_words(table_, text_column(expression));
      return;
    }
    const table::DataColumn* const column = text_column(expression);
    if (column != nullptr && column->mixed.is_spoiled()) {
      throw FormulaError(stray_cell(table_, *column) + "; write factor(" + column->name +
                         ") if it is a name");
    }
  }

  void evaluate_all() {
    const Expression& response = formula_.response;
    const bool composed = response.is_call("Surv") || response.is_call("cbind");
    if (composed) {
      for (const Expression& argument : response.arguments) {
        // Of times, counts and a status only the status may be a factor.
        if (response.is_call("Surv") && &argument == &response.arguments.back()) {
          use(outcome_, argument);
        } else {
          use_numbers(outcome_, argument);
        }
      }
    } else {
      use(outcome_, response);
    }
    for (const Term& term : formula_.terms) {
      for (const Expression& expression : term.variables) {
        use_variable(expression, right_);
      }
    }
    for (const Expression& offset : formula_.offsets) {
      use_numbers(offsets_, offset);
    }
    for (const Expression& strata : formula_.strata) {
      strata_are_text_ =
          strata_are_text_ && evaluate(strata, table_).kind == Variable::Kind::factor;
      use_factor(strata_, strata);
    }
    use_column(strata_, options_.strata);
    if (formula_.clusters.size() + (options_.cluster.empty() ? 0 : 1) > 1) {
      throw FormulaError("formula '" + formula_.text + "': one cluster at the most");
    }
    for (const Expression& cluster : formula_.clusters) {
      use_factor(clusters_, cluster);
    }
    use_column(clusters_, options_.cluster);
    for (const RandomTerm& random : formula_.random_terms) {
      use_factor(groups_, random.group);
      for (const Expression& expression : random.variables()) {
        use_variable(expression, slopes_);
      }
    }
    if (!options_.weights.empty()) {
      use_numbers(weights_, {Expression::Kind::column, 0.0, options_.weights, {}});
    }
  }

  void mark(const std::string& name, const Variable& value, std::vector<bool>& complete) {
    std::size_t missing = 0;
    for (std::size_t row = 0; row < table_.rows; ++row) {
      if (value.is_missing(row)) {
        complete[row] = false;
        ++missing;
      }
    }
    if (missing > 0) {
      frame_.missing.emplace_back(name, missing);
    }
  }

  /// Infinity times 0 within a term is missing.
  void mark_undefined_products(std::vector<bool>& complete) {
    const bool has_products =
        std::any_of(formula_.terms.begin(), formula_.terms.end(), [](const Term& term) {
          return term.variables.size() > 1;
        });
    const bool has_infinity =
        std::any_of(right_.begin(), right_.end(), [](const NamedVariable& variable) {
          const std::vector<double>& x = variable.value.numbers;
          return std::any_of(x.begin(), x.end(), [](double one) { return std::isinf(one); });
        });
    if (!has_products || !has_infinity) {
      return;
    }
    const DesignMatrix design = design_matrix(formula_, right_, table_.rows);
    for (std::size_t t = 0; t < formula_.terms.size(); ++t) {
      std::size_t undefined = 0;
      for (std::size_t row = 0; row < table_.rows; ++row) {
        bool is_undefined = false;
        for (std::size_t k = 0; complete[row] && k < design.term_of.size(); ++k) {
          is_undefined = is_undefined || (design.term_of[k] == t + 1 &&
                                          std::isnan(design.values(static_cast<Eigen::Index>(row),
                                                                   static_cast<Eigen::Index>(k))));
        }
        if (is_undefined) {
          complete[row] = false;
          ++undefined;
        }
      }
      if (undefined > 0) {
        frame_.missing.emplace_back(formula_.terms[t].name(), undefined);
      }
    }
  }

  void find_complete_rows() {
    std::vector<bool> complete(table_.rows, true);
    for (const auto* list : {&outcome_, &offsets_, &strata_, &clusters_, &groups_, &weights_}) {
      for (const Used& used : *list) {
        mark(used.name, used.value, complete);
      }
    }
    for (const NamedVariable& variable : right_) {
      // Those of strata() are marked one by one.
      if (!variable.expression.is_call("strata")) {
        mark(to_string(variable.expression), variable.value, complete);
      }
    }
    for (const NamedVariable& variable : slopes_) {
      mark(to_string(variable.expression), variable.value, complete);
    }
    if (options_.allow_infinite && options_.right_side == RightSide::design) {
      mark_undefined_products(complete);
    }
    for (std::size_t row = 0; row < table_.rows; ++row) {
      if (complete[row]) {
        frame_.rows.push_back(row);
        if (!table_.lines.empty()) {
          frame_.lines.push_back(table_.lines[row]);
        }
      }
    }
    frame_.dropped = table_.rows - frame_.rows.size();
    add_missing_conditions(frame_);
  }

  [[nodiscard]] std::vector<double> kept(const Variable& value) const {
    std::vector<double> numbers;
    numbers.reserve(frame_.rows.size());
    for (const std::size_t row : frame_.rows) {
      numbers.push_back(value.numbers[row]);
    }
    return numbers;
  }

  /// A factor of two levels as 0 and 1: by the levels of the whole column, so that the rows that
  /// happen to be complete do not turn it over.
  /// Words that everybody writes for an outcome mean what they say, whatever their order.
  [[nodiscard]] std::vector<double> kept_outcome(const Used& used, const Expression& expression) {
    if (used.value.kind != Variable::Kind::factor) {
      return kept(used.value);
    }
    const table::Factor& factor = used.value.factor;
    const bool has_order = text_column(expression) == nullptr ||
                           options_.reference.contains(text_column(expression)->name);
    if (const auto coding = has_order ? std::nullopt : coded_by_words(factor)) {
      return kept_coding(*coding);
    }
    refuse_bad_outcome(used, expression);
    std::vector<double> codes;
    codes.reserve(frame_.rows.size());
    for (const std::size_t row : frame_.rows) {
      codes.push_back(factor.codes[row]);
    }
    frame_.outcome_levels = on_rows(factor, frame_.rows).levels;
    return codes;
  }

  [[nodiscard]] std::vector<double> kept_coding(const OutcomeCoding& coding) {
    std::vector<double> codes;
    codes.reserve(frame_.rows.size());
    for (const std::size_t row : frame_.rows) {
      codes.push_back(coding.values[row]);
    }
    if (!coding.failure.empty() && !coding.success.empty()) {
      frame_.outcome_levels = {coding.failure, coding.success};
    }
    return codes;
  }

  void refuse_bad_outcome(const Used& used, const Expression& expression) const {
    const table::Factor& factor = used.value.factor;
    const table::DataColumn* const column = text_column(expression);
    const bool is_spoiled = column != nullptr && column->mixed.is_spoiled();
    const std::string advice = "; an outcome has two: write " + used.name + " == \"" +
                               (factor.levels.empty() ? "" : factor.levels.back()) + "\"";
    if (is_spoiled) {
      throw FormulaError(stray_cell(table_, *column));
    }
    if (column != nullptr && column->mixed.missing_words > 0) {
      throw FormulaError("'" + used.name + "' of " + table_.file + " holds '" +
                         missing_word_of(factor) + "', which is no outcome; " +
                         std::string(table::kHowMissingIsWritten));
    }
    if (factor.levels.size() == 1 || factor.levels.size() > 2) {
      throw FormulaError("'" + used.name + "' has " + std::to_string(factor.levels.size()) +
                         (factor.levels.size() == 1 ? " level" : " levels") + advice);
    }
  }

  static std::string missing_word_of(const table::Factor& factor) {
    const auto found =
        std::find_if(factor.levels.begin(), factor.levels.end(), [](const std::string& level) {
          return table::read_cell(level).meaning == table::CellMeaning::missing_word;
        });
    return found == factor.levels.end() ? "" : *found;
  }

  void take_outcome() {
    const Expression& response = formula_.response;
    if (response.is_call("Surv")) {
      take_survival();
    } else if (response.is_call("cbind")) {
      if (outcome_.size() != 2) {
        throw FormulaError("'" + frame_.response + "': cbind(successes, failures)");
      }
      CountOutcome counts{kept(outcome_[0].value), kept(outcome_[1].value)};
      for (std::size_t i = 0; i < counts.trials.size(); ++i) {
        counts.trials[i] += counts.successes[i];
      }
      frame_.outcome = std::move(counts);
      check_counts(frame_);
    } else {
      NumberOutcome numbers{kept_outcome(outcome_[0], response)};
      check_finite(numbers.values, frame_.response, frame_);
      frame_.outcome = std::move(numbers);
    }
  }

  void take_survival() {
    if (outcome_.size() != 2 && outcome_.size() != 3) {
      throw FormulaError("'" + frame_.response +
                         "': Surv(time, event) or Surv(start, stop, event)");
    }
    SurvivalOutcome survival;
    const Used& time = outcome_[outcome_.size() - 2];
    const Used& status = outcome_.back();
    survival.stop = kept(time.value);
    if (outcome_.size() == 3) {
      survival.start = kept(outcome_.front().value);
    }
    const std::vector<double> events = kept_outcome(status, formula_.response.arguments.back());
    check_binary(events, status.name, frame_);
    survival.event.reserve(events.size());
    for (const double event : events) {
      survival.event.push_back(event == 1.0 ? 1 : 0);
    }
    check_times(survival, time.name, frame_);
    if (!has_error(frame_.conditions)) {
      round_and_check_times(survival, time.name, options_.round_times, frame_);
    }
    frame_.outcome = std::move(survival);
  }

  void keep_rows(std::vector<NamedVariable>& variables) {
    for (NamedVariable& variable : variables) {
      Variable& value = variable.value;
      if (value.kind == Variable::Kind::factor) {
        value.factor = on_rows(value.factor, frame_.rows);
      } else {
        value.numbers = kept(value);
        const std::string name = to_string(variable.expression);
        const bool said = std::any_of(frame_.conditions.begin(),
                                      frame_.conditions.end(),
                                      [&](const Condition& one) { return one.column == name; });
        if (!options_.allow_infinite && !said) {
          check_finite(value.numbers, name, frame_);
        }
      }
    }
  }

  void take_right_side() {
    keep_rows(right_);
    for (const Term& term : formula_.terms) {
      frame_.terms.push_back(term.name());
    }
    if (options_.right_side == RightSide::groups) {
      take_groups();
      return;
    }
    DesignMatrix design = design_within_strata();
    frame_.design = std::move(design.values);
    frame_.columns = std::move(design.columns);
    frame_.term_of = std::move(design.term_of);
  }

  /// Products with strata() are coded as if its own effects were in the model; these have no
  /// columns, as in coxph().
  [[nodiscard]] DesignMatrix design_within_strata() const {
    if (!has_products_with_strata()) {
      return design_matrix(formula_, right_, frame_.rows.size());
    }
    Formula whole = formula_;
    std::copy_if(formula_.strata_effects.begin(),
                 formula_.strata_effects.end(),
                 std::back_inserter(whole.terms),
                 [&](const Term& effect) { return is_on_the_right(effect.variables.front()); });
    const DesignMatrix all = design_matrix(whole, right_, frame_.rows.size());
    DesignMatrix design;
    std::vector<Eigen::Index> kept;
    for (std::size_t k = 0; k < all.columns.size(); ++k) {
      if (all.term_of[k] <= formula_.terms.size()) {
        kept.push_back(static_cast<Eigen::Index>(k));
        design.columns.push_back(all.columns[k]);
        design.term_of.push_back(all.term_of[k]);
      }
    }
    design.values = all.values(Eigen::all, kept);
    return design;
  }

  [[nodiscard]] bool is_on_the_right(const Expression& expression) const {
    return std::any_of(right_.begin(), right_.end(), [&](const NamedVariable& variable) {
      return variable.expression == expression;
    });
  }

  [[nodiscard]] bool has_products_with_strata() const {
    return std::any_of(right_.begin(), right_.end(), [](const NamedVariable& variable) {
      return variable.expression.is_call("strata");
    });
  }

  void take_groups() {
    if (has_products_with_strata()) {
      throw FormulaError("formula '" + formula_.text +
                         "': a product with strata() is for cox; here write + strata()");
    }
    std::vector<table::Factor> factors;
    for (const NamedVariable& variable : right_) {
      factors.push_back(evaluate_factor(variable.expression, table_));
      name_levels(factors.back(), to_string(variable.expression));
    }
    if (factors.empty()) {
      frame_.groups = table::Factor{std::vector<std::uint32_t>(frame_.rows.size(), 0), {"all"}};
    } else {
      frame_.groups = on_rows(crossed(factors, ", "), frame_.rows);
    }
    if (frame_.groups->levels.size() > kMostGroups) {
      throw FormulaError(
          "formula '" + formula_.text + "': " + std::to_string(frame_.groups->levels.size()) +
          " groups to compare, at most " + std::to_string(kMostGroups) + "; did you mean cox?");
    }
  }

  static void name_levels(table::Factor& factor, const std::string& name) {
    for (std::string& level : factor.levels) {
      level.insert(0, name + "=");
    }
  }

  void take_strata() {
    if (strata_.empty()) {
      return;
    }
    std::vector<table::Factor> factors;
    for (const Used& used : strata_) {
      factors.push_back(used.value.factor);
      if (!strata_are_text_ || strata_.size() > 1) {
        name_levels(factors.back(), used.name);
      }
    }
    frame_.strata = on_rows(crossed(factors, ", "), frame_.rows);
  }

  void take_random_effects() {
    keep_rows(slopes_);
    for (std::size_t k = 0; k < groups_.size(); ++k) {
      Formula effects;
      effects.intercept = formula_.random_terms[k].intercept;
      effects.terms = formula_.random_terms[k].terms;
      DesignMatrix design = design_matrix(effects, slopes_, frame_.rows.size());
      frame_.random_effects.push_back({groups_[k].name,
                                       on_rows(groups_[k].value.factor, frame_.rows),
                                       std::move(design.values),
                                       std::move(design.columns)});
    }
  }

  void take_the_rest() {
    take_strata();
    if (!clusters_.empty()) {
      frame_.cluster = on_rows(clusters_.front().value.factor, frame_.rows);
    }
    take_random_effects();
    for (const Used& offset : offsets_) {
      const std::vector<double> values = kept(offset.value);
      check_finite(values, offset.name, frame_);
      const Eigen::Map<const Eigen::VectorXd> column(values.data(),
                                                     static_cast<Eigen::Index>(values.size()));
      frame_.offset = frame_.offset ? Eigen::VectorXd(*frame_.offset + column) : column;
    }
    if (!weights_.empty()) {
      const std::vector<double> values = kept(weights_.front().value);
      check_weights(values, weights_.front().name, frame_);
      frame_.weights = Eigen::Map<const Eigen::VectorXd>(values.data(),
                                                         static_cast<Eigen::Index>(values.size()));
    }
  }

  const Formula& formula_;
  const table::DataTable& table_;
  const FrameOptions& options_;
  ModelFrame frame_;
  std::vector<Used> outcome_, offsets_, strata_, clusters_, groups_, weights_;
  std::vector<NamedVariable> right_, slopes_;
  bool strata_are_text_ = true;
};

void add_column(std::vector<std::string>& columns, const std::string& name) {
  if (!name.empty() && std::find(columns.begin(), columns.end(), name) == columns.end()) {
    columns.push_back(name);
  }
}

}  // namespace

ModelFrame model_frame(const Formula& formula,
                       const table::DataTable& table,
                       const FrameOptions& options) {
  return FrameBuilder(formula, table, options).build();
}

std::vector<std::string> columns_of(const Formula& formula, const FrameOptions& options) {
  std::vector<std::string> columns = formula.columns();
  add_column(columns, options.weights);
  add_column(columns, options.cluster);
  add_column(columns, options.strata);
  return columns;
}

void require_binary(ModelFrame& frame) {
  if (std::holds_alternative<SurvivalOutcome>(frame.outcome)) {
    throw FormulaError("'" + frame.response + "': needs an outcome of 0 and 1, not Surv()");
  }
  const auto* const numbers = std::get_if<NumberOutcome>(&frame.outcome);
  if (numbers == nullptr) {
    return;
  }
  check_binary(numbers->values, frame.response, frame);
  CountOutcome counts;
  counts.successes = numbers->values;
  counts.trials.assign(counts.successes.size(), 1.0);
  frame.outcome = std::move(counts);
}

}  // namespace tcert::statistics
