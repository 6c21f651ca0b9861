#include <algorithm>
#include <cstddef>

#include "reports/table_formats.hpp"

namespace tcert {
namespace {

std::string heading_of(const Column& column) {
  return column.unit.empty() ? column.heading : column.heading + " [" + column.unit + "]";
}

/// Characters, not bytes: continuation bytes of UTF-8 take no width of their own.
std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
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

std::vector<std::size_t> widths_of(const Grid& grid) {
  std::vector<std::size_t> widths(grid[0].size(), 3);
  for (const auto& row : grid) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      widths[c] = std::max(widths[c], width_of(row[c]));
    }
  }
  return widths;
}

std::string padded(const std::string& text, std::size_t width, bool to_the_left) {
  const std::string space(width - width_of(text), ' ');
  return to_the_left ? text + space : space + text;
}

bool is_text(const Column& column) { return column.kind == ColumnKind::text; }

std::string title_of(const Table& table) {
  return table.n ? table.title + " (n = " + std::to_string(*table.n) + ")" : table.title;
}

void append_line(std::string& out,
                 const Table& table,
                 const std::vector<std::string>& cells,
                 const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    line += (c == 0 ? "" : "  ") + padded(cells[c], widths[c], is_text(table.columns[c]));
  }
  line.erase(line.find_last_not_of(' ') + 1);
  out += line + '\n';
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

std::string render_text(const Table& table) {
  std::string out;
  if (table.synthetic) {
    out += to_string(*table.synthetic) + '\n';
  }
  out += title_of(table) + "\n\n";
  const Grid grid = grid_of(table);
  const auto widths = widths_of(grid);
  append_line(out, table, grid[0], widths);
  std::vector<std::string> rule;
  for (const std::size_t width : widths) {
    rule.emplace_back(width, '-');
  }
  append_line(out, table, rule, widths);
  for (std::size_t r = 1; r < grid.size(); ++r) {
    append_line(out, table, grid[r], widths);
  }
  for (const std::string& note : table.footnotes) {
    out += (&note == &table.footnotes.front() ? "\n" : "") + note + '\n';
  }
  return out;
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
