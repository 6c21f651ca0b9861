#include <algorithm>
#include <cmath>
#include <terrain/disc_growth.hpp>
#include <terrain/distance_transform.hpp>
#include <terrain/row_counts.hpp>

namespace tcert::terrain {
namespace {

/// Largest k with k^2 <= rest; -1 if there is none.
[[nodiscard]] int half_width(double rest, double far) {
  if (rest < 0.0) {
    return -1;
  }
  int k = static_cast<int>(std::min(std::sqrt(rest), far));
  while (static_cast<double>(k) * k > rest) {
    --k;
  }
  while (k < far && (k + 1.0) * (k + 1.0) <= rest) {
    ++k;
  }
  return k;
}

/// All cells within radius of `centre`. \pre radius >= 0
void paint_disc(RowCounts& counts, Cell centre, double radius) {
  const Grid& grid = counts.grid();
  const double r2 = radius * radius;
  const double far = grid.rows + grid.columns;
  const int reach = static_cast<int>(std::min(radius, far));
  const int first = std::max(0, centre.x - reach);
  const int last = std::min(grid.rows - 1, centre.x + reach);
  for (int x = first; x <= last; ++x) {
    const double dx = x - centre.x;
    const int half = half_width(r2 - dx * dx, far);
    if (half >= 0) {
      counts.add(x, centre.y - half, centre.y + half);
    }
  }
}

}  // namespace

bool reaches(double bound, double threshold, double lipschitz, double d2) noexcept {
  if (!(bound >= threshold)) {
    return false;
  }
  const double radius = (bound - threshold) / lipschitz;
  return d2 <= radius * radius;
}

CellSet grow_discs(const Grid& grid,
                   const CellSet& safe,
                   std::span<const double> lower,
                   double threshold,
                   double lipschitz,
                   std::span<const std::int64_t> depth2) {
  RowCounts counts(grid);
  CellSet stays(grid.size(), 0);
  bool all_stay = true;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (safe[i] != 0) {
      stays[i] = lower[i] >= threshold ? 1 : 0;
      all_stay = all_stay && stays[i] != 0;
    }
  }
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (stays[i] == 0) {
      continue;
    }
    const double radius = (lower[i] - threshold) / lipschitz;
    // While every member stays, a disc within the set adds nothing.
    if (all_stay && radius * radius < static_cast<double>(depth2[i])) {
      continue;
    }
    if (radius >= grid.rows + grid.columns) {
      return CellSet(grid.size(), 1);  // NOLINT(modernize-return-braced-init-list): a list of two.
    }
    paint_disc(counts, grid.cell(i), radius);
  }
  CellSet grown = counts.covered();
  for (std::size_t i = 0; i < grid.size(); ++i) {
    grown[i] = grown[i] | stays[i];
  }
  return grown;
}

CellSet expanders(const CellSet& safe,
                  std::span<const double> upper,
                  double threshold,
                  double lipschitz,
                  std::span<const std::int64_t> depth2) {
  CellSet set(safe.size(), 0);
  for (std::size_t i = 0; i < safe.size(); ++i) {
    set[i] = safe[i] != 0 && depth2[i] < kNoCell &&
                     reaches(upper[i], threshold, lipschitz, static_cast<double>(depth2[i]))
                 ? 1
                 : 0;
  }
  return set;
}

}  // namespace tcert::terrain
