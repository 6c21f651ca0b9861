#pragma once
/// \file
/// A path of straight pieces and arcs.

#include <cmath>
#include <tcert/elementary.hpp>
#include <tcert/geometry.hpp>
#include <vector>

namespace tcert::witness {

/// From one point to another, turning by `turn_rad` to the left on the way at the same radius all
/// along; 0 is straight. |turn_rad| < pi.
struct Piece {
  Point from;
  Point to;
  double turn_rad = 0.0;
  friend bool operator==(const Piece&, const Piece&) = default;
};

/// Pieces that follow each other: each begins where the one before ends.
using Path = std::vector<Piece>;

[[nodiscard]] inline double chord(const Piece& piece) noexcept {
  return distance(piece.from, piece.to);
}

/// chord / (2 sin(|turn| / 2)); infinity if it is straight.
[[nodiscard]] inline double radius(const Piece& piece) noexcept {
  return 0.5 * chord(piece) / elementary::sin(0.5 * std::abs(piece.turn_rad));
}

/// Heading in rad at its begin, and at its end.
[[nodiscard]] inline double heading_from(const Piece& piece) noexcept {
  const Point way = piece.to - piece.from;
  return elementary::atan2(way.y_m, way.x_m) - 0.5 * piece.turn_rad;
}
[[nodiscard]] inline double heading_to(const Piece& piece) noexcept {
  return heading_from(piece) + piece.turn_rad;
}

/// The place at `share` of the piece's length, from 0 to 1.
[[nodiscard]] inline Point point_at(const Piece& piece, double share) noexcept {
  const double turn = std::abs(piece.turn_rad);
  const double part =
      turn > 0.0 ? elementary::sin(0.5 * share * turn) / elementary::sin(0.5 * turn) : share;
  return piece.from +
         chord(piece) * part * direction(heading_from(piece) + 0.5 * share * piece.turn_rad);
}

}  // namespace tcert::witness
