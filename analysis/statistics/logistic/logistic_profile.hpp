#pragma once
/// \file
/// Profile-likelihood limits of logistic coefficients.

#include <functional>
#include <optional>
#include <statistics/basics/interval.hpp>
#include <statistics/logistic/logistic.hpp>
#include <vector>

namespace tcert::statistics {

/// The values of a coefficient at which twice the drop of the log-likelihood, maximised over the
/// other coefficients, is the chi-squared quantile of the level.
struct ProfileLimits {
  std::optional<double> low;  ///< Empty if it is open or was not found.
  std::optional<double> high;
  bool open_low = false;  ///< There is none: the likelihood never falls far enough below.
  bool open_high = false;
};

/// Per column of `input`: the roots themselves, to 1e-10 of the quantile's, where
/// `MASS:::confint.glm` interpolates. Under separation too: a coefficient that stays finite has the
/// limits of the rows that overlap, one that runs to infinity its one finite limit, the other being
/// open, and one that diverges in an open direction none. A coefficient that has run away has the
/// limit on the side of 0, the other counts as open. Nothing for columns that are not estimable and
/// without convergence. `advance` is called after each column. \throws std::invalid_argument as
/// `fit_logistic`. About 8 fits per coefficient and end: see `profile_work`.
[[nodiscard]] std::vector<ProfileLimits> profile_limits(const LogisticInput& input,
                                                        const LogisticOptions& options = {},
                                                        const std::function<void()>& advance = {});

/// Those that have both ends.
[[nodiscard]] std::vector<std::optional<Interval>> profile_intervals(
    const LogisticInput& input, const LogisticOptions& options = {});

/// About what all profile limits cost, in products of rows and squared columns of one fit's
/// iteration, times columns: rows * p (p^2 + 40), the 40 for a row's exponential.
[[nodiscard]] double profile_work(const LogisticInput& input);

/// Profiles that nobody asked for are made up to this much work: a second or two.
inline constexpr double kMostProfileWork = 1e9;

}  // namespace tcert::statistics
