#include "reports/world_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tcert {
namespace {

constexpr double kLongSide = 900.0;  // pixels
constexpr double kMargin = 10.0;

class Canvas {
 public:
  explicit Canvas(const Bounds& bounds) : bounds_(bounds) {
    const Point size = bounds.high - bounds.low;
    scale_ = kLongSide / std::max(size.x_m, size.y_m);
    text_ = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:.1f} {1:.1f}" width="{0:.0f}" height="{1:.0f}">
)",
        size.x_m * scale_ + 2.0 * kMargin,
        size.y_m * scale_ + 2.0 * kMargin);
    text_ += fmt::format(
        R"(<rect width="100%" height="100%" fill="#d0d0d0"/>
<rect x="{0}" y="{0}" width="{1:.2f}" height="{2:.2f}" fill="#ffffff"/>
)",
        kMargin,
        size.x_m * scale_,
        size.y_m * scale_);
  }

  void region(const Region& region, const char* style) {
    if (const auto* disc = std::get_if<Disc>(&region)) {
      const Point c = at(disc->centre);
      text_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" {}/>\n",
                           c.x_m,
                           c.y_m,
                           disc->radius_m * scale_,
                           style);
      return;
    }
    shape("polygon", std::get<Polygon>(region).vertices, style);
  }

  void line(const std::vector<Point>& points, const char* style) {
    if (!points.empty()) {
      shape("polyline", points, style);
    }
  }

  [[nodiscard]] std::string take(const std::string& title) {
    return text_ + "<title>" + title + "</title>\n</svg>\n";
  }

 private:
  [[nodiscard]] Point at(Point p) const {
    return {kMargin + (p.x_m - bounds_.low.x_m) * scale_,
            kMargin + (bounds_.high.y_m - p.y_m) * scale_};
  }

  void shape(const char* kind, const std::vector<Point>& points, const char* style) {
    text_ += fmt::format("<{} points=\"", kind);
    for (const Point p : points) {
      const Point q = at(p);
      text_ += fmt::format("{:.2f},{:.2f} ", q.x_m, q.y_m);
    }
    text_ += fmt::format("\" {}/>\n", style);
  }

  Bounds bounds_;
  double scale_ = 1.0;
  std::string text_;
};

std::vector<Point> points_of(const std::vector<study::Arc>& path) {
  std::vector<Point> points;
  for (const study::Arc& arc : path) {
    constexpr int kPieces = 6;
    for (int i = 0; i < kPieces; ++i) {
      points.push_back(study::pose_at(arc, arc.length_m * i / kPieces).position);
    }
  }
  if (!path.empty()) {
    points.push_back(study::pose_at(path.back(), path.back().length_m).position);
  }
  return points;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  }
  return result;
}

std::string metres(double value) {
  return std::isfinite(value) ? fmt::format("{:.4f} m", value) : "no path";
}

}  // namespace

std::string world_picture(const World& world,
                          const study::Truth& truth,
                          const std::vector<Point>& widest) {
  Canvas canvas(world.bounds);
  canvas.region(*world.start, R"(fill="#a6dba0")");
  canvas.region(*world.goal, R"(fill="#92c5de")");
  for (const Region& obstacle : world.obstacles) {
    canvas.region(obstacle, R"(fill="#808080")");
  }
  canvas.line(widest, R"(fill="none" stroke="#f4a582" stroke-width="3")");
  canvas.line(points_of(truth.path), R"(fill="none" stroke="#2166ac" stroke-width="2")");
  if (truth.clearance.bottleneck) {
    canvas.region(Disc{*truth.clearance.bottleneck, truth.clearance.clearance_m},
                  R"(fill="none" stroke="#b2182b" stroke-width="2")");
  }
  return canvas.take(fmt::format("{}{}: T at least {}, at most {}",
                                 world.synthetic ? "SYNTHETIC " : "",
                                 escaped(world.name),
                                 metres(truth.lower_m),
                                 metres(truth.upper_m)));
}

}  // namespace tcert
