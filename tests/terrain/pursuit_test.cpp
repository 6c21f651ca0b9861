// Ways in line of sight, and the ground under a body.
#include <gtest/gtest.h>

#include <numbers>
#include <table/random.hpp>
#include <terrain/body.hpp>
#include <terrain/components.hpp>
#include <terrain/pursuit.hpp>
#include <terrain/routes.hpp>

namespace tcert::terrain {
namespace {

CellSet blobs(const Grid& grid, std::uint64_t number, double share) {
  table::RandomStream random(7, 3, number);
  CellSet set(grid.size(), 1);
  while (static_cast<double>(count(set)) > share * static_cast<double>(grid.size())) {
    const Cell c = grid.cell(random.below(static_cast<std::uint32_t>(grid.size())));
    const int radius = static_cast<int>(random.below(4));
    for (int x = c.x - radius; x <= c.x + radius; ++x) {
      for (int y = c.y - radius; y <= c.y + radius; ++y) {
        if (grid.contains({x, y})) {
          set[grid.index({x, y})] = 0;
        }
      }
    }
  }
  return set;
}

bool holds(const Grid& grid, const CellSet& set, const Position& p) {
  const Cell c = nearest_cell(p);
  return grid.contains(c) && set[grid.index(c)] != 0;
}

TEST(Pursuit, StaysOnGroundAndIsNoLongerThanTheRoute) {
  const Grid grid{40, 30};
  int joined = 0;
  double shorter = 0.0;
  for (std::uint64_t number = 0; number < 200; ++number) {
    const CellSet ground = blobs(grid, number, 0.7);
    table::RandomStream random(8, 3, number);
    const auto draw = [&] {
      return grid.cell(random.below(static_cast<std::uint32_t>(grid.size())));
    };
    const Cell from = draw();
    const Cell to = draw();
    const std::vector<Cell> route = shortest_route(grid, ground, from, to);
    // From anywhere within the cell.
    const Position start =
        position(from) + Position(random.uniform(-0.45, 0.45), random.uniform(-0.45, 0.45));
    const std::vector<Position> way = pursuit_way(grid, ground, start, to);
    ASSERT_EQ(route.empty(), way.empty());
    if (route.empty()) {
      continue;
    }
    ++joined;
    EXPECT_EQ(position(to), way.back());
    EXPECT_LE(length_of(way), route_length(route) + 1.5);
    const std::vector<Position> from_centre = pursuit_way(grid, ground, position(from), to);
    EXPECT_LE(length_of(from_centre), route_length(route) + 1e-9);
    shorter += route_length(route) - length_of(from_centre);
    for (std::size_t k = 1; k < way.size(); ++k) {
      for (int i = 0; i <= 200; ++i) {
        const Position p = way[k - 1] + (way[k] - way[k - 1]) * (i / 200.0);
        EXPECT_TRUE(holds(grid, ground, p)) << number;
      }
      for (const Cell c : cells_along(way[k - 1], way[k])) {
        EXPECT_EQ(1, ground[grid.index(c)]);
      }
    }
  }
  EXPECT_GT(joined, 50);
  EXPECT_GT(shorter, 0.0);
}

/// Whether a body at `p` lies on ground, looked at point by point.
bool lies_on_ground(const Grid& grid, const CellSet& ground, const Body& body, const Position& p) {
  for (int i = -24; i <= 24; ++i) {
    for (int j = -24; j <= 24; ++j) {
      Position q(i / 24.0, j / 24.0);
      if (body.kind == Body::Kind::disc) {
        if (q.norm() > 1.0) {
          continue;
        }
        q *= body.radius * 0.999;
      } else {
        const Position local(0.4995 * body.length * q.x(), 0.4995 * body.width * q.y());
        q = {std::cos(body.yaw) * local.x() - std::sin(body.yaw) * local.y(),
             std::sin(body.yaw) * local.x() + std::cos(body.yaw) * local.y()};
      }
      if (!holds(grid, ground, p + q)) {
        return false;
      }
    }
  }
  return true;
}

TEST(Body, StandsOnlyWhereAllGroundUnderItIsGround) {
  const Grid grid{40, 30};
  const std::vector<Body> bodies{{Body::Kind::disc, 0.4},
                                 {Body::Kind::disc, 2.0},
                                 {Body::Kind::box, 0.0, 5.0, 2.0, 0.0},
                                 {Body::Kind::box, 0.0, 6.0, 1.5, std::numbers::pi / 6.0}};
  for (std::uint64_t number = 0; number < 20; ++number) {
    const CellSet ground = blobs(grid, number, 0.9);
    for (const Body& body : bodies) {
      const CellSet standing = standing_cells(grid, ground, Footprint(body));
      table::RandomStream random(9, 3, number);
      for (std::size_t i = 0; i < grid.size(); ++i) {
        if (standing[i] == 0) {
          continue;
        }
        ASSERT_EQ(1, ground[i]);
        const Position within(random.uniform(-0.499, 0.499), random.uniform(-0.499, 0.499));
        ASSERT_TRUE(lies_on_ground(grid, ground, body, position(grid.cell(i)) + within))
            << number << " at " << i;
      }
    }
  }
}

TEST(Body, IsNotTooCareful) {
  // In the open, a body stands one cell and its own reach from the edge.
  const Grid grid{21, 21};
  const CellSet ground(grid.size(), 1);
  const CellSet standing = standing_cells(grid, ground, Footprint({Body::Kind::disc, 2.0}));
  EXPECT_EQ(1, standing[grid.index({2, 10})]);
  EXPECT_EQ(0, standing[grid.index({1, 10})]);
  EXPECT_EQ(17U * 17U, count(standing));
  EXPECT_EQ(grid.size(), count(standing_cells(grid, ground, Footprint(Body{}))));
}

TEST(Body, TakesTheLeastUnderIt) {
  const Grid grid{12, 12};
  std::vector<double> values(grid.size(), 5.0);
  values[grid.index({6, 6})] = 1.0;
  const CellSet ground(grid.size(), 1);
  const Footprint footprint({Body::Kind::disc, 1.0});
  const CellSet standing = standing_cells(grid, ground, footprint);
  const std::vector<double> least = least_under(grid, values, standing, footprint);
  EXPECT_EQ(1.0, least[grid.index({5, 6})]);
  EXPECT_EQ(5.0, least[grid.index({3, 6})]);
  EXPECT_EQ(5.0, least[grid.index({0, 0})]) << "where it does not stand, its own";
}

TEST(Body, RefusesLengthsThatAreNone) {
  EXPECT_THROW(Footprint({Body::Kind::disc, 0.0}), std::invalid_argument);
  EXPECT_THROW(Footprint({Body::Kind::disc, 1e9}), std::invalid_argument);
  EXPECT_THROW(Footprint({Body::Kind::box, 0.0, 2.0, std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace tcert::terrain
