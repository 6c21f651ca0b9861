#include <statistics/glmm/hermite_rule.hpp>

#include <cmath>
#include <cstddef>
#include <statistics/basics/linalg.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

/// The orthonormal polynomials of degrees 0 to n at x.
struct Hermite {
  double last = 1.0;     ///< Of degree n.
  double before = 0.0;   ///< Of degree n - 1.
  double squares = 0.0;  ///< Sum of squares below degree n.
};

Hermite hermite(int n, double x) {
  Hermite h;
  for (int j = 0; j < n; ++j) {
    h.squares += h.last * h.last;
    const double next = (x * h.last - std::sqrt(static_cast<double>(j)) * h.before) /
                        std::sqrt(static_cast<double>(j + 1));
    h.before = h.last;
    h.last = next;
  }
  return h;
}

double polished(int n, double x) {
  for (int step = 0; step < 3; ++step) {
    const Hermite h = hermite(n, x);
    x -= h.last / (std::sqrt(static_cast<double>(n)) * h.before);
  }
  return x;
}

}  // namespace

HermiteRule hermite_rule(int points) {
  if (points < 1 || points > 200) {
    throw std::invalid_argument("hermite_rule: points must be in [1, 200]");
  }
  Eigen::VectorXd beside(points - 1);
  for (int j = 1; j < points; ++j) {
    beside[j - 1] = std::sqrt(static_cast<double>(j));
  }
  const Eigen::VectorXd roots = eigenvalues_of_tridiagonal(Eigen::VectorXd::Zero(points), beside);
  HermiteRule rule;
  const auto size = static_cast<std::size_t>(points);
  rule.nodes.assign(size, 0.0);
  for (std::size_t k = size / 2 + size % 2; k < size; ++k) {
    const double node = polished(points, roots[static_cast<Eigen::Index>(k)]);
    rule.nodes[k] = node;
    rule.nodes[size - 1 - k] = -node;
  }
  for (const double node : rule.nodes) {
    const double squares = hermite(points, node).squares;
    rule.weights.push_back(1.0 / squares);
    rule.log_weights.push_back(-std::log(squares));
  }
  return rule;
}

}  // namespace tcert::statistics
