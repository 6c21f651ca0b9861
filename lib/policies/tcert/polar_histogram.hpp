#pragma once
/// \file
/// The vector field histogram of Borenstein and Koren, *The Vector Field Histogram: Fast Obstacle
/// Avoidance for Mobile Robots*, IEEE Trans. Robotics and Automation 7(3), 1991.

#include <array>
#include <optional>
#include <tcert/certainty_grid.hpp>

namespace tcert::policies {

inline constexpr int kSectors = 72;       ///< Of 5 degrees, centred on multiples of it.
inline constexpr int kSmoothing = 5;      ///< l.
inline constexpr int kWidestValley = 18;  ///< s_max, in sectors.

/// By index of a sector: counter-clockwise from the x axis.
using Densities = std::array<double, kSectors>;

/// Sector of an angle, in [-36, 36], positive to the left; the ends are the same. \pre finite.
[[nodiscard]] int sector_of(double angle_rad) noexcept;

/// The middle of a sector, or of two neighbours where it is a half.
[[nodiscard]] double angle_of(double sector) noexcept;

/// Where in the densities any whole number of sectors stands.
[[nodiscard]] std::size_t sector_index(int sector) noexcept;

/// m = c^2 (a - b d), a = b d_max: at most 225 b d_max, 0 from d_max on.
[[nodiscard]] double cell_magnitude(double certainty,
                                    double distance_m,
                                    double reach_m,
                                    double slope_per_m) noexcept;

/// Polar obstacle density: the sum of the magnitudes of the cells in each sector, seen from `from`.
/// O((reach / cell)^2). \pre b d_max at most 1000.
[[nodiscard]] Densities polar_density(const CertaintyGrid& grid,
                                      Point from,
                                      double reach_m,
                                      double slope_per_m) noexcept;

/// h'_k = sum over |i| <= l of (l + 1 - |i|) h_{k+i} / (2 l + 1). The weights add up to 36/11, as
/// published: it smooths, and scales.
[[nodiscard]] Densities smoothed(const Densities& density) noexcept;

/// Where to steer, in sectors and halves of them to the left of sector `target`: into the nearest
/// valley of densities below `threshold`; of two as near that on `side`. A valley of at most s_max
/// sectors is passed in its middle. In a wider one the robot keeps s_max/2 away from both borders,
/// and goes for the target if that does. None, if no sector is below the threshold.
[[nodiscard]] std::optional<double> choose_valley(const Densities& density,
                                                  double threshold,
                                                  int target,
                                                  int side) noexcept;

/// The sector of the least density, to the left of `target` as above; of equals the nearest, of two
/// as near that on `side`.
[[nodiscard]] int least_dense(const Densities& density, int target, int side) noexcept;

}  // namespace tcert::policies
