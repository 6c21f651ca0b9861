#include <table/header_report.hpp>

#include <map>
#include <string>
#include <table/nearest_name.hpp>

namespace tcert::table {

CsvDialect dialect_of(char separator, const CsvOptions& options) {
  return {separator, separator != ',' && options.decimal_comma ? ',' : '.'};
}

void apply_renames(std::vector<std::string>& names, const CsvOptions& options) {
  for (std::string& name : names) {
    if (const auto renamed = options.rename.find(name); renamed != options.rename.end()) {
      name = renamed->second;
    }
  }
}

void report_equal_names(const CsvHeader& header,
                        const CsvOptions& options,
                        DiagnosticGroups& problems) {
  std::map<std::string, std::string> seen;
  for (const std::string& name : header.names) {
    if (name.empty()) {
      continue;
    }
    const auto [first, is_new] =
        seen.try_emplace(options.fold_names ? case_folded(name) : name, name);
    if (!is_new) {
      problems.add({Severity::error,
                    options.file,
                    header.line,
                    shortened(name),
                    shortened(first->second),
                    options.fold_names ? "column names that differ when case is folded"
                                       : "column names that differ",
                    1});
    }
  }
}

void report_preamble(const CsvHeader& header,
                     const CsvOptions& options,
                     DiagnosticGroups& problems) {
  if (header.preamble_records > 0) {
    problems.add({Severity::note,
                  options.file,
                  header.line,
                  "",
                  std::to_string(header.preamble_records) + " lines before the header",
                  "the header first; the lines before it are not used",
                  1});
  }
}

void report_no_record(const CsvOptions& options, DiagnosticGroups& problems) {
  problems.add({Severity::error, options.file, 0, "", "", "a header line and rows", 1});
}

}  // namespace tcert::table
