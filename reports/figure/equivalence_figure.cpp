#include "reports/figure/set_figures.hpp"

#include <table/not_a_number.hpp>

#include <cmath>
#include <utility>

#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {
namespace {

double margin_of(const Table& equality, const std::string& panel, const std::string& quantity) {
  for (std::size_t row = 0; row < equality.rows.size(); ++row) {
    if (text_at(equality, row, "panel") == panel &&
        text_at(equality, row, "quantity") == quantity) {
      return number_at(equality, row, "margin");
    }
  }
  return table::kNaN;
}

}  // namespace

std::optional<Figure> equivalence_figure(const Table& pairs, const Table& equality) {
  if (pairs.rows.empty()) {
    return std::nullopt;
  }
  const std::string last = distinct(pairs, "panel").back();
  Figure figure = named("equivalence", "Is it as good in every lighting?", pairs.synthetic);
  figure.caption =
      "Differences between lightings with 90 % intervals. Equivalent if all three lie within the "
      "dashed margins" +
      std::string(last == "landmark" ? "; landmark panel." : ".");
  figure.data = figure_table(
      "equivalence", {"panel", "pair"}, {"difference", "difference_low", "difference_high"});
  for (const std::string& quantity : distinct(pairs, "quantity")) {
    Extent extent;
    std::vector<std::string> names;
    for (std::size_t row = 0; row < pairs.rows.size(); ++row) {
      if (text_at(pairs, row, "panel") != last || text_at(pairs, row, "quantity") != quantity) {
        continue;
      }
      const std::string pair =
          text_at(pairs, row, "first") + " \u2212 " + text_at(pairs, row, "second");
      const double low = number_at(pairs, row, "difference_low");
      const double high = number_at(pairs, row, "difference_high");
      names.push_back(pair);
      extent.add(number_at(pairs, row, "difference"));
      extent.add(low);
      extent.add(high);
      add_figure_row(
          figure.data, "pair", {quantity, pair}, {number_at(pairs, row, "difference"), low, high});
    }
    if (names.empty()) {
      continue;
    }
    Panel one = interval_panel("pair", "difference", "pair", names);
    one.name = quantity;
    one.x = axis("difference of " + quantity);
    one.references = {{true, 0.0, false}};
    if (const double margin = margin_of(equality, last, quantity); std::isfinite(margin)) {
      one.references.push_back({true, margin, true});
      one.references.push_back({true, -margin, true});
      extent.add(margin);
      extent.add(-margin);
    }
    extent.apply(one.x);
    one.height = 0.5;
    figure.panels.push_back(std::move(one));
  }
  figure.columns = 2;
  return finished(std::move(figure));
}

}  // namespace tcert
