#include <cmath>
#include <utility>

#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"
#include "reports/figure/h1_figures.hpp"

namespace tcert {
namespace {

/// More clusters than this are no figure.
constexpr std::size_t kMostLeftOut = 80;

}  // namespace

std::optional<Figure> left_out_figure(const Table& h1, const Table& h1_left_out) {
  const std::vector<std::string> clusters = distinct(h1_left_out, "without");
  if (clusters.empty() || clusters.size() > kMostLeftOut) {
    return std::nullopt;
  }
  const std::string panel = distinct(h1_left_out, "panel").back();
  Figure figure =
      named("left_out", "The gain in AUC without each day in turn", h1_left_out.synthetic);
  figure.caption =
      "The gain in AUC of the predictor under test over each of its rivals and over all of them "
      "together, and what it adds to them, without the cluster named on the left (a day, unless "
      "others were asked for). Dashed: the gain of all trials. A "
      "result that hangs on one cluster has a point far from its line" +
      std::string(panel == "landmark" ? "; landmark panel." : ".");
  figure.data = figure_table(figure.name, {"panel", "without"}, {"auc_gain"});
  std::vector<std::string> from_the_bottom(clusters.rbegin(), clusters.rend());
  Extent extent;
  extent.add(0.0);
  for (std::size_t row = 0; row < h1.rows.size(); ++row) {
    const double whole = number_at(h1, row, "auc_gain");
    const std::string predictor = text_at(h1, row, "predictor");
    if (text_at(h1, row, "panel") != panel || !std::isfinite(whole)) {
      continue;
    }
    Panel one;
    one.title = one.name = predictor_label(predictor);
    for (std::size_t k = 0; k < h1_left_out.rows.size(); ++k) {
      const double gain = number_at(h1_left_out, k, "auc_gain");
      if (text_at(h1_left_out, k, "panel") == panel &&
          text_at(h1_left_out, k, "predictor") == predictor && std::isfinite(gain)) {
        add_figure_row(figure.data, "gain", {one.name, text_at(h1_left_out, k, "without")}, {gain});
        extent.add(gain);
      }
    }
    extent.add(whole);
    one.layers = {layer(Mark::point, "gain", "auc_gain", "without")};
    one.x = axis("gain in AUC");
    one.y = axis("without");
    one.y.scale = AxisScale::categories;
    one.y.categories = from_the_bottom;
    one.references = {{true, 0.0, false}, {true, whole, true}};
    one.height = 0.35 + 0.05 * static_cast<double>(clusters.size());
    figure.panels.push_back(std::move(one));
  }
  for (Panel& one : figure.panels) {
    extent.apply(one.x);
  }
  figure.columns = 3;
  return finished(std::move(figure));
}

}  // namespace tcert
