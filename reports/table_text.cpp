#include <algorithm>
#include <cstddef>

#include "reports/table_formats.hpp"
#include "reports/text_width.hpp"

namespace tcert {
namespace {

constexpr std::string_view kBetween = "  ";

std::string heading_of(const Column& column) {
  return column.unit.empty() ? column.heading : column.heading + " [" + column.unit + "]";
}

using Grid = std::vector<std::vector<std::string>>;

/// Heading row first.
Grid grid_of(const Table& table) {
  Grid grid(table.rows.size() + 1);
  for (const Column& column : table.columns) {
    grid[0].push_back(heading_of(column));
  }
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      grid[r + 1].push_back(printed(table.rows[r][c], table.columns[c]));
    }
  }
  return grid;
}

std::vector<std::size_t> widths_of(const Grid& grid, std::size_t first_row = 0) {
  std::vector<std::size_t> widths(grid[0].size(), 3);
  for (std::size_t r = first_row; r < grid.size(); ++r) {
    for (std::size_t c = 0; c < widths.size(); ++c) {
      widths[c] = std::max(widths[c], width_of(grid[r][c]));
    }
  }
  return widths;
}

/// Wide enough for every cell and every word of the heading.
std::vector<std::size_t> narrow_widths_of(const Grid& grid) {
  std::vector<std::size_t> widths = widths_of(grid, 1);
  for (std::size_t c = 0; c < widths.size(); ++c) {
    for (const std::string& word : broken(grid[0][c], 1)) {
      widths[c] = std::max(widths[c], width_of(word));
    }
  }
  return widths;
}

std::size_t total_of(const std::vector<std::size_t>& widths) {
  std::size_t total = 0;
  for (const std::size_t one : widths) {
    total += one + (total > 0 ? kBetween.size() : 0);
  }
  return total;
}

bool is_text(const Column& column) { return column.kind == ColumnKind::text; }

/// Widths for a line of `width`: headings are broken first, then the cells of the widest text; what
/// does not fit then is left out from the right, down to two columns.
std::vector<std::size_t> fitted_widths(const Table& table, const Grid& grid, std::size_t width) {
  constexpr std::size_t kReadable = 24;  // What a text that is broken has at least.
  std::vector<std::size_t> widths = widths_of(grid);
  if (width == 0 || total_of(widths) <= width) {
    return widths;
  }
  widths = narrow_widths_of(grid);
  std::size_t widest = 0;
  for (std::size_t c = 1; c < widths.size(); ++c) {
    if (is_text(table.columns[c]) && (widest == 0 || widths[c] > widths[widest])) {
      widest = c;
    }
  }
  const std::size_t total = total_of(widths);
  if (widest > 0 && total > width && widths[widest] >= total - width + kReadable) {
    widths[widest] -= total - width;
  }
  while (widths.size() > 2 && total_of(widths) > width) {
    widths.pop_back();
  }
  return widths;
}

/// A word longer than `width` sticks out.
std::string padded(const std::string& text, std::size_t width, bool to_the_left) {
  const std::string space(width - std::min(width, width_of(text)), ' ');
  return to_the_left ? text + space : space + text;
}

std::string title_of(const Table& table) {
  return table.n ? table.title + " (n = " + std::to_string(*table.n) + ")" : table.title;
}

/// The first cells of a row, as many as there are widths.
void append_line(std::string& out,
                 const Table& table,
                 const std::vector<std::string>& cells,
                 const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t c = 0; c < widths.size(); ++c) {
    line += c == 0 ? "" : kBetween;
    line += padded(cells[c], widths[c], is_text(table.columns[c]));
  }
  line.erase(line.find_last_not_of(' ') + 1);
  out += line + '\n';
}

/// A row whose cells are broken to the widths: they begin on its first line, headings end on its
/// last.
void append_broken(std::string& out,
                   const Table& table,
                   const std::vector<std::string>& cells,
                   const std::vector<std::size_t>& widths,
                   bool is_heading) {
  std::vector<std::vector<std::string>> parts;
  std::size_t lines = 1;
  for (std::size_t c = 0; c < widths.size(); ++c) {
    parts.push_back(width_of(cells[c]) <= widths[c] ? std::vector{cells[c]}
                                                    : broken(cells[c], widths[c]));
    lines = std::max(lines, parts.back().size());
  }
  for (std::size_t line = 0; line < lines; ++line) {
    std::vector<std::string> row;
    for (const std::vector<std::string>& part : parts) {
      const std::size_t before = is_heading ? lines - part.size() : 0;
      row.push_back(line < before || line - before >= part.size() ? "" : part[line - before]);
    }
    append_line(out, table, row, widths);
  }
}

/// Which columns are not there, and how to see them.
std::string left_out(const std::vector<std::string>& headings, std::size_t shown) {
  std::string names;
  for (std::size_t c = shown; c < headings.size(); ++c) {
    names += (c == shown ? "" : ", ") + headings[c];
  }
  return "Not shown, for want of width (--wide shows all): " + names + ".";
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\n' || c == '\r') {
      out += ' ';
      continue;
    }
    if (c == '|' || c == '\\' || c == '*' || c == '_' || c == '`' || c == '<') {
      out += '\\';
    }
    out += c;
  }
  return out;
}

}  // namespace

std::string render_text(const Table& table, std::size_t width) {
  std::string out;
  if (table.synthetic) {
    out += to_string(*table.synthetic) + '\n';
  }
  out += title_of(table) + "\n\n";
  const Grid grid = grid_of(table);
  const std::vector<std::size_t> widths = fitted_widths(table, grid, width);
  append_broken(out, table, grid[0], widths, true);
  std::vector<std::string> rule;
  for (const std::size_t one : widths) {
    rule.emplace_back(one, '-');
  }
  append_line(out, table, rule, widths);
  for (std::size_t r = 1; r < grid.size(); ++r) {
    append_broken(out, table, grid[r], widths, false);
  }
  std::string notes;
  if (widths.size() < table.columns.size()) {
    notes += '\n' + left_out(grid[0], widths.size()) + '\n';
  }
  for (const std::string& note : table.footnotes) {
    notes += (&note == &table.footnotes.front() ? "\n" : "") + note + '\n';
  }
  return out + wrapped(notes, width);
}

std::string render_markdown(const Table& table) {
  std::string out;
  if (table.synthetic) {
    out += "**" + to_string(*table.synthetic) + "**\n\n";
  }
  out += "### " + escaped(title_of(table)) + "\n\n";
  Grid grid = grid_of(table);
  for (auto& row : grid) {
    std::transform(row.begin(), row.end(), row.begin(), escaped);
  }
  const auto widths = widths_of(grid);
  for (std::size_t r = 0; r < grid.size(); ++r) {
    out += '|';
    for (std::size_t c = 0; c < widths.size(); ++c) {
      out += ' ' + padded(grid[r][c], widths[c], is_text(table.columns[c])) + " |";
    }
    out += '\n';
    if (r > 0) {
      continue;
    }
    out += '|';
    for (std::size_t c = 0; c < widths.size(); ++c) {
      const std::string dashes(widths[c] + 1, '-');
      out += is_text(table.columns[c]) ? dashes + "-|" : dashes + ":|";
    }
    out += '\n';
  }
  for (const std::string& note : table.footnotes) {
    out += '\n' + escaped(note) + '\n';
  }
  return out;
}

}  // namespace tcert
