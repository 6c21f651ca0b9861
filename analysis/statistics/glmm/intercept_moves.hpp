#pragma once
/// \file
/// Derivatives of a group's log-likelihood, from the sums at its mode and nodes. Internal to
/// intercept_likelihood.cpp.

#include <statistics/glmm/intercept_mode.hpp>

namespace tcert::statistics {

/// How the group's log-likelihood moves with u0 and with log h, for first and second derivatives.
/// P1 is the mean of f_u over the nodes, P2 that of f_u z.
struct InterceptMoves {
  double by_s = 0.0;        ///< s P2.
  double whole = 1.0;       ///< 1 + s P2.
  double h_u = 0.0;         ///< How h moves with u.
  double along_mode = 0.0;  ///< (P1 - whole h_u / (2 h)) / h: the factor of derivatives of f_u.
  double along_h = 0.0;     ///< -whole / (2 h): that of derivatives of h.
};

[[nodiscard]] InterceptMoves moves_of(double theta,
                                      const HermiteRule& rule,
                                      const InterceptMode& mode,
                                      const InterceptScratch& scratch);

/// A slope a row, and the gradient by theta.
void add_slopes(const InterceptGroup& group,
                double theta,
                const InterceptMode& mode,
                const InterceptMoves& moves,
                const InterceptScratch& scratch,
                double* slope,
                InterceptSum& sum);

/// A curvature a row, and the rest of the Hessian.
void add_curvatures(const InterceptGroup& group,
                    double theta,
                    const HermiteRule& rule,
                    const InterceptMode& mode,
                    const InterceptMoves& moves,
                    InterceptScratch& scratch,
                    double* curvature,
                    Eigen::MatrixXd& hessian);

}  // namespace tcert::statistics
