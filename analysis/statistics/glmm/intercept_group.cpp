#include <statistics/glmm/intercept_group.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tcert::statistics {
namespace {

constexpr double kLargestGroupEta = 300.0;

/// Sums over the rows at one u.
struct Sums {
  double residual = 0.0;
  double w0 = 0.0;
  double w1 = 0.0;
  double w2 = 0.0;
};

Sums sums_at(const InterceptGroup& group, double theta, double u) {
  const double factor = std::exp(theta * u);
  double residual = 0.0;
  double weight = 0.0;
  for (Eigen::Index i = 0; i < group.rows; ++i) {
    const double odds = group.odds[i] * factor;
    const double failure = 1.0 / (1.0 + odds);
    const double success = odds * failure;
    residual += group.successes[i] - group.trials[i] * success;
    weight += group.trials[i] * success * failure;
  }
  Sums sums;
  sums.residual = residual;
  sums.w0 = weight;
  return sums;
}

/// Newton's method on f_u, which falls strictly, within the bracket that its signs leave.
bool find_mode(const InterceptGroup& group, double theta, double& mode) {
  double low = -std::numeric_limits<double>::infinity();
  double high = -low;
  double u = mode;
  for (int iteration = 0; iteration < 200; ++iteration) {
    if (!(std::abs(theta * u) <= kLargestGroupEta)) {
      // Far off: start where every group can.
      u = 0.0;
      if (iteration > 0) {
        return false;
      }
    }
    const Sums sums = sums_at(group, theta, u);
    const double slope = theta * sums.residual - u;
    const double step = slope / (1.0 + theta * theta * sums.w0);
    (slope > 0.0 ? low : high) = u;
    double next = u + step;
    if (std::abs(step) <= 1e-9 * (1.0 + std::abs(u))) {
      mode = next;
      return std::isfinite(next);
    }
    if (!(next > low && next < high)) {
      next = 0.5 * (low + high);
      if (!std::isfinite(next)) {
        return false;
      }
    }
    u = next;
  }
  return false;
}

/// Everything that the derivatives need of the mode.
struct Mode {
  double u = 0.0;
  double h = 1.0;
  double s = 1.0;
  Sums sums;
};

Mode at_mode(const InterceptGroup& group, double theta, double u, InterceptScratch& scratch) {
  const auto rows = static_cast<std::size_t>(group.rows);
  scratch.w0.resize(rows);
  scratch.w1.resize(rows);
  scratch.w2.resize(rows);
  const double factor = std::exp(theta * u);
  Mode mode;
  for (Eigen::Index i = 0; i < group.rows; ++i) {
    const double odds = group.odds[i] * factor;
    const double failure = 1.0 / (1.0 + odds);
    const double success = odds * failure;
    const double w0 = group.trials[i] * success * failure;
    const double w1 = w0 * (failure - success);
    const double w2 = w0 * (1.0 - 6.0 * success * failure);
    mode.sums.residual += group.successes[i] - group.trials[i] * success;
    mode.sums.w0 += w0;
    mode.sums.w1 += w1;
    mode.sums.w2 += w2;
    scratch.w0[static_cast<std::size_t>(i)] = w0;
    scratch.w1[static_cast<std::size_t>(i)] = w1;
    scratch.w2[static_cast<std::size_t>(i)] = w2;
  }
  mode.u = u;
  mode.h = 1.0 + theta * theta * mode.sums.w0;
  mode.s = 1.0 / std::sqrt(mode.h);
  return mode;
}

/// Sets product to the sum over rows of m log(1 + exp eta) at every node. For single trials the
/// factors are multiplied first, as many as cannot overflow, which saves logarithms.
void sum_losses(const InterceptGroup& group, double largest_eta, InterceptScratch& scratch) {
  const std::size_t nodes = scratch.t.size();
  std::vector<double>& loss = scratch.product;
  loss.assign(nodes, 0.0);
  const double* const factor = scratch.factor.data();
  if (!group.unit_trials) {
    for (Eigen::Index i = 0; i < group.rows; ++i) {
      for (std::size_t k = 0; k < nodes; ++k) {
        loss[k] += group.trials[i] * std::log1p(group.odds[i] * factor[k]);
      }
    }
    return;
  }
  const double room = 650.0 / (std::max(0.0, largest_eta) + 0.7);
  const auto chunk = std::max<Eigen::Index>(1, static_cast<Eigen::Index>(room));
  double* const product = scratch.weight.data();
  for (Eigen::Index first = 0; first < group.rows; first += chunk) {
    const Eigen::Index last = std::min(group.rows, first + chunk);
    std::fill_n(product, nodes, 1.0);
    for (Eigen::Index i = first; i < last; ++i) {
      const double odds = group.odds[i];
      for (std::size_t k = 0; k < nodes; ++k) {
        product[k] *= 1.0 + odds * factor[k];
      }
    }
    for (std::size_t k = 0; k < nodes; ++k) {
      loss[k] += std::log(product[k]);
    }
  }
}

/// Nodes, and the group's log-likelihood: the log of the sum over them. Empty optional as NaN.
double value_at_nodes(const InterceptGroup& group,
                      double theta,
                      const HermiteRule& rule,
                      const Mode& mode,
                      InterceptScratch& scratch) {
  const std::size_t nodes = rule.nodes.size();
  for (auto* list : {&scratch.t,
                     &scratch.factor,
                     &scratch.log_density,
                     &scratch.share,
                     &scratch.residual,
                     &scratch.weight}) {
    list->resize(nodes);
  }
  for (std::size_t k = 0; k < nodes; ++k) {
    scratch.t[k] = mode.u + mode.s * rule.nodes[k];
    scratch.factor[k] = std::exp(theta * scratch.t[k]);
  }
  double largest = -kLargestGroupEta;
  double smallest = kLargestGroupEta;
  double successes = 0.0;
  double linear = 0.0;
  for (Eigen::Index i = 0; i < group.rows; ++i) {
    largest = std::max(largest, group.fixed[i]);
    smallest = std::min(smallest, group.fixed[i]);
    successes += group.successes[i];
    linear += group.successes[i] * group.fixed[i];
  }
  const double reach =
      std::max(std::abs(theta * scratch.t.front()), std::abs(theta * scratch.t.back()));
  if (!(std::max({std::abs(largest), std::abs(smallest), reach}) <= kLargestGroupEta)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  sum_losses(group, largest + reach, scratch);
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < nodes; ++k) {
    const double t = scratch.t[k];
    scratch.log_density[k] = linear + theta * t * successes - scratch.product[k] - 0.5 * t * t +
                             0.5 * rule.nodes[k] * rule.nodes[k] + rule.log_weights[k];
    highest = std::max(highest, scratch.log_density[k]);
  }
  double total = 0.0;
  for (std::size_t k = 0; k < nodes; ++k) {
    scratch.share[k] = std::exp(scratch.log_density[k] - highest);
    total += scratch.share[k];
  }
  for (double& share : scratch.share) {
    share /= total;
  }
  return highest + std::log(total) + std::log(mode.s);
}

/// Sums over rows at each node: of residuals, and for the Hessian of weights and of both times x.
void sum_at_nodes(const InterceptGroup& group, bool with_x, InterceptScratch& scratch) {
  const std::size_t nodes = scratch.t.size();
  const auto columns = static_cast<std::size_t>(group.columns);
  std::fill(scratch.residual.begin(), scratch.residual.end(), 0.0);
  std::fill(scratch.weight.begin(), scratch.weight.end(), 0.0);
  if (with_x) {
    scratch.residual_x.assign(columns * nodes, 0.0);
    scratch.weight_x.assign(columns * nodes, 0.0);
  }
  // A row's residuals and weights at all nodes.
  double* const row_residual = scratch.product.data();
  double* const row_weight = scratch.log_density.data();
  for (Eigen::Index i = 0; i < group.rows; ++i) {
    const double odds = group.odds[i];
    const double successes = group.successes[i];
    const double trials = group.trials[i];
    for (std::size_t k = 0; k < nodes; ++k) {
      const double at = odds * scratch.factor[k];
      const double failure = 1.0 / (1.0 + at);
      const double success = at * failure;
      row_residual[k] = successes - trials * success;
      row_weight[k] = trials * success * failure;
      scratch.residual[k] += row_residual[k];
      scratch.weight[k] += row_weight[k];
    }
    if (!with_x) {
      continue;
    }
    const double* const x = group.basis + i * group.columns;
    for (std::size_t j = 0; j < columns; ++j) {
      const double value = x[j];
      double* const residual_x = scratch.residual_x.data() + j * nodes;
      double* const weight_x = scratch.weight_x.data() + j * nodes;
      for (std::size_t k = 0; k < nodes; ++k) {
        residual_x[k] += value * row_residual[k];
        weight_x[k] += value * row_weight[k];
      }
    }
  }
}

/// How the group's log-likelihood moves with u0 and with log h, for first and second derivatives.
struct Moves {
  double by_mode = 0.0;  ///< P1: mean of f_u over the nodes.
  double by_s = 0.0;     ///< s P2: of f_u z, times s.
  double whole = 1.0;    ///< 1 + s P2.
  double second = 0.0;   ///< P1 - whole h_u / (2 h): the factor of the mode's second derivatives.
  double h_u = 0.0;
};

Moves moves_of(double theta, const HermiteRule& rule, const Mode& mode, InterceptScratch& scratch) {
  Moves moves;
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const double slope = theta * scratch.residual[k] - scratch.t[k];
    moves.by_mode += scratch.share[k] * slope;
    moves.by_s += scratch.share[k] * slope * rule.nodes[k] * mode.s;
  }
  moves.whole = 1.0 + moves.by_s;
  moves.h_u = theta * theta * theta * mode.sums.w1;
  moves.second = moves.by_mode - moves.whole * moves.h_u / (2.0 * mode.h);
  return moves;
}

void add_slopes(const InterceptGroup& group,
                double theta,
                const Mode& mode,
                const Moves& moves,
                const InterceptScratch& scratch,
                double* slope,
                InterceptSum& sum) {
  const std::size_t nodes = scratch.t.size();
  const double along_mode = moves.second / mode.h;
  const double along_h = -moves.whole / (2.0 * mode.h);
  const Sums& s = mode.sums;
  for (Eigen::Index i = 0; i < group.rows; ++i) {
    double mean = 0.0;
    for (std::size_t k = 0; k < nodes; ++k) {
      const double at = group.odds[i] * scratch.factor[k];
      mean += scratch.share[k] * (at / (1.0 + at));
    }
    const auto row = static_cast<std::size_t>(i);
    slope[i] = group.successes[i] - group.trials[i] * mean - theta * along_mode * scratch.w0[row] +
               theta * theta * along_h * scratch.w1[row];
  }
  double direct = 0.0;
  for (std::size_t k = 0; k < nodes; ++k) {
    direct += scratch.share[k] * scratch.t[k] * scratch.residual[k];
  }
  sum.gradient[0] += direct + along_mode * (s.residual - theta * mode.u * s.w0) +
                     along_h * (2.0 * theta * s.w0 + theta * theta * mode.u * s.w1);
}

void fill_mode_derivatives(const InterceptGroup& group,
                           double theta,
                           const Mode& mode,
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
  const Sums& s = mode.sums;
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
                        const Mode& mode,
                        const Moves& moves,
                        const InterceptScratch& scratch,
                        Eigen::MatrixXd& hessian) {
  const Eigen::Index columns = scratch.w0_x.size();
  const Sums& s = mode.sums;
  const double u = mode.u;
  const double square = theta * theta;
  const double along_mode = moves.second / mode.h;
  const double along_h = -moves.whole / (2.0 * mode.h);
  // Second derivatives of f_u and of h at fixed u; the rows' share is in the curvatures.
  hessian(0, 0) += along_mode * (-2.0 * u * s.w0 - theta * u * u * s.w1) +
                   along_h * (2.0 * s.w0 + 4.0 * theta * u * s.w1 + square * u * u * s.w2);
  hessian.col(0).tail(columns) +=
      -along_mode * (scratch.w0_x + theta * u * scratch.w1_x) +
      along_h * (2.0 * theta * scratch.w1_x + square * u * scratch.w2_x);
  add_both(-along_mode, scratch.h_by, scratch.mode_by, hessian);
  add_both(along_h, scratch.h_by_u, scratch.mode_by, hessian);
  add_one(-along_mode * moves.h_u + along_h * square * square * s.w2, scratch.mode_by, hessian);
  add_one(2.0 * moves.whole + moves.by_s, scratch.log_s_by, hessian);
}

/// The part of the nodes: second derivatives of f there, and the variance of its first ones.
void add_node_curvature(double theta,
                        const HermiteRule& rule,
                        const Mode& mode,
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
                     const Mode& mode,
                     const Moves& moves,
                     const InterceptScratch& scratch,
                     double* curvature) {
  const double along_mode = moves.second / mode.h;
  const double along_h = -moves.whole / (2.0 * mode.h);
  for (Eigen::Index i = 0; i < group.rows; ++i) {
    double mean = 0.0;
    for (std::size_t k = 0; k < scratch.t.size(); ++k) {
      const double at = group.odds[i] * scratch.factor[k];
      const double failure = 1.0 / (1.0 + at);
      mean += scratch.share[k] * (at * failure * failure);
    }
    const auto row = static_cast<std::size_t>(i);
    curvature[i] = -group.trials[i] * mean - along_mode * theta * scratch.w1[row] +
                   along_h * theta * theta * scratch.w2[row];
  }
}

}  // namespace

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
  const Mode mode = at_mode(group, theta, mode_u, scratch);
  const double value = value_at_nodes(group, theta, rule, mode, scratch);
  if (!std::isfinite(value)) {
    return false;
  }
  sum.value += value;
  if (wanted == Derivatives::none) {
    return true;
  }
  sum_at_nodes(group, wanted == Derivatives::hessian, scratch);
  const Moves moves = moves_of(theta, rule, mode, scratch);
  add_slopes(group, theta, mode, moves, scratch, slope, sum);
  if (wanted == Derivatives::hessian) {
    fill_mode_derivatives(group, theta, mode, moves.h_u, scratch);
    add_mode_curvature(theta, mode, moves, scratch, sum.hessian);
    add_node_curvature(theta, rule, mode, scratch, sum.hessian);
    fill_curvatures(group, theta, mode, moves, scratch, curvature);
  }
  return true;
}

double intercept_curvature(const InterceptGroup& group, double theta, double u) {
  return 1.0 + theta * theta * sums_at(group, theta, u).w0;
}

}  // namespace tcert::statistics
