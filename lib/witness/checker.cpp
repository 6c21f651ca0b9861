#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>
#include <witness/checker.hpp>
#include <witness/region_shape.hpp>

namespace tcert::witness {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMostBreak = 1e-6;    // rad, between pieces: rounding
constexpr double kMostTurn = 3.0;      // rad, of a piece
constexpr double kMostBulge = 5e-5;    // m, of an arc beyond its chord
constexpr double kLongestChord = 0.1;  // m

/// By row, the columns of the cells that are not free and touch a free one: of what is not free,
/// nothing is nearer to a point of the free space.
using Borders = std::vector<std::vector<int>>;

Borders borders_of(const FreeCells& cells) {
  const int rows = cells.lattice().rows;
  Borders borders(static_cast<std::size_t>(rows));
  for (int iy = 0; iy < rows; ++iy) {
    const auto here = cells.row(iy);
    const auto below = cells.row(std::max(iy - 1, 0));
    const auto above = cells.row(std::min(iy + 1, rows - 1));
    const auto any = [&](std::size_t w) { return here[w] | below[w] | above[w]; };
    for (std::size_t w = 0; w < here.size(); ++w) {
      const std::uint64_t left = w > 0 ? any(w - 1) >> 63U : 0U;
      const std::uint64_t right = w + 1 < here.size() ? any(w + 1) << 63U : 0U;
      std::uint64_t bits = (any(w) | any(w) << 1U | left | any(w) >> 1U | right) & ~here[w];
      for (; bits != 0; bits &= bits - 1) {
        borders[static_cast<std::size_t>(iy)].push_back(static_cast<int>(64 * w) +
                                                        std::countr_zero(bits));
      }
    }
  }
  return borders;
}

bool touches_border(const FreeCells& cells) {
  const Lattice& lattice = cells.lattice();
  bool touches = false;
  for (int ix = 0; ix < lattice.columns; ++ix) {
    touches = touches || cells.is_free(ix, 0) || cells.is_free(ix, lattice.rows - 1);
  }
  for (int iy = 0; iy < lattice.rows; ++iy) {
    touches = touches || cells.is_free(0, iy) || cells.is_free(lattice.columns - 1, iy);
  }
  return touches;
}

double distance_to_box(Point p, const Box& box) {
  return norm({std::max({box.low.x_m - p.x_m, 0.0, p.x_m - box.high.x_m}),
               std::max({box.low.y_m - p.y_m, 0.0, p.y_m - box.high.y_m})});
}

double segment_to_box(Point a, Point b, const Box& box) {
  double least = std::min(distance_to_box(a, box), distance_to_box(b, box));
  double left = -kInfinity;
  double right = -kInfinity;
  for (const Point corner :
       {box.low, Point{box.high.x_m, box.low.y_m}, box.high, Point{box.low.x_m, box.high.y_m}}) {
    least = std::min(least, distance_to_segment(corner, a, b));
    const double side = cross(b - a, corner - a);
    left = std::max(left, side);
    right = std::max(right, -side);
  }
  const bool meets = left >= 0.0 && right >= 0.0 && std::max(a.x_m, b.x_m) >= box.low.x_m &&
                     std::min(a.x_m, b.x_m) <= box.high.x_m &&
                     std::max(a.y_m, b.y_m) >= box.low.y_m &&
                     std::min(a.y_m, b.y_m) <= box.high.y_m;
  return meets ? 0.0 : least;
}

/// Lowers `least` to the distance of the segment, less `bulge_m`; true if that is lower.
bool lower(Point a,
           Point b,
           double bulge_m,
           const FreeCells& cells,
           const Borders& borders,
           double& least) {
  const Lattice& lattice = cells.lattice();
  const double reach_m = least + bulge_m;
  const double before = least;
  const int first = std::max(0, lattice.row_of(std::min(a.y_m, b.y_m) - reach_m) - 1);
  const int last = std::min(lattice.rows - 1, lattice.row_of(std::max(a.y_m, b.y_m) + reach_m) + 1);
  const int left = lattice.column_of(std::min(a.x_m, b.x_m) - reach_m) - 1;
  const int right = lattice.column_of(std::max(a.x_m, b.x_m) + reach_m) + 1;
  for (int iy = first; iy <= last; ++iy) {
    const std::vector<int>& row = borders[static_cast<std::size_t>(iy)];
    for (auto ix = std::lower_bound(row.begin(), row.end(), left); ix != row.end() && *ix <= right;
         ++ix) {
      const Box box{lattice.corner(*ix, iy), lattice.corner(*ix + 1, iy + 1)};
      least = std::min(least, segment_to_box(a, b, box) - bulge_m);
    }
  }
  return least < before;
}

std::string fault_of(const Path& path,
                     const Region& start,
                     const Region& goal,
                     double min_turn_radius_m) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Piece& piece = path[i];
    const double sum =
        piece.from.x_m + piece.from.y_m + piece.to.x_m + piece.to.y_m + piece.turn_rad;
    if (!std::isfinite(sum) || !std::isfinite(chord(piece)) || !(chord(piece) > 0.0)) {
      return "a piece is not finite or has no length";
    }
    if (std::abs(piece.turn_rad) > kMostTurn) {
      return "a piece turns by more than 3 rad";
    }
    if (i > 0 && path[i - 1].to != piece.from) {
      return "two pieces do not meet";
    }
    if (i > 0 && min_turn_radius_m > 0.0 &&
        !(std::abs(angle_between(heading_to(path[i - 1]), heading_from(piece))) <= kMostBreak)) {
      return "the path has a corner";
    }
  }
  if (path.empty() || !contains(start, path.front().from)) {
    return "the path does not start in S";
  }
  return contains(goal, path.back().to) ? "" : "the path does not end in G";
}

}  // namespace

Checked check(const Path& path,
              const FreeCells& cells,
              const Region& start,
              const Region& goal,
              const Robot& robot) {
  Checked checked{fault_of(path, start, goal, robot.min_turn_radius_m), -kInfinity, 0.0, 0.0, {}};
  if (checked.refused.empty() && overlap(start, goal)) {
    checked.refused = "S and G overlap";
  }
  if (checked.refused.empty() && touches_border(cells)) {
    checked.refused = "free cells lie along the border of the lattice";
  }
  const Lattice& lattice = cells.lattice();
  const auto is_free = [&](Point p) {
    return cells.is_free(lattice.column_of(p.x_m), lattice.row_of(p.y_m));
  };
  if (!checked.refused.empty() || !is_free(path.front().from)) {
    checked.refused = checked.refused.empty() ? "the path does not start in F_t" : checked.refused;
    return checked;
  }
  const Borders borders = borders_of(cells);
  double least_m = kInfinity;
  double curvature = 0.0;
  Point narrowest;
  Point tightest;
  double break_rad = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Piece& piece = path[i];
    const double turn = std::abs(piece.turn_rad);
    const double half_sine = elementary::sin(0.5 * turn);
    const double length_m = turn > 0.0 ? chord(piece) * 0.5 * turn / half_sine : chord(piece);
    const double next_rad =
        i + 1 < path.size() ? std::abs(angle_between(heading_to(piece), heading_from(path[i + 1])))
                            : 0.0;
    const double bent =
        next_rad > kMostBreak ? kInfinity : (turn + break_rad + next_rad) / length_m;
    break_rad = next_rad > kMostBreak ? 0.0 : next_rad;
    const double parts = std::max({1.0,
                                   std::ceil(length_m / kLongestChord),
                                   std::ceil(std::sqrt(length_m * turn / (8.0 * kMostBulge)))});
    const double bulge_m = length_m * turn / (8.0 * parts * parts);
    Point a = piece.from;
    for (double k = 1.0; k <= parts; ++k) {
      const double part = k / parts;
      const double way_m =
          chord(piece) * (turn > 0.0 ? elementary::sin(0.5 * part * turn) / half_sine : part);
      const Point b =
          k == parts
              ? piece.to
              : piece.from + way_m * direction(heading_from(piece) + 0.5 * part * piece.turn_rad);
      if (lower(a, b, bulge_m, cells, borders, least_m)) {
        narrowest = 0.5 * (a + b);
      }
      a = b;
    }
    if (bent > curvature) {
      curvature = bent;
      tightest = piece.to;
    }
  }
  if (!(least_m > 0.0)) {
    checked.refused = "the path leaves F_t";
    return checked;
  }
  const double width_m = 2.0 * least_m - robot.body_width_m - 2.0 * robot.tracking_buffer_m;
  const double slack_m = 1.0 / (curvature + robot.curvature_buffer_per_m) - robot.min_turn_radius_m;
  checked.clearance_m = least_m;
  checked.turn_radius_m = 1.0 / curvature;
  checked.margin_m = std::min(width_m, slack_m);
  checked.bottleneck = width_m <= slack_m ? narrowest : tightest;
  return checked;
}

}  // namespace tcert::witness
