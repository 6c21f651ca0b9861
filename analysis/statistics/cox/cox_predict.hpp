#pragma once
/// \file
/// Risks by given times of rows that a Cox model has not seen.

#include <Eigen/Core>
#include <span>
#include <statistics/cox/cox.hpp>

namespace tcert::statistics {

/// 1 - S(t | x), rows of `others` x times: other rows of the same columns, strata by their levels.
/// NaN in a stratum that the fit has no rows of. \pre `fit` is the fit to `data`, with inference,
/// without an error. \throws std::invalid_argument if the columns differ.
[[nodiscard]] Eigen::MatrixXd cox_risks(const CoxData& data,
                                        const CoxFit& fit,
                                        const CoxData& others,
                                        std::span<const double> times);

}  // namespace tcert::statistics
