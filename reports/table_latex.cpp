#include <algorithm>

#include "reports/table_formats.hpp"

namespace tcert {
namespace {

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

/// A cell whose minus signs are signs, not hyphens.
std::string cell_text(const TableCell& cell, const Column& column) {
  std::string text = escaped(printed(cell, column));
  if (column.kind == ColumnKind::text) {
    return text;
  }
  std::string out;
  for (const char c : text) {
    out += c == '-' ? std::string("$-$") : std::string(1, c);
  }
  return out;
}

std::string heading_of(const Column& column) {
  return escaped(column.unit.empty() ? column.heading : column.heading + " [" + column.unit + "]");
}

}  // namespace

std::string render_latex(const Table& table) {
  std::string out = "% needs \\usepackage{booktabs}\n\\begin{table}\n  \\centering\n";
  std::string title = table.title;
  if (table.n) {
    title += " (n = " + std::to_string(*table.n) + ")";
  }
  if (table.synthetic) {
    title = to_string(*table.synthetic) + " " + title;
  }
  out += "  \\caption{" + escaped(title) + "}\n  \\begin{tabular}{";
  for (const Column& column : table.columns) {
    out += column.kind == ColumnKind::text ? 'l' : 'r';
  }
  out += "}\n    \\toprule\n    ";
  for (const Column& column : table.columns) {
    out += (&column == &table.columns.front() ? "" : " & ") + heading_of(column);
  }
  out += " \\\\\n    \\midrule\n";
  for (const auto& row : table.rows) {
    out += "    ";
    for (std::size_t c = 0; c < row.size(); ++c) {
      out += (c == 0 ? "" : " & ") + cell_text(row[c], table.columns[c]);
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
