#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <witness/checker.hpp>
#include <witness/polygon.hpp>
#include <witness/region_shape.hpp>

#include "lib/witness/cells.hpp"
#include "lib/witness/walls.hpp"

namespace tcert::witness {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

bool within(Point p, double left, double right, double bottom, double top) {
  return p.x_m > left && p.x_m < right && p.y_m > bottom && p.y_m < top;
}

// A corridor 1 m wide and straight: the disc that fits has its width.
TEST(Checker, ACorridorHasItsWidth) {
  const FreeCells cells =
      cells_where({0, 0}, {4, 1}, [](Point p) { return within(p, 0, 4, 0, 1); });
  const Region start = Disc{{0.6, 0.5}, 0.05};
  const Region goal = Disc{{3.4, 0.5}, 0.05};
  Robot robot = robot_of(0.45, 0.35);
  const Path path{{{0.6, 0.5}, {3.4, 0.5}, 0.0}};
  Checked checked = check(path, cells, start, goal, robot);
  EXPECT_EQ(checked.refused, "");
  EXPECT_NEAR(checked.margin_m, 1.0 - 0.45, 1e-9);
  EXPECT_EQ(checked.turn_radius_m, kInf);
  // Off the middle by 10 cm, it is 20 cm less; buffers count twice.
  const Path beside{{{0.6, 0.46}, {3.4, 0.46}, 0.0}};
  EXPECT_NEAR(check(beside, cells, start, goal, robot).margin_m, 0.92 - 0.45, 1e-9);
  robot.tracking_buffer_m = 0.05;
  EXPECT_NEAR(check(path, cells, start, goal, robot).margin_m, 0.9 - 0.45, 1e-9);
  robot.curvature_buffer_per_m = 2.0;
  EXPECT_NEAR(check(path, cells, start, goal, robot).margin_m, 0.5 - 0.35, 1e-9);
}

// Round a right angle between corridors of 1 m: the arc of radius 1 about (1.5, 1.5) from the
// middle of one to the middle of the other passes the inner corner (1, 1) at 1 - sqrt(0.5).
TEST(Checker, AnLBendIsWhatGeometrySays) {
  const FreeCells cells = cells_where(
      {0, 0}, {4, 4}, [](Point p) { return within(p, 0, 4, 0, 1) || within(p, 0, 1, 0, 4); });
  const Path path{{{0.5, 3.2}, {0.5, 1.5}, 0.0},
                  {{0.5, 1.5}, {1.5, 0.5}, 0.5 * std::numbers::pi},
                  {{1.5, 0.5}, {3.2, 0.5}, 0.0}};
  const Region start = Disc{{0.5, 3.2}, 0.05};
  const Region goal = Disc{{3.2, 0.5}, 0.05};
  const Checked checked = check(path, cells, start, goal, robot_of(0.3, 0.35));
  EXPECT_EQ(checked.refused, "");
  EXPECT_NEAR(checked.clearance_m, 1.0 - std::sqrt(0.5), 1e-4);  // twice what an arc bulges
  EXPECT_LE(checked.clearance_m, 1.0 - std::sqrt(0.5) + 1e-9);
  EXPECT_NEAR(checked.turn_radius_m, 1.0, 1e-12);
  EXPECT_NEAR(checked.bottleneck.x_m, 0.79, 0.06);
  // Twice as sharp a turn decides by its radius.
  EXPECT_NEAR(check(path, cells, start, goal, robot_of(0.3, 0.9)).margin_m, 0.1, 1e-9);
}

// About the end of a wall 0.1 m thick: half a circle of radius 0.55 about the middle of the end.
TEST(Checker, AUTurnIsWhatGeometrySays) {
  const FreeCells cells = cells_where({-2, -1}, {1, 1}, [](Point p) {
    return within(p, -2, 1, -1, 1) && !within(p, -2, 0, -0.05, 0.05);
  });
  const Path path{{{-1.4, -0.55}, {0.0, -0.55}, 0.0},
                  {{0.0, -0.55}, {0.0, 0.55}, 0.9999 * std::numbers::pi},
                  {{0.0, 0.55}, {-1.4, 0.55}, 0.0}};
  const Region start = Disc{{-1.4, -0.55}, 0.05};
  const Region goal = Disc{{-1.4, 0.55}, 0.05};
  EXPECT_EQ(check(path, cells, start, goal, robot_of(0.3, 0.3)).refused,
            "a piece turns by more than 3 rad");
  Path halves = path;
  halves[1] = {{0.0, -0.55}, {0.55, 0.0}, 0.5 * std::numbers::pi};
  halves.insert(halves.begin() + 2, {{0.55, 0.0}, {0.0, 0.55}, 0.5 * std::numbers::pi});
  const Checked checked = check(halves, cells, start, goal, robot_of(0.3, 0.3));
  EXPECT_EQ(checked.refused, "");
  EXPECT_NEAR(checked.clearance_m, 0.45, 1e-4);  // to the outer walls and to (1, 0) alike
  EXPECT_NEAR(checked.turn_radius_m, 0.55, 1e-12);
}

struct Found {
  FreeCells cells;
  Region start;
  Region goal;
  std::vector<Point> polygon;
  Path path;
};

/// A random smooth polygon, and free cells within a random distance of it that varies.
Found random_path(std::mt19937& engine) {
  Found found;
  Point at{0.0, 0.0};
  double heading = drawn(engine, -3.0, 3.0);
  double turn = 0.0;
  for (int i = 0; i < 40; ++i) {
    found.polygon.push_back(at);
    if (i % 6 == 0) {
      turn = drawn(engine, -0.08, 0.08);
    }
    heading += turn;
    at = at + drawn(engine, 0.03, 0.05) * direction(heading);
  }
  found.path = path_of(found.polygon);
  found.start = Disc{found.polygon.front(), 0.1};
  found.goal = Disc{found.polygon.back(), 0.1};
  std::vector<double> width;
  for (std::size_t i = 0; i < found.polygon.size(); ++i) {
    width.push_back(drawn(engine, 0.25, 0.35));
  }
  found.cells = cells_where({-2.4, -2.4}, {2.4, 2.4}, [&](Point p) {
    for (std::size_t i = 0; i < width.size(); ++i) {
      if (distance(p, found.polygon[i]) < width[i]) {
        return true;
      }
    }
    return false;
  });
  return found;
}

/// Distance of the path to the nearest cell that is not free, looking at all cells from many
/// points.
double brute_force(const Path& path, const FreeCells& cells) {
  const Lattice& lattice = cells.lattice();
  double least = kInf;
  for (const Piece& piece : path) {
    for (int k = 0; k <= 8; ++k) {
      const double part = 0.125 * k;
      const double turn = piece.turn_rad;
      const double share = turn == 0.0 ? part : std::sin(0.5 * part * turn) / std::sin(0.5 * turn);
      const double angle = heading_from(piece) + 0.5 * part * turn;
      const Point p = piece.from + chord(piece) * share * Point{std::cos(angle), std::sin(angle)};
      for (int iy = lattice.row_of(p.y_m - 0.4); iy <= lattice.row_of(p.y_m + 0.4); ++iy) {
        for (int ix = lattice.column_of(p.x_m - 0.4); ix <= lattice.column_of(p.x_m + 0.4); ++ix) {
          if (!cells.is_free(ix, iy)) {
            const Point low = lattice.corner(ix, iy);
            least = std::min(least,
                             std::hypot(std::max({low.x_m - p.x_m, 0.0, p.x_m - low.x_m - kCell}),
                                        std::max({low.y_m - p.y_m, 0.0, p.y_m - low.y_m - kCell})));
          }
        }
      }
    }
  }
  return least;
}

TEST(Checker, TheDistanceIsThatOfBruteForce) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 engine(seed);
    const Found found = random_path(engine);
    const Checked checked =
        check(found.path, found.cells, found.start, found.goal, robot_of(0.3, 0.2));
    ASSERT_EQ(checked.refused, "");
    const double slow = brute_force(found.path, found.cells);
    EXPECT_LE(checked.clearance_m, slow + 1e-9);
    EXPECT_NEAR(checked.clearance_m, slow, 3e-4);  // between the points of brute force
    EXPECT_NEAR(checked.margin_m,
                std::min(2.0 * checked.clearance_m - 0.3, checked.turn_radius_m - 0.2),
                1e-12);
  }
}

// What is done to a path that stands: none of it goes unnoticed.
void tamper(Path& path, std::mt19937& engine) {
  const std::size_t i = 1 + engine() % (path.size() - 2);
  const double by = (engine() % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, drawn(engine, -4.0, 0.0));
  switch (engine() % 9) {
    case 0:
      path[i].to = path[i].to + Point{by, 0.0};
      break;
    case 1:  // a joint
      path[i].to = path[i].to + Point{0.0, by};
      path[i + 1].from = path[i].to;
      break;
    case 2:
      path[i].turn_rad += by;
      break;
    case 3:
      path.erase(path.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    case 4:
      std::swap(path[i], path[i - 1]);
      break;
    case 5:
      path[i].turn_rad = std::numeric_limits<double>::quiet_NaN();
      break;
    case 6:
      path[i].from.x_m = kInf;
      break;
    case 7:
      path.resize(path.size() / 2);
      break;
    default:
      for (Piece& piece : path) {  // far away
        piece.from = piece.from + Point{10.0 * (1.0 + std::abs(by)), 0.0};
        piece.to = piece.to + Point{10.0 * (1.0 + std::abs(by)), 0.0};
      }
  }
}

TEST(Checker, RefusesAThousandTamperedPaths) {
  std::mt19937 engine(11);
  int refused = 0;
  for (int round = 0; round < 20; ++round) {
    const Found found = random_path(engine);
    for (int i = 0; i < 50; ++i) {
      Path path = found.path;
      tamper(path, engine);
      const Checked checked = check(path, found.cells, found.start, found.goal, robot_of(0.3, 0.2));
      refused += checked.refused.empty() ? 0 : 1;
      EXPECT_NE(checked.refused, "") << round << ' ' << i;
    }
  }
  EXPECT_EQ(refused, 1000);
}

TEST(Checker, SaysWhyAPathIsRefused) {
  std::mt19937 engine(5);
  const Found found = random_path(engine);
  const Robot robot = robot_of(0.3, 0.2);
  const Region far = Disc{{9.0, 9.0}, 0.1};
  const auto why = [&](const Path& path, const Region& start, const Region& goal) {
    return check(path, found.cells, start, goal, robot).refused;
  };
  EXPECT_EQ(why({}, found.start, found.goal), "the path does not start in S");
  EXPECT_EQ(why(found.path, far, found.goal), "the path does not start in S");
  EXPECT_EQ(why(found.path, found.start, far), "the path does not end in G");
  EXPECT_EQ(why(found.path, Disc{found.polygon.front(), 9.0}, found.goal), "S and G overlap");
  FreeCells cut = found.cells;
  FreeCells holes(cut.lattice());
  const int middle = cut.lattice().column_of(found.polygon[20].x_m);
  for (int iy = 0; iy < cut.lattice().rows; ++iy) {
    for (int ix = 0; ix < cut.lattice().columns; ++ix) {
      if (cut.is_free(ix, iy) && ix != middle) {
        holes.mark(ix, iy);
      }
    }
  }
  EXPECT_EQ(check(found.path, holes, found.start, found.goal, robot).refused,
            "the path leaves F_t");
  cut.mark_run(0, 3, 4);
  EXPECT_EQ(check(found.path, cut, found.start, found.goal, robot).refused,
            "free cells lie along the border of the lattice");
}

// Where the robot can turn on the spot a corner is a path, of radius 0; a cusp of no width never
// has a margin above 0.
TEST(Checker, ACornerIsAllowedWhereTheTurnRadiusIsZero) {
  const FreeCells cells =
      cells_where({0, 0}, {4, 4}, [](Point p) { return within(p, 0, 4, 0, 4); });
  const Path path{{{1, 1}, {3, 1}, 0.0}, {{3, 1}, {3, 3}, 0.0}};
  const Region start = Disc{{1, 1}, 0.1};
  const Region goal = Disc{{3, 3}, 0.1};
  EXPECT_EQ(check(path, cells, start, goal, robot_of(0.3, 0.1)).refused, "the path has a corner");
  const Checked checked = check(path, cells, start, goal, robot_of(0.3, 0.0));
  EXPECT_EQ(checked.refused, "");
  EXPECT_EQ(checked.margin_m, 0.0);
}

// Breaks in heading that are too small to be corners are charged to the turning.
TEST(Checker, ManySmallBreaksAreNoWayRoundTheTurnLimit) {
  const FreeCells cells =
      cells_where({0, 0}, {4, 4}, [](Point p) { return within(p, 0, 4, 0, 4); });
  Path path;
  Point at{1, 1};
  for (int i = 0; i < 2000; ++i) {
    const Point to = at + 1e-3 * direction(0.9e-6 * i);
    path.push_back({at, to, 0.0});
    at = to;
  }
  const Checked checked = check(path, cells, Disc{{1, 1}, 0.1}, Disc{at, 0.1}, robot_of(0.3, 0.1));
  ASSERT_EQ(checked.refused, "");
  EXPECT_NEAR(1.0 / checked.turn_radius_m, 2.0 * 0.9e-3, 1e-6);
}

}  // namespace
}  // namespace tcert::witness
