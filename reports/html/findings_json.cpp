#include "reports/html/findings_json.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <variant>

namespace tcert {
namespace {

constexpr std::array<std::string_view, 3> kFindingColumns = {"about", "verdict", "evidence"};

OrderedJson cell_text(const TableCell& cell) {
  const auto* const text = std::get_if<std::string>(&cell);
  return text != nullptr ? OrderedJson(*text) : OrderedJson();
}

bool has_verdict(const PageFindings& findings) {
  return std::any_of(findings.table.rows.begin(), findings.table.rows.end(), [](const auto& row) {
    return std::holds_alternative<std::string>(row[1]);
  });
}

struct KindWords {
  ResultKind kind;
  std::string_view title;
  std::string_view question;
};

constexpr std::array<KindWords, 11> kKinds = {{
    {ResultKind::corpus, "Trials", ""},
    {ResultKind::certificates, "Certificates", ""},
    {ResultKind::h1, "H1", "Does the early certificate tell more than counting contacts?"},
    {ResultKind::h2, "H2", "Is it as good in every lighting?"},
    {ResultKind::replays, "Replays under speed laws", ""},
    {ResultKind::h3, "H3", "Does a speed law win time without losing successes?"},
    {ResultKind::ablation, "Ablation", "What does each part of the method add?"},
    {ResultKind::sweep, "Sweep", "Does it depend on the parameters?"},
    {ResultKind::gate, "Gate", "Is a margin of 0 an even chance to pass?"},
    {ResultKind::driven, "Driven trials", ""},
    {ResultKind::h3_driven,
     "H3 in closed loop",
     "Does a speed law in the loop win time without losing successes?"},
}};

const KindWords* words_of_kind(ResultKind kind) {
  const auto* const found = std::find_if(
      kKinds.begin(), kKinds.end(), [&](const KindWords& words) { return words.kind == kind; });
  return found == kKinds.end() ? nullptr : found;
}

}  // namespace

bool is_findings_table(const Table& table) {
  return table.columns.size() == kFindingColumns.size() &&
         std::equal(table.columns.begin(),
                    table.columns.end(),
                    kFindingColumns.begin(),
                    [](const Column& column, std::string_view name) {
                      return column.name == name && column.kind == ColumnKind::text;
                    });
}

std::string result_title(const Result& result) {
  const KindWords* const words = words_of_kind(result.kind);
  const std::string title = words != nullptr ? std::string(words->title) : result.manifest.command;
  // The folder's name says nothing more where it is that of the kind.
  const bool is_plain = result.name == "." || result.name == to_string(result.kind);
  return is_plain ? title : title + " (" + result.name + ")";
}

std::string result_question(const Result& result) {
  const KindWords* const words = words_of_kind(result.kind);
  return words != nullptr ? std::string(words->question) : "";
}

OrderedJson findings_json(const std::vector<PageFindings>& findings) {
  std::vector<const PageFindings*> order;
  for (const bool decided : {true, false}) {
    for (const PageFindings& one : findings) {
      if (has_verdict(one) == decided) {
        order.push_back(&one);
      }
    }
  }
  OrderedJson json = OrderedJson::array();
  for (const PageFindings* const one : order) {
    OrderedJson lines = OrderedJson::array();
    for (const std::vector<TableCell>& row : one->table.rows) {
      lines.push_back({{"about", cell_text(row[0])},
                       {"verdict", cell_text(row[1])},
                       {"evidence", cell_text(row[2])}});
    }
    json.push_back({{"title", one->title},
                    {"question", one->question},
                    {"lines", std::move(lines)},
                    {"rules", one->table.footnotes}});
  }
  return json;
}

}  // namespace tcert
