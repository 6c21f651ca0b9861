#include <cstddef>
#include <statistics/glmm/intercept_moves.hpp>

namespace tcert::statistics {
namespace {

void fill_mode_derivatives(const InterceptGroup& group,
                           double theta,
                           const InterceptMode& mode,
                           double h_u,
                           InterceptScratch& scratch) {
  const Eigen::Index columns = group.columns;
  for (auto* list : {&scratch.w0_x, &scratch.w1_x, &scratch.w2_x}) {
    list->setZero(columns);
  }
  for (Eigen::Index i = 0; i < group.rows; ++i) {
    const Eigen::Map<const Eigen::VectorXd> x(group.basis + i * columns, columns);
    const auto row = static_cast<std::size_t>(i);
    scratch.w0_x += scratch.w0[row] * x;
    scratch.w1_x += scratch.w1[row] * x;
    scratch.w2_x += scratch.w2[row] * x;
  }
  for (auto* list : {&scratch.mode_by, &scratch.h_by, &scratch.log_s_by, &scratch.h_by_u}) {
    list->resize(columns + 1);
  }
  const RowSums& s = mode.sums;
  const double square = theta * theta;
  scratch.mode_by[0] = (s.residual - theta * mode.u * s.w0) / mode.h;
  scratch.mode_by.tail(columns) = (-theta / mode.h) * scratch.w0_x;
  scratch.h_by[0] = 2.0 * theta * s.w0 + square * mode.u * s.w1;
  scratch.h_by.tail(columns) = square * scratch.w1_x;
  scratch.h_by_u[0] = 3.0 * square * s.w1 + square * theta * mode.u * s.w2;
  scratch.h_by_u.tail(columns) = square * theta * scratch.w2_x;
  scratch.log_s_by = (-0.5 / mode.h) * (scratch.h_by + h_u * scratch.mode_by);
}

/// Adds a b' + b a'.
void add_both(double factor,
              const Eigen::VectorXd& a,
              const Eigen::VectorXd& b,
              Eigen::MatrixXd& to) {
  to.selfadjointView<Eigen::Lower>().rankUpdate(a, b, factor);
}

void add_one(double factor, const Eigen::VectorXd& a, Eigen::MatrixXd& to) {
  to.selfadjointView<Eigen::Lower>().rankUpdate(a, factor);
}

/// The part that passes through the mode and its curvature.
void add_mode_curvature(double theta,
                        const InterceptMode& mode,
                        const InterceptMoves& moves,
                        const InterceptScratch& scratch,
                        Eigen::MatrixXd& hessian) {
  const Eigen::Index columns = scratch.w0_x.size();
  const RowSums& s = mode.sums;
  const double u = mode.u;
  const double square = theta * theta;
  // Second derivatives of f_u and of h at fixed u; the rows' share is in the curvatures.
  hessian(0, 0) += moves.along_mode * (-2.0 * u * s.w0 - theta * u * u * s.w1) +
                   moves.along_h * (2.0 * s.w0 + 4.0 * theta * u * s.w1 + square * u * u * s.w2);
  hessian.col(0).tail(columns) +=
      -moves.along_mode * (scratch.w0_x + theta * u * scratch.w1_x) +
      moves.along_h * (2.0 * theta * scratch.w1_x + square * u * scratch.w2_x);
  add_both(-moves.along_mode, scratch.h_by, scratch.mode_by, hessian);
  add_both(moves.along_h, scratch.h_by_u, scratch.mode_by, hessian);
  add_one(-moves.along_mode * moves.h_u + moves.along_h * square * square * s.w2,
          scratch.mode_by,
          hessian);
  add_one(2.0 * moves.whole + moves.by_s, scratch.log_s_by, hessian);
}

/// The part of the nodes: second derivatives of f there, and the variance of its first ones.
void add_node_curvature(double theta,
                        const HermiteRule& rule,
                        const InterceptMode& mode,
                        InterceptScratch& scratch,
                        Eigen::MatrixXd& hessian) {
  const std::size_t nodes = rule.nodes.size();
  const Eigen::Index columns = scratch.w0_x.size();
  scratch.d.resize(columns + 1);
  for (auto* list : {&scratch.mean_d, &scratch.cross0, &scratch.cross1}) {
    list->setZero(columns + 1);
  }
  double bend0 = 0.0;
  double bend1 = 0.0;
  double bend2 = 0.0;
  using Strided = Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<>>;
  const Eigen::InnerStride<> stride(static_cast<Eigen::Index>(nodes));
  for (std::size_t k = 0; k < nodes; ++k) {
    const double share = scratch.share[k];
    const double t = scratch.t[k];
    const double z = rule.nodes[k] * mode.s;
    const double slope = theta * scratch.residual[k] - t;
    const Strided residual_x(scratch.residual_x.data() + k, columns, stride);
    const Strided weight_x(scratch.weight_x.data() + k, columns, stride);
    scratch.d[0] = t * scratch.residual[k];
    scratch.d.tail(columns) = residual_x;
    scratch.d += slope * (scratch.mode_by + z * scratch.log_s_by);
    scratch.mean_d += share * scratch.d;
    add_one(share, scratch.d, hessian);
    const double by_theta = scratch.residual[k] - theta * t * scratch.weight[k];
    scratch.cross0[0] += share * by_theta;
    scratch.cross1[0] += share * z * by_theta;
    scratch.cross0.tail(columns) -= share * theta * weight_x;
    scratch.cross1.tail(columns) -= share * z * theta * weight_x;
    const double bend = -share * (1.0 + theta * theta * scratch.weight[k]);
    bend0 += bend;
    bend1 += bend * z;
    bend2 += bend * z * z;
    hessian(0, 0) -= share * t * t * scratch.weight[k];
    hessian.col(0).tail(columns) -= share * t * weight_x;
  }
  add_one(-1.0, scratch.mean_d, hessian);
  add_both(1.0, scratch.cross0, scratch.mode_by, hessian);
  add_both(1.0, scratch.cross1, scratch.log_s_by, hessian);
  add_one(bend0, scratch.mode_by, hessian);
  add_both(bend1, scratch.mode_by, scratch.log_s_by, hessian);
  add_one(bend2, scratch.log_s_by, hessian);
}

void fill_curvatures(const InterceptGroup& group,
                     double theta,
                     const InterceptMoves& moves,
                     const InterceptScratch& scratch,
                     double* curvature) {
  for (Eigen::Index i = 0; i < group.rows; ++i) {
    double mean = 0.0;
    for (std::size_t k = 0; k < scratch.t.size(); ++k) {
      const double at = group.odds[i] * scratch.factor[k];
      const double failure = 1.0 / (1.0 + at);
      mean += scratch.share[k] * (at * failure * failure);
    }
    const auto row = static_cast<std::size_t>(i);
    curvature[i] = -group.trials[i] * mean - moves.along_mode * theta * scratch.w1[row] +
                   moves.along_h * theta * theta * scratch.w2[row];
  }
}

}  // namespace

InterceptMoves moves_of(double theta,
                        const HermiteRule& rule,
                        const InterceptMode& mode,
                        const InterceptScratch& scratch) {
  InterceptMoves moves;
  double by_mode = 0.0;
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const double slope = theta * scratch.residual[k] - scratch.t[k];
    by_mode += scratch.share[k] * slope;
    moves.by_s += scratch.share[k] * slope * rule.nodes[k] * mode.s;
  }
  moves.whole = 1.0 + moves.by_s;
  moves.h_u = theta * theta * theta * mode.sums.w1;
  moves.along_mode = (by_mode - moves.whole * moves.h_u / (2.0 * mode.h)) / mode.h;
  moves.along_h = -moves.whole / (2.0 * mode.h);
  return moves;
}

void add_slopes(const InterceptGroup& group,
                double theta,
                const InterceptMode& mode,
                const InterceptMoves& moves,
                const InterceptScratch& scratch,
                double* slope,
                InterceptSum& sum) {
  const std::size_t nodes = scratch.t.size();
  const RowSums& s = mode.sums;
  for (Eigen::Index i = 0; i < group.rows; ++i) {
    double mean = 0.0;
    for (std::size_t k = 0; k < nodes; ++k) {
      const double at = group.odds[i] * scratch.factor[k];
      mean += scratch.share[k] * (at / (1.0 + at));
    }
    const auto row = static_cast<std::size_t>(i);
    slope[i] = group.successes[i] - group.trials[i] * mean -
               theta * moves.along_mode * scratch.w0[row] +
               theta * theta * moves.along_h * scratch.w1[row];
  }
  double direct = 0.0;
  for (std::size_t k = 0; k < nodes; ++k) {
    direct += scratch.share[k] * scratch.t[k] * scratch.residual[k];
  }
  sum.gradient[0] += direct + moves.along_mode * (s.residual - theta * mode.u * s.w0) +
                     moves.along_h * (2.0 * theta * s.w0 + theta * theta * mode.u * s.w1);
}

void add_curvatures(const InterceptGroup& group,
                    double theta,
                    const HermiteRule& rule,
                    const InterceptMode& mode,
                    const InterceptMoves& moves,
                    InterceptScratch& scratch,
                    double* curvature,
                    Eigen::MatrixXd& hessian) {
  fill_mode_derivatives(group, theta, mode, moves.h_u, scratch);
  add_mode_curvature(theta, mode, moves, scratch, hessian);
  add_node_curvature(theta, rule, mode, scratch, hessian);
  fill_curvatures(group, theta, moves, scratch, curvature);
}

}  // namespace tcert::statistics
