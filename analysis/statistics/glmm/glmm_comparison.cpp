#include <statistics/glmm/glmm_comparison.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <statistics/model/droppable_terms.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

DroppedTerm dropped(const GlmmInput& input,
                    std::size_t term,
                    const GlmmFit& whole,
                    const GlmmOptions& options) {
  DroppedTerm result;
  result.term = input.fixed.terms[term];
  const GlmmFit rest = fit_glmm({without_term(input.fixed, term), input.random}, options);
  if (!rest.log_likelihood) {
    return result;
  }
  result.df = whole.rank - rest.rank;
  result.deviance = -2.0 * *rest.log_likelihood;
  result.aic = rest.aic;
  result.chi_squared = std::max(0.0, 2.0 * (*whole.log_likelihood - *rest.log_likelihood));
  if (result.df > 0) {
    result.p_value = chi_square_test(*result.chi_squared, result.df).p_value;
  }
  return result;
}

}  // namespace

std::optional<ChiSquareTest> compare_models(const GlmmFit& small, const GlmmFit& large) {
  if (small.rows != large.rows || small.quadrature != large.quadrature ||
      small.parameters >= large.parameters) {
    throw std::invalid_argument("compare_models: the models are not nested");
  }
  if (!small.log_likelihood || !large.log_likelihood) {
    return std::nullopt;
  }
  return chi_square_test(2.0 * (*large.log_likelihood - *small.log_likelihood),
                         large.parameters - small.parameters);
}

std::vector<DroppedTerm> drop_terms(const GlmmInput& input, const GlmmOptions& options) {
  GlmmOptions plain = options;
  plain.test_terms = false;
  const GlmmFit whole = fit_glmm(input, plain);
  if (!whole.log_likelihood) {
    return {};
  }
  const std::vector<std::size_t> terms = droppable_terms(input.fixed.terms);
  std::vector<DroppedTerm> result(terms.size());
  tbb::parallel_for(std::size_t{0}, terms.size(), [&](std::size_t k) {
    result[k] = dropped(input, terms[k], whole, plain);
  });
  return result;
}

}  // namespace tcert::statistics
