#pragma once
/// \file
/// The columns of a table, each declared once: its name, heading, unit and kind, and the value that
/// a row has in it.
///
///     ColumnsOf<Trial> columns;
///     columns.text("trial_id", "trial", &Trial::id)
///         .fixed("time_s", "time", "s", 1, &Trial::time_s)
///         .yes_or_no("fast", "fast", [](auto& trial) { return trial.time_s < 60.0; });
///     Table table = columns.table("trials", "The trials", trials);
///
/// A value that is not there is an empty optional. A column that is not always there is added
/// behind an `if`.

#include <functional>
#include <optional>
#include <statistics/basics/interval.hpp>
#include <string>
#include <utility>
#include <vector>

#include "reports/column_doc.hpp"
#include "reports/fit/cells.hpp"
#include "reports/table.hpp"

namespace tcert {

/// What a column of estimates takes: whatever has an interval and a value, ratio or estimate.
struct Estimated {
  std::optional<double> value;
  std::optional<statistics::Interval> interval;

  Estimated(const std::optional<double>& v, const std::optional<statistics::Interval>& i)
      : value(v), interval(i) {}
  template <class Score>
  requires requires(const Score& score) { score.interval; }
  Estimated(const Score& score) : interval(score.interval) {
    if constexpr (requires { score.value; }) {
      value = score.value;
    } else if constexpr (requires { score.ratio; }) {
      value = score.ratio;
    } else {
      value = score.estimate;
    }
  }
};

[[nodiscard]] inline TableCell cell_of(const Estimated& estimated) {
  return estimate_cell(estimated.value, estimated.interval);
}

/// A row of a table that says more of something than it has: what points to a member of either is
/// a value.
template <class Of>
struct RowOf {
  const Of& of;

  const Of& operator*() const noexcept { return of; }
};

template <class Row>
class ColumnsOf {
 public:
  /// How a row gives a value: a lambda, or a pointer to a member of the row or of what it points
  /// to.
  template <class Value>
  using Get = std::function<Value(const Row&)>;

  ColumnsOf& add(Column column, Get<TableCell> cell) {
    columns_.push_back({std::move(column), std::move(cell), ""});
    return *this;
  }
  ColumnsOf& text(std::string name, std::string heading, Get<std::optional<std::string>> value) {
    return add(text_column(std::move(name), std::move(heading)), with(text_cell, value));
  }
  ColumnsOf& integer(std::string name,
                     std::string heading,
                     Get<std::optional<std::int64_t>> value) {
    return add(integer_column(std::move(name), std::move(heading)), with(integer_cell, value));
  }
  ColumnsOf& integer(std::string name,
                     std::string heading,
                     std::string unit,
                     Get<std::optional<std::int64_t>> value) {
    integer(std::move(name), std::move(heading), std::move(value));
    columns_.back().column.unit = std::move(unit);
    return *this;
  }
  ColumnsOf& number(std::string name, std::string heading, Get<std::optional<double>> value) {
    return add(number_column(std::move(name), std::move(heading)), with(number_cell, value));
  }
  ColumnsOf& time(std::string name, std::string heading, Get<std::optional<double>> value) {
    return add(time_column(std::move(name), std::move(heading)), with(number_cell, value));
  }
  ColumnsOf& fixed(std::string name,
                   std::string heading,
                   std::string unit,
                   int decimals,
                   Get<std::optional<double>> value) {
    return add(fixed_column(std::move(name), std::move(heading), std::move(unit), decimals),
               with(number_cell, value));
  }
  ColumnsOf& fixed(std::string name, std::string heading, Get<std::optional<double>> value) {
    return add(fixed_column(std::move(name), std::move(heading)), with(number_cell, value));
  }
  ColumnsOf& estimate(
      std::string name, std::string heading, std::string unit, int decimals, Get<Estimated> value) {
    return add(estimate_column(std::move(name), std::move(heading), std::move(unit), decimals),
               with(cell_of, value));
  }
  ColumnsOf& estimate(std::string name, std::string heading, Get<Estimated> value) {
    return add(estimate_column(std::move(name), std::move(heading)), with(cell_of, value));
  }
  ColumnsOf& p(std::string name, std::string heading, Get<std::optional<double>> value) {
    return add(p_column(std::move(name), std::move(heading)), with(p_cell, value));
  }
  ColumnsOf& yes_or_no(std::string name, std::string heading, Get<std::optional<bool>> value) {
    return add(text_column(std::move(name), std::move(heading)), with(yes_or_no_cell, value));
  }
  /// Two columns of numbers: both ends of an interval.
  ColumnsOf& ends(std::pair<std::string, std::string> low,
                  std::pair<std::string, std::string> high,
                  Get<std::optional<statistics::Interval>> interval) {
    add(number_column(std::move(low.first), std::move(low.second)), with(low_cell, interval));
    return add(number_column(std::move(high.first), std::move(high.second)),
               with(high_cell, interval));
  }
  /// The columns of a part of the row, missing where it has none: `find` gives a pointer to the
  /// part, or an optional.
  template <class Part, class Find>
  ColumnsOf& part(const ColumnsOf<Part>& columns, Find find) {
    for (const auto& one : columns.all()) {
      columns_.push_back({one.column,
                          [find, cell = one.cell](const Row& row) {
                            const auto& found = std::invoke(find, row);
                            return found ? cell(*found) : TableCell{};
                          },
                          one.doc});
    }
    return *this;
  }
  /// What the last column means: one line, no full stop.
  ColumnsOf& doc(std::string text) {
    columns_.back().doc = std::move(text);
    return *this;
  }
  /// Digits that people see of the last column.
  ColumnsOf& significant(int digits) {
    columns_.back().column.significant = digits;
    return *this;
  }

  [[nodiscard]] std::vector<TableCell> row(const Row& row) const {
    std::vector<TableCell> cells;
    cells.reserve(columns_.size());
    for (const One& one : columns_) {
      cells.push_back(one.cell(row));
    }
    return cells;
  }
  template <class Rows = std::vector<Row>>
  [[nodiscard]] Table table(std::string name, std::string title, const Rows& rows = {}) const {
    Table table;
    table.name = std::move(name);
    table.title = std::move(title);
    append_to(table.columns);
    for (const auto& one : rows) {
      table.add_row(row(one));
    }
    return table;
  }
  void append_to(std::vector<Column>& columns) const {
    for (const One& one : columns_) {
      columns.push_back(one.column);
    }
  }
  [[nodiscard]] std::vector<ColumnDoc> docs() const {
    std::vector<ColumnDoc> docs;
    for (const One& one : columns_) {
      docs.push_back({one.column.name, one.column.unit, one.doc});
    }
    return docs;
  }

  struct One {
    Column column;
    Get<TableCell> cell;
    std::string doc;
  };
  [[nodiscard]] const std::vector<One>& all() const noexcept { return columns_; }

 private:
  template <class Cell, class Value>
  static Get<TableCell> with(Cell* cell, const Get<Value>& value) {
    return [cell, value](const Row& row) { return cell(value(row)); };
  }

  std::vector<One> columns_;
};

}  // namespace tcert
