#pragma once
/// \file
/// The robust (sandwich) variance of a Cox model, with clusters or without (Lin and Wei 1989).

#include <Eigen/Core>
#include <statistics/cox/cox_rows.hpp>

namespace tcert::statistics {

/// Sums of weighted score residuals within clusters.
struct ClusterScores {
  Eigen::MatrixXd products;  ///< p x p: the sum over clusters of their sum times its transpose.
  Eigen::VectorXd total;     ///< p.
  Eigen::MatrixXd sums;      ///< p x levels of the cluster; without columns if it is null.
};

/// At `beta`, in scaled columns; a row is its own cluster if `cluster` is null. O(m p^2): the
/// residuals come from cumulative sums over event times.
[[nodiscard]] ClusterScores cluster_scores(const CoxRows& rows,
                                           const Eigen::VectorXd& beta,
                                           Ties ties,
                                           const table::Factor* cluster);

}  // namespace tcert::statistics
