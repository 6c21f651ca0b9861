#pragma once
/// \file
/// A mixed model made ready to be solved: what the fit, its profile and its tests share. Internal
/// to the estimator.

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <statistics/glmm/glmm.hpp>
#include <statistics/glmm/grouped_rows.hpp>
#include <statistics/glmm/mixed_likelihood.hpp>
#include <statistics/logistic/logistic_problem.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {

/// One random term on the rows of the problem.
struct TermRows {
  std::string group;
  std::vector<std::string> columns;
  std::vector<std::string> levels;   ///< Those that occur.
  std::vector<std::uint32_t> codes;  ///< One a row, below levels.size().
  RowMajorMatrix design;             ///< rows x columns, divided by `scale`.
  Eigen::VectorXd scale;             ///< Root mean square of each column.

  /// Elements of the factor: q (q + 1) / 2.
  [[nodiscard]] Eigen::Index thetas() const noexcept {
    const auto q = static_cast<Eigen::Index>(columns.size());
    return q * (q + 1) / 2;
  }
};

/// The term on the rows `used` of its input, levels without rows left out; without its design the
/// scale is 1.
[[nodiscard]] TermRows term_rows(const RandomEffects& random,
                                 const std::vector<Eigen::Index>& used,
                                 bool with_design);

/// What stands against a random term: infinite_value, one_group and collinear_column (errors),
/// singleton_groups (a warning, of rows that are single trials).
void add_term_conditions(const RandomEffects& random,
                         const TermRows& term,
                         bool single_trials,
                         Conditions& conditions);

/// The same effect of the same group twice: collinear_column, an error.
void add_duplicate_conditions(const std::vector<RandomEffects>& random, Conditions& conditions);

struct GlmmProblem {
  LogisticProblem fixed;
  NewtonResult plain;  ///< Without random effects.
  std::vector<TermRows> terms;
  GroupedRows grouped;  ///< For a single intercept.

  [[nodiscard]] bool single_intercept() const noexcept {
    return terms.size() == 1 && terms[0].columns.size() == 1 && terms[0].design.size() == 0;
  }
  [[nodiscard]] Eigen::Index thetas() const noexcept;
  [[nodiscard]] Eigen::Index size() const noexcept { return thetas() + fixed.space.rank(); }

  /// Holds references into the problem.
  [[nodiscard]] std::unique_ptr<MixedLikelihood> likelihood(int quadrature) const;
};

/// What stands against a fit goes into `conditions`; an error there leaves no problem.
/// \pre the input's lengths fit.
[[nodiscard]] std::optional<GlmmProblem> glmm_problem(const GlmmInput& input,
                                                      const GlmmOptions& options,
                                                      Conditions& conditions);

/// The factors of a term from its elements, for the columns as they are in the data: lower
/// triangle, diagonal at least 0.
[[nodiscard]] Eigen::MatrixXd factor_of(const TermRows& term,
                                        const Eigen::Ref<const Eigen::VectorXd>& thetas);

}  // namespace tcert::statistics
