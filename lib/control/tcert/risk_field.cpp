#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <tcert/block_hash.hpp>
#include <tcert/cells_along.hpp>
#include <tcert/elementary.hpp>
#include <tcert/risk_field.hpp>

namespace tcert {
namespace {

constexpr std::int32_t kSide = RiskField::kSide;
constexpr std::int32_t kSideBits = 3;  // a cell's block is its index without them
static_assert(1 << kSideBits == kSide);

std::size_t within(std::int32_t column, std::int32_t row) noexcept {
  return static_cast<std::size_t>(row & (kSide - 1)) * kSide +
         static_cast<std::size_t>(column & (kSide - 1));
}

std::int32_t index_of(double at_m, double cell_m) noexcept {
  return static_cast<std::int32_t>(std::floor(at_m / cell_m));
}

/// The cells along one axis that share a coordinate: one, or two if it is their border.
struct Shared {
  std::int32_t first = 0;
  std::int32_t last = 0;
  [[nodiscard]] double share() const noexcept { return first == last ? 1.0 : 0.5; }
};

Shared shared_by(double at_m, double cell_m) noexcept {
  const std::int32_t cell = index_of(at_m, cell_m);
  return {at_m / cell_m == std::floor(at_m / cell_m) ? cell - 1 : cell, cell};
}

constexpr double kMostCellsAlong = 1000.0;

/// A cell, or two that a line along their border shares.
struct CellsBeside {
  std::int32_t column = 0;
  std::int32_t row = 0;
  std::int32_t beside_column = 0;
  std::int32_t beside_row = 0;
  bool two = false;
};

/// visit(cells, part_m): a line along a border counts by half on either side.
template <typename Visit>
void visit_cells(
    Point from, Point unit_direction, double length_m, double cell_m, Visit visit) noexcept {
  const std::int32_t beside_x = CellAxis(from.x_m, unit_direction.x_m, cell_m).on_border() ? 1 : 0;
  const std::int32_t beside_y = CellAxis(from.y_m, unit_direction.y_m, cell_m).on_border() ? 1 : 0;
  visit_cells_along(
      from,
      unit_direction,
      length_m,
      cell_m,
      [&](std::int32_t column, std::int32_t row, double part_m) noexcept {
        visit(CellsBeside{column, row, column - beside_x, row - beside_y, beside_x + beside_y > 0},
              part_m);
      });
}

}  // namespace

void validate(const RiskParameters& p) { require_fields(p); }

void validate(const RiskParameters& p, const Robot& robot) {
  validate(p);
  double longest_m = std::max(p.ahead_m, 8.0 * robot.body_width_m);
  for (const Ray& ray : robot.rays) {
    longest_m = std::max(longest_m, longest_clearance(ray));
  }
  if (!(longest_m <= kMostCellsAlong * p.cell_m)) {
    throw std::invalid_argument("risk_cell_m is " + to_text(p.cell_m) + "; it must be at least " +
                                to_text(longest_m / kMostCellsAlong) +
                                ", a thousandth of the longest ray, of risk_ahead_m and of eight "
                                "body widths");
  }
}

RiskField::RiskField(const RiskParameters& parameters) : parameters_(parameters) {
  validate(parameters);
  blocks_.resize(std::bit_ceil(std::max<std::size_t>(parameters.max_cells / (kSide * kSide), 1)));
}

void RiskField::clear() noexcept {
  std::fill(blocks_.begin(), blocks_.end(), Block{});
  used_ = 0;
  full_ = false;
}

bool RiskField::is_far(Point at, double length_m) const noexcept {
  const double far_m = 1e8 * parameters_.cell_m;
  return !(std::abs(at.x_m) + length_m < far_m && std::abs(at.y_m) + length_m < far_m);
}

std::size_t RiskField::slot_of(std::int32_t bx, std::int32_t by) const noexcept {
  return static_cast<std::size_t>(block_hash(block_key(bx, by))) & (blocks_.size() - 1);
}

const RiskField::Block* RiskField::find(std::int32_t bx, std::int32_t by) const noexcept {
  std::size_t slot = slot_of(bx, by);
  for (std::size_t probe = 0; probe < blocks_.size(); ++probe) {
    const Block& block = blocks_[slot];
    if (block.halvings < 0.0) {
      return nullptr;
    }
    if (block.bx == bx && block.by == by) {
      return &block;
    }
    slot = (slot + 1) & (blocks_.size() - 1);
  }
  return nullptr;
}

// At most three quarters of the table are used, so that a search for what is not there is short.
RiskField::Block* RiskField::claim(std::int32_t bx, std::int32_t by, double halvings) noexcept {
  std::size_t slot = slot_of(bx, by);
  while (blocks_[slot].halvings >= 0.0 && (blocks_[slot].bx != bx || blocks_[slot].by != by)) {
    slot = (slot + 1) & (blocks_.size() - 1);
  }
  Block& block = blocks_[slot];
  if (block.halvings < 0.0) {
    if (4 * (used_ + 1) > 3 * blocks_.size()) {
      full_ = true;
      return nullptr;
    }
    ++used_;
    block.bx = bx;
    block.by = by;
    block.halvings = halvings;
  } else if (block.halvings < halvings) {
    const double left = elementary::exp2(block.halvings - halvings);
    for (std::size_t i = 0; i < block.hits.size(); ++i) {
      block.hits[i] *= left;
      block.misses[i] *= left;
    }
    block.halvings = halvings;
  }
  return &block;
}

void RiskField::count(
    std::int32_t column, std::int32_t row, double hits, double misses, double halvings) noexcept {
  Block* const block = claim(column >> kSideBits, row >> kSideBits, halvings);
  if (block != nullptr) {
    block->hits[within(column, row)] += hits;
    block->misses[within(column, row)] += misses;
  }
}

void RiskField::observe_ray(
    Point from, Point unit_direction, double clear_m, bool touches, double time_s) noexcept {
  if (is_far(from, clear_m)) {
    return;
  }
  const double cell_m = parameters_.cell_m;
  const double halvings = halvings_at(time_s);
  const Point tip = from + clear_m * unit_direction;
  const Shared columns = shared_by(tip.x_m, cell_m);
  const Shared rows = shared_by(tip.y_m, cell_m);
  const auto miss = [&](std::int32_t column, std::int32_t row, double share) noexcept {
    const bool at_tip = touches && column >= columns.first && column <= columns.last &&
                        row >= rows.first && row <= rows.last;
    if (!at_tip) {
      count(column, row, 0.0, share, halvings);
    }
  };
  visit_cells(
      from, unit_direction, clear_m, cell_m, [&](const CellsBeside& at, double part_m) noexcept {
        if (2.0 * part_m >= cell_m) {
          miss(at.column, at.row, at.two ? 0.5 : 1.0);
          if (at.two) {
            miss(at.beside_column, at.beside_row, 0.5);
          }
        }
      });
  for (std::int32_t row = rows.first; touches && row <= rows.last; ++row) {
    for (std::int32_t column = columns.first; column <= columns.last; ++column) {
      count(column, row, rows.share() * columns.share(), 0.0, halvings);
    }
  }
}

void RiskField::observe_body(Point centre, double radius_m, double time_s) noexcept {
  if (is_far(centre, radius_m)) {
    return;
  }
  const double cell_m = parameters_.cell_m;
  const double halvings = halvings_at(time_s);
  const std::int32_t last_column = index_of(centre.x_m + radius_m, cell_m);
  const std::int32_t last_row = index_of(centre.y_m + radius_m, cell_m);
  for (std::int32_t row = index_of(centre.y_m - radius_m, cell_m); row <= last_row; ++row) {
    for (std::int32_t column = index_of(centre.x_m - radius_m, cell_m); column <= last_column;
         ++column) {
      const Point middle{(column + 0.5) * cell_m, (row + 0.5) * cell_m};
      const Point off = middle - centre;
      if (dot(off, off) <= radius_m * radius_m) {
        count(column, row, 0.0, 1.0, halvings);
      }
    }
  }
}

CellCounts RiskField::counts_of(std::int32_t column,
                                std::int32_t row,
                                double halvings) const noexcept {
  CellCounts counts{0.0, 0.0, parameters_.error_m2};
  if (const Block* const block = find(column >> kSideBits, row >> kSideBits)) {
    const double left =
        block->halvings < halvings ? elementary::exp2(block->halvings - halvings) : 1.0;
    counts.hits = block->hits[within(column, row)] * left;
    counts.misses = block->misses[within(column, row)] * left;
  }
  return counts;
}

double RiskField::intensity_of(const CellCounts& counts) const noexcept {
  if (parameters_.intensity == RiskIntensity::gamma) {
    return gamma_intensity(counts, parameters_.prior_per_m2, parameters_.prior_weight);
  }
  return counts.hits + counts.misses > 0.0 ? lambda_intensity(counts) : parameters_.prior_per_m2;
}

CellCounts RiskField::counts_at(Point at, double time_s) const noexcept {
  if (is_far(at, 0.0)) {
    return {0.0, 0.0, parameters_.error_m2};
  }
  return counts_of(index_of(at.x_m, parameters_.cell_m),
                   index_of(at.y_m, parameters_.cell_m),
                   halvings_at(time_s));
}

double RiskField::intensity_at(Point at, double time_s) const noexcept {
  return intensity_of(counts_at(at, time_s));
}

double RiskField::integral_along(Point from,
                                 Point unit_direction,
                                 double length_m,
                                 double time_s) const noexcept {
  if (is_far(from, length_m)) {
    return intensity_of({0.0, 0.0, parameters_.error_m2}) * length_m;
  }
  const double halvings = halvings_at(time_s);
  double integral = 0.0;
  visit_cells(from,
              unit_direction,
              length_m,
              parameters_.cell_m,
              [&](const CellsBeside& at, double part_m) noexcept {
                if (part_m > 0.0) {
                  const double here = intensity_of(counts_of(at.column, at.row, halvings));
                  const double beside =
                      at.two ? intensity_of(counts_of(at.beside_column, at.beside_row, halvings))
                             : here;
                  integral += part_m * (0.5 * (here + beside));
                }
              });
  return integral;
}

double RiskField::collision_probability(Point from,
                                        Point unit_direction,
                                        double length_m,
                                        double width_m,
                                        double time_s) const noexcept {
  const int lines = std::max(1, static_cast<int>(std::ceil(width_m / parameters_.cell_m)));
  const double apart_m = width_m / lines;
  const Point left{-unit_direction.y_m, unit_direction.x_m};
  double integral = 0.0;
  for (int line = 0; line < lines; ++line) {
    const double off_m = (line + 0.5) * apart_m - 0.5 * width_m;
    integral += apart_m * integral_along(from + off_m * left, unit_direction, length_m, time_s);
  }
  return 1.0 - elementary::exp(-integral);
}

}  // namespace tcert
