#pragma once
/// \file
/// How few clusters, and how few outcomes of a class, are few.

#include <cstddef>

namespace tcert {

/// With fewer, cluster-robust numbers are too sure of themselves: it is said.
inline constexpr std::size_t kFewClusters = 30;

/// With fewer, no interval and no test that is here is near its nominal level: `fit` warns, and
/// `hypotheses` withholds them.
inline constexpr std::size_t kTooFewClusters = 10;

/// The same of outcomes of the rarer class.
inline constexpr std::size_t kTooFewOutcomes = 10;

}  // namespace tcert
