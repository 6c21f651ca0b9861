#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "analysis/study/truth/circle_ties.hpp"
#include "analysis/study/truth/clearance_value.hpp"
#include "analysis/study/truth/parity_sets.hpp"

namespace tcert::study {
namespace {

/// A component of the overlap of two blown-up obstacles is born.
struct Birth {
  double clearance_m = 0.0;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  Point at;
};

bool operator<(const Birth& p, const Birth& q) {
  if (p.clearance_m != q.clearance_m) {
    return p.clearance_m < q.clearance_m;
  }
  return p.a != q.a ? p.a < q.a : p.b < q.b;
}

/// The walls that the bounds make, in the order in which neighbours follow each other.
std::array<Wall, 4> walls_of(const Bounds& bounds) {
  return {Wall{{1.0, 0.0}, bounds.low.x_m},
          Wall{{0.0, 1.0}, bounds.low.y_m},
          Wall{{-1.0, 0.0}, -bounds.high.x_m},
          Wall{{0.0, -1.0}, -bounds.high.y_m}};
}

class Field {
 public:
  explicit Field(const World& world)
      : bounds_(world.bounds),
        start_(std::get<Disc>(*world.start)),
        goal_(std::get<Disc>(*world.goal)) {
    for (const Region& obstacle : world.obstacles) {
      discs_.push_back(std::get<Disc>(obstacle));
      widest_ = std::max(widest_, discs_.back().radius_m);
    }
    std::sort(discs_.begin(), discs_.end(), [](const Disc& a, const Disc& b) {
      return a.centre.x_m < b.centre.x_m;
    });
  }

  /// Clearance at which S, G or everything is covered by one obstacle, and where that ends.
  [[nodiscard]] Birth covered() const {
    Birth least;
    const Point middle = 0.5 * (bounds_.low + bounds_.high);
    const Point half = 0.5 * (bounds_.high - bounds_.low);
    least.clearance_m = std::min(half.x_m, half.y_m);
    least.at = middle;
    for (const Disc& region : {start_, goal_}) {
      const auto offer = [&](double clearance_m, Point away) {
        if (clearance_m < least.clearance_m) {
          least.clearance_m = clearance_m;
          least.at = region.centre + region.radius_m * away;
        }
      };
      for (const Disc& disc : discs_) {
        const Point d = region.centre - disc.centre;
        offer(norm(d) + region.radius_m - disc.radius_m, (1.0 / norm(d)) * d);
      }
      for (const Wall& wall : walls_of(bounds_)) {
        offer(surface_distance(wall, region.centre) + region.radius_m, wall.normal);
      }
    }
    return least;
  }

  /// All births up to `limit`, sorted.
  [[nodiscard]] std::vector<Birth> births(double limit) const {
    std::vector<Birth> births;
    add_gaps_between_discs(limit, births);
    add_gaps_to_walls(limit, births);
    add_at_edge_of(start_, limit, births);
    add_at_edge_of(goal_, limit, births);
    std::sort(births.begin(), births.end());
    return births;
  }

  /// The birth that separates S from G, or null.
  [[nodiscard]] const Birth* separation(const std::vector<Birth>& births) const {
    ParitySets sets(discs_.size() + 4);
    for (std::size_t k = 1; k < 4; ++k) {
      (void)sets.join(discs_.size(), discs_.size() + k, false);  // all one outside
    }
    for (const Birth& birth : births) {
      const bool odd = crosses(anchor(birth.a, birth.at), birth.at) !=
                       crosses(birth.at, anchor(birth.b, birth.at));
      if (!sets.join(birth.a, birth.b, odd)) {
        return &birth;
      }
    }
    return nullptr;
  }

 private:
  [[nodiscard]] Obstacle obstacle(std::uint32_t index) const {
    if (index < discs_.size()) {
      return discs_[index];
    }
    return walls_of(bounds_)[index - discs_.size()];
  }

  /// Where the straight curve from `p` into an obstacle ends: its centre, or the foot on its wall.
  [[nodiscard]] Point anchor(std::uint32_t index, Point p) const {
    if (index < discs_.size()) {
      return discs_[index].centre;
    }
    const Wall wall = walls_of(bounds_)[index - discs_.size()];
    return p - surface_distance(wall, p) * wall.normal;
  }

  /// Parity of crossings of the segment from S's centre to G's. A point on its line counts as
  /// right of it, always, so that the parities of a closed curve add up.
  [[nodiscard]] bool crosses(Point p, Point q) const {
    const Point along = goal_.centre - start_.centre;
    const bool p_left = cross(along, p - start_.centre) > 0.0;
    const bool q_left = cross(along, q - start_.centre) > 0.0;
    if (p_left == q_left) {
      return false;
    }
    return (cross(q - p, start_.centre - p) > 0.0) != (cross(q - p, goal_.centre - p) > 0.0);
  }

  void add_gap(Birth birth, std::vector<Birth>& births) const {
    if (!contains(start_, birth.at) && !contains(goal_, birth.at)) {
      births.push_back(birth);
    }
  }

  void add_gaps_between_discs(double limit, std::vector<Birth>& births) const {
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      const Disc& a = discs_[i];
      const double reach = 2.0 * limit + a.radius_m + widest_;
      for (std::size_t j = i + 1; j < discs_.size(); ++j) {
        const Disc& b = discs_[j];
        if (b.centre.x_m - a.centre.x_m > reach) {
          break;
        }
        const double apart = distance(a.centre, b.centre);
        const double half_gap = 0.5 * (apart - a.radius_m - b.radius_m);
        if (half_gap <= limit) {
          const double from_a = std::clamp(a.radius_m + half_gap, 0.0, apart);
          const Point at =
              apart > 0.0 ? a.centre + (from_a / apart) * (b.centre - a.centre) : a.centre;
          add_gap({half_gap, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), at},
                  births);
        }
      }
    }
  }

  void add_gaps_to_walls(double limit, std::vector<Birth>& births) const {
    const std::array<Wall, 4> walls = walls_of(bounds_);
    for (std::size_t k = 0; k < walls.size(); ++k) {
      for (std::size_t i = 0; i < discs_.size(); ++i) {
        const Disc& disc = discs_[i];
        const double apart = surface_distance(walls[k], disc.centre);
        const double half_gap = 0.5 * (apart - disc.radius_m);
        if (half_gap <= limit) {
          const double from_disc = std::max(disc.radius_m + half_gap, 0.0);
          add_gap({half_gap,
                   static_cast<std::uint32_t>(i),
                   static_cast<std::uint32_t>(discs_.size() + k),
                   disc.centre - from_disc * walls[k].normal},
                  births);
        }
      }
    }
  }

  void add_at_edge_of(const Disc& region, double limit, std::vector<Birth>& births) const {
    std::vector<std::uint32_t> near;
    for (std::size_t i = 0; i < discs_.size() + 4; ++i) {
      const auto index = static_cast<std::uint32_t>(i);
      if (surface_distance(obstacle(index), region.centre) - region.radius_m <= limit) {
        near.push_back(index);
      }
    }
    for (std::size_t i = 0; i < near.size(); ++i) {
      for (std::size_t j = i + 1; j < near.size(); ++j) {
        const Obstacle a = obstacle(near[i]);
        const Obstacle b = obstacle(near[j]);
        for (const Point p : circle_ties(region, a, b)) {
          const double clearance_m = std::max(surface_distance(a, p), surface_distance(b, p));
          const Disc& other = &region == &start_ ? goal_ : start_;
          if (clearance_m <= limit && !contains(other, p)) {
            births.push_back({clearance_m, near[i], near[j], p});
          }
        }
      }
    }
  }

  Bounds bounds_;
  Disc start_;
  Disc goal_;
  std::vector<Disc> discs_;  // by x
  double widest_ = 0.0;
};

/// A gap narrower than this is what rounding leaves of none.
constexpr double kTouching = 1e-9;

ClearanceValue value_of(const Birth& birth) {
  if (birth.clearance_m <= kTouching) {
    return {};
  }
  return {birth.clearance_m, birth.clearance_m, birth.clearance_m, birth.at};
}

}  // namespace

void require_regions(const World& world) {
  if (!world.start || !world.goal) {
    throw std::invalid_argument("world '" + world.name + "': expected " +
                                (world.start ? "a goal" : "a start"));
  }
}

bool is_disc_field(const World& world) noexcept {
  const auto is_disc = [](const Region& region) { return std::holds_alternative<Disc>(region); };
  return world.start && world.goal && is_disc(*world.start) && is_disc(*world.goal) &&
         std::all_of(world.obstacles.begin(), world.obstacles.end(), is_disc);
}

ClearanceValue exact_disc_clearance(const World& world) {
  require_regions(world);
  if (!is_disc_field(world)) {
    throw std::invalid_argument("world '" + world.name + "': expected discs only");
  }
  const Field field(world);
  const Birth covered = field.covered();
  constexpr double kFirstShare = 1.0 / 16.0;
  for (double share = kFirstShare; covered.clearance_m > 0.0 && share <= 1.0; share *= 2.0) {
    const std::vector<Birth> births = field.births(share * covered.clearance_m);
    if (const Birth* const birth = field.separation(births)) {
      return value_of(*birth);
    }
  }
  return value_of(covered);
}

}  // namespace tcert::study
