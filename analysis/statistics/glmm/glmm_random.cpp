#include <cmath>
#include <numbers>
#include <statistics/glmm/glmm_parts.hpp>
#include <table/not_a_number.hpp>
#include <utility>

namespace tcert::statistics {
namespace {

constexpr double kResidualVariance = std::numbers::pi * std::numbers::pi / 3.0;

}  // namespace

GlmmRandomTerm random_term(const TermRows& rows, const Eigen::Ref<const Eigen::VectorXd>& thetas) {
  GlmmRandomTerm term;
  term.group = rows.group;
  term.columns = rows.columns;
  term.levels = rows.levels;
  term.factor = factor_of(rows, thetas);
  term.covariance = term.factor * term.factor.transpose();
  const Eigen::Index q = term.factor.rows();
  term.correlation.setConstant(q, q, table::kNaN);
  term.singular = (term.factor.diagonal().array() == 0.0).any();
  for (Eigen::Index a = 0; a < q; ++a) {
    term.sd.push_back(std::sqrt(term.covariance(a, a)));
    for (Eigen::Index b = 0; b <= a; ++b) {
      const double scale = std::sqrt(term.covariance(a, a) * term.covariance(b, b));
      if (scale > 0.0) {
        term.correlation(a, b) = a == b ? 1.0 : term.covariance(a, b) / scale;
        term.correlation(b, a) = term.correlation(a, b);
      }
    }
  }
  return term;
}

double mean_variance(const TermRows& rows, const GlmmRandomTerm& term) {
  if (rows.design.size() == 0) {
    return term.covariance(0, 0);
  }
  const RowMajorMatrix z = rows.design * rows.scale.asDiagonal();
  const Eigen::MatrixXd products = z.transpose() * z;
  return products.cwiseProduct(term.covariance).sum() / static_cast<double>(z.rows());
}

void add_random_effects(const GlmmProblem& problem, const GlmmMaximum& maximum, GlmmFit& fit) {
  const std::unique_ptr<MixedLikelihood> likelihood = problem.likelihood(fit.quadrature);
  std::vector<TermModes> modes = likelihood->modes(maximum.parameters);
  Eigen::Index at = 0;
  for (std::size_t t = 0; t < problem.terms.size(); ++t) {
    const TermRows& rows = problem.terms[t];
    fit.random.push_back(random_term(rows, maximum.parameters.segment(at, rows.thetas())));
    fit.random.back().modes = std::move(modes[t].modes);
    fit.random.back().mode_sds = std::move(modes[t].sds);
    fit.singular = fit.singular || fit.random.back().singular;
    at += rows.thetas();
  }
}

void add_explained(const GlmmProblem& problem, const GlmmMaximum& maximum, GlmmFit& fit) {
  const Eigen::VectorXd fixed =
      problem.fixed.space.basis * maximum.parameters.tail(problem.fixed.space.rank());
  const double of_fixed =
      (fixed.array() - fixed.mean()).square().sum() / (static_cast<double>(fixed.size()) - 1.0);
  double of_random = 0.0;
  for (std::size_t t = 0; t < problem.terms.size(); ++t) {
    of_random += mean_variance(problem.terms[t], fit.random[t]);
  }
  const double whole = of_fixed + of_random + kResidualVariance;
  fit.icc = of_random / (of_random + kResidualVariance);
  fit.r2_marginal = of_fixed / whole;
  fit.r2_conditional = (of_fixed + of_random) / whole;
}

}  // namespace tcert::statistics
