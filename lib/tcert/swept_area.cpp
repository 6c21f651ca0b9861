#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tcert/cell_box.hpp>
#include <tcert/elementary.hpp>
#include <tcert/swept_area.hpp>
#include <utility>

namespace tcert {
namespace {

constexpr std::int32_t kFarthest = 1 << 28;  // cells from the frame's origin

std::int32_t floor_index(double at) noexcept {
  return static_cast<std::int32_t>(std::clamp(std::floor(at), -1.0 * kFarthest, 1.0 * kFarthest));
}

std::int32_t ceil_index(double at) noexcept {
  return static_cast<std::int32_t>(std::clamp(std::ceil(at), -1.0 * kFarthest, 1.0 * kFarthest));
}

}  // namespace

SweptArea::SweptArea(const Robot& robot,
                     const Course& course,
                     const CertificateParameters& parameters)
    : rule_{parameters.swept_cell_m,
            parameters.travel_deadband_m,
            parameters.least_obstacle_m,
            0.5 / elementary::tan(0.5 * parameters.sharpest_corner_rad)},
      half_diagonal_m_(std::sqrt(0.5) * rule_.cell_m),
      body_radius_m_(0.5 * robot.body_width_m),
      reach_m_(body_radius_m_),
      rays_(robot.rays),
      sweeps_(robot.rays.size()),
      regions_{course.start, course.goal},
      local_regions_(regions_),
      cells_(parameters.max_swept_cells) {
  for (const Ray& ray : rays_) {
    reach_m_ = std::max(reach_m_, norm(ray.mount) + ray.reach_m);
  }
  const auto rows = static_cast<std::size_t>(2.0 * body_radius_m_ / rule_.cell_m) + 3;
  body_rows_.reserve(rows);
  last_body_rows_.reserve(rows);
}

void SweptArea::begin(const Pose& first) noexcept {
  cells_.clear();
  body_rows_.clear();
  frame_ = first;
  axis_ = direction(first.yaw_rad);
  break_path();
  for (std::size_t k = 0; k < regions_.size(); ++k) {
    if (!regions_[k]) {
      continue;
    }
    if (const auto* disc = std::get_if<Disc>(&*regions_[k])) {
      std::get_if<Disc>(&*local_regions_[k])->centre = local(disc->centre);
      continue;
    }
    const auto& given = std::get_if<Polygon>(&*regions_[k])->vertices;
    auto& moved = std::get_if<Polygon>(&*local_regions_[k])->vertices;
    for (std::size_t i = 0; i < given.size(); ++i) {
      moved[i] = local(given[i]);
    }
  }
}

void SweptArea::break_path() noexcept {
  for (RaySweep& sweep : sweeps_) {
    sweep.restart();
  }
}

Point SweptArea::local(Point p) const noexcept {
  const Point off = p - frame_.position;
  return {dot(axis_, off), cross(axis_, off)};
}

void SweptArea::sweep(const Pose& pose,
                      std::span<const double> clearances_m,
                      std::span<const double> bearings_rad) noexcept {
  const Pose here{local(pose.position), pose.yaw_rad - frame_.yaw_rad};
  mark_body(here.position);
  for (std::size_t k = 0; k < rays_.size(); ++k) {
    const Ray& ray = rays_[k];
    const bool in_body =
        norm(ray.mount) + rule_.lost_share * rule_.least_obstacle_m <= body_radius_m_;
    sweeps_[k].advance(transform(here, ray.mount),
                       direction(here.yaw_rad + bearings_rad[k]),
                       clearances_m[k],
                       in_body,
                       rule_,
                       cells_);
  }
}

// Row by row, the cells that lie wholly in the disc, without those of the disc before: mostly one
// or two of a row, or none.
void SweptArea::mark_body(Point centre) noexcept {
  const double cell_m = rule_.cell_m;
  const std::int32_t first_row = floor_index((centre.y_m - body_radius_m_) / cell_m);
  const std::int32_t last_row = floor_index((centre.y_m + body_radius_m_) / cell_m);
  body_rows_.swap(last_body_rows_);
  const std::int32_t last_first_row = std::exchange(first_body_row_, first_row);
  body_rows_.clear();
  for (std::int32_t iy = first_row; iy <= last_row; ++iy) {
    const double below = centre.y_m - static_cast<double>(iy) * cell_m;
    const double above = static_cast<double>(iy + 1) * cell_m - centre.y_m;
    const double furthest = std::max(below, above);
    CellRun run;
    if (furthest < body_radius_m_) {
      const double half_m = std::sqrt(body_radius_m_ * body_radius_m_ - furthest * furthest);
      run = {ceil_index((centre.x_m - half_m) / cell_m),
             floor_index((centre.x_m + half_m) / cell_m) - 1};
    }
    body_rows_.push_back(run);
    const auto k = static_cast<std::size_t>(std::int64_t{iy} - last_first_row);
    const CellRun marked = k < last_body_rows_.size() ? last_body_rows_[k] : CellRun{};
    if (marked.last < run.first || run.last < marked.first) {
      cells_.mark_run(iy, run.first, run.last);
    } else {
      cells_.mark_run(iy, run.first, marked.first - 1);
      cells_.mark_run(iy, marked.last + 1, run.last);
    }
  }
}

bool SweptArea::in_course(SweptCell cell) const noexcept {
  const CellBox box = box_of(cell, rule_.cell_m);
  return std::any_of(local_regions_.begin(), local_regions_.end(), [&](const auto& region) {
    return region.has_value() && covers(*region, box);
  });
}

bool SweptArea::is_free(SweptCell cell) noexcept {
  return cells_.contains(cell) || in_course(cell);
}

// Of the open cells of a block the one whose centre is nearest to the segment's middle is tried
// first: what it leaves of the distance rules nearly all others out.
void SweptArea::look_into(std::int32_t bx,
                          std::int32_t by,
                          const Piece& piece,
                          SweptClearance& best) noexcept {
  constexpr std::int32_t kSide = SweptCells::kSide;
  std::uint64_t open = ~cells_.block(bx, by);
  if (open == 0) {
    return;
  }
  const double cell_m = rule_.cell_m;
  const Point middle = piece.middle;
  const double slack_m = half_diagonal_m_ + piece.half_length_m;
  std::array<double, kSide> x2{};  // squares of the way from the middle to the centres
  std::array<double, kSide> y2{};
  for (std::int32_t i = 0; i < kSide; ++i) {
    const double x_m = (static_cast<double>(bx * kSide + i) + 0.5) * cell_m - middle.x_m;
    const double y_m = (static_cast<double>(by * kSide + i) + 0.5) * cell_m - middle.y_m;
    x2[static_cast<std::size_t>(i)] = x_m * x_m;
    y2[static_cast<std::size_t>(i)] = y_m * y_m;
  }
  const auto square_of = [&](std::uint64_t cells) noexcept {
    const auto bit = static_cast<std::size_t>(std::countr_zero(cells));
    return x2[bit % kSide] + y2[bit / kSide];
  };
  while (open != 0) {
    // The nearest of those that are left, without those that are too far.
    const double bound_m = best.distance_m + slack_m;
    double least = bound_m * bound_m;
    std::uint64_t nearest = 0;
    for (std::uint64_t left = open; left != 0; left &= left - 1) {
      const std::uint64_t lowest = left & (~left + 1U);
      const double square = square_of(left);
      if (square >= bound_m * bound_m) {
        open ^= lowest;
      } else if (square < least) {
        least = square;
        nearest = lowest;
      }
    }
    if (nearest == 0) {
      return;
    }
    open ^= nearest;
    const auto bit = static_cast<std::int32_t>(std::countr_zero(nearest));
    const SweptCell cell{bx * kSide + bit % kSide, by * kSide + bit / kSide};
    const double distance_m = distance_between(box_of(cell, cell_m), piece.from, piece.to);
    if (distance_m >= best.distance_m) {
      continue;
    }
    if (in_course(cell)) {
      cells_.mark(cell);
      continue;
    }
    best = {distance_m, cell};
  }
}

// Blocks in rings round the one that the segment's middle lies in, until no ring can be nearer.
SweptClearance SweptArea::clearance(Point from, Point to) noexcept {
  const Point a = local(from);
  const Point b = local(to);
  const double block_m = SweptCells::kSide * rule_.cell_m;
  const Point middle = 0.5 * (a + b);
  const double half_length = 0.5 * distance(a, b);
  const Piece piece{a, b, middle, half_length};
  const std::int32_t mx = floor_index(middle.x_m / block_m);
  const std::int32_t my = floor_index(middle.y_m / block_m);
  SweptClearance best{reach_m_, std::nullopt};
  const auto look = [&](std::int32_t bx, std::int32_t by) noexcept {
    const CellBox box{
        {static_cast<double>(bx) * block_m, static_cast<double>(by) * block_m},
        {static_cast<double>(bx + 1) * block_m, static_cast<double>(by + 1) * block_m}};
    if (box.distance_to(middle) - half_length < best.distance_m) {
      look_into(bx, by, piece, best);
    }
  };
  look(mx, my);
  for (std::int32_t ring = 1;
       static_cast<double>(ring - 1) * block_m - half_length < best.distance_m;
       ++ring) {
    for (std::int32_t i = -ring; i < ring; ++i) {
      look(mx + i, my - ring);
      look(mx + ring, my + i);
      look(mx - i, my + ring);
      look(mx - ring, my - i);
    }
  }
  return best;
}

}  // namespace tcert
