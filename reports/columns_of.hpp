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
#include <memory>
#include <optional>
#include <statistics/basics/interval.hpp>
#include <string>
#include <string_view>
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

/// A row of a table that says more of something than it has: what points to a member of either is
/// a value.
template <class Of>
struct RowOf {
  const Of& of;

  const Of& operator*() const noexcept { return of; }
};

/// What is the same whatever the rows are, compiled once.
class ColumnList {
 public:
  struct Cell {
    virtual ~Cell() = default;
    [[nodiscard]] virtual TableCell of(const void* row) const = 0;
  };
  struct One {
    Column column;
    std::shared_ptr<const Cell> cell;
    std::string doc;
  };
  [[nodiscard]] const std::vector<One>& all() const noexcept { return columns_; }
  [[nodiscard]] std::vector<ColumnDoc> docs() const;
  void append_to(std::vector<Column>& columns) const;

 protected:
  void push(Column column, std::unique_ptr<const Cell> cell, const std::string& doc = "");
  void push(Column (*column)(std::string name, std::string heading),
            std::string_view name,
            std::string_view heading,
            std::unique_ptr<const Cell> cell);
  void set_unit(std::string_view unit, int decimals);
  [[nodiscard]] std::vector<TableCell> cells_of(const void* row) const;
  [[nodiscard]] Table without_rows(std::string name, std::string title) const;

  std::vector<One> columns_;
};

[[nodiscard]] TableCell estimated_cell(const Estimated& estimated);

/// A value is got from a row by a lambda, or by a pointer to a member of the row or of what the row
/// points to. A name and a heading stand before it, with a unit and decimals for print if need be.
template <class Row>
class ColumnsOf : public ColumnList {
  using Text = std::string_view;

 public:
  template <class Get>
  ColumnsOf& add(Column column, Get cell) {
    push(std::move(column), std::make_unique<By<Get>>(std::move(cell)));
    return *this;
  }
  template <class Get>
  ColumnsOf& text(Text name, Text heading, Get value) {
    return add(text_column, name, heading, text_cell, value);
  }
  template <class Get>
  ColumnsOf& yes_or_no(Text name, Text heading, Get value) {
    return add(text_column, name, heading, yes_or_no_cell, value);
  }
  template <class Get>
  ColumnsOf& integer(Text name, Text heading, Get value) {
    return add(integer_column, name, heading, integer_cell, value);
  }
  template <class Get>
  ColumnsOf& number(Text name, Text heading, Get value) {
    return add(number_column, name, heading, number_cell, value);
  }
  template <class Get>
  ColumnsOf& time(Text name, Text heading, Get value) {
    return add(time_column, name, heading, number_cell, value);
  }
  template <class Get>
  ColumnsOf& p(Text name, Text heading, Get value) {
    return add(p_column, name, heading, p_cell, value);
  }
  template <class Get>
  ColumnsOf& fixed(Text name, Text heading, Get value) {
    return add(fixed_column, name, heading, number_cell, value);
  }
  template <class Get>
  ColumnsOf& fixed(Text name, Text heading, Text unit, int decimals, Get value) {
    fixed(name, heading, value).set_unit(unit, decimals);
    return *this;
  }
  template <class Get>
  ColumnsOf& estimate(Text name, Text heading, Get value) {
    return add(estimate_column, name, heading, estimated_cell, value);
  }
  template <class Get>
  ColumnsOf& estimate(Text name, Text heading, Text unit, int decimals, Get value) {
    estimate(name, heading, value).set_unit(unit, decimals);
    return *this;
  }
  /// Two columns of numbers, each a name and a heading: both ends of an interval.
  template <class Get>
  ColumnsOf& ends(std::pair<Text, Text> low, std::pair<Text, Text> high, Get interval) {
    add(number_column, low.first, low.second, low_cell, interval);
    return add(number_column, high.first, high.second, high_cell, interval);
  }
  /// The columns of a part of the row, missing where it has none: `find` gives a pointer to the
  /// part, or an optional.
  template <class Part, class Find>
  ColumnsOf& part(const ColumnsOf<Part>& columns, Find find) {
    for (const One& one : columns.all()) {
      const auto cell = [find, of_part = one.cell](const Row& row) {
        const auto& found = std::invoke(find, row);
        return found ? of_part->of(&*found) : TableCell{};
      };
      push(one.column, std::make_unique<By<decltype(cell)>>(cell), one.doc);
    }
    return *this;
  }
  /// What the last column means: one line, no full stop.
  ColumnsOf& doc(Text text) {
    columns_.back().doc = text;
    return *this;
  }
  /// The last column is what the table is for.
  ColumnsOf& answer() {
    columns_.back().column.is_answer = true;
    return *this;
  }
  /// Digits that people see of the last column.
  ColumnsOf& significant(int digits) {
    columns_.back().column.significant = digits;
    return *this;
  }

  [[nodiscard]] std::vector<TableCell> row(const Row& row) const { return cells_of(&row); }
  template <class Rows = std::vector<Row>>
  [[nodiscard]] Table table(std::string name, std::string title, const Rows& rows = {}) const {
    Table table = without_rows(std::move(name), std::move(title));
    for (const Row& one : rows) {
      table.add_row(cells_of(&one));
    }
    return table;
  }

 private:
  template <class Function>
  struct By : Cell {
    explicit By(Function f) : function(std::move(f)) {}
    [[nodiscard]] TableCell of(const void* row) const override {
      return function(*static_cast<const Row*>(row));
    }
    Function function;
  };

  template <class ToCell, class Get>
  ColumnsOf& add(Column (*column)(std::string, std::string),
                 Text name,
                 Text heading,
                 ToCell* to_cell,
                 const Get& get) {
    const auto cell = [to_cell, get](const Row& row) { return to_cell(std::invoke(get, row)); };
    push(column, name, heading, std::make_unique<By<decltype(cell)>>(cell));
    return *this;
  }
};

}  // namespace tcert
