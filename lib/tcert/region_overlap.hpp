#pragma once
/// \file
/// Whether two regions of a course overlap: between those there is no way to certify.

#include <tcert/region.hpp>

namespace tcert {

/// True if the regions have a point in common, their boundaries included. O(product of vertices).
[[nodiscard]] bool touch(const Region& a, const Region& b) noexcept;

}  // namespace tcert
