#pragma once
/// \file
/// What cluster-robust inference needs of a fit, whatever the model.

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace tcert::statistics {

/// G clusters, p coefficients, r of them with an estimate. In coordinates in which the information
/// of all rows is the identity: with the inverse information M = L L', a score u is L' u, and the
/// coefficient c' b has the functional L' c.
struct SandwichParts {
  Eigen::MatrixXd scores;               ///< r x G: of each cluster.
  std::vector<Eigen::MatrixXd> shares;  ///< G of r x r: L' A_g L, A_g the cluster's information;
                                        ///< they add up to the identity.
  Eigen::MatrixXd functionals;          ///< r x p; NaN where a coefficient has no estimate.
  Eigen::VectorXd estimates;            ///< p; NaN likewise.

  [[nodiscard]] std::size_t clusters() const noexcept { return shares.size(); }
};

/// The parts where coefficient `k` is held at `value` and the others are fitted; empty without such
/// a fit.
using PartsAt = std::function<std::optional<SandwichParts>(std::size_t k, double value)>;

/// Numbers in the shares above which they are not made: 400 MB.
inline constexpr double kMostShareNumbers = 5e7;

}  // namespace tcert::statistics
