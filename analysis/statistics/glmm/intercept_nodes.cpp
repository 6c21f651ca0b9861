#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <statistics/glmm/intercept_nodes.hpp>

namespace tcert::statistics {
namespace {

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

}  // namespace

double value_at_nodes(const InterceptGroup& group,
                      double theta,
                      const HermiteRule& rule,
                      const InterceptMode& mode,
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

}  // namespace tcert::statistics
