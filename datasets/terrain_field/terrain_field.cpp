#include "datasets/terrain_field/terrain_field.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <table/random.hpp>
#include <tcert/elementary.hpp>
#include <terrain/lipschitz.hpp>

namespace tcert {
namespace {

constexpr int kWaves = 256;
constexpr std::uint32_t kPurpose = 0x7e44a1;  // of the random stream

/// cos and sin of frequency k + phase on 0..count-1.
struct Wave {
  std::vector<double> cosine;
  std::vector<double> sine;

  Wave(int count, double frequency, double phase) {
    for (int i = 0; i < count; ++i) {
      cosine.push_back(elementary::cos(frequency * i + phase));
      sine.push_back(elementary::sin(frequency * i + phase));
    }
  }
};

/// What a wave's numbers are divided by, beside the length scale.
[[nodiscard]] double spread(FieldKind kind, table::RandomStream& random) {
  const int freedom = kind == FieldKind::matern52 ? 5 : kind == FieldKind::matern32 ? 3 : 0;
  double squares = 0.0;
  for (int k = 0; k < freedom; ++k) {
    const double z = random.normal();
    squares += z * z;
  }
  return freedom > 0 ? std::sqrt(squares / freedom) : 1.0;
}

}  // namespace

TerrainGrid random_terrain(const TerrainFieldOptions& o) {
  if (o.rows < 2 || o.columns < 2) {
    throw std::invalid_argument("a terrain needs at least 2 x 2 cells");
  }
  if (!(o.length_scale > 0.0) || !(o.lipschitz > 0.0)) {
    throw std::invalid_argument("the length scale and the Lipschitz constant must be > 0");
  }
  TerrainGrid terrain{o.rows, o.columns, {}, {}};
  const auto rows = static_cast<std::size_t>(o.rows);
  const auto columns = static_cast<std::size_t>(o.columns);
  terrain.values.assign(rows * columns, 0.0);
  table::RandomStream random(o.seed, kPurpose, o.number);
  for (int k = 0; k < kWaves; ++k) {
    const double scale = o.length_scale * spread(o.kind, random);
    const double along_x = random.normal() / scale;
    const double along_y = random.normal() / scale;
    const Wave down(o.rows, along_x, random.uniform(0.0, 2.0 * std::numbers::pi));
    const Wave across(o.columns, along_y, 0.0);
    for (std::size_t x = 0; x < rows; ++x) {
      double* row = &terrain.values[x * columns];
      const double c = down.cosine[x];
      const double s = down.sine[x];
      for (std::size_t y = 0; y < columns; ++y) {
        row[y] += c * across.cosine[y] - s * across.sine[y];
      }
    }
  }
  const double steepest = terrain::lipschitz_bound({o.rows, o.columns}, terrain.values);
  const double factor = steepest > 0.0 ? o.lipschitz / steepest : 0.0;
  for (double& value : terrain.values) {
    value = o.mean + factor * value;
  }
  return terrain;
}

}  // namespace tcert
