#include "reports/findings.hpp"

#include <cmath>
#include <utility>

#include "reports/columns_of.hpp"
#include "reports/text_width.hpp"

namespace tcert {
namespace {

constexpr int kMostDecimals = 6;

}  // namespace

Table findings_table(const std::vector<Finding>& findings, std::vector<std::string> rules) {
  const auto columns =
      ColumnsOf<Finding>()
          .text("about", "about", &Finding::about)
          .text("verdict", "verdict", [](auto& one) { return not_empty(one.verdict); })
          .text("evidence", "evidence", &Finding::evidence);
  Table table = columns.table("findings", "What was found", findings);
  table.footnotes = std::move(rules);
  return table;
}

std::string findings_text(const Table& findings, std::size_t width) {
  std::string text;
  for (const std::vector<TableCell>& row : findings.rows) {
    const auto* const verdict = std::get_if<std::string>(&row[1]);
    text += std::get<std::string>(row[0]) + ": " + (verdict != nullptr ? *verdict + ". " : "") +
            std::get<std::string>(row[2]) + '\n';
  }
  for (const std::string& rule : findings.footnotes) {
    text += rule + '\n';
  }
  return wrapped(text, width);
}

std::string in_words(const std::optional<double>& value,
                     const std::optional<statistics::Interval>& interval,
                     int decimals) {
  // A bound that lies beside 0 is not printed as 0: its side decides.
  const auto is_lost = [&](double bound) {
    return bound != 0.0 && std::abs(bound) < 0.5 * std::pow(10.0, -decimals);
  };
  while (interval && decimals < kMostDecimals &&
         (is_lost(interval->low) || is_lost(interval->high))) {
    ++decimals;
  }
  Column column = estimate_column("", "");
  column.decimals = decimals;
  return printed(estimate_cell(value, interval), column);
}

}  // namespace tcert
