#include <statistics/glmm/intercept_group.hpp>

#include <cmath>
#include <statistics/glmm/intercept_mode.hpp>
#include <statistics/glmm/intercept_moves.hpp>
#include <statistics/glmm/intercept_nodes.hpp>

namespace tcert::statistics {

bool add_intercept_group(const InterceptGroup& group,
                         double theta,
                         const HermiteRule& rule,
                         Derivatives wanted,
                         double& mode_u,
                         InterceptScratch& scratch,
                         double* slope,
                         double* curvature,
                         InterceptSum& sum) {
  if (!find_mode(group, theta, mode_u)) {
    mode_u = 0.0;
    return false;
  }
  const InterceptMode mode = at_mode(group, theta, mode_u, scratch);
  const double value = value_at_nodes(group, theta, rule, mode, scratch);
  if (!std::isfinite(value)) {
    return false;
  }
  sum.value += value;
  if (wanted == Derivatives::none) {
    return true;
  }
  sum_at_nodes(group, wanted == Derivatives::hessian, scratch);
  const InterceptMoves moves = moves_of(theta, rule, mode, scratch);
  add_slopes(group, theta, mode, moves, scratch, slope, sum);
  if (wanted == Derivatives::hessian) {
    add_curvatures(group, theta, rule, mode, moves, scratch, curvature, sum.hessian);
  }
  return true;
}

}  // namespace tcert::statistics
