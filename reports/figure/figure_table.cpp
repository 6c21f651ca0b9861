#include "reports/figure/figure_table.hpp"

#include <algorithm>
#include <cmath>
#include <table/round_number.hpp>
#include <utility>

namespace tcert {

bool is_control(char c) noexcept {
  const auto code = static_cast<unsigned char>(c);
  return code < 0x20U || code == 0x7FU;
}

std::string intervals_of(const Table& table, std::string_view column) {
  for (const Column& one : table.columns) {
    const std::size_t open = one.heading.find('[');
    const std::size_t close = one.heading.find(']', open == std::string::npos ? 0 : open);
    if (one.name == column && open != std::string::npos && close != std::string::npos) {
      return one.heading.substr(open + 1, close - open - 1) + " intervals";
    }
  }
  return "intervals";
}

std::vector<std::string> distinct(const Table& table, std::string_view column) {
  std::vector<std::string> values;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::string value = text_at(table, row, column);
    if (!value.empty() && std::find(values.begin(), values.end(), value) == values.end()) {
      values.push_back(value);
    }
  }
  return values;
}

Table figure_table(std::string name,
                   const std::vector<std::string>& texts,
                   const std::vector<std::string>& numbers) {
  Table table;
  table.name = std::move(name);
  table.columns.push_back({"part", "part", "", ColumnKind::text});
  for (const std::string& text : texts) {
    table.columns.push_back({text, text, "", ColumnKind::text});
  }
  for (const std::string& number : numbers) {
    table.columns.push_back({number, number, "", ColumnKind::number});
  }
  return table;
}

void add_figure_row(Table& table,
                    const std::string& part,
                    const std::vector<std::string>& texts,
                    const std::vector<double>& numbers) {
  std::vector<TableCell> cells(1 + texts.size() + numbers.size());
  cells[0] = part;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (!texts[i].empty()) {
      cells[1 + i] = texts[i];
    }
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (std::isfinite(numbers[i])) {
      cells[1 + texts.size() + i] = Number{numbers[i]};
    }
  }
  table.add_row(std::move(cells));
}

void make_plain(Figure& figure) {
  const auto plain = [](std::string& text) {
    std::replace(text.begin(), text.end(), ',', ';');
    std::replace(text.begin(), text.end(), '"', '\'');
    std::replace_if(text.begin(), text.end(), is_control, ' ');
  };
  for (auto& row : figure.data.rows) {
    for (TableCell& cell : row) {
      if (auto* const text = std::get_if<std::string>(&cell)) {
        plain(*text);
      }
    }
  }
  for (std::string& name : figure.key.classes) {
    plain(name);
  }
  for (std::string* const text : {&figure.name, &figure.title, &figure.caption}) {
    std::replace_if(text->begin(), text->end(), is_control, ' ');
  }
  for (Panel& panel : figure.panels) {
    plain(panel.name);
    std::replace_if(panel.title.begin(), panel.title.end(), is_control, ' ');
    for (Axis* const axis : {&panel.x, &panel.y}) {
      for (std::string& name : axis->categories) {
        plain(name);
      }
    }
    for (Layer& layer : panel.layers) {
      plain(layer.label);
    }
  }
}

double round_step(double span, int parts) { return table::round_number_from(span / parts); }

std::vector<double> round_ticks(double low, double high, int most) {
  std::vector<double> ticks;
  if (!(low < high)) {
    return ticks;
  }
  const double step = round_step(high - low, most);
  // Whole numbers by a power of ten: the double that is nearest to what the label says.
  const double scale = std::pow(10.0, std::max(0.0, std::ceil(-std::log10(step) - 1e-9)));
  const double first = std::ceil(low / step - 1e-9);
  const auto more = static_cast<int>(std::floor(high / step + 1e-9) - first);
  for (int k = 0; k <= more; ++k) {
    ticks.push_back(std::round((first + k) * step * scale) / scale + 0.0);
  }
  return ticks;
}

std::vector<double> ratio_ticks(double low, double high) {
  if (high / low < 3.0) {
    return round_ticks(low, high, 5);  // Nearly a linear scale.
  }
  std::vector<double> candidates = {0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0};
  if (high / low >= 6.0) {
    const bool wide = high / low > 500.0;
    candidates.clear();
    for (int power = -9; power <= 9; ++power) {
      for (const double factor : wide ? std::vector{1.0} : std::vector{1.0, 2.0, 5.0}) {
        candidates.push_back(factor * std::pow(10.0, power));
      }
    }
  }
  std::vector<double> ticks;
  for (const double tick : candidates) {
    if (tick >= low && tick <= high) {
      ticks.push_back(tick);
    }
  }
  return ticks;
}

}  // namespace tcert
