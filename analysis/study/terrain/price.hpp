#pragma once
/// \file
/// The price of not knowing the Lipschitz constant: random terrains of several kinds, explored by
/// rules that are told it, that bound it, and that need none.

#include <cstddef>
#include <cstdint>
#include <string>
#include <table/row_text.hpp>
#include <terrain/rules.hpp>
#include <vector>

namespace tcert::terrain::study {

/// A kind of ground, and what is told of it that is wrong.
struct GroundKind {
  std::string name;
  enum class Field { gaussian, matern52, matern32, craters } field = Field::gaussian;
  double told_length = 1.0;  ///< Times the true length scale.
  double noise = 0.0;        ///< Of a measurement, in standard deviations of the field.
};

/// How ground is certified.
struct Method {
  std::string name;
  RuleSet rules = RuleSet::certified;
  bool told = true;           ///< `certified`: L is told; else it is bounded.
  double least_length = 0.5;  ///< `band`: times the length scale that is told.
  Selection selection = Selection::horizon;
  bool adaptive = false;  ///< The length scale is chosen on the way.
};

/// Every kind with every method that it is explored by.
struct PriceCell {
  GroundKind ground;
  Method method;
};
[[nodiscard]] std::vector<PriceCell> price_cells();

/// What came of one terrain.
struct PriceOutcome {
  bool unsafe_cells = false;
  bool unsafe_visits = false;
  bool covered = false;    ///< The constant in use was at least the true one at all times.
  bool reachable = false;  ///< Ground at the threshold joins start and goal.
  bool reached = false;
  std::uint64_t samples = 0;
  double travelled = 0.0;
  double first_ratio = 0.0;  ///< Of the constant in use to the true one; 0 under `band`.
  double last_ratio = 0.0;
};

void row_cells(auto& row, table::Is<PriceOutcome> auto& one) {
  row(one.unsafe_cells, one.unsafe_visits, one.covered, one.reachable, one.reached);
  row(one.samples, one.travelled, one.first_ratio, one.last_ratio);
}

/// Terrain number `number` of the kind: 60 x 48 cells of length scale 8 with the threshold at the
/// mean, or 90 x 60 cells of craters with the slope limit; start and goal drawn from safe cells,
/// the start such that all within two cells of it is safe; at most 300 measurements.
[[nodiscard]] PriceOutcome explore_at_price(const PriceCell& cell,
                                            std::uint64_t seed,
                                            std::uint64_t number);

/// What a set of terrains comes to.
struct Prices {
  std::size_t terrains = 0;
  std::size_t unsafe_cells = 0;
  std::size_t unsafe_visits = 0;
  std::size_t covered = 0;
  std::size_t reachable = 0;
  std::size_t reached = 0;
  std::vector<double> samples;  ///< Of those that reached the goal.
  std::vector<double> ways;
  std::vector<double> last_ratios;  ///< Of all.

  void add(const PriceOutcome& one);
};

}  // namespace tcert::terrain::study
