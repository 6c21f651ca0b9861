#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <witness/distance_field.hpp>

namespace tcert::witness {
namespace {

/// The distance of a vertex to the nearest cell that is not free, looking at all of them; the cells
/// around the lattice are not free either.
double brute_force(const FreeCells& cells, int vx, int vy) {
  const Lattice& lattice = cells.lattice();
  double least = 1e9;
  for (int iy = -1; iy <= lattice.rows; ++iy) {
    for (int ix = -1; ix <= lattice.columns; ++ix) {
      if (!cells.is_free(ix, iy)) {
        const double dx = std::max({ix - vx, 0, vx - ix - 1});
        const double dy = std::max({iy - vy, 0, vy - iy - 1});
        least = std::min(least, std::sqrt(dx * dx + dy * dy));
      }
    }
  }
  return lattice.cell_m * least;
}

TEST(DistanceField, IsThatOfBruteForceAtEveryVertex) {
  std::mt19937 engine(7);
  for (int round = 0; round < 40; ++round) {
    const int columns = 2 + static_cast<int>(engine() % 90U);
    const int rows = 2 + static_cast<int>(engine() % 40U);
    FreeCells cells(Lattice{0.005, -17, 5, columns, rows});
    const auto density = 1 + engine() % 60U;
    for (int iy = 0; iy < rows; ++iy) {
      for (int ix = 0; ix < columns; ++ix) {
        if (engine() % density != 0 || round == 0) {
          cells.mark(ix, iy);
        }
      }
    }
    const DistanceField field(cells);
    ASSERT_EQ(field.columns(), columns + 1);
    for (int vy = 0; vy <= rows; ++vy) {
      for (int vx = 0; vx <= columns; ++vx) {
        ASSERT_EQ(field.at_vertex(vx, vy),
                  static_cast<double>(static_cast<float>(brute_force(cells, vx, vy))))
            << round << ' ' << vx << ' ' << vy;
      }
    }
  }
}

TEST(DistanceField, IsBilinearBetweenAndZeroOutside) {
  FreeCells cells(Lattice{0.1, 0, 0, 5, 5});
  for (int iy = 0; iy < 5; ++iy) {
    cells.mark_run(iy, 0, 4);
  }
  const DistanceField field(cells);
  EXPECT_NEAR(field.at({0.25, 0.25}), 0.2, 1e-7);
  EXPECT_NEAR(field.at({0.15, 0.25}), 0.15, 1e-7);
  EXPECT_EQ(field.at({-0.01, 0.2}), 0.0);
  EXPECT_EQ(field.at({0.2, 9.0}), 0.0);
  EXPECT_NEAR(field.gradient({0.15, 0.25}, 0.01).x_m, 1.0, 1e-5);
}

TEST(FreeCells, RunsAreThoseOfSingleMarks) {
  std::mt19937 engine(3);
  FreeCells runs(Lattice{1.0, 0, 0, 200, 3});
  FreeCells marks(Lattice{1.0, 0, 0, 200, 3});
  for (int i = 0; i < 60; ++i) {
    const int iy = static_cast<int>(engine() % 5U) - 1;
    const int first = static_cast<int>(engine() % 230U) - 15;
    const int last = first + static_cast<int>(engine() % 90U) - 2;
    runs.mark_run(iy, first, last);
    for (int ix = std::max(0, first); ix <= std::min(199, last); ++ix) {
      if (iy >= 0 && iy < 3) {
        marks.mark(ix, iy);
      }
    }
    ASSERT_TRUE(runs == marks);
  }
}

}  // namespace
}  // namespace tcert::witness
