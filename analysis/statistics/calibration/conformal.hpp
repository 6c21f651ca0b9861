#pragma once
/// \file
/// Split conformal prediction: a bound of the score of a new unit from the scores of others, with
/// no assumption but that they are exchangeable (Vovk, Gammerman and Shafer 2005; Lei et al. 2018).
/// What the scores are of must have been settled without these units.

#include <cstddef>
#include <optional>
#include <span>

namespace tcert::statistics {

/// The rank k of the score that bounds a new one: n + 1 - l, l = floor((n + 1) alpha), which is
/// ceil((n + 1)(1 - alpha)). Empty if l is 0: so few units bound nothing at this level. Alpha
/// counts as the decimal that it is written as. \throws std::invalid_argument if alpha is not in
/// (0, 1).
[[nodiscard]] std::optional<std::size_t> conformal_rank(std::size_t units, double alpha);

/// The least units with which that level can be promised: 19 for 0.05. Errors as above.
[[nodiscard]] std::size_t least_conformal_units(double alpha);

/// The smallest alpha that so many units can promise: 1 / (units + 1).
[[nodiscard]] double least_conformal_alpha(std::size_t units) noexcept;

/// The k-th smallest score: a new one, exchangeable with these, is at most this with probability
/// k / (n + 1) >= 1 - alpha, or more where scores tie. Empty where there is no rank. O(n).
/// \throws std::invalid_argument if alpha is not in (0, 1) or a score is NaN.
[[nodiscard]] std::optional<double> conformal_quantile(std::span<const double> scores,
                                                       double alpha);

/// What the coverage is, given the units that there are, has the law Beta(k, n + 1 - k) if scores
/// do not tie: its `p` quantile. \pre 0 < rank <= units; \throws std::invalid_argument unless p is
/// in (0, 1).
[[nodiscard]] double conformal_coverage_quantile(std::size_t units, std::size_t rank, double p);

}  // namespace tcert::statistics
