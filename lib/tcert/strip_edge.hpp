#pragma once
/// \file
/// An edge of the strip between two positions of a ray, row by row of a grid.

#include <algorithm>
#include <tcert/geometry.hpp>
#include <utility>

namespace tcert {

/// Which columns it meets in a range of heights; for candidates alone, so that rounding of its
/// slope is nothing to a range that is widened by far more.
class StripEdge {
 public:
  StripEdge(Point p, Point q) noexcept {
    constexpr double kFlat = 1e-9;  // m
    if (p.y_m > q.y_m) {
      std::swap(p, q);
    }
    bottom_ = p.y_m;
    top_ = q.y_m;
    x_at_bottom_ = p.x_m;
    is_flat_ = top_ - bottom_ <= kFlat;
    slope_ = is_flat_ ? 0.0 : (q.x_m - p.x_m) / (top_ - bottom_);
    left_ = std::min(p.x_m, q.x_m);
    right_ = std::max(p.x_m, q.x_m);
  }

  /// Adds its x-range within low <= y <= high to [from, to].
  void add_range(double low, double high, double& from, double& to) const noexcept {
    if (bottom_ > high || top_ < low) {
      return;
    }
    if (is_flat_) {
      from = std::min(from, left_);
      to = std::max(to, right_);
      return;
    }
    const double a = x_at_bottom_ + (std::max(low, bottom_) - bottom_) * slope_;
    const double b = x_at_bottom_ + (std::min(high, top_) - bottom_) * slope_;
    from = std::min({from, a, b});
    to = std::max({to, a, b});
  }

 private:
  double bottom_ = 0.0, top_ = 0.0, x_at_bottom_ = 0.0, slope_ = 0.0, left_ = 0.0, right_ = 0.0;
  bool is_flat_ = false;
};

}  // namespace tcert
