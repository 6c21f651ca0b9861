#include <statistics/cox/cox_terms.hpp>

#include <algorithm>
#include <statistics/model/droppable_terms.hpp>

namespace tcert::statistics {
namespace {

/// `data` with the columns of the terms for which `keep(term)` holds.
template <class Keep>
CoxData with_terms(const CoxData& data, const Keep& keep) {
  CoxData part;
  std::vector<Eigen::Index> kept;
  for (std::size_t j = 0; j < data.columns.size(); ++j) {
    if (keep(data.term_of[j])) {
      kept.push_back(static_cast<Eigen::Index>(j));
      part.columns.push_back(data.columns[j]);
      part.term_of.push_back(data.term_of[j]);
    }
  }
  part.outcome = data.outcome;
  part.design = data.design(Eigen::all, kept);
  part.terms = data.terms;
  part.offset = data.offset;
  part.weights = data.weights;
  part.strata = data.strata;
  return part;
}

/// A refit; the robust variance has no part in a likelihood. One that stops before the limit of its
/// likelihood is an error.
CoxFit refit(const CoxData& data, const CoxOptions& options) {
  CoxOptions light = options;
  light.inference = false;
  light.robust = false;
  CoxFit fit = fit_cox(data, light);
  if (!fit.at_limit) {
    fit.conditions.push_back({ConditionKind::not_converged,
                              ConditionSeverity::error,
                              {},
                              "a likelihood that rises without end"});
  }
  return fit;
}

TermTest row_of(const std::string& term, const CoxFit& fit) {
  TermTest row;
  row.term = term;
  row.loglik = *fit.loglik;
  row.aic = -2.0 * *fit.loglik + 2.0 * static_cast<double>(fit.df);
  return row;
}

void add_test(const CoxFit& smaller, const CoxFit& larger, TermTest& row) {
  if (larger.df > smaller.df) {
    const double statistic = std::max(0.0, 2.0 * (*larger.loglik - *smaller.loglik));
    row.test = chi_square_test(statistic, larger.df - smaller.df);
  }
}

}  // namespace

TermTests cox_anova(const CoxData& data, const CoxOptions& options) {
  TermTests result;
  CoxFit previous = refit(with_terms(data, [](std::size_t) { return false; }), options);
  if (has_error(previous.conditions)) {
    result.conditions = previous.conditions;
    return result;
  }
  result.rows.push_back(row_of("NULL", previous));
  for (std::size_t last = 0; last < data.terms.size(); ++last) {
    CoxFit fit = refit(with_terms(data, [&](std::size_t term) { return term <= last; }), options);
    result.conditions = fit.conditions;
    if (has_error(fit.conditions)) {
      result.rows.clear();
      return result;
    }
    result.rows.push_back(row_of(data.terms[last], fit));
    add_test(previous, fit, result.rows.back());
    previous = std::move(fit);
  }
  return result;
}

TermTests cox_drop1(const CoxData& data, const CoxOptions& options) {
  TermTests result;
  const CoxFit full = refit(data, options);
  result.conditions = full.conditions;
  if (has_error(full.conditions)) {
    return result;
  }
  result.rows.push_back(row_of("<none>", full));
  for (const std::size_t out : droppable_terms(data.terms)) {
    const CoxFit fit =
        refit(with_terms(data, [&](std::size_t term) { return term != out; }), options);
    if (has_error(fit.conditions)) {
      result.conditions = fit.conditions;
      result.rows.clear();
      return result;
    }
    result.rows.push_back(row_of(data.terms[out], fit));
    add_test(fit, full, result.rows.back());
  }
  return result;
}

}  // namespace tcert::statistics
