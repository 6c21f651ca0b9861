#pragma once
/// \file
/// What the results found, as the page's first section shows it.

#include <string>
#include <vector>

#include "reports/results/results.hpp"
#include "reports/table.hpp"
#include "reports/table_json.hpp"

namespace tcert {

/// The findings of one result.
struct PageFindings {
  std::string title;     ///< result_title().
  std::string question;  ///< result_question().
  Table table;           ///< Of findings_table().
};

/// True if the table has the columns of findings_table(); one of another make is a plain table.
[[nodiscard]] bool is_findings_table(const Table& table);

/// What a result is, for a heading: "H1", "Certificates", the command of any other; the folder's
/// name behind it where it says something else.
[[nodiscard]] std::string result_title(const Result& result);

/// The question that a result answers; empty if it answers none.
[[nodiscard]] std::string result_question(const Result& result);

/// An object a result: title, question, rules, and lines of about, verdict (null without one) and
/// evidence. Results with a verdict come first.
[[nodiscard]] OrderedJson findings_json(const std::vector<PageFindings>& findings);

}  // namespace tcert
