#include "datasets/perturb/perturbed_row.hpp"

#include <algorithm>
#include <table/cell_reading.hpp>
#include <table/csv_write.hpp>
#include <table/decimal.hpp>
#include <utility>

namespace tcert::perturb {

bool PerturbedRow::read(table::CsvCursor& cursor, std::size_t columns) {
  changed_ = false;
  static_cast<void>(table::scan_record(cursor, dialect_.separator, cells_));
  const bool is_whole = cells_.size() >= columns;
  cells_.resize(columns);
  return is_whole;
}

bool PerturbedRow::is_missing(std::size_t column) const {
  return table::is_missing_cell(cells_[column]);
}

std::optional<double> PerturbedRow::number(std::optional<std::size_t> column) const {
  if (!column) {
    return std::nullopt;
  }
  const auto reading = table::read_cell(cells_[*column], dialect_.decimal_point);
  return reading.meaning == table::CellMeaning::number ? std::optional(reading.value)
                                                       : std::nullopt;
}

std::optional<std::int64_t> PerturbedRow::seconds(std::size_t column) {
  padded_.assign(cells_[column]);
  std::int64_t time_ns = 0;
  const char* const end =
      table::scan_seconds(padded_.view().data(), dialect_.decimal_point, time_ns);
  return end == nullptr ? std::nullopt : std::optional(time_ns);
}

void PerturbedRow::set(std::size_t column, double value) {
  set_text(column, in_dialect(table::number_text(value)));
}

void PerturbedRow::set_seconds(std::size_t column, std::int64_t time_ns) {
  std::string text;
  table::append_seconds(text, time_ns);
  set_text(column, in_dialect(std::move(text)));
}

void PerturbedRow::set_text(std::size_t column, std::string text) {
  cells_[column] = std::move(text);
  changed_ = true;
}

void PerturbedRow::append_seconds(std::int64_t time_ns) {
  cells_.emplace_back();
  set_seconds(cells_.size() - 1, time_ns);
}

void PerturbedRow::write(std::string_view raw, std::string& out) const {
  if (!changed_) {
    out += raw;
    return;
  }
  const char separator = dialect_.separator;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (i > 0) {
      out += separator;
    }
    const std::string& cell = cells_[i];
    const bool is_plain = cell.find_first_of("\"\r\n") == std::string::npos &&
                          cell.find(separator) == std::string::npos;
    if (is_plain) {
      out += cell.empty() ? missing() : cell;
    } else {
      table::append_quoted(out, cell);
    }
  }
  out += raw.ends_with("\r\n") ? "\r\n" : "\n";
}

std::string PerturbedRow::in_dialect(std::string text) const {
  std::ranges::replace(text, '.', dialect_.decimal_point);
  return text;
}

}  // namespace tcert::perturb
