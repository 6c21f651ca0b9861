#include "datasets/joined_seconds.hpp"

#include <algorithm>
#include <charconv>
#include <functional>
#include <string_view>
#include <table/csv_dialect.hpp>
#include <table/decimal.hpp>
#include <table/diagnostic.hpp>

namespace tcert {
namespace {

constexpr std::size_t kLeastRows = 10;
constexpr std::size_t kAllDigits = 9;

std::optional<std::int64_t> whole_number(std::string_view digits) {
  std::int64_t value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  const bool signless = !digits.empty() && digits.front() != '-';
  return signless && error == std::errc{} && stop == end ? std::optional(value) : std::nullopt;
}

/// A stamp read as seconds, point, nanoseconds; `has_all` if these have nine digits.
std::optional<std::int64_t> joined(std::string_view stamp, char point, bool& has_all) {
  const std::size_t at = stamp.find(point);
  if (at == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view fraction = stamp.substr(at + 1);
  const auto seconds = whole_number(stamp.substr(0, at));
  const auto nanoseconds = whole_number(fraction);
  if (!seconds || !nanoseconds || fraction.size() > kAllDigits ||
      *seconds >= table::kLongestTimeS) {
    return std::nullopt;
  }
  has_all = fraction.size() == kAllDigits;
  return *seconds * 1'000'000'000 + *nanoseconds;
}

}  // namespace

std::optional<std::vector<std::int64_t>> joined_seconds(const table::Bytes& bytes,
                                                        const table::CsvOptions& csv,
                                                        const std::string& time_column,
                                                        std::span<const std::uint32_t> lines) {
  table::DiagnosticGroups ignored;
  const std::vector<std::string> required{time_column};
  const auto header = table::find_header(bytes.view(), csv, required, ignored);
  const auto column = header ? header->find(time_column) : std::nullopt;
  if (!column || lines.size() < kLeastRows) {
    return std::nullopt;
  }
  std::vector<std::int64_t> times;
  std::size_t whole = 0;
  std::vector<std::string> record;
  table::CsvCursor cursor = header->data;
  while (times.size() < lines.size() && table::skip_to_record(cursor)) {
    const std::size_t line = cursor.line;
    table::scan_record(cursor, header->dialect.separator, record);
    if (line != lines[times.size()]) {
      continue;
    }
    bool has_all = false;
    const auto time = *column < record.size()
                          ? joined(record[*column], header->dialect.decimal_point, has_all)
                          : std::nullopt;
    if (!time || (!times.empty() && *time <= times.back())) {
      return std::nullopt;
    }
    times.push_back(*time);
    whole += has_all ? 1 : 0;
  }
  const bool found = times.size() == lines.size() && 2 * whole > times.size();
  return found ? std::optional(std::move(times)) : std::nullopt;
}

}  // namespace tcert
