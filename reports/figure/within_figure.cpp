#include <array>
#include <cmath>
#include <utility>

#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"
#include "reports/figure/h1_figures.hpp"

namespace tcert {
namespace {

constexpr const char* kAllPairs = "all pairs of trials";
constexpr const char* kPairsWithin = "pairs of the same stratum";

/// A score: the table of pooled ones, that of the ones within strata, its columns there.
struct PairedScore {
  const Table* pooled;
  const Table* within;
  const char* column;
  const char* within_column;
  const char* title;
  const char* axis;
};

/// Row of the panel with this predictor; the number of rows if there is none.
std::size_t row_of(const Table& table, const std::string& panel, const std::string& predictor) {
  std::size_t row = 0;
  while (row < table.rows.size() &&
         (text_at(table, row, "panel") != panel || text_at(table, row, "predictor") != predictor)) {
    ++row;
  }
  return row;
}

std::optional<Panel> score_panel(const PairedScore& score, const std::string& panel, Table& data) {
  std::vector<std::string> from_the_top;
  Extent extent;
  extent.add(0.5);
  const auto add = [&](const Table& table, std::size_t row, const std::string& column, bool all) {
    const std::string label =
        predictor_label(text_at(table, row, "predictor")) + (all ? " (all)" : " (within)");
    const double value = number_at(table, row, column);
    const double low = number_at(table, row, column + "_low");
    const double high = number_at(table, row, column + "_high");
    if (!std::isfinite(value)) {
      return;
    }
    from_the_top.push_back(label);
    for (const double one : {value, low, high}) {
      extent.add(one);
    }
    add_figure_row(
        data, "score", {score.title, label, all ? kAllPairs : kPairsWithin}, {value, low, high});
  };
  for (std::size_t row = 0; row < score.within->rows.size(); ++row) {
    if (text_at(*score.within, row, "panel") != panel) {
      continue;
    }
    const std::string predictor = text_at(*score.within, row, "predictor");
    const std::size_t pooled = row_of(*score.pooled, panel, predictor);
    if (pooled < score.pooled->rows.size()) {
      add(*score.pooled, pooled, score.column, true);
    }
    add(*score.within, row, score.within_column, false);
  }
  if (from_the_top.empty()) {
    return std::nullopt;
  }
  Panel one = interval_panel("score", "score", "predictor", from_the_top);
  for (Layer& each : one.layers) {
    each.colour = "pairs";
  }
  one.title = one.name = score.title;
  one.x = axis(score.axis);
  extent.apply(one.x);
  one.references = {{true, 0.5, true}};
  one.height = 0.95;
  return one;
}

}  // namespace

std::optional<Figure> within_figure(const Table& h1,
                                    const Table& h1_within,
                                    const Table& h1_time,
                                    const Table& h1_time_within) {
  if (h1_within.rows.empty()) {
    return std::nullopt;
  }
  const std::string panel = distinct(h1_within, "panel").back();
  Figure figure =
      named("within_strata", "All trials, and within algorithm and lighting", h1_within.synthetic);
  figure.caption =
      "AUC of success and Harrell's C of the time to the goal over all pairs of trials, and over "
      "pairs of the same stratum (algorithm and lighting, unless others were asked for) alone, "
      "with " +
      intervals_of(h1_within, "auc_within") +
      ". What differs between algorithms or lightings before a trial begins cannot help within a "
      "stratum: a score that falls to 0.5 there told groups apart, not trials. Dashed: 0.5, no "
      "use" +
      std::string(panel == "landmark" ? "; landmark panel." : ".");
  figure.key = {"", {kAllPairs, kPairsWithin}};
  figure.data = figure_table(
      figure.name, {"panel", "predictor", "pairs"}, {"score", "score_low", "score_high"});
  const std::array<PairedScore, 2> scores = {
      {{&h1, &h1_within, "auc", "auc_within", "Success", "AUC"},
       {&h1_time, &h1_time_within, "c", "c_within", "Time to the goal", "C"}}};
  for (const PairedScore& score : scores) {
    if (std::optional<Panel> one = score_panel(score, panel, figure.data)) {
      figure.panels.push_back(std::move(*one));
    }
  }
  figure.columns = 2;
  return finished(std::move(figure));
}

}  // namespace tcert
