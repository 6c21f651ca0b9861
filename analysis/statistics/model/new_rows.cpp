#include <statistics/model/new_rows.hpp>

#include <algorithm>
#include <statistics/model/variable.hpp>

namespace tcert::statistics {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

[[noreturn]] void refuse_level(const std::string& level,
                               const table::DataColumn& column,
                               const table::DataTable& others) {
  throw FormulaError("column '" + column.name + "' of " + others.file + ": the fit has not seen '" +
                     level + "'");
}

/// Appends the codes of texts among levels that are there.
void append_texts(const table::DataColumn& from,
                  const table::DataTable& others,
                  table::DataColumn& to) {
  std::vector<bool> seen(to.text.levels.size(), false);
  for (const std::uint32_t code : to.text.codes) {
    if (code != table::Factor::kMissing) {
      seen[code] = true;
    }
  }
  std::vector<std::uint32_t> code_of;
  for (const std::string& level : from.text.levels) {
    const auto found = std::find(to.text.levels.begin(), to.text.levels.end(), level);
    const auto code = static_cast<std::size_t>(found - to.text.levels.begin());
    if (found == to.text.levels.end() || !seen[code]) {
      refuse_level(level, to, others);
    }
    code_of.push_back(static_cast<std::uint32_t>(code));
  }
  for (const std::uint32_t code : from.text.codes) {
    to.text.codes.push_back(code == table::Factor::kMissing ? code : code_of[code]);
  }
}

/// Appends the new rows of a column that they have.
void append(const table::DataColumn& from, const table::DataTable& others, table::DataColumn& to) {
  const bool all_missing =
      !from.is_text &&
      std::all_of(from.numbers.begin(), from.numbers.end(), [](double one) { return one != one; });
  if (all_missing) {
    if (to.is_text) {
      to.text.codes.insert(to.text.codes.end(), others.rows, table::Factor::kMissing);
    } else {
      to.numbers.insert(to.numbers.end(), from.numbers.begin(), from.numbers.end());
    }
    return;
  }
  if (from.is_text != to.is_text) {
    throw FormulaError(
        "column '" + to.name + "' of " + others.file + " holds " +
        (from.is_text ? "text, where the fit had numbers" : "numbers, where the fit had text"));
  }
  if (to.is_text) {
    append_texts(from, others, to);
  } else {
    to.numbers.insert(to.numbers.end(), from.numbers.begin(), from.numbers.end());
  }
}

/// Appends what makes the new rows complete in a column of the outcome, the cluster or the weights.
void append_filling(std::size_t count, std::size_t model, table::DataColumn& to) {
  if (to.is_text) {
    to.text.codes.insert(to.text.codes.end(), count, to.text.codes[model]);
  } else {
    to.numbers.insert(to.numbers.end(), count, to.numbers[model]);
  }
}

}  // namespace

std::vector<std::string> columns_to_predict(const Formula& formula, const FrameOptions& options) {
  Formula right = formula;
  right.response = {Expression::Kind::number, 1.0, "", {}};
  right.clusters.clear();
  std::vector<std::string> columns = right.columns();
  if (!options.strata.empty() && !contains(columns, options.strata)) {
    columns.push_back(options.strata);
  }
  return columns;
}

NewRows new_rows(const Formula& formula,
                 const table::DataTable& table,
                 const ModelFrame& fitted,
                 const table::DataTable& others,
                 const FrameOptions& options) {
  const std::vector<std::string> needed = columns_to_predict(formula, options);
  table::DataTable both = table;
  both.rows = table.rows + others.rows;
  both.lines.clear();
  both.learned = table.learned > 0 ? table.learned : table.rows;
  for (table::DataColumn& column : both.columns) {
    if (contains(needed, column.name)) {
      append(named_column(others, column.name), others, column);
    } else {
      append_filling(others.rows, fitted.rows.front(), column);
    }
  }
  const ModelFrame frame = model_frame(formula, both, options);
  if (frame.columns != fitted.columns) {
    for (const std::string& column : frame.columns) {
      if (!contains(fitted.columns, column)) {
        throw FormulaError("'" + column + "' of " + others.file +
                           ": the fit has not seen this level");
      }
    }
    throw FormulaError(others.file + ": its rows change the columns of the fit");
  }
  NewRows result;
  std::vector<Eigen::Index> places;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (frame.rows[i] >= table.rows) {
      places.push_back(static_cast<Eigen::Index>(i));
      kept.push_back(i);
      result.rows.push_back(frame.rows[i] - table.rows);
    }
  }
  result.dropped = others.rows - result.rows.size();
  result.design = frame.design(places, Eigen::all);
  if (frame.offset) {
    result.offset = Eigen::VectorXd((*frame.offset)(places));
  }
  if (frame.strata) {
    result.strata.emplace();
    result.strata->levels = frame.strata->levels;
    for (const std::size_t place : kept) {
      result.strata->codes.push_back(frame.strata->codes[place]);
    }
  }
  return result;
}

}  // namespace tcert::statistics
