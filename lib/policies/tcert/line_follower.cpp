#include <algorithm>
#include <limits>
#include <tcert/line_follower.hpp>
#include <tcert/segment.hpp>

namespace tcert::policies {
namespace {

/// A lane is driven when no more than this share of a lookahead is left of it. On the way back all
/// of one may be left, or the point ahead would lie beside the robot, on the next lane.
constexpr double kDone = 0.25;

}  // namespace

LineFollower::LineFollower(const CourseLine& line, double lookahead_m) : lookahead_m_(lookahead_m) {
  for (const Lobe& lobe : line.lobes) {
    std::vector<Line>& lanes = lobes_.emplace_back();
    for (const LaneLine& lane : lobe.lanes) {
      Line& made = lanes.emplace_back();
      made.points = lane;
      made.along_m = {0.0};
      for (std::size_t i = 1; i < lane.size(); ++i) {
        made.along_m.push_back(made.along_m.back() + distance(lane[i - 1], lane[i]));
      }
    }
  }
}

void LineFollower::reset() noexcept {
  lobe_ = lane_ = next_lane_ = 0;
  along_m_ = 0.0;
}

Point LineFollower::point_at(const Line& line, double along_m) noexcept {
  const auto above = std::upper_bound(line.along_m.begin(), line.along_m.end(), along_m);
  if (above == line.along_m.begin()) {
    return line.points.front();
  }
  if (above == line.along_m.end()) {
    return line.points.back();
  }
  const auto i = static_cast<std::size_t>(above - line.along_m.begin());
  const double share = (along_m - line.along_m[i - 1]) / (line.along_m[i] - line.along_m[i - 1]);
  return line.points[i - 1] + share * (line.points[i] - line.points[i - 1]);
}

double LineFollower::nearest_along(const Line& line, Point position) const noexcept {
  const double window_m = 2.0 * lookahead_m_;
  const auto first =
      std::upper_bound(line.along_m.begin(), line.along_m.end(), along_m_ - window_m);
  auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(first - line.along_m.begin(), 1));
  double nearest_m = std::numeric_limits<double>::infinity();
  double along_m = along_m_;
  for (; i < line.points.size() && line.along_m[i - 1] <= along_m_ + window_m; ++i) {
    const Point at = nearest_on_segment(position, line.points[i - 1], line.points[i]);
    const double away_m = distance(position, at);
    if (away_m < nearest_m) {
      nearest_m = away_m;
      along_m = line.along_m[i - 1] + distance(line.points[i - 1], at);
    }
  }
  return std::clamp(along_m, along_m_ - window_m, along_m_ + window_m);
}

void LineFollower::advance(Point position) noexcept {
  while (lobe_ < lobes_.size()) {
    const Line& line = lobes_[lobe_][lane_];
    along_m_ = nearest_along(line, position);
    if (backing_out()) {
      if (along_m_ > lookahead_m_) {
        return;
      }
      lane_ = next_lane_;
    } else {
      if (along_m_ < line.along_m.back() - kDone * lookahead_m_) {
        return;
      }
      ++lobe_;
      lane_ = next_lane_ = 0;
    }
    along_m_ = 0.0;
  }
}

Point LineFollower::carrot(Point position, Point goal) noexcept {
  advance(position);
  if (lobe_ == lobes_.size()) {
    return goal;
  }
  const Line& line = lobes_[lobe_][lane_];
  if (backing_out()) {
    return point_at(line, along_m_ - lookahead_m_);
  }
  const double beyond_m = along_m_ + lookahead_m_ - line.along_m.back();
  if (beyond_m <= 0.0) {
    return point_at(line, along_m_ + lookahead_m_);
  }
  return lobe_ + 1 < lobes_.size() ? point_at(lobes_[lobe_ + 1].front(), beyond_m) : goal;
}

void LineFollower::give_up_lane() noexcept {
  if (lobe_ < lobes_.size() && !backing_out()) {
    next_lane_ = (lane_ + 1) % lobes_[lobe_].size();
  }
}

}  // namespace tcert::policies
