#include "reports/figure/h1_figures.hpp"

#include <utility>

#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {
namespace {

struct PlanePoint {
  double x = 0.0;
  double y = 0.0;
};

bool straight(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (a.x == b.x && b.x == c.x) || (a.y == b.y && b.y == c.y);
}

/// Corners of a curve.
std::vector<PlanePoint> corners(const std::vector<PlanePoint>& points) {
  std::vector<PlanePoint> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i == 0 || i + 1 == points.size() || !straight(kept.back(), points[i], points[i + 1])) {
      kept.push_back(points[i]);
    }
  }
  return kept;
}

}  // namespace

std::optional<Figure> roc_figure(const Table& h1_roc) {
  Figure figure = named("roc", "Success: ROC curves", h1_roc.synthetic);
  figure.caption =
      "Share of successes called success against share of failures called success, by threshold. "
      "Models are scored on the trials of their fit. Dashed: chance.";
  figure.key.classes = predictor_labels(distinct(h1_roc, "predictor"));
  figure.data =
      figure_table("roc", {"panel", "predictor"}, {"false_success_share", "success_share"});
  for (const std::string& panel : distinct(h1_roc, "panel")) {
    for (const std::string& predictor : distinct(h1_roc, "predictor")) {
      std::vector<PlanePoint> points;
      for (std::size_t row = 0; row < h1_roc.rows.size(); ++row) {
        if (text_at(h1_roc, row, "panel") == panel &&
            text_at(h1_roc, row, "predictor") == predictor) {
          points.push_back(
              {1.0 - number_at(h1_roc, row, "specificity"), number_at(h1_roc, row, "sensitivity")});
        }
      }
      for (const PlanePoint& point : corners(points)) {
        add_figure_row(
            figure.data, "curve", {panel, predictor_label(predictor)}, {point.x, point.y});
      }
    }
    add_figure_row(figure.data, "chance", {panel, ""}, {0.0, 0.0});
    add_figure_row(figure.data, "chance", {panel, ""}, {1.0, 1.0});
    Panel one;
    one.title = panel_title(panel);
    one.name = panel;
    one.x = share_axis("failures called success");
    one.y = share_axis("successes called success");
    Layer curve = layer(Mark::line, "curve", "false_success_share", "success_share");
    curve.colour = "predictor";
    curve.width = 1.8;
    one.layers = {guide("chance", "false_success_share", "success_share"), curve};
    one.height = 1.15;
    figure.panels.push_back(std::move(one));
  }
  figure.columns = 2;
  return finished(std::move(figure));
}

}  // namespace tcert
