#include "reports/cells_by_name.hpp"

#include <cmath>
#include <table/csv_write.hpp>
#include <table/not_a_number.hpp>
#include <variant>

namespace tcert {
namespace {

using table::kNaN;

const TableCell* cell_at(const Table& table, std::size_t row, std::string_view column) {
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (table.columns[c].name == column) {
      return &table.rows[row][c];
    }
  }
  return nullptr;
}

double bound_at(const Table& table, std::size_t row, std::string_view column, bool high) {
  const std::string_view ending = high ? "_high" : "_low";
  if (column.size() <= ending.size() || column.substr(column.size() - ending.size()) != ending) {
    return kNaN;
  }
  const TableCell* const cell =
      cell_at(table, row, column.substr(0, column.size() - ending.size()));
  const auto* const estimate = cell != nullptr ? std::get_if<Estimate>(cell) : nullptr;
  return estimate == nullptr ? kNaN : high ? estimate->high : estimate->low;
}

struct AsNumber {
  double operator()(std::monostate /*missing*/) const { return kNaN; }
  double operator()(const std::string& /*text*/) const { return kNaN; }
  double operator()(std::int64_t value) const { return static_cast<double>(value); }
  double operator()(const Number& number) const { return number.value; }
  double operator()(const Estimate& estimate) const { return estimate.value; }
  double operator()(const PValue& p) const { return p.value; }
};

}  // namespace

std::string text_at(const Table& table, std::size_t row, std::string_view column) {
  const TableCell* const cell = cell_at(table, row, column);
  const auto* const text = cell != nullptr ? std::get_if<std::string>(cell) : nullptr;
  return text != nullptr ? *text : std::string();
}

std::string text_at(const table::DataTable& table, std::size_t row, std::string_view column) {
  const table::DataColumn* const found = table.find(column);
  if (found == nullptr) {
    return {};
  }
  if (!found->is_text) {
    std::string text;
    if (!std::isnan(found->numbers[row])) {
      table::append_number(text, found->numbers[row]);
    }
    return text;
  }
  const std::uint32_t code = found->text.codes[row];
  return code == table::Factor::kMissing ? std::string() : found->text.levels[code];
}

double number_at(const Table& table, std::size_t row, std::string_view column) {
  if (const TableCell* const cell = cell_at(table, row, column)) {
    return std::visit(AsNumber{}, *cell);
  }
  const double low = bound_at(table, row, column, false);
  return std::isnan(low) ? bound_at(table, row, column, true) : low;
}

double number_at(const table::DataTable& table, std::size_t row, std::string_view column) {
  const table::DataColumn* const found = table.find(column);
  return found == nullptr || found->is_text ? kNaN : found->numbers[row];
}

}  // namespace tcert
