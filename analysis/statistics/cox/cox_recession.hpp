#pragma once
/// \file
/// Whether a partial likelihood has a maximum, decided by a certificate and not by how far a fit
/// has run.

#include <Eigen/Core>
#include <optional>
#include <statistics/cox/cox_rows.hpp>

namespace tcert::statistics {

/// A direction d of the scaled columns, within the span of `basis` (p x k), along which the partial
/// likelihood never falls and somewhere rises; empty if there is none, so that the maximum is
/// finite within that span.
///
/// Method: d never lowers the likelihood if (x_i - x_j) d >= 0 for every row i with an event and
/// every row j at risk then (with exact ties: without an event then). The score at 0 is a positive
/// combination of all x_i - x_j, so its projection onto the cone of these d is 0 if and only if no
/// d has a positive margin. The pairs are far too many to list: those that the present projection
/// violates most are added until none is left. Margins below 1e-9 of a pair's distance are ties.
/// \param score basis' times the score at 0. About O(m (p + log m)) a round, few rounds.
[[nodiscard]] std::optional<Eigen::VectorXd> recession_direction(const CoxRows& rows,
                                                                 Ties ties,
                                                                 const Eigen::MatrixXd& basis,
                                                                 const Eigen::VectorXd& score);

}  // namespace tcert::statistics
