#pragma once
/// \file
/// Profile-likelihood intervals of a mixed model.

#include <cstddef>
#include <functional>
#include <optional>
#include <statistics/basics/interval.hpp>
#include <statistics/glmm/glmm.hpp>
#include <vector>

namespace tcert::statistics {

struct GlmmProfile {
  std::vector<std::optional<Interval>> coefficients;  ///< One a column of the fixed part.
  /// The standard deviation of each random term of one column; empty for those of several.
  std::vector<std::optional<Interval>> sds;
};

/// Who waits: `started(ends)` is called once, `advance()` after each end, by one thread at a time.
struct GlmmProfileWatch {
  std::function<void(std::size_t)> started{};
  std::function<void()> advance{};
};

/// Values at which twice the drop of the log-likelihood, maximised over all other parameters, is
/// the chi-squared quantile of `options.level`: the roots themselves, each with its model refitted,
/// where `confint(method = "profile")` interpolates. A standard deviation's lower end is 0 if the
/// likelihood there is not low enough. Empty without an estimate and where a root is not found.
/// \throws std::invalid_argument as `fit_glmm`. About 5 refits per parameter and end, in parallel.
[[nodiscard]] GlmmProfile glmm_profile(const GlmmInput& input,
                                       const GlmmOptions& options = {},
                                       const GlmmProfileWatch& watch = {});

}  // namespace tcert::statistics
