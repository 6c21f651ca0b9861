#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tcert/barrier_filter.hpp>

namespace tcert {
namespace {

/// A row may be missed by this much of the size of its terms: what rounding leaves of a point that
/// was computed to lie on it.
constexpr double kRounding = 1e-12;

constexpr std::size_t kMostRows = kMostBarrierRows + 4;

/// A command in the units of the box, where distance is what W says.
struct Scaled {
  double x = 0.0;
  double y = 0.0;
};

/// a x + b y >= c.
struct Row {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;
};

class Search {
 public:
  Search(Scaled wanted, std::span<const Row> rows) noexcept : wanted_(wanted), rows_(rows) {}

  void look_at(Scaled u) noexcept {
    const double dx = u.x - wanted_.x;
    const double dy = u.y - wanted_.y;
    const double cost = dx * dx + dy * dy;
    if (cost < best_cost_ && keeps_all(u)) {
      best_cost_ = cost;
      best_ = u;
    }
  }
  [[nodiscard]] bool found() const noexcept { return best_cost_ < kNone; }
  [[nodiscard]] Scaled best() const noexcept { return best_; }

 private:
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool keeps_all(Scaled u) const noexcept {
    return std::ranges::all_of(rows_, [&](const Row& row) noexcept {
      const double size = std::abs(row.a * u.x) + std::abs(row.b * u.y) + std::abs(row.c);
      return row.a * u.x + row.b * u.y - row.c >= -kRounding * size;
    });
  }

  Scaled wanted_;
  std::span<const Row> rows_;
  double best_cost_ = kNone;
  Scaled best_;
};

}  // namespace

FilteredCommand nearest_command(const Command& wanted,
                                std::span<const BarrierRow> rows,
                                const CommandBox& box) noexcept {
  const double v = box.speed_unit_mps;
  const double w = box.yaw_unit_rps;
  std::array<Row, kMostRows> all{};
  std::size_t count = std::min(rows.size(), kMostBarrierRows);
  for (std::size_t i = 0; i < count; ++i) {
    all[i] = {rows[i].speed * v, rows[i].yaw_rate * w, rows[i].least};
  }
  all[count++] = {1.0, 0.0, box.min_speed_mps / v};
  all[count++] = {-1.0, 0.0, -box.max_speed_mps / v};
  all[count++] = {0.0, 1.0, -box.max_yaw_rate_rps / w};
  all[count++] = {0.0, -1.0, -box.max_yaw_rate_rps / w};
  const std::span<const Row> kept(all.data(), count);

  const Scaled aim{wanted.speed_mps / v, wanted.yaw_rate_rps / w};
  Search search(aim, kept);
  search.look_at(aim);
  if (search.found()) {
    return {wanted, true};
  }
  for (const Row& row : kept) {
    const double square = row.a * row.a + row.b * row.b;
    if (square > 0.0) {
      const double by = (row.c - row.a * aim.x - row.b * aim.y) / square;
      search.look_at({aim.x + by * row.a, aim.y + by * row.b});
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const double determinant = kept[i].a * kept[j].b - kept[j].a * kept[i].b;
      if (determinant != 0.0) {
        search.look_at({(kept[i].c * kept[j].b - kept[j].c * kept[i].b) / determinant,
                        (kept[i].a * kept[j].c - kept[j].a * kept[i].c) / determinant});
      }
    }
  }
  if (!search.found()) {
    return {{}, false};
  }
  // What rounding leaves beyond the box is taken off; adding 0 turns -0 into 0.
  return {{std::clamp(search.best().x * v, box.min_speed_mps, box.max_speed_mps) + 0.0,
           std::clamp(search.best().y * w, -box.max_yaw_rate_rps, box.max_yaw_rate_rps) + 0.0},
          true};
}

}  // namespace tcert
