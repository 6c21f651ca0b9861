#pragma once
/// \file
/// The Fine-Gray model of a subdistribution hazard as a weighted Cox model (Fine and Gray 1999,
/// Geskus 2011). Checked against `survival::finegray` with `coxph`.

#include <cstddef>
#include <statistics/cox/cox.hpp>
#include <statistics/survival/cumulative_incidence.hpp>

namespace tcert::statistics {

/// Rows that the weighted data may have.
inline constexpr std::size_t kMostFineGrayRows = 20'000'000;

/// The rows of `data` with the outcome that `outcome.causes[cause]` has where the others compete: a
/// row that has had another event stays at risk, weighted by the chance G(t-) / G(T-) that it would
/// not have been censored since, G the Kaplan-Meier curve of being censored in its stratum, where
/// events come before censoring at the same time. Rows of one row are a cluster, unless `data` has
/// clusters. The outcome of `data` is not read. \throws std::invalid_argument if rows differ, enter
/// late or have weights, there is no such cause, or the rows would be more than kMostFineGrayRows.
[[nodiscard]] CoxData fine_gray_data(const CoxData& data,
                                     const CompetingOutcome& outcome,
                                     std::size_t cause);

/// The same with the other causes censored: the model of the hazard of this cause.
[[nodiscard]] CoxData cause_specific_data(const CoxData& data,
                                          const CompetingOutcome& outcome,
                                          std::size_t cause);

}  // namespace tcert::statistics
