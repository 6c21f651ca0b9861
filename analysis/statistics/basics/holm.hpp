#pragma once
/// \file
/// Holm's correction for several tests. Checked against R's `p.adjust(method = "holm")`.

#include <optional>
#include <span>
#include <vector>

namespace tcert::statistics {

/// Adjusted p-values in the order given: the family-wise error of rejecting where they are at most
/// alpha is at most alpha (Holm 1979). Tests without a p-value stay so and, as in R, do not count
/// towards the family. \throws std::invalid_argument if a p-value is not in [0, 1]. O(n log n).
[[nodiscard]] std::vector<std::optional<double>> holm(std::span<const std::optional<double>> p);

}  // namespace tcert::statistics
