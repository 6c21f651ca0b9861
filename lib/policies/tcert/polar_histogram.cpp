#include <algorithm>
#include <cmath>
#include <numbers>
#include <tcert/polar_histogram.hpp>

namespace tcert::policies {
namespace {

constexpr double kSectorRad = 2.0 * std::numbers::pi / kSectors;

/// Sums of whole 2^-20 are exact, hence the same in any order.
double exact_magnitude(double magnitude) noexcept {
  constexpr double kUnit = 0x1p20;
  return std::round(magnitude * kUnit) / kUnit;
}

}  // namespace

int sector_of(double angle_rad) noexcept {
  const double turns = wrapped_angle(angle_rad);
  return static_cast<int>(std::round(turns / kSectorRad));
}

double angle_of(double sector) noexcept { return sector * kSectorRad; }

std::size_t sector_index(int sector) noexcept {
  return static_cast<std::size_t>((sector % kSectors + kSectors) % kSectors);
}

double cell_magnitude(double certainty,
                      double distance_m,
                      double reach_m,
                      double slope_per_m) noexcept {
  const double nearness = slope_per_m * reach_m - slope_per_m * distance_m;
  return certainty * certainty * std::fmax(nearness, 0.0);
}

Densities polar_density(const CertaintyGrid& grid,
                        Point from,
                        double reach_m,
                        double slope_per_m) noexcept {
  Densities density{};
  const CourseGrid& cells = grid.grid();
  const GridCell here = cells.cell_at(from);
  const auto most = static_cast<std::int32_t>(std::ceil(reach_m / cells.cell_m()));
  for (std::int32_t y = -most; y <= most; ++y) {
    for (std::int32_t x = -most; x <= most; ++x) {
      const GridCell cell = here + GridCell{x, y};
      const std::uint32_t index = cells.index(cell);
      if (index == CourseGrid::kOutside || grid.certainties()[index] == 0) {
        continue;
      }
      const Point away = cells.centre(cell) - from;
      const auto sector = sector_index(sector_of(bearing_of(away)));
      density[sector] += exact_magnitude(
          cell_magnitude(grid.certainties()[index], norm(away), reach_m, slope_per_m));
    }
  }
  return density;
}

// Pairs that mirror each other are added first: the mirrored densities give the mirrored result.
Densities smoothed(const Densities& density) noexcept {
  Densities smooth{};
  for (int k = 0; k < kSectors; ++k) {
    double sum = (kSmoothing + 1) * density[sector_index(k)];
    for (int i = 1; i <= kSmoothing; ++i) {
      sum += (kSmoothing + 1 - i) * (density[sector_index(k - i)] + density[sector_index(k + i)]);
    }
    smooth[sector_index(k)] = sum / (2 * kSmoothing + 1);
  }
  return smooth;
}

std::optional<double> choose_valley(const Densities& density,
                                    double threshold,
                                    int target,
                                    int side) noexcept {
  const auto free = [&](int turn) noexcept {
    return density[sector_index(target + turn)] < threshold;
  };
  int nearest = 0;
  for (int turn = 0; turn <= kSectors / 2; ++turn) {
    nearest = free(side * turn) ? side * turn : -side * turn;
    if (free(nearest)) {
      break;
    }
  }
  if (!free(nearest)) {
    return std::nullopt;
  }
  int left = nearest;
  int right = nearest;
  while (left - right < kSectors && free(left + 1)) {
    ++left;
  }
  while (left - right < kSectors && free(right - 1)) {
    --right;
  }
  if (left - right + 1 > kSectors) {
    return 0.0;
  }
  if (left - right + 1 <= kWidestValley) {
    return 0.5 * (left + right);
  }
  return std::clamp(0.0, right + 0.5 * kWidestValley, left - 0.5 * kWidestValley);
}

int least_dense(const Densities& density, int target, int side) noexcept {
  int best = 0;
  for (int turn = 1; turn <= kSectors / 2; ++turn) {
    for (const int k : {side * turn, -side * turn}) {
      best = density[sector_index(target + k)] < density[sector_index(target + best)] ? k : best;
    }
  }
  return best;
}

}  // namespace tcert::policies
