#include "reports/fit/fit_report.hpp"

#include <algorithm>
#include <stdexcept>

#include "reports/findings.hpp"
#include "reports/table_json.hpp"

namespace tcert {
namespace {

using Json = OrderedJson;

/// A record as a table of two columns, for people.
Table name_and_value(const Table& record) {
  Table table;
  table.name = record.name;
  table.title = record.title;
  table.n = record.n;
  table.footnotes = record.footnotes;
  table.columns = {{"name", "", "", ColumnKind::text}, {"value", "", "", ColumnKind::text}};
  for (std::size_t c = 0; c < record.columns.size() && !record.rows.empty(); ++c) {
    const TableCell& cell = record.rows.front()[c];
    if (!std::holds_alternative<std::monostate>(cell)) {
      table.add_row({record.columns[c].heading, printed(cell, record.columns[c])});
    }
  }
  return table;
}

Json json_of(const statistics::Conditions& conditions) {
  Json list = Json::array();
  for (const statistics::Condition& condition : conditions) {
    list.push_back({{"name", statistics::name_of(condition.kind)},
                    {"severity", statistics::to_string(condition.severity)},
                    {"column", condition.column.empty() ? Json(nullptr) : Json(condition.column)},
                    {"detail", condition.detail},
                    {"message", statistics::to_string(condition)}});
  }
  return list;
}

bool is_number(const TableCell& cell) {
  return std::holds_alternative<Number>(cell) || std::holds_alternative<Estimate>(cell) ||
         std::holds_alternative<PValue>(cell);
}

/// False if there is nothing but NA in the main table.
bool has_number(const FitReport& report) {
  if (report.tables.empty()) {
    return false;
  }
  const auto& rows = report.tables.front().rows;
  return std::any_of(rows.begin(), rows.end(), [&](const std::vector<TableCell>& cells) {
    return std::any_of(cells.begin(), cells.end(), is_number);
  });
}

std::string json_document(const FitReport& report) {
  Json json;
  json["model"] = report.model;
  for (const auto& [key, value] : report.settings) {
    json[key] = setting_value(value);
  }
  json["synthetic"] = report.synthetic.has_value();
  if (report.synthetic) {
    json["synthetic_seed"] = report.synthetic->seed ? Json(*report.synthetic->seed) : Json(nullptr);
  }
  json["summary"] = report.summary.rows.empty()
                        ? Json::object()
                        : json_row(report.summary, report.summary.rows.front());
  const std::vector<Table> findings(report.findings.rows.empty() ? 0 : 1, report.findings);
  for (const auto* list : {&findings, &report.tables, &report.details}) {
    for (const Table& table : *list) {
      Json rows = Json::array();
      for (const auto& cells : table.rows) {
        rows.push_back(json_row(table, cells));
      }
      json[table.name] = std::move(rows);
    }
  }
  for (const Attachment& one : report.attachments) {
    json[one.name] = one.ending == "json" ? Json::parse(one.text) : Json(one.text);
  }
  json["conditions"] = json_of(report.conditions);
  return dumped(json, 1);
}

/// Every table as `print` has it, and the summary.
template <class Print>
std::string tables_of(const FitReport& report, const Print& print) {
  std::string out;
  for (const Table& one : report.tables) {
    out += print(one) + '\n';
  }
  return out + print(name_and_value(report.summary));
}

/// Each below its title, between two lines if it is to be told from the text round it.
std::string attachments_text(const FitReport& report, std::string_view fence) {
  std::string out;
  for (const Attachment& one : report.attachments) {
    out += '\n' + one.title + "\n\n";
    out +=
        fence.empty() ? one.text : std::string(fence) + '\n' + one.text + std::string(fence) + '\n';
  }
  return out;
}

/// Says once that its data were made. What was found is first, or last on a terminal.
std::string text_document(const FitReport& report, std::size_t width) {
  std::string out = report.synthetic ? to_string(*report.synthetic) + "\n\n" : "";
  const std::string findings = findings_text(report.findings, width);
  if (width == 0 && !findings.empty()) {
    out += findings + '\n';
  }
  out += tables_of(report, [&](const Table& one) { return render(one, TableFormat::text, width); });
  out += attachments_text(report, "");
  if (!report.conditions.empty()) {
    out += "\nConditions\n\n" + conditions_text(report.conditions, width);
  }
  if (width > 0 && !findings.empty()) {
    out += '\n' + findings;
  }
  return out;
}

/// Likewise.
std::string markdown_document(const FitReport& report) {
  const auto print = [](const Table& one) { return render(one, TableFormat::markdown); };
  std::string out = report.synthetic ? "**" + to_string(*report.synthetic) + "**\n\n" : "";
  if (!report.findings.rows.empty()) {
    out += print(report.findings) + '\n';
  }
  out += tables_of(report, print);
  out += attachments_text(report, "```");
  if (!report.conditions.empty()) {
    out += '\n' + print(conditions_table(report.conditions));
  }
  return out;
}

}  // namespace

const Table* FitReport::find(std::string_view table) const noexcept {
  for (const Table* const one : {&summary, &findings}) {
    if (one->name == table) {
      return one;
    }
  }
  for (const auto* list : {&tables, &details}) {
    for (const Table& one : *list) {
      if (one.name == table) {
        return &one;
      }
    }
  }
  return nullptr;
}

std::vector<std::string> FitReport::table_names() const {
  std::vector<std::string> names{summary.name};
  if (!findings.rows.empty()) {
    names.push_back(findings.name);
  }
  for (const auto* list : {&tables, &details}) {
    for (const Table& one : *list) {
      names.push_back(one.name);
    }
  }
  return names;
}

void FitReport::add(const statistics::Conditions& more) {
  conditions.insert(conditions.end(), more.begin(), more.end());
}

bool has_estimate(const FitReport& report) {
  if (report.tables.empty()) {
    return !statistics::has_error(report.conditions);
  }
  const Table& main = report.tables.front();
  const auto column_of = [&](std::string_view name) {
    return std::find_if(main.columns.begin(),
                        main.columns.end(),
                        [&](const Column& column) { return column.name == name; }) -
           main.columns.begin();
  };
  const auto columns = static_cast<std::ptrdiff_t>(main.columns.size());
  const std::ptrdiff_t estimate = column_of("estimate");
  const std::ptrdiff_t effect = column_of("effect");
  const bool found = std::any_of(main.rows.begin(), main.rows.end(), [&](const auto& cells) {
    const auto* const kind =
        effect == columns ? nullptr
                          : std::get_if<std::string>(&cells[static_cast<std::size_t>(effect)]);
    const bool counts = kind == nullptr || *kind == "fixed";
    return counts && estimate < columns && is_number(cells[static_cast<std::size_t>(estimate)]);
  });
  if (found || estimate == columns || main.rows.empty()) {
    return true;
  }
  const Table* const brier = report.find("brier");
  return brier != nullptr &&
         std::any_of(brier->rows.begin(), brier->rows.end(), [](const auto& row) {
           return std::any_of(row.begin(), row.end(), is_number);
         });
}

std::string render(const FitReport& report,
                   TableFormat format,
                   std::string_view table,
                   std::size_t width) {
  const auto labelled = [&](Table one) {
    one.synthetic = report.synthetic;
    return render(one, format, width);
  };
  if (!table.empty()) {
    const Table* const chosen = report.find(table);
    if (chosen == nullptr) {
      throw std::invalid_argument("no table '" + std::string(table) + "'");
    }
    return labelled(*chosen);
  }
  if (format == TableFormat::json) {
    return json_document(report);
  }
  if (format == TableFormat::csv || format == TableFormat::jsonl) {
    return report.tables.empty() ? labelled(report.summary) : labelled(report.tables.front());
  }
  if (statistics::has_error(report.conditions) && !has_number(report)) {
    const std::string findings =
        format == TableFormat::text ? findings_text(report.findings, width) : "";
    return labelled(conditions_table(report.conditions)) +
           (findings.empty() ? "" : '\n' + findings);
  }
  if (format == TableFormat::latex) {
    return tables_of(report, labelled);
  }
  return format == TableFormat::markdown ? markdown_document(report) : text_document(report, width);
}

}  // namespace tcert
