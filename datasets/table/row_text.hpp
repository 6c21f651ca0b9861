#pragma once
/// \file
/// Values as the cells of one line, from which they read back to the same bits.
///
/// A struct takes part by one function that names its members, for both ways:
///     void row_cells(auto& row, table::Is<Point> auto& point) { row(point.x_m, point.y_m); }
/// and an enumeration by one that names its last value:
///     constexpr Colour row_last(Colour) { return Colour::blue; }

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace tcert::table {

/// `T` or `const T` is `Wanted`.
template <class T, class Wanted>
concept Is = std::same_as<std::remove_const_t<T>, Wanted>;

/// A line that is not what a RowWriter writes.
class RowError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Appends cells with a comma between: numbers as their shortest decimals ("nan", "inf" among
/// them), enumerations and bools as integers, an optional as 0, or 1 and its value, a vector as its
/// length and its values.
class RowWriter {
 public:
  template <class... Values>
  void operator()(const Values&... values) {
    (put(values), ...);
  }

  [[nodiscard]] std::string take() noexcept { return std::move(text_); }

 private:
  void cell(double value);
  void cell(std::uint64_t value);

  template <class Value>
  void put(const Value& value) {
    if constexpr (std::floating_point<Value>) {
      cell(static_cast<double>(value));
    } else if constexpr (std::unsigned_integral<Value> || std::is_enum_v<Value>) {
      cell(static_cast<std::uint64_t>(value));
    } else {
      row_cells(*this, value);
    }
  }
  template <class Value>
  void put(const std::optional<Value>& value) {
    put(value.has_value());
    if (value) {
      put(*value);
    }
  }
  template <class Value>
  void put(const std::vector<Value>& values) {
    cell(std::uint64_t{values.size()});
    for (const Value& value : values) {
      put(value);
    }
  }

  std::string text_;
};

/// Takes the cells in the order in which they were written.
class RowReader {
 public:
  explicit RowReader(std::string_view text) noexcept : rest_(text) {}

  /// \throws RowError for a cell that is missing or holds something else.
  template <class... Values>
  void operator()(Values&... values) {
    (get(values), ...);
  }

  /// \throws RowError if there are cells left.
  void end() const;

 private:
  [[nodiscard]] double number();
  /// At most `most`.
  [[nodiscard]] std::uint64_t integer(std::uint64_t most);
  [[nodiscard]] std::string_view next();

  template <class Value>
  void get(Value& value) {
    if constexpr (std::floating_point<Value>) {
      value = static_cast<Value>(number());
    } else if constexpr (std::is_enum_v<Value>) {
      value = static_cast<Value>(integer(static_cast<std::uint64_t>(row_last(value))));
    } else if constexpr (std::unsigned_integral<Value>) {
      value = static_cast<Value>(integer(std::is_same_v<Value, bool> ? 1 : static_cast<Value>(-1)));
    } else {
      row_cells(*this, value);
    }
  }
  template <class Value>
  void get(std::optional<Value>& value) {
    bool is_there = false;
    get(is_there);
    value.reset();
    if (is_there) {
      get(value.emplace());
    }
  }
  template <class Value>
  void get(std::vector<Value>& values) {
    values.clear();
    // No value takes less than a character, so that a wrong length cannot ask for much memory.
    values.resize(integer(rest_.size()));
    for (Value& value : values) {
      get(value);
    }
  }

  std::string_view rest_;
  bool is_first_ = true;
};

template <class Value>
[[nodiscard]] std::string row_text(const Value& value) {
  RowWriter row;
  row(value);
  return row.take();
}

/// \throws RowError if the line is not that of one `Value`.
template <class Value>
[[nodiscard]] Value from_row(std::string_view text) {
  RowReader row(text);
  Value value{};
  row(value);
  row.end();
  return value;
}

}  // namespace tcert::table
