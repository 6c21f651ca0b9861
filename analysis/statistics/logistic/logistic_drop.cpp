#include <statistics/logistic/logistic_drop.hpp>

#include <algorithm>
#include <statistics/basics/chi_square.hpp>
#include <statistics/logistic/logistic_problem.hpp>
#include <statistics/model/droppable_terms.hpp>

namespace tcert::statistics {
namespace {

DroppedTerm dropped(const LogisticInput& input,
                    std::size_t term,
                    const LogisticFit& whole,
                    const NewtonOptions& options) {
  DroppedTerm result;
  result.term = input.terms[term];
  const LogisticInput reduced = without_term(input, term);
  const LogisticProblem problem = logistic_problem(reduced);
  const LogisticMaximum maximum = maximum_of(reduced, problem, options);
  const auto rank = static_cast<std::size_t>(problem.space.rank());
  result.df = whole.rank - rank;
  if (!maximum.newton.converged()) {
    return result;
  }
  result.deviance = 2.0 * (problem.saturated - maximum.newton.at.log_likelihood);
  if (maximum.separation.kind == Separation::none) {
    result.aic = 2.0 * static_cast<double>(rank) -
                 2.0 * (maximum.newton.at.log_likelihood + problem.log_coefficients);
  }
  result.chi_squared = std::max(0.0, *result.deviance - *whole.deviance);
  if (result.df > 0) {
    result.p_value = chi_square_tail(*result.chi_squared, result.df);
  }
  return result;
}

}  // namespace

LogisticInput without_term(const LogisticInput& input, std::size_t term) {
  LogisticInput reduced = input;
  std::vector<Eigen::Index> columns;
  reduced.columns.clear();
  reduced.term_of.clear();
  for (std::size_t j = 0; j < input.columns.size(); ++j) {
    if (input.term_of[j] != term + 1) {
      columns.push_back(static_cast<Eigen::Index>(j));
      reduced.columns.push_back(input.columns[j]);
      reduced.term_of.push_back(input.term_of[j]);
    }
  }
  reduced.design = input.design(Eigen::all, columns);
  return reduced;
}

std::vector<DroppedTerm> drop_terms(const LogisticInput& input, const NewtonOptions& options) {
  LogisticOptions whole_options;
  whole_options.newton = options;
  const LogisticFit whole = fit_logistic(input, whole_options);
  std::vector<DroppedTerm> result;
  if (!whole.deviance) {
    return result;
  }
  for (const std::size_t term : droppable_terms(input.terms)) {
    result.push_back(dropped(input, term, whole, options));
  }
  return result;
}

}  // namespace tcert::statistics
