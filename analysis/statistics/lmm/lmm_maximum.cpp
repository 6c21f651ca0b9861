#include <statistics/lmm/lmm_maximum.hpp>

#include <cmath>
#include <utility>

namespace tcert::statistics {
namespace {

constexpr double kLmmStart = 1.0;
/// A relative deviation below this is set to 0 if the likelihood does not fall by it.
constexpr double kSmallDeviation = 1e-3;

/// Calls `visit(term, row, column, place)` for each element of each factor.
template <class Visit>
void for_elements(const std::vector<TermRows>& terms, const Visit& visit) {
  Eigen::Index place = 0;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const Eigen::Index q = terms[t].scale.size();
    for (Eigen::Index column = 0; column < q; ++column) {
      for (Eigen::Index row = column; row < q; ++row) {
        visit(t, row, column, place++);
      }
    }
  }
}

GlmmMaximum maximum_beside(LmmLikelihood& likelihood,
                           const Eigen::VectorXd& start,
                           const std::vector<bool>& held) {
  return newton_maximum(likelihood, start, free_directions(held), GlmmOptions{});
}

/// The likelihood is even in each column of a factor, so that 0 is a stationary value of a
/// diagonal: where the maximum lies there it is reached by setting it.
void set_small_to_zero(LmmLikelihood& likelihood,
                       const std::vector<TermRows>& terms,
                       GlmmMaximum& maximum) {
  std::vector<bool> held(static_cast<std::size_t>(likelihood.thetas()), false);
  Eigen::VectorXd settled = maximum.parameters;
  for_elements(terms, [&](std::size_t, Eigen::Index row, Eigen::Index column, Eigen::Index place) {
    if (row == column && std::abs(settled[place]) < kSmallDeviation) {
      settled[place] = 0.0;
      held[static_cast<std::size_t>(place)] = true;
    }
  });
  if (settled == maximum.parameters) {
    return;
  }
  GlmmMaximum at = maximum_beside(likelihood, settled, held);
  const double rounding = 1e-12 * (1.0 + std::abs(maximum.at.value));
  if (at.converged() && is_concave(at.at.hessian) && at.at.value >= maximum.at.value - rounding) {
    at.iterations += maximum.iterations;
    at.evaluations += maximum.evaluations;
    maximum = std::move(at);
  }
}

void make_positive(const std::vector<TermRows>& terms, Eigen::VectorXd& thetas) {
  double sign = 1.0;
  for_elements(terms, [&](std::size_t, Eigen::Index row, Eigen::Index column, Eigen::Index place) {
    if (row == column) {
      sign = thetas[place] < 0.0 ? -1.0 : 1.0;
    }
    thetas[place] *= sign;
  });
}

}  // namespace

GlmmMaximum lmm_maximum(LmmLikelihood& likelihood, const std::vector<TermRows>& terms) {
  Eigen::VectorXd start = Eigen::VectorXd::Zero(likelihood.thetas());
  for_elements(terms, [&](std::size_t, Eigen::Index row, Eigen::Index column, Eigen::Index place) {
    start[place] = row == column ? kLmmStart : 0.0;
  });
  int iterations = 0;
  int evaluations = 0;
  start = search_maximum(likelihood, start, 1e-4, 0.0, iterations, evaluations);
  GlmmMaximum maximum = newton_maximum(likelihood, start, std::nullopt, GlmmOptions{});
  if (!maximum.converged()) {
    maximum = newton_maximum(
        likelihood, Eigen::VectorXd::Zero(likelihood.thetas()), std::nullopt, GlmmOptions{});
  }
  maximum.iterations += iterations;
  maximum.evaluations += evaluations;
  if (maximum.converged()) {
    set_small_to_zero(likelihood, terms, maximum);
  }
  make_positive(terms, maximum.parameters);
  return maximum;
}

GlmmMaximum lmm_maximum_without(LmmLikelihood& likelihood,
                                const std::vector<TermRows>& terms,
                                std::size_t term,
                                const Eigen::VectorXd& whole) {
  Eigen::VectorXd start = whole;
  std::vector<bool> held(static_cast<std::size_t>(whole.size()), false);
  for_elements(terms, [&](std::size_t t, Eigen::Index row, Eigen::Index, Eigen::Index place) {
    if (t == term && row + 1 == terms[t].scale.size()) {
      start[place] = 0.0;
      held[static_cast<std::size_t>(place)] = true;
    }
  });
  return maximum_beside(likelihood, start, held);
}

}  // namespace tcert::statistics
