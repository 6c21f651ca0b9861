#include "reports/fit/cells.hpp"

#include <cmath>
#include <utility>

namespace tcert {

TableCell text_cell(const std::optional<std::string>& text) {
  return text ? TableCell{*text} : TableCell{};
}

TableCell integer_cell(const std::optional<std::int64_t>& value) {
  return value ? TableCell{*value} : TableCell{};
}

TableCell number_cell(const std::optional<double>& value) {
  return value && !std::isnan(*value) ? TableCell{Number{*value}} : TableCell{};
}

TableCell p_cell(const std::optional<double>& value) {
  return value && !std::isnan(*value) ? TableCell{PValue{*value}} : TableCell{};
}

TableCell low_cell(const std::optional<statistics::Interval>& interval) {
  return interval ? number_cell(interval->low) : TableCell{};
}

TableCell high_cell(const std::optional<statistics::Interval>& interval) {
  return interval ? number_cell(interval->high) : TableCell{};
}

TableCell estimate_cell(const std::optional<double>& value,
                        const std::optional<statistics::Interval>& interval) {
  if (!value) {
    return {};
  }
  Estimate cell{*value};
  if (interval) {
    cell.low = interval->low;
    cell.high = interval->high;
  }
  return cell;
}

std::optional<double> share(std::size_t part, std::size_t whole) {
  return whole == 0 ? std::nullopt
                    : std::optional(static_cast<double>(part) / static_cast<double>(whole));
}

std::optional<std::string> not_empty(std::string text) {
  return text.empty() ? std::nullopt : std::optional(std::move(text));
}

TableCell yes_or_no_cell(const std::optional<bool>& answer) {
  return answer ? TableCell{std::string(*answer ? "yes" : "no")} : TableCell{};
}

Column text_column(std::string name, std::string heading) {
  return {std::move(name), std::move(heading), "", ColumnKind::text};
}

Column integer_column(std::string name, std::string heading) {
  return {std::move(name), std::move(heading), "", ColumnKind::integer};
}

Column number_column(std::string name, std::string heading) {
  Column column{std::move(name), std::move(heading), "", ColumnKind::number};
  column.significant = kShownDigits;
  return column;
}

Column time_column(std::string name, std::string heading) {
  constexpr int kAllDigits = 15;
  Column column = number_column(std::move(name), std::move(heading));
  column.significant = kAllDigits;
  return column;
}

Column fixed_column(std::string name, std::string heading) {
  return fixed_column(std::move(name), std::move(heading), "");
}

Column fixed_column(std::string name, std::string heading, std::string unit, int decimals) {
  return {std::move(name), std::move(heading), std::move(unit), ColumnKind::number, decimals};
}

Column estimate_column(std::string name, std::string heading) {
  return {std::move(name), std::move(heading), "", ColumnKind::estimate};
}

Column p_column(std::string name, std::string heading) {
  return {std::move(name), std::move(heading), "", ColumnKind::p_value};
}

Record::Record(std::string name, std::string title) {
  table_.name = std::move(name);
  table_.title = std::move(title);
}

Record& Record::text(std::string name, std::string heading, std::string value) {
  table_.columns.push_back(text_column(std::move(name), std::move(heading)));
  cells_.emplace_back(std::move(value));
  return *this;
}

Record& Record::integer(std::string name, std::string heading, std::size_t value) {
  table_.columns.push_back(integer_column(std::move(name), std::move(heading)));
  cells_.push_back(integer_cell(value));
  return *this;
}

Record& Record::number(std::string name, std::string heading, const std::optional<double>& value) {
  table_.columns.push_back(number_column(std::move(name), std::move(heading)));
  table_.columns.back().significant = 6;
  cells_.push_back(number_cell(value));
  return *this;
}

Record& Record::p(std::string name, std::string heading, const std::optional<double>& value) {
  table_.columns.push_back(p_column(std::move(name), std::move(heading)));
  cells_.push_back(p_cell(value));
  return *this;
}

Table Record::table() && {
  table_.add_row(std::move(cells_));
  return std::move(table_);
}

}  // namespace tcert
