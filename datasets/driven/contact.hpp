#pragma once
/// \file
/// What walls leave of a round body's velocity.

#include <span>
#include <tcert/geometry.hpp>

namespace tcert {

/// A wall that the body may reach in one step.
struct Contact {
  Point normal;        ///< Unit vector from the wall's nearest point to the body's middle.
  double gap_m = 0.0;  ///< Between wall and body; >= 0.
};

/// The vector nearest to `wanted`, in m/s, among the v that close no gap faster than at
/// `closing_hz`: normal . v >= -closing_hz gap for every contact. With the inverse of a step it is
/// the velocity that takes the body at most up to its walls; with 0 all walls touch already.
///
/// The set is convex and holds 0, so there is one nearest vector: `wanted` itself, its projection
/// onto one wall, or the corner of two. Each wall is convex, so a body that keeps to the half plane
/// of its nearest point never enters it. Where rounding leaves none of them the body is held: 0.
/// Of two at the same distance the one of the earlier contacts counts, so that contacts mirrored
/// in the same order give the mirrored vector, bit for bit. O(contacts^3).
[[nodiscard]] Point nearest_allowed(Point wanted,
                                    std::span<const Contact> contacts,
                                    double closing_hz) noexcept;

}  // namespace tcert
