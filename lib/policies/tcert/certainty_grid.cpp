#include <algorithm>
#include <cmath>
#include <tcert/certainty_grid.hpp>

namespace tcert::policies {

CertaintyGrid::CertaintyGrid(const PolicySetup& setup)
    : grid_(setup), certainty_(grid_.cells(), std::uint8_t{0}) {
  const double cell_m = grid_.cell_m();
  // A cell less, or the body would deny what it touches.
  for_each_offset_within(std::max(0.5 * setup.robot.body_width_m - cell_m, 0.0),
                         cell_m,
                         [&](GridCell offset) { body_.push_back(offset); });
  std::size_t most = body_.size() + 1;
  for (const Ray& ray : setup.robot.rays) {
    most += 2 * static_cast<std::size_t>(ray.reach_m / cell_m) + 3;
  }
  touched_.resize(most);
}

void CertaintyGrid::reset() noexcept {
  std::fill(certainty_.begin(), certainty_.end(), std::uint8_t{0});
  touched_count_ = 0;
}

void CertaintyGrid::touch(std::uint32_t cell) noexcept {
  if (touched_count_ < touched_.size()) {
    touched_[touched_count_++] = cell;
  }
}

void CertaintyGrid::lower(std::uint32_t cell) noexcept {
  if (cell != CourseGrid::kOutside && certainty_[cell] > 0) {
    --certainty_[cell];
    touch(cell);
  }
}

void CertaintyGrid::raise(std::uint32_t cell) noexcept {
  if (cell != CourseGrid::kOutside && certainty_[cell] < kMost) {
    certainty_[cell] = static_cast<std::uint8_t>(std::min<int>(certainty_[cell] + kContact, kMost));
    touch(cell);
  }
}

// Points half a cell apart; the cell of the tip is not swept by a ray in contact.
void CertaintyGrid::sweep(const BodyFrame& body, const FeltRay& ray) noexcept {
  const double step_m = 0.5 * grid_.cell_m();
  const std::uint32_t end =
      ray.contact ? index_at(body.to_odometry(ray.tip())) : CourseGrid::kOutside;
  std::uint32_t last = CourseGrid::kOutside;
  const auto steps = static_cast<int>(std::floor(ray.clearance_m / step_m));
  for (int i = 0; i <= steps; ++i) {
    const std::uint32_t cell = index_at(body.to_odometry(ray.mount + (i * step_m) * ray.ahead));
    if (cell != last && cell != end) {
      lower(cell);
    }
    last = cell;
  }
}

// All that lowers comes before all that raises: within either the order does not matter.
void CertaintyGrid::take(const Outlook& now) noexcept {
  touched_count_ = 0;
  const GridCell here = grid_.cell_at(now.body.origin);
  for (const GridCell offset : body_) {
    lower(grid_.index(here + offset));
  }
  for (const FeltRay& ray : now.rays) {
    if (!std::isnan(ray.clearance_m)) {
      sweep(now.body, ray);
    }
  }
  for (const FeltRay& ray : now.rays) {
    if (ray.contact && !std::isnan(ray.clearance_m)) {
      raise(index_at(now.body.to_odometry(ray.tip())));
    }
  }
  if (now.bump) {
    raise(index_at(*now.bump));
  }
}

}  // namespace tcert::policies
