#include "reports/fit/cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tcert {

TableCell integer_cell(std::size_t value) { return static_cast<std::int64_t>(value); }

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

Column fixed_column(std::string name, std::string heading, std::string unit, int decimals) {
  return {std::move(name), std::move(heading), std::move(unit), ColumnKind::number, decimals};
}

Column estimate_column(std::string name, std::string heading, std::string unit, int decimals) {
  return {std::move(name), std::move(heading), std::move(unit), ColumnKind::estimate, decimals};
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

std::string apart_from(std::string name, const std::vector<std::string>& taken) {
  while (std::find(taken.begin(), taken.end(), name) != taken.end()) {
    name.insert(0, ".");
  }
  return name;
}

Table matrix_table(std::string name,
                   std::string title,
                   const std::vector<std::string>& names,
                   const Eigen::MatrixXd& values) {
  Table table;
  table.name = std::move(name);
  table.title = std::move(title);
  table.columns.push_back(text_column(apart_from("term", names), "term"));
  for (const std::string& one : names) {
    table.columns.push_back(number_column(one, one));
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::vector<TableCell> cells{names[i]};
    for (std::size_t j = 0; j < names.size(); ++j) {
      cells.push_back(
          number_cell(values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j))));
    }
    table.add_row(std::move(cells));
  }
  return table;
}

}  // namespace tcert
