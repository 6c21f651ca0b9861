#include <gtest/gtest.h>

#include <random>
#include <terrain/components.hpp>
#include <terrain/controller.hpp>
#include <terrain/distance_transform.hpp>
#include <terrain/outline.hpp>
#include <terrain/pursuit.hpp>
#include <terrain/routes.hpp>
#include <terrain/triangulation.hpp>

namespace tcert::terrain {
namespace {

/// Blobs with holes, islands and spurs.
CellSet random_ground(const Grid& grid, std::mt19937& random) {
  std::bernoulli_distribution seed(0.012);
  CellSet set(grid.size());
  for (auto& cell : set) {
    cell = seed(random) ? 1 : 0;
  }
  const auto near = squared_distance_transform(grid, set);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    set[i] = near[i] <= 20 ? 1 : 0;
  }
  return set;
}

bool is_square(const Grid& grid, const CellSet& ground, int x, int y) {
  for (const Cell c : {Cell{x, y}, Cell{x + 1, y}, Cell{x, y + 1}, Cell{x + 1, y + 1}}) {
    if (!grid.contains(c) || ground[grid.index(c)] == 0) {
      return false;
    }
  }
  return true;
}

/// Even-odd over all rings of all parts.
bool within_outlines(const std::vector<Outline>& parts, double px, double py) {
  bool inside = false;
  const auto cross = [&](const std::vector<Cell>& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Cell a = ring[k];
      const Cell b = ring[(k + 1) % ring.size()];
      if ((a.y > py) != (b.y > py)) {
        const double at = a.x + (py - a.y) / static_cast<double>(b.y - a.y) * (b.x - a.x);
        inside = inside != (px < at);
      }
    }
  };
  for (const Outline& part : parts) {
    cross(part.ring);
    for (const auto& hole : part.holes) {
      cross(hole);
    }
  }
  return inside;
}

TEST(Outlines, HoldExactlyTheSquaresOfGround) {
  std::mt19937 random(17);
  std::size_t holes = 0;
  for (int run = 0; run < 60; ++run) {
    const Grid grid{40, 33};
    const CellSet ground = random_ground(grid, random);
    const auto parts = outlines(grid, ground);
    for (const Outline& part : parts) {
      EXPECT_GT(doubled_area(part.ring), 0.0);
      holes += part.holes.size();
    }
    for (int x = -1; x < grid.rows; ++x) {
      for (int y = -1; y < grid.columns; ++y) {
        ASSERT_EQ(is_square(grid, ground, x, y), within_outlines(parts, x + 0.5, y + 0.5))
            << run << " at " << x << ", " << y;
      }
    }
  }
  EXPECT_GT(holes, 10U) << "the test needs holes";
}

TEST(Simplified, NeverLeavesTheGround) {
  std::mt19937 random(23);
  std::size_t before = 0;
  std::size_t after = 0;
  for (int run = 0; run < 60; ++run) {
    const Grid grid{60, 50};
    const CellSet ground = random_ground(grid, random);
    for (const Outline& part : outlines(grid, ground)) {
      std::vector<std::vector<Cell>> rings = part.holes;
      rings.push_back(part.ring);
      for (const auto& ring : rings) {
        const std::vector<Cell> simple = simplified(grid, ground, ring, 4.0);
        before += ring.size();
        after += simple.size();
        for (std::size_t k = 0; k < simple.size(); ++k) {
          const Position a = position(simple[k]);
          const Position b = position(simple[(k + 1) % simple.size()]);
          const int pieces = static_cast<int>((b - a).norm() * 16.0) + 1;
          for (int j = 0; j <= pieces; ++j) {
            const Position p = a + (b - a) * (static_cast<double>(j) / pieces);
            const Cell c = nearest_cell(p);
            ASSERT_EQ(1, ground[grid.index(c)]) << p.transpose();
          }
        }
      }
    }
  }
  EXPECT_LT(after, before / 2);
}

TEST(EarClipping, CoversThePolygonOnce) {
  std::mt19937 random(29);
  std::size_t parts = 0;
  std::size_t clipped = 0;
  for (int run = 0; run < 40; ++run) {
    const Grid grid{40, 33};
    const CellSet ground = random_ground(grid, random);
    for (const Outline& part : outlines(grid, ground)) {
      std::vector<Position> polygon;
      for (const Cell c : part.ring) {
        polygon.push_back(position(c));
      }
      const auto triangles = ear_clipping(polygon);
      double area = 0.0;
      for (const Triangle& t : triangles) {
        const double one = doubled_area(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
        EXPECT_GT(one, 0.0);
        area += one;
      }
      ++parts;
      if (!triangles.empty()) {
        ++clipped;
        EXPECT_NEAR(doubled_area(part.ring), area, 1e-9);
        const auto tree = triangle_tree(triangles, triangles.size() / 2);
        EXPECT_EQ(triangles.size(), tree.size());
        for (std::size_t t = 0; t + 1 < tree.size(); ++t) {
          EXPECT_GT(tree[t].parent, t);
        }
      }
    }
  }
  RecordProperty("clipped", static_cast<int>(clipped));
  EXPECT_GE(10 * clipped, 9 * parts);
}

/// The map has a pole on an obstacle's border.
bool near_ring(const Outline& part, const Position& p) {
  std::vector<std::vector<Cell>> rings = part.holes;
  rings.push_back(part.ring);
  for (const auto& ring : rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      if (distance_to_segment(p, position(ring[k]), position(ring[(k + 1) % ring.size()])) < 0.5) {
        return true;
      }
    }
  }
  return false;
}

TEST(ObstacleMap, HasTheJacobianOfItsDifferences) {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> x(0.0, 59.0);
  std::uniform_real_distribution<double> y(0.0, 49.0);
  std::size_t moved = 0;
  for (int run = 0; run < 10; ++run) {
    const Grid grid{60, 50};
    const CellSet ground = random_ground(grid, random);
    for (Outline& part : outlines(grid, ground)) {
      part.ring = simplified(grid, ground, part.ring, 4.0);
      const ObstacleMap map(pseudo_obstacles(part), MapParameters{});
      for (int k = 0; k < 40; ++k) {
        const Position p(x(random), y(random));
        if (!within_outlines({part}, p.x(), p.y()) || near_ring(part, p)) {
          continue;
        }
        const Mapped m = map.map(p);
        moved += (m.x - p).norm() > 1e-6 ? 1U : 0U;
        constexpr double kStep = 1e-6;
        for (int axis = 0; axis < 2; ++axis) {
          const Eigen::Vector2d d = kStep * Eigen::Vector2d::Unit(axis);
          const Eigen::Vector2d slope = (map.map(p + d).x - map.map(p - d).x) / (2.0 * kStep);
          const double scale = 1.0 + m.jacobian.norm();
          if (scale < 1e3) {
            EXPECT_LT((slope - m.jacobian.col(axis)).norm(), 1e-4 * scale) << p.transpose();
          }
        }
      }
    }
  }
  EXPECT_GT(moved, 20U) << "the test needs points near obstacles";
}

/// The stupid way: a thousand points.
bool sampled_on_ground(const Grid& grid,
                       const CellSet& ground,
                       const Position& a,
                       const Position& b) {
  for (int k = 0; k <= 1000; ++k) {
    const Cell c = nearest_cell(a + (b - a) * (k / 1000.0));
    if (!grid.contains(c) || ground[grid.index(c)] == 0) {
      return false;
    }
  }
  return true;
}

TEST(Segment, StaysOnTheGroundAtEveryPoint) {
  CellSet corner{1, 0, 1, 1};  // (0, 1) is no ground
  EXPECT_FALSE(stays_on_ground({2, 2}, corner, {0.41, 0.44}, {0.52, 0.55}));
  std::mt19937 random(43);
  const Grid grid{30, 25};
  std::uniform_real_distribution<double> at(0.0, 23.0);
  std::uniform_real_distribution<double> by(-3.0, 3.0);
  int stays = 0;
  for (int run = 0; run < 10; ++run) {
    const CellSet ground = random_ground(grid, random);
    for (int k = 0; k < 500; ++k) {
      const Position a(at(random), at(random));
      const Position b = a + Position(by(random), by(random));
      const bool exact = stays_on_ground(grid, ground, a, b);
      stays += exact ? 1 : 0;
      // Points may miss a corner that is cut; they never see one that is not.
      if (exact) {
        ASSERT_TRUE(sampled_on_ground(grid, ground, a, b));
      }
    }
  }
  EXPECT_GT(stays, 500);
}

TEST(Controller, StaysOnTheGround) {
  std::mt19937 random(37);
  const Grid grid{60, 50};
  int arrived = 0;
  int ways = 0;
  for (int run = 0; run < 20; ++run) {
    const CellSet ground = random_ground(grid, random);
    const auto labels = label_components(grid, ground);
    std::vector<Cell> cells;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      if (labels[i] == 0) {
        cells.push_back(grid.cell(i));
      }
    }
    const Cell from = cells[random() % cells.size()];
    const Cell to = cells[random() % cells.size()];
    const ReactiveWay way =
        reactive_way(grid, ground, position(from), position(to), ControllerOptions{});
    ++ways;
    arrived += way.arrived ? 1 : 0;
    for (std::size_t k = 1; k < way.path.size(); ++k) {
      ASSERT_TRUE(sampled_on_ground(grid, ground, way.path[k - 1], way.path[k])) << run;
    }
  }
  RecordProperty("arrived", arrived);
  RecordProperty("ways", ways);
  EXPECT_GE(arrived, 3) << "the ground is narrow, but some ways lead to the end";
}

TEST(Routes, WidestEqualsBruteForce) {
  std::mt19937 random(41);
  const Grid grid{9, 8};
  std::uniform_real_distribution<double> value(0.0, 1.0);
  for (int run = 0; run < 50; ++run) {
    CellSet ground(grid.size());
    std::vector<double> values(grid.size());
    for (std::size_t i = 0; i < grid.size(); ++i) {
      ground[i] = value(random) < 0.75 ? 1 : 0;
      values[i] = std::round(value(random) * 8.0);
    }
    const Cell from{0, 0};
    const Cell to{8, 7};
    const auto found = widest_route(grid, ground, values, 2.0, from, to);
    // The largest level at which both are in one part.
    std::optional<double> expected;
    for (int level = 0; level <= 8; ++level) {
      CellSet above = ground;
      for (std::size_t i = 0; i < grid.size(); ++i) {
        above[i] = above[i] != 0 && values[i] >= level ? 1 : 0;
      }
      if (component_of(grid, above, from)[grid.index(to)] != 0) {
        expected = level - 2.0;
      }
    }
    ASSERT_EQ(expected, found);
    const auto route = shortest_route(grid, ground, from, to);
    EXPECT_EQ(found.has_value(), !route.empty());
  }
}

}  // namespace
}  // namespace tcert::terrain
