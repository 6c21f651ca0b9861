#pragma once
/// \file
/// The path that was driven, without its loops.

#include <cstddef>
#include <limits>
#include <map>
#include <tcert/region.hpp>
#include <utility>
#include <vector>
#include <witness/samples.hpp>

namespace tcert::witness {

/// The positions of a run, 5 cm apart, and the ways between them: from each to the one driven
/// before or after it, and to those within 8 cm.
class DrivenPositions {
 public:
  explicit DrivenPositions(const Samples& samples);

  /// The shortest way from S to G, at most `most_m` long; empty if there is none.
  /// O(n + k log k), n positions, of which k lie nearer than G.
  [[nodiscard]] std::vector<Point> route(
      const Region& start,
      const Region& goal,
      double most_m = std::numeric_limits<double>::infinity()) const;

 private:
  using Bin = std::pair<double, double>;
  static Bin bin_of(Point p) noexcept;
  /// visit(position, way to it in m)
  template <class Visit>
  void for_each_step(std::size_t i, Visit visit) const;

  std::vector<Point> points_;
  std::vector<bool> broken_;  // the path broke before the position
  std::map<Bin, std::vector<std::size_t>> bins_;
};

}  // namespace tcert::witness
