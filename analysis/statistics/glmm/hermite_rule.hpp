#pragma once
/// \file
/// Gauss-Hermite quadrature for expectations under the standard normal density.

#include <vector>

namespace tcert::statistics {

/// E f(Z) = sum of weight * f(node), exact for polynomials of a degree below twice the points.
struct HermiteRule {
  std::vector<double> nodes;    ///< Ascending, symmetric about 0.
  std::vector<double> weights;  ///< They add up to 1.
  std::vector<double> log_weights;
};

/// Nodes are eigenvalues of the Jacobi matrix (Golub and Welsch, 1969), polished by Newton's
/// method. \throws std::invalid_argument unless 1 <= points <= 200. O(points^3).
[[nodiscard]] HermiteRule hermite_rule(int points);

}  // namespace tcert::statistics
