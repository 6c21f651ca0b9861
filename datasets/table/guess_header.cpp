#include <algorithm>
#include <map>
#include <set>
#include <table/cell_reading.hpp>
#include <table/csv_header.hpp>
#include <table/header_report.hpp>
#include <utility>

namespace tcert::table {
namespace {

constexpr std::size_t kLookedAt = 50;

struct SampledRecord {
  std::vector<std::string> fields;
  std::size_t line = 0;
  CsvCursor begin;
  CsvCursor after;
};

/// The first records of a file.
class Sample {
 public:
  Sample(std::string_view text, const CsvDialect& dialect, std::size_t preamble_records)
      : dialect_(dialect) {
    CsvCursor cursor = csv_begin(text);
    while (records_.size() <= preamble_records + kLookedAt && skip_to_record(cursor)) {
      SampledRecord record{{}, cursor.line, cursor, cursor};
      scan_record(cursor, dialect.separator, record.fields);
      record.after = cursor;
      records_.push_back(std::move(record));
    }
  }

  [[nodiscard]] const std::vector<SampledRecord>& records() const noexcept { return records_; }

  /// The number of fields that most records have from record `first` on; 0 without one.
  [[nodiscard]] std::size_t usual_fields(std::size_t first) const {
    std::map<std::size_t, std::size_t> count;
    for (std::size_t i = first; i < records_.size(); ++i) {
      ++count[records_[i].fields.size()];
    }
    const auto usual =
        std::ranges::max_element(count, {}, [](const auto& entry) { return entry.second; });
    return usual == count.end() ? 0 : usual->first;
  }

  /// True if the fields from `field` on are empty in all records from `first` on.
  [[nodiscard]] bool is_empty_from(std::size_t field, std::size_t first) const {
    return std::all_of(records_.begin() + static_cast<std::ptrdiff_t>(first),
                       records_.end(),
                       [field](const SampledRecord& record) {
                         return std::all_of(
                             record.fields.begin() +
                                 static_cast<std::ptrdiff_t>(std::min(field, record.fields.size())),
                             record.fields.end(),
                             [](const std::string& cell) { return cell.empty(); });
                       });
  }

  /// Most of what stands below record `header` in that field are numbers.
  [[nodiscard]] bool is_numeric_below(std::size_t header, std::size_t field) const {
    std::size_t numbers = 0;
    std::size_t others = 0;
    for (std::size_t i = header + 1; i < records_.size(); ++i) {
      if (field < records_[i].fields.size()) {
        const CellMeaning meaning = meaning_of(records_[i].fields[field]);
        numbers += meaning == CellMeaning::number ? 1U : 0U;
        others += meaning != CellMeaning::number && meaning != CellMeaning::missing ? 1U : 0U;
      }
    }
    return numbers > others;
  }

  [[nodiscard]] CellMeaning meaning_of(const std::string& cell) const {
    return read_cell(cell, dialect_.decimal_point).meaning;
  }

  /// As the docstring of guess_header() says.
  [[nodiscard]] bool is_header(std::size_t record) const {
    const std::vector<std::string>& names = records_[record].fields;
    std::size_t texts_over_numbers = 0;
    std::vector<std::string> numbers;  // over numbers
    bool any_numbers = false;
    for (std::size_t k = 0; k < names.size(); ++k) {
      const CellMeaning meaning = meaning_of(names[k]);
      const bool is_text = meaning == CellMeaning::text || meaning == CellMeaning::missing_word;
      const bool over_numbers = is_numeric_below(record, k);
      any_numbers = any_numbers || over_numbers;
      texts_over_numbers += is_text && over_numbers ? 1U : 0U;
      if (meaning == CellMeaning::number && (over_numbers || record + 1 == records_.size())) {
        numbers.push_back(names[k]);
      }
    }
    if (any_numbers) {
      return texts_over_numbers > 0 && number_columns(numbers);
    }
    const std::set<std::string> distinct(names.begin(), names.end());
    return numbers.empty() && distinct.size() == names.size() && holds_only_texts(names);
  }

  /// True if all of `names` are texts.
  [[nodiscard]] bool holds_only_texts(const std::vector<std::string>& names) const {
    return std::ranges::all_of(names, [this](const std::string& name) {
      const CellMeaning meaning = meaning_of(name);
      return meaning == CellMeaning::text || meaning == CellMeaning::missing_word;
    });
  }

 private:
  /// Digits alone, each number above the one before: so columns are numbered.
  static bool number_columns(const std::vector<std::string>& numbers) {
    double last = -1.0;
    return std::ranges::all_of(numbers, [&last](const std::string& text) {
      const double number = read_cell(text).value;
      const bool rises = number > last;
      last = number;
      return rises && text.find_first_not_of("0123456789") == std::string::npos;
    });
  }

  CsvDialect dialect_;
  std::vector<SampledRecord> records_;
};

/// The names of the comment that ends right before the first record, if it has `fields` of them.
std::vector<std::string> names_in_comment(std::string_view text,
                                          const SampledRecord& first,
                                          const Sample& sample,
                                          char separator,
                                          std::size_t fields) {
  std::string_view before = text.substr(0, static_cast<std::size_t>(first.begin.at - text.data()));
  while (before.ends_with('\n') || before.ends_with('\r')) {
    before.remove_suffix(1);
  }
  std::string_view line = before.substr(before.rfind('\n') + 1);
  if (!line.starts_with('#')) {
    return {};
  }
  line.remove_prefix(std::min(line.find_first_not_of("# \t"), line.size()));
  CsvCursor cursor = csv_begin(line);
  std::vector<std::string> names;
  if (cursor.at < cursor.end) {
    scan_record(cursor, separator, names);
  }
  return names.size() == fields && sample.holds_only_texts(names) ? names
                                                                  : std::vector<std::string>{};
}

/// The first record that is a header of the rows below it, or else one that is but has another
/// number of names than they have fields; the number of records if there is none.
std::size_t header_record(const Sample& sample, std::size_t preamble_records) {
  const std::size_t none = sample.records().size();
  std::size_t unlike = none;
  for (std::size_t i = 0; i < none && i <= preamble_records; ++i) {
    const std::size_t names = sample.records()[i].fields.size();
    const std::size_t usual = sample.usual_fields(i + 1);
    if (names < 2 && usual > 1) {
      continue;
    }
    if (!sample.is_header(i)) {
      continue;
    }
    if (usual == 0 || names == usual || (names < usual && sample.is_empty_from(names, i + 1))) {
      return i;
    }
    unlike = i;
  }
  return unlike;
}

void report_length(const SampledRecord& header,
                   std::size_t fields,
                   const CsvOptions& options,
                   DiagnosticGroups& problems) {
  problems.add({Severity::error,
                options.file,
                header.line,
                "",
                "a header of " + std::to_string(header.fields.size()) + " names, rows of " +
                    std::to_string(fields) + " fields",
                "as many names as fields; the program that wrote it dropped some of either",
                1});
}

}  // namespace

std::optional<CsvHeader> guess_header(std::string_view text,
                                      const CsvOptions& options,
                                      DiagnosticGroups& problems) {
  CsvHeader header;
  const char detected = detect_separator(text, options.decimal_comma ? ',' : '.');
  header.dialect = dialect_of(options.separator.value_or(detected), options);
  const Sample sample(text, header.dialect, options.preamble_records);
  if (sample.records().empty()) {
    report_no_record(options, problems);
    return std::nullopt;
  }
  const std::size_t found = header_record(sample, options.preamble_records);
  if (found < sample.records().size()) {
    const SampledRecord& record = sample.records()[found];
    const std::size_t usual = sample.usual_fields(found + 1);
    const std::size_t names = record.fields.size();
    if (usual != 0 && names != usual &&
        (names > usual || !sample.is_empty_from(names, found + 1))) {
      report_length(record, usual, options, problems);
    }
    header.names = record.fields;
    header.line = record.line;
    header.preamble_records = found;
    header.data = record.after;
    while (header.names.size() > 1 && header.names.back().empty() &&
           sample.is_empty_from(header.names.size() - 1, found + 1)) {
      header.names.pop_back();
    }
  } else {
    const SampledRecord& first = sample.records().front();
    std::size_t fields = sample.usual_fields(0);
    while (fields > 1 && sample.is_empty_from(fields - 1, 0)) {
      --fields;
    }
    header.names = names_in_comment(text, first, sample, header.dialect.separator, fields);
    header.line = header.names.empty() ? 0 : first.line - 1;
    header.data = first.begin;
    for (std::size_t i = header.names.size(); i < fields; ++i) {
      header.names.push_back("c" + std::to_string(i + 1));
    }
  }
  apply_renames(header.names, options);
  report_equal_names(header, options, problems);
  report_preamble(header, options, problems);
  return header;
}

}  // namespace tcert::table
