#include <cmath>
#include <numbers>
#include <tcert/headings.hpp>

namespace tcert::policies {
namespace {

constexpr double kSector = std::numbers::pi / 12.0;

using Units = std::array<Point, HeadingCosts::kHighest - HeadingCosts::kLowest + 1>;

Units all_headings() noexcept {
  Units units{};
  for (int k = HeadingCosts::kLowest; k <= HeadingCosts::kHighest; ++k) {
    units[static_cast<std::size_t>(k - HeadingCosts::kLowest)] = unit(HeadingCosts::turn_rad(k));
  }
  return units;
}

const Units kUnits = all_headings();

}  // namespace

double HeadingCosts::turn_rad(int k) noexcept { return k * kSector; }

Point HeadingCosts::heading(int k) noexcept { return kUnits[index(k)]; }

int HeadingCosts::cheapest(int side) const noexcept {
  int best = 0;
  for (int turn = 1; turn <= kHighest; ++turn) {
    for (const int k : {side * turn, -side * turn}) {
      // Straight back is one heading and not two.
      if (k >= kLowest && (*this)[k] < (*this)[best]) {
        best = k;
      }
    }
  }
  return best;
}

void add_goal_cost(HeadingCosts& costs, double bearing_rad, double weight) noexcept {
  for (int k = HeadingCosts::kLowest; k <= HeadingCosts::kHighest; ++k) {
    const double away_rad = std::abs(angle_between(bearing_rad, HeadingCosts::turn_rad(k)));
    costs.add(k, weight * (away_rad / std::numbers::pi));
  }
}

void add_clearance_cost(HeadingCosts& costs,
                        std::span<const FeltRay> rays,
                        double weight) noexcept {
  for (int k = HeadingCosts::kLowest; k <= HeadingCosts::kHighest; ++k) {
    const double felt = kernel_sum(
        HeadingCosts::heading(k), rays, [&](std::size_t i) noexcept { return rays[i].depth; });
    costs.add(k, weight * felt);
  }
}

double turn_into(int k, double bearing_rad) noexcept {
  const double turn_rad = HeadingCosts::turn_rad(k);
  return std::abs(angle_between(bearing_rad, turn_rad)) <= 0.5 * kSector ? bearing_rad : turn_rad;
}

}  // namespace tcert::policies
