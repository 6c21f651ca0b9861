#include <algorithm>
#include <array>
#include <cmath>
#include <terrain/pursuit.hpp>
#include <terrain/routes.hpp>

namespace tcert::terrain {
namespace {

[[nodiscard]] bool is_ground(const Grid& grid, const CellSet& ground, const Position& p) {
  const Cell c = nearest_cell(p);
  return grid.contains(c) && ground[grid.index(c)] != 0;
}

/// Where a segment crosses lines that part cells, as shares of it, one after the other from its
/// begin to its end, both included. Between two of them all points round to one cell: that of the
/// middle.
class Crossings {
 public:
  Crossings(const Position& a, const Position& b) : axes_{Axis(a[0], b[0]), Axis(a[1], b[1])} {}

  /// The next share; false after the last, 1.
  bool next(double& share) {
    if (is_over_) {
      return false;
    }
    const std::size_t first = axes_[0].share() <= axes_[1].share() ? 0 : 1;
    share = axes_[first].share();
    is_over_ = share == kNone;
    share = is_over_ ? 1.0 : share;
    axes_[first].advance();
    return true;
  }

 private:
  static constexpr double kNone = 2.0;

  /// The lines across one axis, in the order of the way.
  class Axis {
   public:
    Axis(double a, double b) : a_(a), way_(b - a), step_(b < a ? -1.0 : 1.0) {
      const double low = std::min(a, b);
      line_ = std::ceil(low - 0.5) + 0.5;
      left_ = std::max(0.0, std::ceil(std::max(a, b) - line_));  // Those below the higher end.
      line_ += b < a ? left_ - 1.0 : 0.0;
    }
    [[nodiscard]] double share() const {
      return left_ > 0.0 ? std::clamp((line_ - a_) / way_, 0.0, 1.0) : kNone;
    }
    void advance() {
      line_ += step_;
      left_ -= 1.0;
    }

   private:
    double a_;
    double way_;
    double step_;
    double line_ = 0.0;
    double left_ = 0.0;
  };

  std::array<Axis, 2> axes_;
  bool is_over_ = false;
};

}  // namespace

bool stays_on_ground(const Grid& grid,
                     const CellSet& ground,
                     const Position& a,
                     const Position& b) {
  const Eigen::Vector2d way = b - a;
  Crossings crossings(a, b);
  double before = 0.0;
  for (double share = 0.0; crossings.next(share); before = share) {
    const Position middle = a + way * (0.5 * (before + share));
    if (!is_ground(grid, ground, middle) || !is_ground(grid, ground, a + way * share)) {
      return false;
    }
  }
  return true;
}

std::vector<Cell> cells_along(const Position& a, const Position& b) {
  std::vector<Cell> cells;
  Cell last = nearest_cell(a);
  Crossings crossings(a, b);
  double before = 0.0;
  for (double share = 0.0; crossings.next(share); before = share) {
    const Cell c = nearest_cell(a + (b - a) * (0.5 * (before + share)));
    if (!(c == last)) {
      cells.push_back(c);
      last = c;
    }
  }
  return cells;
}

std::vector<Position> pursuit_way(const Grid& grid,
                                  const CellSet& ground,
                                  const Position& from,
                                  Cell to) {
  const std::vector<Cell> route = shortest_route(grid, ground, nearest_cell(from), to);
  if (route.empty()) {
    return {};
  }
  std::vector<Position> way{from};
  std::size_t at = 0;  // of the route: what lies behind the robot
  while (way.back() != position(to)) {
    std::size_t next = route.size() - 1;
    while (next > at + 1 && !stays_on_ground(grid, ground, way.back(), position(route[next]))) {
      --next;
    }
    way.push_back(position(route[next]));
    at = next;
  }
  return way;
}

double length_of(const std::vector<Position>& way) noexcept {
  double length = 0.0;
  for (std::size_t k = 1; k < way.size(); ++k) {
    length += (way[k] - way[k - 1]).norm();
  }
  return length;
}

}  // namespace tcert::terrain
