#include "datasets/trial_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <table/cell_reading.hpp>
#include <table/csv.hpp>
#include <table/csv_write.hpp>
#include <table/nearest_name.hpp>
#include <table/outcome_word.hpp>
#include <table/path_name.hpp>
#include <tcert/tick.hpp>
#include <utility>

#include "datasets/bundle_fields.hpp"

namespace tcert {

namespace {

constexpr std::array<std::string_view, 6> kEndReasons{
    "", "goal", "collision", "wedged", "timeout", "aborted"};

/// Reads one row after another, each with all its problems.
class TrialRowReader {
 public:
  TrialRowReader(const table::TextTable& table,
                 const Bundle& bundle,
                 table::DiagnosticGroups& problems)
      : table_(table), bundle_(bundle), problems_(problems) {}

  /// Columns that are not ours, in file order.
  [[nodiscard]] std::vector<std::string> extra_columns() const {
    std::vector<std::string> extra;
    for (const std::string& name : table_.columns) {
      if (!is_ours(name)) {
        extra.push_back(name);
      }
    }
    return extra;
  }

  [[nodiscard]] std::optional<TrialRow> read(std::size_t row) {
    row_ = row;
    good_ = true;
    TrialRow trial;
    trial.trial_id = cell("trial_id");
    if (!table::is_file_name(trial.trial_id)) {
      reject("trial_id", std::string(table::kFileNameRule));
    }
    trial.algorithm = name_in("algorithm");
    trial.lighting = name_in("lighting");
    trial.day = name_in("day");
    trial.batch = name_in("batch");
    trial.success = read_success();
    trial.time_s = read_amount("time_s");
    trial.distance_m = read_amount("distance_m");
    trial.end_reason = read_end_reason();
    warn_of_odd_values(trial);
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      if (!is_ours(table_.columns[i])) {
        trial.extra.push_back(table_.at(row, i));
      }
    }
    return good_ ? std::optional(std::move(trial)) : std::nullopt;
  }

 private:
  [[nodiscard]] bool is_ours(const std::string& name) const {
    return std::ranges::find(ours_, name) != ours_.end();
  }

  [[nodiscard]] std::string cell(std::string_view name) const {
    const auto column = table_.find(name);
    return column ? table_.at(row_, *column) : std::string{};
  }

  /// Empty if the cell is missing.
  [[nodiscard]] std::string name_in(std::string_view column) const {
    std::string text = cell(column);
    return table::is_missing_cell(text) ? std::string{} : text;
  }

  void add(table::Severity severity, std::string_view column, std::string expectation) {
    problems_.add({severity,
                   "trials.csv",
                   table_.lines[row_],
                   std::string(column),
                   table::shortened(cell(column)),
                   std::move(expectation),
                   1});
  }

  void reject(std::string_view column, std::string expectation) {
    good_ = false;
    add(table::Severity::error, column, std::move(expectation) + "; the trial is rejected");
  }

  std::optional<bool> read_success() {
    switch (table::outcome_of_cell(cell("success"), table_.dialect.decimal_point)) {
      case table::OutcomeWord::success:
        return true;
      case table::OutcomeWord::failure:
        return false;
      case table::OutcomeWord::missing:
        return std::nullopt;
      case table::OutcomeWord::unknown:
        break;
    }
    reject(
        "success",
        std::string(table::kOutcomeWords) + " (" + std::string(table::kHowMissingIsWritten) + ")");
    return std::nullopt;
  }

  /// A number of seconds or metres, or missing.
  std::optional<double> read_amount(std::string_view column) {
    const table::CellReading reading = table::read_cell(cell(column), table_.dialect.decimal_point);
    if (reading.meaning == table::CellMeaning::missing) {
      return std::nullopt;
    }
    if (reading.meaning != table::CellMeaning::number || !std::isfinite(reading.value) ||
        reading.value < 0.0) {
      reject(column,
             "a finite number, 0 or more (" + std::string(table::kHowMissingIsWritten) + ")");
      return std::nullopt;
    }
    return reading.value;
  }

  EndReason read_end_reason() {
    const auto* const found =
        std::ranges::find(kEndReasons, table::case_folded(name_in("end_reason")));
    if (found == kEndReasons.end()) {
      reject("end_reason", "goal, collision, wedged, timeout, aborted or nothing");
      return EndReason::unknown;
    }
    return static_cast<EndReason>(found - kEndReasons.begin());
  }

  void warn_of_odd_values(const TrialRow& trial) {
    const BundleInfo& info = bundle_.info;
    if (trial.time_s && info.trial_limit_s && *trial.time_s > 10.0 * *info.trial_limit_s) {
      add(table::Severity::warning, "time_s", "at most ten times the trial limit");
    }
    if (!trial.lighting.empty() && !info.lighting_tiers.empty() &&
        std::ranges::find(info.lighting_tiers, trial.lighting) == info.lighting_tiers.end()) {
      add(table::Severity::warning, "lighting", "one of the tiers of bundle.json");
    }
  }

  const table::TextTable& table_;
  const Bundle& bundle_;
  table::DiagnosticGroups& problems_;
  const std::vector<std::string> ours_ = names_at("trials.csv", bundle_fields());
  std::size_t row_ = 0;
  bool good_ = true;
};

/// Lines that repeat an id, by id.
std::map<std::string, std::vector<std::size_t>> repeated_ids(const table::TextTable& table,
                                                             std::size_t id_column) {
  std::map<std::string, std::vector<std::size_t>> lines;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    lines[table.at(row, id_column)].push_back(table.lines[row]);
  }
  std::erase_if(lines, [](const auto& entry) { return entry.second.size() < 2; });
  return lines;
}

}  // namespace

std::string_view to_string(EndReason reason) noexcept {
  return kEndReasons[static_cast<std::size_t>(reason)];
}

void read_trial_table(const table::Bytes& bytes,
                      Bundle& bundle,
                      table::DiagnosticGroups& problems) {
  table::CsvOptions csv;
  csv.file = "trials.csv";
  csv.decimal_comma = bundle.decimal_comma;
  csv.fold_names = true;
  if (const auto renames = bundle.info.columns.find(csv.file);
      renames != bundle.info.columns.end()) {
    csv.rename = renames->second;
  }
  std::vector<std::string> required;
  for (const FileField& field : fields_at(csv.file, bundle_fields())) {
    if (field.need != FieldNeed::optional) {
      required.emplace_back(field.name);
    }
  }
  const auto table = table::read_text_table(bytes, csv, required, problems);
  if (!table) {
    return;
  }
  const auto repeated = repeated_ids(*table, *table->find("trial_id"));
  for (const auto& [id, lines] : repeated) {
    problems.add({table::Severity::error,
                  csv.file,
                  lines[1],
                  "trial_id",
                  table::shortened(id),
                  "a trial_id that no other row has; all rows of it are rejected",
                  lines.size() - 1});
  }
  TrialRowReader reader(*table, bundle, problems);
  bundle.extra_columns = reader.extra_columns();
  for (std::size_t row = 0; row < table->rows(); ++row) {
    std::optional<TrialRow> trial = reader.read(row);
    if (trial && !repeated.contains(trial->trial_id)) {
      bundle.trials.push_back(std::move(*trial));
    }
  }
  if (table->rows() == 0) {
    problems.add({table::Severity::error, csv.file, 0, "", "no rows", "at least one trial", 1});
  }
}

std::string to_trials_csv(const std::vector<TrialRow>& trials,
                          const std::vector<std::string>& extra_columns) {
  std::string out = "trial_id,algorithm,lighting,day,batch,success,time_s,distance_m,end_reason";
  for (const std::string& name : extra_columns) {
    out += ',';
    table::append_text(out, name);
  }
  out += '\n';
  for (const TrialRow& trial : trials) {
    for (const std::string* text :
         {&trial.trial_id, &trial.algorithm, &trial.lighting, &trial.day, &trial.batch}) {
      table::append_text(out, *text);
      out += ',';
    }
    if (trial.success) {
      out += *trial.success ? '1' : '0';
    }
    out += ',';
    table::append_number(out, trial.time_s.value_or(kMissing));
    out += ',';
    table::append_number(out, trial.distance_m.value_or(kMissing));
    out += ',';
    out += to_string(trial.end_reason);
    for (const std::string& text : trial.extra) {
      out += ',';
      table::append_text(out, text);
    }
    out += '\n';
  }
  return out;
}

}  // namespace tcert
