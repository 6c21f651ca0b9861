#include <algorithm>
#include <cstddef>

#include "reports/table_formats.hpp"
#include "reports/text_width.hpp"

namespace tcert {
namespace {

constexpr std::string_view kBetween = "  ";

std::string plain_heading(const Column& column) {
  return column.unit.empty() ? column.heading : column.heading + " [" + column.unit + "]";
}

using Grid = std::vector<std::vector<std::string>>;

/// Heading row first.
Grid grid_of(const Table& table) {
  Grid grid(table.rows.size() + 1);
  for (const Column& column : table.columns) {
    grid[0].push_back(plain_heading(column));
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

/// What is printed of a table, and how wide.
struct Layout {
  std::vector<Column> columns;
  Grid grid;
  std::vector<std::size_t> widths;
  std::vector<std::string> left_out;  ///< Headings of columns that are not printed.

  void leave_out(std::size_t c) {
    const auto at = static_cast<std::ptrdiff_t>(c);
    left_out.insert(left_out.begin(), grid[0][c]);
    columns.erase(columns.begin() + at);
    widths.erase(widths.begin() + at);
    for (auto& row : grid) {
      row.erase(row.begin() + at);
    }
  }

  /// All rows have the same in column `c`.
  [[nodiscard]] bool is_constant(std::size_t c) const {
    return grid.size() > 2 && std::all_of(grid.begin() + 2, grid.end(), [&](const auto& row) {
             return row[c] == grid[1][c];
           });
  }

  /// The widest column of texts behind the first one; 0 if there is none.
  [[nodiscard]] std::size_t widest_text() const {
    std::size_t widest = 0;
    for (std::size_t c = 1; c < widths.size(); ++c) {
      if (is_text(columns[c]) && (widest == 0 || widths[c] > widths[widest])) {
        widest = c;
      }
    }
    return widest;
  }
};

/// For a line of `width`: headings are broken first, then the cells of the widest text; then
/// columns that say the same in every row are left out, and in the end those on the right, down to
/// two; what the table is for stays.
Layout layout_of(const Table& table, std::size_t width) {
  constexpr std::size_t kReadable = 24;  // What a text that is broken has at least.
  Layout layout{table.columns, grid_of(table), {}, {}};
  layout.widths = widths_of(layout.grid);
  if (width == 0 || total_of(layout.widths) <= width) {
    return layout;
  }
  layout.widths = narrow_widths_of(layout.grid);
  std::size_t text = layout.widest_text();
  const std::size_t whole = text > 0 ? layout.widths[text] : 0;
  if (text > 0) {
    layout.widths[text] = std::min(whole, kReadable);
  }
  const auto leave_out = [&](std::size_t c) {
    layout.leave_out(c);
    text -= c < text ? 1 : 0;
  };
  for (std::size_t c = layout.widths.size(); c-- > 1 && total_of(layout.widths) > width;) {
    if (c != text && !layout.columns[c].is_answer && layout.is_constant(c)) {
      leave_out(c);
    }
  }
  for (std::size_t c = layout.widths.size();
       c-- > 1 && layout.widths.size() > 2 && total_of(layout.widths) > width;) {
    if (c != text && !layout.columns[c].is_answer) {
      leave_out(c);
    }
  }
  if (const std::size_t total = total_of(layout.widths); text > 0 && total < width) {
    layout.widths[text] = std::min(whole, layout.widths[text] + width - total);
  }
  return layout;
}

/// A word longer than `width` sticks out.
std::string padded(const std::string& text, std::size_t width, bool to_the_left) {
  const std::string space(width - std::min(width, width_of(text)), ' ');
  return to_the_left ? text + space : space + text;
}

std::string title_of(const Table& table) {
  return table.n ? table.title + " (n = " + std::to_string(*table.n) + ")" : table.title;
}

void append_line(std::string& out,
                 const std::vector<Column>& columns,
                 const std::vector<std::string>& cells,
                 const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t c = 0; c < widths.size(); ++c) {
    line += c == 0 ? "" : kBetween;
    line += padded(cells[c], widths[c], is_text(columns[c]));
  }
  line.erase(line.find_last_not_of(' ') + 1);
  out += line + '\n';
}

/// A row whose cells are broken to the widths: they begin on its first line, headings end on its
/// last.
void append_broken(std::string& out,
                   const Layout& layout,
                   const std::vector<std::string>& cells,
                   bool is_heading) {
  std::vector<std::vector<std::string>> parts;
  std::size_t lines = 1;
  for (std::size_t c = 0; c < layout.widths.size(); ++c) {
    const std::size_t width = layout.widths[c];
    parts.push_back(width_of(cells[c]) <= width ? std::vector{cells[c]} : broken(cells[c], width));
    lines = std::max(lines, parts.back().size());
  }
  for (std::size_t line = 0; line < lines; ++line) {
    std::vector<std::string> row;
    for (const std::vector<std::string>& part : parts) {
      const std::size_t before = is_heading ? lines - part.size() : 0;
      row.push_back(line < before || line - before >= part.size() ? "" : part[line - before]);
    }
    append_line(out, layout.columns, row, layout.widths);
  }
}

/// Which columns are not there, and how to see them.
std::string words_of(const std::vector<std::string>& left_out) {
  std::string names;
  for (const std::string& heading : left_out) {
    names += heading.empty() ? "" : (names.empty() ? "" : ", ") + heading;
  }
  return "Not shown, for want of width (--wide shows all): " + names + ".";
}

bool has_headings(const Grid& grid) {
  return std::any_of(
      grid[0].begin(), grid[0].end(), [](const std::string& text) { return !text.empty(); });
}

std::string markdown_escaped(std::string_view text) {
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
  out += wrapped(title_of(table), width) + "\n\n";
  const Layout layout = layout_of(table, width);
  if (has_headings(layout.grid)) {
    append_broken(out, layout, layout.grid[0], true);
    std::vector<std::string> rule;
    for (const std::size_t one : layout.widths) {
      rule.emplace_back(one, '-');
    }
    append_line(out, layout.columns, rule, layout.widths);
  }
  for (std::size_t r = 1; r < layout.grid.size(); ++r) {
    append_broken(out, layout, layout.grid[r], false);
  }
  std::string notes;
  if (!layout.left_out.empty()) {
    notes += '\n' + words_of(layout.left_out) + '\n';
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
  out += "### " + markdown_escaped(title_of(table)) + "\n\n";
  Grid grid = grid_of(table);
  for (auto& row : grid) {
    std::transform(row.begin(), row.end(), row.begin(), markdown_escaped);
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
    out += '\n' + markdown_escaped(note) + '\n';
  }
  return out;
}

}  // namespace tcert
