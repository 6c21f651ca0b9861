#pragma once
/// \file
/// Which terms of a model may be left out alone.

#include <cstddef>
#include <string>
#include <vector>

namespace tcert::statistics {

/// Indices of the terms that no other term contains: of a, b and a:b only a:b.
[[nodiscard]] std::vector<std::size_t> droppable_terms(const std::vector<std::string>& terms);

}  // namespace tcert::statistics
