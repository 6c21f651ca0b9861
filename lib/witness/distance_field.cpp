#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <witness/distance_field.hpp>

namespace tcert::witness {
namespace {

/// Of each vertex, how many steps up or down its column the next vertex is that touches a cell that
/// is not free.
std::vector<std::int32_t> steps_in_columns(const FreeCells& cells, int columns, int rows) {
  const auto width = static_cast<std::size_t>(columns);
  std::vector<std::int32_t> steps(width * static_cast<std::size_t>(rows), 0);
  for (int iy = 1; iy + 1 < rows; ++iy) {
    const auto above = cells.row(iy);
    const auto below = cells.row(iy - 1);
    const auto place = static_cast<std::size_t>(iy) * width;
    for (std::size_t w = 0; w < above.size(); ++w) {
      const std::uint64_t right = above[w] & below[w];  // of a vertex, both cells to the right
      const std::uint64_t carried = w > 0 ? (above[w - 1] & below[w - 1]) >> 63U : 0U;
      for (std::uint64_t bits = right & (right << 1U | carried); bits != 0; bits &= bits - 1) {
        const std::size_t i = place + 64 * w + static_cast<std::size_t>(std::countr_zero(bits));
        steps[i] = steps[i - width] + 1;
      }
    }
  }
  for (std::size_t i = steps.size() - width; i-- > 0;) {
    steps[i] = std::min(steps[i], steps[i + width] + 1);
  }
  return steps;
}

/// Where the parabola of column `right` comes below that of `left`, rounded down.
std::int64_t meeting(std::int64_t left,
                     std::int64_t right,
                     std::int64_t left_steps,
                     std::int64_t right_steps) {
  const std::int64_t numerator =
      right * right - left * left + right_steps * right_steps - left_steps * left_steps;
  const std::int64_t denominator = 2 * (right - left);
  return numerator >= 0 ? numerator / denominator : -((-numerator + denominator - 1) / denominator);
}

/// The lower envelope of the parabolas of a row: the columns that own it, and where each begins.
struct Envelope {
  std::vector<std::int64_t> owner;
  std::vector<std::int64_t> from;
};

/// Fills in the distances between two vertices of a row that touch what is not free.
void fill_between(std::int64_t begin,
                  std::int64_t end,
                  const std::int32_t* steps,
                  double cell_m,
                  Envelope& envelope,
                  float* distances_m) {
  auto& [owner, from] = envelope;
  const auto squared = [steps](std::int64_t at, std::int64_t of) {
    return (at - of) * (at - of) + static_cast<std::int64_t>(steps[of]) * steps[of];
  };
  std::size_t count = 1;
  owner[0] = from[0] = begin;
  for (std::int64_t ix = begin + 1; ix <= end; ++ix) {
    while (count > 0 && squared(from[count - 1], owner[count - 1]) > squared(from[count - 1], ix)) {
      --count;
    }
    const std::int64_t first =
        count == 0 ? begin : 1 + meeting(owner[count - 1], ix, steps[owner[count - 1]], steps[ix]);
    if (first <= end) {
      owner[count] = ix;
      from[count] = first;
      ++count;
    }
  }
  for (std::int64_t ix = end - 1; ix > begin; --ix) {
    while (from[count - 1] > ix) {
      --count;
    }
    distances_m[ix] =
        static_cast<float>(cell_m * std::sqrt(static_cast<double>(squared(ix, owner[count - 1]))));
  }
}

}  // namespace

DistanceField::DistanceField(const FreeCells& cells)
    : lattice_(cells.lattice()),
      columns_(lattice_.columns + 1),
      rows_(lattice_.rows + 1),
      distance_m_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
  const std::vector<std::int32_t> steps = steps_in_columns(cells, columns_, rows_);
  const auto width = static_cast<std::size_t>(columns_);
  Envelope envelope{std::vector<std::int64_t>(width), std::vector<std::int64_t>(width)};
  for (int iy = 0; iy < rows_; ++iy) {
    const std::int32_t* const row = &steps[static_cast<std::size_t>(iy) * width];
    float* const distances_m = &distance_m_[static_cast<std::size_t>(iy) * width];
    // Between two vertices that touch what is not free nothing beyond them is nearer.
    std::int64_t left = 0;
    for (std::int64_t right = 1; right < columns_; ++right) {
      if (row[right] != 0) {
        continue;
      }
      const std::int64_t begin = std::exchange(left, right);
      if (right > begin + 1) {
        fill_between(begin, right, row, lattice_.cell_m, envelope, distances_m);
      }
    }
  }
}

double DistanceField::at(Point p) const noexcept {
  const double x = p.x_m / lattice_.cell_m - static_cast<double>(lattice_.first_x);
  const double y = p.y_m / lattice_.cell_m - static_cast<double>(lattice_.first_y);
  if (!(x >= 0.0 && y >= 0.0 && x < columns_ - 1 && y < rows_ - 1)) {
    return 0.0;
  }
  const int ix = static_cast<int>(x);
  const int iy = static_cast<int>(y);
  const double a = x - ix;
  const double b = y - iy;
  return (1.0 - b) * ((1.0 - a) * at_vertex(ix, iy) + a * at_vertex(ix + 1, iy)) +
         b * ((1.0 - a) * at_vertex(ix, iy + 1) + a * at_vertex(ix + 1, iy + 1));
}

Point DistanceField::gradient(Point p, double step_m) const noexcept {
  const Point x{step_m, 0.0};
  const Point y{0.0, step_m};
  return {(at(p + x) - at(p - x)) / (2.0 * step_m), (at(p + y) - at(p - y)) / (2.0 * step_m)};
}

}  // namespace tcert::witness
