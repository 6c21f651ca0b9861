#include <table/csv_header.hpp>

#include <algorithm>
#include <table/cell_reading.hpp>
#include <table/header_report.hpp>
#include <table/nearest_name.hpp>
#include <table/rename_advice.hpp>
#include <utility>

namespace tcert::table {

namespace {

struct Candidate {
  CsvHeader header;
  std::size_t matches = 0;
};

std::size_t count_matches(const std::vector<std::string>& names,
                          std::span<const std::string> required) {
  return static_cast<std::size_t>(std::ranges::count_if(
      required,
      [&names](const std::string& name) { return std::ranges::find(names, name) != names.end(); }));
}

/// The earliest record with the most of the required names, for one separator.
std::optional<Candidate> best_record(std::string_view text,
                                     char separator,
                                     const CsvOptions& options,
                                     std::span<const std::string> required) {
  std::optional<Candidate> best;
  CsvCursor cursor = csv_begin(text);
  std::vector<std::string> names;
  for (std::size_t i = 0; i <= options.preamble_records && skip_to_record(cursor); ++i) {
    const std::size_t line = cursor.line;
    scan_record(cursor, separator, names);
    apply_renames(names, options);
    const std::size_t matches = count_matches(names, required);
    if (!best || matches > best->matches) {
      best = {{dialect_of(separator, options), names, line, i, cursor}, matches};
    }
    if (matches == required.size()) {
      break;
    }
  }
  return best;
}

std::optional<Candidate> best_header(std::string_view text,
                                     const CsvOptions& options,
                                     std::span<const std::string> required) {
  if (options.separator) {
    return best_record(text, *options.separator, options, required);
  }
  std::optional<Candidate> best;
  for (const char separator : kCsvSeparators) {
    std::optional<Candidate> candidate = best_record(text, separator, options, required);
    if (candidate && (!best || candidate->matches > best->matches)) {
      best = std::move(candidate);
    }
  }
  if (best && best->matches == 0) {
    best = best_record(text, detect_separator(text), options, required);
  }
  return best;
}

/// A word that is read as a number or as missing names no column.
bool holds_text(const std::vector<std::string>& record, char decimal_point) {
  return std::ranges::any_of(record, [decimal_point](const std::string& cell) {
    const CellMeaning meaning = read_cell(cell, decimal_point).meaning;
    return meaning != CellMeaning::number && meaning != CellMeaning::missing;
  });
}

/// What to say of a file whose columns nobody named, instead of what each column lacks.
void report_no_header(const CsvHeader& header,
                      const CsvOptions& options,
                      std::span<const std::string> required,
                      DiagnosticGroups& problems) {
  std::string names;
  for (const std::string& name : required) {
    names += (names.empty() ? "" : ", ") + name;
  }
  problems.add({Severity::error,
                options.file,
                header.line,
                "",
                "numbers where the names of columns should be",
                "a header line before the rows, which names " + names,
                1});
}

void report_missing(const CsvHeader& header,
                    const CsvOptions& options,
                    std::span<const std::string> required,
                    DiagnosticGroups& problems) {
  for (const std::string& name : required) {
    if (header.find(name)) {
      continue;
    }
    const auto nearest = nearest_name(name, header.names);
    problems.add({Severity::error,
                  options.file,
                  header.line,
                  name,
                  nearest ? shortened(*nearest) : std::string{},
                  "a column of this name in the header" + std::string(kRenameAdvice),
                  1});
  }
}

}  // namespace

std::optional<std::size_t> CsvHeader::find(std::string_view name) const noexcept {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(found - names.begin());
}

std::optional<CsvHeader> find_header(std::string_view text,
                                     const CsvOptions& options,
                                     std::span<const std::string> required,
                                     DiagnosticGroups& problems) {
  std::optional<Candidate> best = best_header(text, options, required);
  if (!best) {
    report_no_record(options, problems);
    return std::nullopt;
  }
  if (best->matches == 0 && !required.empty() &&
      !holds_text(best->header.names, best->header.dialect.decimal_point)) {
    report_no_header(best->header, options, required, problems);
    return std::nullopt;
  }
  report_missing(best->header, options, required, problems);
  report_equal_names(best->header, options, problems);
  if (problems.has_error()) {
    return std::nullopt;
  }
  report_preamble(best->header, options, problems);
  return std::move(best->header);
}

}  // namespace tcert::table
