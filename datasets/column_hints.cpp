#include "datasets/column_hints.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <table/cell_reading.hpp>
#include <table/decimal.hpp>
#include <vector>

#include "datasets/ray_names.hpp"

namespace tcert {
namespace {

constexpr std::size_t kSampledRows = 1000;

/// What the cells of one column look like.
struct SampledColumn {
  std::string name;
  std::size_t position = 0;
  std::size_t stated = 0;    // cells that are not missing
  std::size_t commas = 0;    // that hold a comma
  std::size_t by_comma = 0;  // that are numbers if a comma is the decimal point
  std::size_t dates = 0;
  std::size_t huge = 0;  // numbers beyond any time in seconds
  std::string first{};

  [[nodiscard]] bool all_are(std::size_t count) const noexcept {
    return stated > 0 && count == stated;
  }
};

bool is_date(std::string_view cell) noexcept {
  constexpr std::string_view kShape = "0000-00-00";
  return cell.size() >= kShape.size() &&
         std::ranges::equal(cell.substr(0, kShape.size()), kShape, [](char c, char shape) {
           return shape == '0' ? c >= '0' && c <= '9' : c == shape;
         });
}

void look_at(std::string_view cell, char point, SampledColumn& column) {
  if (table::is_missing_cell(cell)) {
    return;
  }
  column.first = column.stated == 0 ? std::string(cell) : column.first;
  ++column.stated;
  if (point == '.') {
    column.commas += cell.find(',') != std::string_view::npos ? 1 : 0;
    column.by_comma += table::read_cell(cell, ',').meaning == table::CellMeaning::number ? 1 : 0;
  }
  column.dates += is_date(cell) ? 1 : 0;
  const double value = table::read_cell(cell, point).value;
  column.huge += std::abs(value) > static_cast<double>(table::kLongestTimeS) ? 1 : 0;
}

std::vector<SampledColumn> sampled(const table::CsvHeader& header,
                                   const table::NumberOptions& wanted) {
  std::vector<SampledColumn> columns;
  std::vector<std::string> names{wanted.time_column};
  for (const table::NumberColumn& column : wanted.columns) {
    names.push_back(column.name);
  }
  for (const std::string& name : names) {
    if (const auto position = header.find(name)) {
      columns.push_back({name, *position});
    }
  }
  std::vector<std::string> record;
  table::CsvCursor cursor = header.data;
  for (std::size_t row = 0; row < kSampledRows && table::skip_to_record(cursor); ++row) {
    table::scan_record(cursor, header.dialect.separator, record);
    for (SampledColumn& column : columns) {
      if (column.position < record.size()) {
        look_at(record[column.position], header.dialect.decimal_point, column);
      }
    }
  }
  return columns;
}

bool comma_takes_effect(const table::Bytes& bytes,
                        table::CsvOptions csv,
                        const std::vector<std::string>& required) {
  csv.decimal_comma = true;
  table::DiagnosticGroups ignored;
  const auto header = table::find_header(bytes.view(), csv, required, ignored);
  return header && header->dialect.decimal_point == ',';
}

/// The unit of times since 1970 of this size.
const char* unit_since_1970(double value) noexcept {
  constexpr double kMs = 1e14;
  constexpr double kUs = 1e17;
  return value < kMs ? "milliseconds" : value < kUs ? "microseconds" : "nanoseconds";
}

}  // namespace

void add_column_hints(const table::Bytes& bytes,
                      const table::CsvOptions& csv,
                      const table::NumberOptions& wanted,
                      table::DiagnosticGroups& problems) {
  table::DiagnosticGroups ignored;
  const std::vector<std::string> required{wanted.time_column};
  const auto header = table::find_header(bytes.view(), csv, required, ignored);
  if (!header) {
    return;
  }
  const std::vector<SampledColumn> columns = sampled(*header, wanted);
  std::vector<std::string> with_commas;
  std::string first;
  for (const SampledColumn& column : columns) {
    if (column.commas > 0 && column.all_are(column.by_comma)) {
      first = with_commas.empty() ? column.first : first;
      with_commas.push_back(column.name);
    }
  }
  const auto add = [&](std::string name, const std::string& value, std::string expectation) {
    problems.add({table::Severity::error,
                  csv.file,
                  0,
                  std::move(name),
                  table::shortened(value),
                  std::move(expectation),
                  1});
  };
  if (!with_commas.empty() && comma_takes_effect(bytes, csv, required)) {
    add(joined_names(with_commas), first, "a decimal point; --decimal-comma reads these");
  }
  for (const SampledColumn& column : columns) {
    if (column.name != wanted.time_column) {
      continue;
    }
    if (column.all_are(column.dates)) {
      add(column.name, column.first, "seconds as a number, not dates");
    } else if (column.all_are(column.huge)) {
      const double value = table::read_cell(column.first, header->dialect.decimal_point).value;
      add(column.name,
          column.first,
          std::string("seconds; these are ") + unit_since_1970(std::abs(value)) + "?");
    }
  }
}

}  // namespace tcert
