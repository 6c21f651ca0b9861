#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <terrain/outline.hpp>
#include <terrain/squares.hpp>

namespace tcert::terrain {
namespace {

// Directions in order of the left turn: +x, +y, -x, -y.
constexpr std::array<Cell, 4> kDirections{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// True if `p` lies inside the ring (even-odd; not for points of the ring).
[[nodiscard]] bool surrounds(const std::vector<Cell>& ring, double px, double py) {
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Cell a = ring[k];
    const Cell b = ring[(k + 1) % ring.size()];
    if ((a.y > py) != (b.y > py)) {
      const double at = a.x + (py - a.y) / static_cast<double>(b.y - a.y) * (b.x - a.x);
      inside = inside != (px < at);
    }
  }
  return inside;
}

/// -1, 0 or 1.
[[nodiscard]] int sign_of(int value) noexcept { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// A point of the ground just inside the ring's first edge.
[[nodiscard]] Position inner_point(const std::vector<Cell>& ring) {
  const Cell a = ring[0];
  const Cell b = ring[1];
  const double dx = sign_of(b.x - a.x);
  const double dy = sign_of(b.y - a.y);
  return {a.x + 0.5 * dx - 0.5 * dy, a.y + 0.5 * dy + 0.5 * dx};
}

[[nodiscard]] std::int64_t cross(Cell a, Cell b, Cell p) {
  return std::int64_t{b.x - a.x} * (p.y - a.y) - std::int64_t{b.y - a.y} * (p.x - a.x);
}

class Simplifier {
 public:
  Simplifier(const Grid& grid,
             const CellSet& ground,
             const std::vector<Cell>& ring,
             double tolerance)
      : grid_(grid), ground_(ground), ring_(ring), tolerance_(tolerance), keep_(ring.size(), 0) {}

  std::vector<Cell> run() {
    // The two corners farthest apart, roughly, hold the ring open.
    const std::size_t a = 0;
    std::size_t b = 0;
    for (std::size_t k = 1; k < ring_.size(); ++k) {
      if (squared_distance(ring_[k], ring_[a]) > squared_distance(ring_[b], ring_[a])) {
        b = k;
      }
    }
    keep_[a] = keep_[b] = 1;
    between(a, b);
    between(b, a + ring_.size());
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      if (keep_[k] != 0) {
        kept.push_back(k);
      }
    }
    drop_needless(kept);
    std::vector<Cell> corners;
    corners.reserve(kept.size());
    for (const std::size_t k : kept) {
      corners.push_back(ring_[k]);
    }
    return corners.size() < 3 ? ring_ : corners;
  }

 private:
  [[nodiscard]] Cell at(std::size_t k) const { return ring_[k % ring_.size()]; }

  void between(std::size_t a, std::size_t b) {
    std::vector<std::pair<std::size_t, std::size_t>> open{{a, b}};
    while (!open.empty()) {
      const auto [from, to] = open.back();
      open.pop_back();
      if (to - from < 2 || may_cut(from, to)) {
        continue;
      }
      std::size_t farthest = from + 1;
      for (std::size_t k = from + 1; k < to; ++k) {
        if (off(from, to, k) > off(from, to, farthest)) {
          farthest = k;
        }
      }
      keep_[farthest % ring_.size()] = 1;
      open.emplace_back(from, farthest);
      open.emplace_back(farthest, to);
    }
  }

  /// Splitting at the farthest corner keeps the steps of a staircase: what the rules allow to go,
  /// goes.
  void drop_needless(std::vector<std::size_t>& kept) const {
    for (bool dropped = true; dropped && kept.size() > 3;) {
      dropped = false;
      for (std::size_t k = 0; k < kept.size() && kept.size() > 3; ++k) {
        const std::size_t from = kept[(k + kept.size() - 1) % kept.size()];
        std::size_t to = kept[(k + 1) % kept.size()];
        to += to <= from ? ring_.size() : 0;
        if (may_cut(from, to)) {
          kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(k));
          dropped = true;
        }
      }
    }
  }

  /// Distance of corner k from the chord.
  [[nodiscard]] double off(std::size_t from, std::size_t to, std::size_t k) const {
    const double length = distance(at(from), at(to));
    return length > 0.0 ? std::abs(static_cast<double>(cross(at(from), at(to), at(k)))) / length
                        : distance(at(from), at(k));
  }

  /// The ground lies to the left of the ring, so what a chord cuts off must lie to its right.
  [[nodiscard]] bool may_cut(std::size_t from, std::size_t to) const {
    for (std::size_t k = from + 1; k < to; ++k) {
      if (cross(at(from), at(to), at(k)) > 0 || off(from, to, k) > tolerance_) {
        return false;
      }
    }
    return !(at(from) == at(to)) && runs_within(grid_, ground_, at(from), at(to));
  }

  const Grid& grid_;
  const CellSet& ground_;
  const std::vector<Cell>& ring_;
  double tolerance_;
  CellSet keep_;
};

}  // namespace

double doubled_area(const std::vector<Cell>& ring) noexcept {
  double area = 0.0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Cell a = ring[k];
    const Cell b = ring[(k + 1) % ring.size()];
    area += static_cast<double>(a.x) * b.y - static_cast<double>(a.y) * b.x;
  }
  return area;
}

namespace {

/// Edges of cells, by direction, that are still to be walked.
using OpenEdges = std::vector<std::array<std::uint8_t, 4>>;

/// Those with ground on their left and none on their right, by where they leave.
OpenEdges open_edges(const Grid& grid, const Squares& squares) {
  OpenEdges open(grid.size(), {0, 0, 0, 0});
  for (std::size_t i = 0; i < grid.size(); ++i) {
    for (int d = 0; d < 4; ++d) {
      const Cell c = grid.cell(i);
      open[i][static_cast<std::size_t>(d)] = squares.left(c, d) && !squares.right(c, d) ? 1 : 0;
    }
  }
  return open;
}

/// The corners of the ring that leaves `c` in direction `heading`; its edges are open no more.
std::vector<Cell> walk_ring(
    const Grid& grid, const Squares& squares, Cell c, int heading, OpenEdges& open) {
  std::vector<Cell> ring;
  while (open[grid.index(c)][static_cast<std::size_t>(heading)] != 0) {
    open[grid.index(c)][static_cast<std::size_t>(heading)] = 0;
    const int before = heading;
    const Cell step = kDirections[static_cast<std::size_t>(heading)];
    c = {c.x + step.x, c.y + step.y};
    // At a corner where two parts touch turn left first, so that they stay apart.
    for (const int turn : {1, 0, 3}) {
      const int next = (before + turn) % 4;
      if (squares.left(c, next) && !squares.right(c, next)) {
        heading = next;
        break;
      }
    }
    if (heading != before) {
      ring.push_back(c);
    }
  }
  return ring;
}

/// Gives each hole to the part that it lies in: of nested ones the smallest.
void give_holes(std::vector<std::vector<Cell>> holes, std::vector<Outline>& parts) {
  for (std::vector<Cell>& hole : holes) {
    const Position p = inner_point(hole);
    Outline* owner = nullptr;
    for (Outline& part : parts) {
      if (surrounds(part.ring, p.x(), p.y()) &&
          (owner == nullptr || doubled_area(part.ring) < doubled_area(owner->ring))) {
        owner = &part;
      }
    }
    if (owner != nullptr) {
      owner->holes.push_back(std::move(hole));
    }
  }
}

}  // namespace

std::vector<Outline> outlines(const Grid& grid, const CellSet& ground) {
  const Squares squares(grid, ground);
  OpenEdges open = open_edges(grid, squares);
  std::vector<Outline> parts;
  std::vector<std::vector<Cell>> holes;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    for (int d = 0; d < 4; ++d) {
      std::vector<Cell> ring = walk_ring(grid, squares, grid.cell(i), d, open);
      if (ring.empty()) {
        continue;
      }
      if (doubled_area(ring) > 0.0) {
        parts.push_back({std::move(ring), {}});
      } else {
        holes.push_back(std::move(ring));
      }
    }
  }
  give_holes(std::move(holes), parts);
  return parts;
}

bool runs_within(const Grid& grid, const CellSet& ground, Cell a, Cell b) {
  const Squares squares(grid, ground);
  const int dx = b.x - a.x;
  const int dy = b.y - a.y;
  if (dx == 0 || dy == 0) {
    // Along a grid line a square on either side will do.
    const int steps = std::max(std::abs(dx), std::abs(dy));
    const int sx = sign_of(dx);
    const int sy = sign_of(dy);
    for (int k = 0; k < steps; ++k) {
      const int x = std::min(a.x + k * sx, a.x + (k + 1) * sx);
      const int y = std::min(a.y + k * sy, a.y + (k + 1) * sy);
      if (!(squares(x, y) || squares(x - (dx == 0 ? 1 : 0), y - (dy == 0 ? 1 : 0)))) {
        return false;
      }
    }
    return true;
  }
  // The squares that the segment's interior crosses, column by column of x.
  const Cell low = dx > 0 ? a : b;
  const Cell high = dx > 0 ? b : a;
  const std::int64_t run = high.x - low.x;
  const std::int64_t rise = high.y - low.y;
  for (std::int64_t k = 0; k < run; ++k) {
    // y over [k, k+1], in units of 1 / run.
    const std::int64_t first = std::min(k * rise, (k + 1) * rise);
    const std::int64_t last = std::max(k * rise, (k + 1) * rise);
    const auto floor_of = [&](std::int64_t v) {
      return v >= 0 ? v / run : -((-v + run - 1) / run);
    };
    for (std::int64_t y = floor_of(first); y * run < last; ++y) {
      if (!squares(low.x + static_cast<int>(k), low.y + static_cast<int>(y))) {
        return false;
      }
    }
  }
  return true;
}

std::vector<Cell> simplified(const Grid& grid,
                             const CellSet& ground,
                             const std::vector<Cell>& ring,
                             double tolerance) {
  if (ring.size() < 4) {
    return ring;
  }
  return Simplifier(grid, ground, ring, tolerance).run();
}

}  // namespace tcert::terrain
