#include "analysis/study/truth/turning_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/study/truth/cell_grid.hpp"
#include "analysis/study/truth/clearance_value.hpp"
#include "analysis/study/truth/obstacle_distance.hpp"

namespace tcert::study {
namespace {

constexpr double kResolution = 1e-3;    // m
constexpr double kCellsOfPiece = 16.0;  // in a piece of path, at least
constexpr int kFewestBins = 8;          // so that a piece turns by less than a right angle
constexpr int kMostBins = 256;
constexpr std::size_t kMostStates = std::size_t{1} << 26U;

/// Displacements along a heading and to either side of it.
struct Box {
  double near_m = 0.0;
  double far_m = 0.0;
  double beside_m = 0.0;
};

struct Offset {
  int columns = 0;
  int rows = 0;
};

/// The pieces of path that are asked about: `bins` headings, radius and length of a piece.
struct Pieces {
  int bins = kFewestBins;
  double radius_m = 0.0;
  double length_m = 0.0;
  double delta_rad = 0.0;

  /// What a piece is displaced by that stays in its bin, along the middle heading of that; or that
  /// comes into the next one, along the border of the two. At s its heading is off by at most the
  /// larger of half a bin and what lies between, delta/2 + min(s, L - s)/R, or max(s, L - s)/R.
  [[nodiscard]] Box of_turn(int turn) const noexcept {
    const double half = 0.5 * delta_rad;
    const double near_m = 2.0 * radius_m * (std::sin(delta_rad) - std::sin(half));
    const double beside_m = turn == 0 ? 2.0 * radius_m * (std::cos(half) - std::cos(delta_rad))
                                      : radius_m * (1.0 - std::cos(delta_rad));
    return {near_m, length_m, beside_m};
  }
  /// Any part of a piece, along the middle heading of its first bin.
  [[nodiscard]] Box of_part() const noexcept {
    return {0.0, length_m, radius_m * (std::cos(0.5 * delta_rad) - std::cos(1.5 * delta_rad))};
  }
};

/// The cells of which some point is displaced from some point of cell (0, 0) by one of the box,
/// which lies along `heading_rad`: squares and box overlap unless a side of either parts them.
std::vector<Offset> offsets_of(const Box& box, double heading_rad, double cell_m) {
  const double cosine = std::cos(heading_rad);
  const double sine = std::sin(heading_rad);
  const double round_m = cell_m * (std::abs(cosine) + std::abs(sine));
  std::array<double, 4> xs{};
  std::array<double, 4> ys{};
  std::size_t corner = 0;
  for (const double along_m : {box.near_m, box.far_m}) {
    for (const double left_m : {-box.beside_m, box.beside_m}) {
      xs[corner] = cosine * along_m - sine * left_m;
      ys[corner++] = sine * along_m + cosine * left_m;
    }
  }
  const auto [low_x, high_x] = std::ranges::minmax(xs);
  const auto [low_y, high_y] = std::ranges::minmax(ys);
  const auto first = [&](double low_m) { return static_cast<int>(std::floor(low_m / cell_m)) - 1; };
  const auto last = [&](double high_m) { return static_cast<int>(std::ceil(high_m / cell_m)) + 1; };
  std::vector<Offset> offsets;
  for (int row = first(low_y); row <= last(high_y); ++row) {
    for (int column = first(low_x); column <= last(high_x); ++column) {
      const double along_m = cell_m * (cosine * column + sine * row);
      const double left_m = cell_m * (cosine * row - sine * column);
      if (along_m > box.near_m - round_m && along_m < box.far_m + round_m &&
          std::abs(left_m) < box.beside_m + round_m) {
        offsets.push_back({column, row});
      }
    }
  }
  return offsets;
}

/// Cells of a world with what is asked of them.
struct TurningGrid {
  CellGrid cells;
  std::vector<double> most_m;  ///< No point of the cell has more clearance.
  std::vector<std::uint8_t> starts;
  std::vector<std::uint8_t> goals;
};

CellGrid turning_cells(const World& world, double cell_m) {
  try {
    return cell_grid(world, cell_m);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(error.what()) +
                                ", of the cells for turning (--turn-cell)");
  }
}

TurningGrid turning_grid(const World& world, double cell_m) {
  require_regions(world);
  TurningGrid grid{turning_cells(world, cell_m), {}, {}, {}};
  const double round_m = cell_m / std::numbers::sqrt2;
  const ObstacleDistance obstacles(world);
  grid.most_m.resize(grid.cells.size());
  for (std::size_t i = 0; i < grid.most_m.size(); ++i) {
    grid.most_m[i] = obstacles.at(grid.cells.centre(i)) + round_m;
  }
  grid.starts.assign(grid.cells.size(), 0);
  grid.goals.assign(grid.cells.size(), 0);
  mark_region(grid.cells, *world.start, round_m, grid.starts);
  mark_region(grid.cells, *world.goal, round_m, grid.goals);
  return grid;
}

/// A search through (cell, bin) for a way from S to G.
class TurningSearch {
 public:
  TurningSearch(const TurningGrid& grid, const Pieces& pieces, double clearance_m)
      : grid_(grid), pieces_(pieces), clearance_m_(clearance_m) {
    const auto bins = static_cast<std::size_t>(pieces.bins);
    if (grid.cells.size() > kMostStates / bins) {
      throw std::invalid_argument(
          "more cells and headings than 2^26: raise the size of the cells for turning "
          "(--turn-cell)");
    }
    seen_.assign(grid.cells.size() * bins, 0);
    for (int bin = 0; bin < pieces.bins; ++bin) {
      const double heading_rad = bin * pieces.delta_rad;
      for (const int turn : {-1, 0, 1}) {
        steps_.push_back(offsets_of(
            pieces.of_turn(turn), heading_rad + 0.5 * turn * pieces.delta_rad, grid.cells.step_m));
      }
      parts_.push_back(offsets_of(pieces.of_part(), heading_rad, grid.cells.step_m));
    }
  }

  [[nodiscard]] bool finds_a_way() {
    for (std::size_t cell = 0; cell < grid_.cells.size(); ++cell) {
      for (int bin = 0; grid_.starts[cell] != 0 && bin < pieces_.bins; ++bin) {
        visit(cell, bin);
      }
    }
    while (!open_.empty()) {
      const std::size_t state = open_.back();
      open_.pop_back();
      const auto bins = static_cast<std::size_t>(pieces_.bins);
      if (leads_on(state / bins, static_cast<int>(state % bins))) {
        return true;
      }
    }
    return false;
  }

 private:
  void visit(std::size_t cell, int bin) {
    const std::size_t state =
        cell * static_cast<std::size_t>(pieces_.bins) + static_cast<std::size_t>(bin);
    if (seen_[state] == 0 && grid_.most_m[cell] >= clearance_m_) {
      seen_[state] = 1;
      open_.push_back(state);
    }
  }

  /// visit(cell) of those at the offsets that lie in the grid.
  template <class Visit>
  void for_each(std::size_t cell, const std::vector<Offset>& offsets, Visit visit) const {
    const auto column = static_cast<std::int64_t>(cell % grid_.cells.columns);
    const auto row = static_cast<std::int64_t>(cell / grid_.cells.columns);
    for (const Offset& offset : offsets) {
      const std::int64_t x = column + offset.columns;
      const std::int64_t y = row + offset.rows;
      if (x >= 0 && y >= 0 && x < static_cast<std::int64_t>(grid_.cells.columns) &&
          y < static_cast<std::int64_t>(grid_.cells.rows)) {
        visit(static_cast<std::size_t>(y) * grid_.cells.columns + static_cast<std::size_t>(x));
      }
    }
  }

  /// Visits what follows; true if G does.
  bool leads_on(std::size_t cell, int bin) {
    bool is_there = false;
    for_each(cell, parts_[static_cast<std::size_t>(bin)], [&](std::size_t next) {
      is_there = is_there || grid_.goals[next] != 0;
    });
    for (const int turn : {-1, 0, 1}) {
      const int next_bin = (bin + turn + pieces_.bins) % pieces_.bins;
      for_each(cell,
               steps_[3 * static_cast<std::size_t>(bin) + static_cast<std::size_t>(turn + 1)],
               [&](std::size_t next) { visit(next, next_bin); });
    }
    return is_there;
  }

  const TurningGrid& grid_;
  Pieces pieces_;
  double clearance_m_;
  std::vector<std::vector<Offset>> steps_;  // by bin, to the right, ahead, to the left
  std::vector<std::vector<Offset>> parts_;  // by bin
  std::vector<std::uint8_t> seen_;
  std::vector<std::size_t> open_;
};

/// True unless no path has such a clearance and turns on no smaller circle.
bool may_exist(const TurningGrid& grid, double clearance_m, double radius_m) {
  const double cell_m = grid.cells.step_m;
  if (clearance_m < 2.0 * cell_m || radius_m < 2.0 * cell_m) {
    return true;
  }
  const double circle_m = 2.0 * std::numbers::pi * radius_m;
  const double wanted = circle_m / (kCellsOfPiece * cell_m);
  // A piece no longer than the clearance leads through no wall.
  const double needed = std::ceil(circle_m / clearance_m);
  const int bins =
      static_cast<int>(std::max(std::clamp<double>(wanted, kFewestBins, 24.0), needed));
  if (bins > kMostBins) {
    return true;
  }
  const double delta_rad = 2.0 * std::numbers::pi / bins;
  return TurningSearch(grid, {bins, radius_m, delta_rad * radius_m, delta_rad}, clearance_m)
      .finds_a_way();
}

}  // namespace

double turning_upper(const World& world,
                     const Robot& robot,
                     SlackConvention convention,
                     double least_m,
                     double most_m,
                     double cell_m) {
  const TurningGrid grid = turning_grid(world, cell_m);
  const double per_clearance = convention == SlackConvention::width ? 2.0 : 1.0;
  double low_m = std::max(least_m, -robot.min_turn_radius_m);
  const auto refuted = [&](double margin_m) {
    const double clearance_m = margin_m / per_clearance + 0.5 * robot.body_width_m;
    return !may_exist(grid, clearance_m, robot.min_turn_radius_m + margin_m);
  };
  if (!std::isfinite(most_m) || most_m <= low_m || !refuted(most_m)) {
    return most_m;
  }
  while (most_m - low_m > kResolution) {
    const double middle_m = 0.5 * (low_m + most_m);
    (refuted(middle_m) ? most_m : low_m) = middle_m;
  }
  return most_m;
}

}  // namespace tcert::study
