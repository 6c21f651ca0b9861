#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tcert/region_overlap.hpp>
#include <witness/checker.hpp>

namespace tcert::witness {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMostBreak = 1e-6;    // rad, between pieces: rounding
constexpr double kMostTurn = 3.0;      // rad, of a piece
constexpr double kMostBulge = 5e-5;    // m, of an arc beyond its chord
constexpr double kLongestChord = 0.1;  // m

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

/// How near a path comes to what is not free, and where.
struct Nearest {
  double least_m = kInfinity;
  Point place;
};

/// Looks at one more piece, of this length, in chords.
void look_at(const Piece& piece, double length_m, const BorderCells& borders, Nearest& nearest) {
  const double turn = std::abs(piece.turn_rad);
  const double parts = std::max({1.0,
                                 std::ceil(length_m / kLongestChord),
                                 std::ceil(std::sqrt(length_m * turn / (8.0 * kMostBulge)))});
  const double bulge_m = length_m * turn / (8.0 * parts * parts);
  const auto last = static_cast<std::int64_t>(parts);
  Point a = piece.from;
  for (std::int64_t k = 1; k <= last; ++k) {
    const Point b = k == last ? piece.to : point_at(piece, static_cast<double>(k) / parts);
    const double near_m = borders.distance_m(a, b, nearest.least_m + bulge_m) - bulge_m;
    if (near_m < nearest.least_m) {
      nearest = {near_m, 0.5 * (a + b)};
    }
    a = b;
  }
}

}  // namespace

Checked Checker::check(const Path& path,
                       const Region& start,
                       const Region& goal,
                       const Robot& robot) const {
  Checked checked{fault_of(path, start, goal, robot.min_turn_radius_m), -kInfinity, 0.0, 0.0, {}};
  if (checked.refused.empty() && touch(start, goal)) {
    checked.refused = "S and G overlap";
  }
  if (checked.refused.empty() && borders_.are_cut()) {
    checked.refused = "free cells lie along the border of the lattice";
  }
  const Lattice& lattice = cells_.lattice();
  const auto is_free = [&](Point p) {
    return cells_.is_free(lattice.column_of(p.x_m), lattice.row_of(p.y_m));
  };
  // Of the joints first: what lies between them is then no longer than the lattice.
  const auto is_outside = [&](const Piece& one) { return !is_free(one.from) || !is_free(one.to); };
  if (checked.refused.empty() && std::ranges::any_of(path, is_outside)) {
    checked.refused = "the path leaves F_t";
  }
  if (!checked.refused.empty()) {
    return checked;
  }
  Nearest nearest;
  double curvature = 0.0;
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
    look_at(piece, length_m, borders_, nearest);
    if (bent > curvature) {
      curvature = bent;
      tightest = piece.to;
    }
  }
  if (!(nearest.least_m > 0.0)) {
    checked.refused = "the path leaves F_t";
    return checked;
  }
  const double width_m = 2.0 * nearest.least_m - robot.body_width_m - 2.0 * robot.tracking_buffer_m;
  const double slack_m = 1.0 / (curvature + robot.curvature_buffer_per_m) - robot.min_turn_radius_m;
  checked.clearance_m = nearest.least_m;
  checked.turn_radius_m = 1.0 / curvature;
  checked.margin_m = std::min(width_m, slack_m);
  checked.bottleneck = width_m <= slack_m ? nearest.place : tightest;
  return checked;
}

Checked check(const Path& path,
              const FreeCells& cells,
              const Region& start,
              const Region& goal,
              const Robot& robot) {
  return Checker(cells).check(path, start, goal, robot);
}

}  // namespace tcert::witness
