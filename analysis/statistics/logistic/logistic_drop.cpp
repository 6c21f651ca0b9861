#include <statistics/logistic/logistic_drop.hpp>

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <statistics/logistic/logistic_problem.hpp>
#include <string_view>

namespace tcert::statistics {
namespace {

/// The variables of a term: parts between colons that no parenthesis encloses, sorted.
std::vector<std::string> variables_of(std::string_view term) {
  std::vector<std::string> variables(1);
  int depth = 0;
  for (const char c : term) {
    depth += (c == '(' ? 1 : 0) - (c == ')' ? 1 : 0);
    if (c == ':' && depth == 0) {
      variables.emplace_back();
    } else {
      variables.back() += c;
    }
  }
  std::sort(variables.begin(), variables.end());
  return variables;
}

bool is_contained(const std::vector<std::string>& terms, std::size_t term) {
  const std::vector<std::string> small = variables_of(terms[term]);
  for (std::size_t other = 0; other < terms.size(); ++other) {
    const std::vector<std::string> large = variables_of(terms[other]);
    if (other != term && large.size() > small.size() &&
        std::includes(large.begin(), large.end(), small.begin(), small.end())) {
      return true;
    }
  }
  return false;
}

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
    result.p_value =
        boost::math::gamma_q(0.5 * static_cast<double>(result.df), 0.5 * *result.chi_squared);
  }
  return result;
}

}  // namespace

std::vector<std::size_t> droppable_terms(const std::vector<std::string>& terms) {
  std::vector<std::size_t> droppable;
  for (std::size_t term = 0; term < terms.size(); ++term) {
    if (!is_contained(terms, term)) {
      droppable.push_back(term);
    }
  }
  return droppable;
}

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
