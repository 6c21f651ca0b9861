#include "reports/table.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "reports/table_formats.hpp"

namespace tcert {
namespace {

constexpr std::array<std::string_view, 6> kFormatWords = {
    "text", "md", "csv", "json", "jsonl", "tex"};

/// In the order of ColumnKind.
constexpr std::array<std::string_view, 5> kKindWords = {
    "text", "integer", "number", "estimate", "p_value"};

bool fits(const TableCell& cell, ColumnKind kind) {
  switch (kind) {
    case ColumnKind::text:
      return std::holds_alternative<std::string>(cell);
    case ColumnKind::integer:
      return std::holds_alternative<std::int64_t>(cell);
    case ColumnKind::number:
      return std::holds_alternative<Number>(cell);
    case ColumnKind::estimate:
      return std::holds_alternative<Estimate>(cell);
    case ColumnKind::p_value:
      return std::holds_alternative<PValue>(cell);
  }
  return false;
}

/// As the cell says, else as its column does; a number of more digits than anybody reads by its
/// first ones.
std::string rounded(double value, int own_decimals, const Column& column) {
  constexpr double kUnreadable = 1e9;
  if (own_decimals == kColumnDecimals && column.significant > 0) {
    return significant(value, column.significant);
  }
  if (std::abs(value) >= kUnreadable) {
    return significant(value, 4);
  }
  return fixed(value, own_decimals == kColumnDecimals ? column.decimals : own_decimals);
}

struct Printer {
  const Column& column;

  std::string operator()(std::monostate /*missing*/) const { return "NA"; }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(const Number& number) const {
    return rounded(number.value, number.decimals, column);
  }
  std::string operator()(const Estimate& estimate) const {
    if (!std::isfinite(estimate.value)) {
      return "NA";
    }
    std::string value = rounded(estimate.value, estimate.decimals, column);
    if (std::isnan(estimate.low) && std::isnan(estimate.high)) {
      return value;
    }
    return value + " [" + rounded(estimate.low, estimate.decimals, column) + ", " +
           rounded(estimate.high, estimate.decimals, column) + "]";
  }
  std::string operator()(const PValue& p) const {
    if (!std::isfinite(p.value)) {
      return "NA";
    }
    return p.value < 0.001 ? "<0.001" : fixed(p.value, 3);
  }
};

}  // namespace

std::string_view to_string(ColumnKind kind) noexcept {
  return kKindWords[static_cast<std::size_t>(kind)];
}

std::string to_string(const SyntheticLabel& label) {
  return "SYNTHETIC data" + (label.seed ? ", seed " + std::to_string(*label.seed) : "") +
         ": made by a program, not measured on a robot.";
}

void Table::add_row(std::vector<TableCell> cells) {
  if (cells.size() != columns.size()) {
    throw std::invalid_argument("table '" + name + "': a row of " + std::to_string(cells.size()) +
                                " cells for " + std::to_string(columns.size()) + " columns");
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!std::holds_alternative<std::monostate>(cells[i]) && !fits(cells[i], columns[i].kind)) {
      throw std::invalid_argument("table '" + name + "': a cell of another kind in column '" +
                                  columns[i].name + "'");
    }
  }
  rows.push_back(std::move(cells));
}

std::string_view to_string(TableFormat format) noexcept {
  return kFormatWords[static_cast<std::size_t>(format)];
}

std::optional<TableFormat> table_format_from(std::string_view word) noexcept {
  for (std::size_t i = 0; i < kFormatWords.size(); ++i) {
    if (kFormatWords[i] == word) {
      return static_cast<TableFormat>(i);
    }
  }
  return std::nullopt;
}

std::string render(const Table& table, TableFormat format, std::size_t width) {
  switch (format) {
    case TableFormat::text:
      return render_text(table, width);
    case TableFormat::markdown:
      return render_markdown(table);
    case TableFormat::csv:
      return render_csv(table);
    case TableFormat::json:
      return render_json(table);
    case TableFormat::jsonl:
      return render_jsonl(table);
    case TableFormat::latex:
      return render_latex(table);
  }
  throw std::invalid_argument("unknown table format");
}

std::string printed(const TableCell& cell, const Column& column) {
  return std::visit(Printer{column}, cell);
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) {
    return "NA";
  }
  // 1.8e308 has 309 digits before the point; decimals are a few.
  std::array<char, 352> buffer{};
  const auto result = std::to_chars(
      buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  std::string text(buffer.data(), result.ptr);
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) {
    text.erase(0, 1);
  }
  return text;
}

std::string significant(double value, int digits) {
  if (!std::isfinite(value)) {
    return "NA";
  }
  std::array<char, 64> buffer{};
  const auto result = std::to_chars(
      buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
  return {buffer.data(), result.ptr};
}

}  // namespace tcert
