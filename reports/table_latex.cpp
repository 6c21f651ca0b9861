#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reports/table_formats.hpp"

namespace tcert {
namespace {

/// Columns from which a table is set smaller.
constexpr std::size_t kWide = 8;

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
      case '%':
      case '$':
      case '#':
      case '_':
      case '{':
      case '}':
        out += '\\';
        out += c;
        break;
      case '\\':
        out += "\\textbackslash{}";
        break;
      case '~':
        out += "\\textasciitilde{}";
        break;
      case '^':
        out += "\\textasciicircum{}";
        break;
      case '<':
        out += "$<$";
        break;
      case '>':
        out += "$>$";
        break;
      case '[':  // After \\ it would be an option.
        out += "{[}";
        break;
      case '\n':
      case '\r':
        out += ' ';
        break;
      default:
        out += c;
    }
  }
  return out;
}

/// Minus signs that are signs, not hyphens.
std::string with_minus(const std::string& text) {
  std::string out;
  for (const char c : text) {
    out += c == '-' ? std::string("$-$") : std::string(1, c);
  }
  return out;
}

std::string heading_of(const Column& column) {
  return escaped(column.unit.empty() ? column.heading : column.heading + " [" + column.unit + "]");
}

/// What an S column of siunitx needs to know; empty if a number has an exponent.
std::optional<std::string> number_format(const std::vector<std::string>& numbers) {
  std::size_t whole = 1;
  std::size_t decimals = 0;
  bool negative = false;
  bool bounded = false;
  for (const std::string& text : numbers) {
    if (text.find('e') != std::string::npos) {
      return std::nullopt;
    }
    const std::size_t begin = text.find_first_of("0123456789");
    if (begin == std::string::npos) {
      continue;
    }
    negative = negative || text.find('-') < begin;
    bounded = bounded || text.find('<') < begin;
    const std::size_t point = std::min(text.find('.'), text.size());
    whole = std::max(whole, point - begin);
    decimals = std::max(decimals, text.size() - std::min(point + 1, text.size()));
  }
  return (bounded ? std::string("<") : "") + (negative ? "-" : "") + std::to_string(whole) +
         (decimals > 0 ? "." + std::to_string(decimals) : "");
}

/// A number in an S column; what is none stands in braces.
std::string aligned(const std::string& text) {
  const bool is_number = text.find_first_of("0123456789") != std::string::npos &&
                         text.find_first_not_of("0123456789.-<") == std::string::npos;
  return is_number ? text : "{" + escaped(text) + "}";
}

/// One column of a table as one or, for an estimate beside its interval, two of LaTeX.
struct LatexColumn {
  std::string specification;
  std::string heading;
  std::vector<std::string> cells;  ///< With the & between two.
};

LatexColumn text_cells(const Column& column, const std::vector<std::string>& printed_cells) {
  LatexColumn latex{column.kind == ColumnKind::text ? "l" : "r", heading_of(column), {}};
  for (const std::string& text : printed_cells) {
    latex.cells.push_back(column.kind == ColumnKind::text ? escaped(text)
                                                          : with_minus(escaped(text)));
  }
  return latex;
}

LatexColumn latex_column(const Table& table, std::size_t c) {
  const Column& column = table.columns[c];
  std::vector<std::string> whole;
  for (const auto& row : table.rows) {
    whole.push_back(printed(row[c], column));
  }
  if (column.kind == ColumnKind::text) {
    return text_cells(column, whole);
  }
  std::vector<std::string> values;
  std::vector<std::string> intervals;
  for (const std::string& text : whole) {
    const std::size_t space =
        column.kind == ColumnKind::estimate ? std::min(text.find(' '), text.size()) : text.size();
    values.push_back(text.substr(0, space));
    intervals.push_back(space < text.size() ? text.substr(space + 1) : "");
  }
  const std::optional<std::string> format = number_format(values);
  if (!format) {
    return text_cells(column, whole);
  }
  LatexColumn latex{"S[table-format=" + *format + "]", "{" + heading_of(column) + "}", {}};
  const bool pair = column.kind == ColumnKind::estimate;
  if (pair) {
    latex.specification += "@{\\ }r";
    latex.heading = "\\multicolumn{2}{c}{" + heading_of(column) + "}";
  }
  for (std::size_t r = 0; r < values.size(); ++r) {
    latex.cells.push_back(aligned(values[r]) +
                          (pair ? " & " + with_minus(escaped(intervals[r])) : ""));
  }
  return latex;
}

}  // namespace

std::string render_latex(const Table& table) {
  std::string out =
      "% needs \\usepackage{booktabs} and \\usepackage{siunitx}, version 3\n\\begin{table}\n"
      "  \\centering\n";
  std::string title = table.title;
  if (table.n) {
    title += " (n = " + std::to_string(*table.n) + ")";
  }
  if (table.synthetic) {
    title = to_string(*table.synthetic) + " " + title;
  }
  out += "  \\caption{" + escaped(title) + "}\n";
  if (table.columns.size() > kWide) {
    out += "  \\footnotesize\\setlength{\\tabcolsep}{3pt}\n";
  }
  std::vector<LatexColumn> columns;
  out += "  \\begin{tabular}{";
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    columns.push_back(latex_column(table, c));
    out += columns.back().specification;
  }
  out += "}\n    \\toprule\n    ";
  for (std::size_t c = 0; c < columns.size(); ++c) {
    out += (c == 0 ? "" : " & ") + columns[c].heading;
  }
  out += " \\\\\n    \\midrule\n";
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    out += "    ";
    for (std::size_t c = 0; c < columns.size(); ++c) {
      out += (c == 0 ? "" : " & ") + columns[c].cells[r];
    }
    out += " \\\\\n";
  }
  out += "    \\bottomrule\n  \\end{tabular}\n";
  for (const std::string& note : table.footnotes) {
    out += "\n  {\\footnotesize " + escaped(note) + "\\par}\n";
  }
  return out + "\\end{table}\n";
}

}  // namespace tcert
