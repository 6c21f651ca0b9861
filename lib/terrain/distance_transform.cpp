#include <algorithm>
#include <terrain/distance_transform.hpp>

namespace tcert::terrain {
namespace {

/// Largest integer not above a / b. \pre b > 0
[[nodiscard]] std::int64_t floor_divide(std::int64_t a, std::int64_t b) noexcept {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

/// Lower envelope of the parabolas (y - i)^2 + g[i]^2, where g[i] is finite.
class Envelope {
 public:
  explicit Envelope(std::size_t width) : apex_(width), start_(width) {}

  void transform(const std::int64_t* gap, std::int64_t no_gap, int width, std::int64_t* out) {
    int top = -1;
    for (int i = 0; i < width; ++i) {
      if (gap[i] >= no_gap) {
        continue;
      }
      std::int64_t from = 0;
      while (top >= 0) {
        const int below = apex_[static_cast<std::size_t>(top)];
        // First y at which i is nearer than the apex below.
        const std::int64_t num = std::int64_t{i} * i - std::int64_t{below} * below +
                                 gap[i] * gap[i] - gap[below] * gap[below];
        from = floor_divide(num, 2 * (std::int64_t{i} - below)) + 1;
        if (from > start_[static_cast<std::size_t>(top)]) {
          break;
        }
        --top;
        from = 0;
      }
      if (from < width) {
        ++top;
        apex_[static_cast<std::size_t>(top)] = i;
        start_[static_cast<std::size_t>(top)] = std::max<std::int64_t>(from, 0);
      }
    }
    if (top < 0) {
      std::fill(out, out + width, kNoCell);
      return;
    }
    for (int y = width - 1; y >= 0; --y) {
      while (start_[static_cast<std::size_t>(top)] > y) {
        --top;
      }
      const int i = apex_[static_cast<std::size_t>(top)];
      out[y] = (std::int64_t{y} - i) * (std::int64_t{y} - i) + gap[i] * gap[i];
    }
  }

 private:
  std::vector<int> apex_;
  std::vector<std::int64_t> start_;
};

std::vector<std::int64_t> transform(const Grid& grid, const CellSet& set, std::uint8_t wanted) {
  const auto width = static_cast<std::size_t>(grid.columns);
  const std::int64_t no_gap = std::int64_t{grid.rows} + grid.columns;
  // Distance along x to the nearest wanted cell of the same column.
  std::vector<std::int64_t> gap(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const std::int64_t above = i < width ? no_gap : std::min(no_gap, gap[i - width] + 1);
    gap[i] = set[i] == wanted ? 0 : above;
  }
  for (std::size_t i = grid.size(); i-- > 0;) {
    if (i + width < grid.size()) {
      gap[i] = std::min(gap[i], gap[i + width] + 1);
    }
  }
  std::vector<std::int64_t> result(grid.size());
  Envelope envelope(width);
  for (int x = 0; x < grid.rows; ++x) {
    const std::size_t row = grid.index({x, 0});
    envelope.transform(&gap[row], no_gap, grid.columns, &result[row]);
  }
  return result;
}

}  // namespace

std::vector<std::int64_t> squared_distance_transform(const Grid& grid, const CellSet& set) {
  return transform(grid, set, 1);
}

std::vector<std::int64_t> squared_depth(const Grid& grid, const CellSet& set) {
  return transform(grid, set, 0);
}

}  // namespace tcert::terrain
