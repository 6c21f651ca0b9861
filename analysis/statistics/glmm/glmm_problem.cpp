#include <statistics/glmm/glmm_problem.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <statistics/glmm/intercept_likelihood.hpp>
#include <statistics/glmm/sparse_likelihood.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

bool is_intercept(const RandomEffects& random) {
  return random.columns.size() == 1 && random.columns[0] == "(Intercept)";
}

void check_lengths(const GlmmInput& input) {
  const Eigen::Index rows = input.fixed.design.rows();
  for (const RandomEffects& random : input.random) {
    if (random.levels.rows() != static_cast<std::size_t>(rows) || random.design.rows() != rows ||
        random.design.cols() != static_cast<Eigen::Index>(random.columns.size()) ||
        random.columns.empty()) {
      throw std::invalid_argument("mixed model: lengths differ");
    }
  }
}

void check_quadrature(const GlmmInput& input, const GlmmOptions& options) {
  const int points = options.quadrature.value_or(1);
  if (points < 1 || points > kMostQuadrature) {
    throw std::invalid_argument("mixed model: quadrature must be in [1, 100]");
  }
  if (points > 1 && !is_single_intercept(input)) {
    throw std::invalid_argument("mixed model: quadrature above 1 is for a single random intercept");
  }
}

/// Everything finite and of equal length, so that the fixed part can be taken apart.
bool is_sound(const LogisticInput& fixed) {
  const Eigen::Index rows = fixed.design.rows();
  const auto fits = [rows](const Eigen::VectorXd& v) { return v.size() == 0 || v.size() == rows; };
  return fixed.successes.size() == rows && fits(fixed.trials) && fits(fixed.weights) &&
         fits(fixed.offset) && fixed.design.allFinite() && fixed.offset.allFinite() &&
         fixed.weights.allFinite() && (fixed.weights.array() >= 0.0).all() &&
         (fixed.successes.array() >= 0.0).all() &&
         (fixed.trials.size() > 0 ? (fixed.successes.array() <= fixed.trials.array()).all()
                                  : (fixed.successes.array() <= 1.0).all());
}

bool has_both_outcomes(const BinomialRows& rows) {
  return (rows.successes.array() > 0.0).any() &&
         (rows.successes.array() < rows.trials.array()).any();
}

/// The conditions that a logistic regression of the fixed part meets; separation leaves no estimate
/// here.
void add_fixed_conditions(const GlmmInput& input,
                          const GlmmOptions& options,
                          Conditions& conditions) {
  LogisticInput fixed = input.fixed;
  fixed.cluster.reset();
  LogisticOptions logistic;
  logistic.level = options.level;
  const LogisticFit fit = fit_logistic(fixed, logistic);
  conditions = fit.conditions;
  for (Condition& condition : conditions) {
    if (condition.kind == ConditionKind::quasi_separation ||
        condition.kind == ConditionKind::complete_separation) {
      condition.severity = ConditionSeverity::error;
      condition.advice =
          "no finite estimate; merge levels or leave the term out (fit glm with --firth has one, "
          "of a model without random effects)";
    }
  }
}

}  // namespace

Eigen::Index GlmmProblem::thetas() const noexcept {
  Eigen::Index sum = 0;
  for (const TermRows& term : terms) {
    sum += term.thetas();
  }
  return sum;
}

TermRows term_rows(const RandomEffects& random,
                   const std::vector<Eigen::Index>& used,
                   bool with_design) {
  TermRows term;
  term.group = random.group;
  term.columns = random.columns;
  std::vector<std::uint32_t> place(random.levels.levels.size(), table::Factor::kMissing);
  for (const Eigen::Index row : used) {
    place[random.levels.codes[static_cast<std::size_t>(row)]] = 0;
  }
  for (std::size_t level = 0; level < place.size(); ++level) {
    if (place[level] != table::Factor::kMissing) {
      place[level] = static_cast<std::uint32_t>(term.levels.size());
      term.levels.push_back(random.levels.levels[level]);
    }
  }
  term.codes.reserve(used.size());
  for (const Eigen::Index row : used) {
    term.codes.push_back(place[random.levels.codes[static_cast<std::size_t>(row)]]);
  }
  term.scale = Eigen::VectorXd::Ones(random.design.cols());
  if (!with_design) {
    return term;
  }
  const auto rows = static_cast<Eigen::Index>(used.size());
  term.design.resize(rows, random.design.cols());
  for (Eigen::Index i = 0; i < rows; ++i) {
    term.design.row(i) = random.design.row(used[static_cast<std::size_t>(i)]);
  }
  for (Eigen::Index j = 0; j < term.scale.size(); ++j) {
    const double size = term.design.col(j).norm() / std::sqrt(static_cast<double>(rows));
    term.scale[j] = size > 0.0 ? size : 1.0;
    term.design.col(j) /= term.scale[j];
  }
  return term;
}

void add_term_conditions(const RandomEffects& random,
                         const TermRows& term,
                         bool single_trials,
                         Conditions& conditions) {
  if (!random.design.allFinite()) {
    conditions.push_back(
        error_of(ConditionKind::infinite_value, random.group, "of a random slope"));
    return;
  }
  if (term.levels.size() < 2) {
    conditions.push_back(error_of(
        ConditionKind::one_group,
        random.group,
        fmt::format("every row has {}", term.levels.empty() ? "none" : term.levels.front())));
    return;
  }
  if (term.levels.size() == term.codes.size() && single_trials) {
    conditions.push_back(
        {ConditionKind::singleton_groups,
         ConditionSeverity::warning,
         random.group,
         fmt::format("{} levels, {} rows", term.levels.size(), term.codes.size())});
  }
  if (term.design.size() > 0) {
    for (const std::size_t j : orthonormal_basis(term.design).dropped) {
      conditions.push_back(error_of(ConditionKind::collinear_column,
                                    random.columns[j],
                                    "among the random effects of " + random.group,
                                    "leave the effect out"));
    }
  }
}

void add_duplicate_conditions(const std::vector<RandomEffects>& random, Conditions& conditions) {
  for (std::size_t a = 0; a < random.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (random[a].group != random[b].group) {
        continue;
      }
      for (const std::string& column : random[a].columns) {
        const auto& others = random[b].columns;
        if (std::find(others.begin(), others.end(), column) != others.end()) {
          conditions.push_back(error_of(ConditionKind::collinear_column,
                                        column,
                                        "twice among the random effects of " + random[a].group,
                                        "leave one of them out"));
        }
      }
    }
  }
}

std::unique_ptr<MixedLikelihood> GlmmProblem::likelihood(int quadrature) const {
  if (single_intercept()) {
    return std::make_unique<InterceptLikelihood>(grouped, quadrature);
  }
  return std::make_unique<SparseLikelihood>(fixed.space.basis, fixed.rows, terms);
}

std::optional<GlmmProblem> glmm_problem(const GlmmInput& input,
                                        const GlmmOptions& options,
                                        Conditions& conditions) {
  check_lengths(input);
  check_quadrature(input, options);
  conditions = input.fixed.conditions;
  if (input.random.empty()) {
    conditions.push_back(error_of(ConditionKind::no_random_effects, "", ""));
  }
  add_duplicate_conditions(input.random, conditions);
  if (has_error(conditions)) {
    return std::nullopt;
  }
  if (!is_sound(input.fixed)) {
    add_fixed_conditions(input, options, conditions);
    return std::nullopt;
  }
  GlmmProblem problem;
  problem.fixed = logistic_problem(input.fixed);
  bool fits = problem.fixed.size() > 0 && has_both_outcomes(problem.fixed.rows);
  if (fits) {
    LogisticMaximum maximum = maximum_of(input.fixed, problem.fixed, NewtonOptions{});
    fits = maximum.newton.converged() && maximum.separation.kind == Separation::none;
    problem.plain = std::move(maximum.newton);
  }
  if (!fits || !problem.fixed.space.dropped.empty()) {
    add_fixed_conditions(input, options, conditions);
    if (has_error(conditions)) {
      return std::nullopt;
    }
  }
  const bool single = is_single_intercept(input);
  for (const RandomEffects& random : input.random) {
    problem.terms.push_back(term_rows(random, problem.fixed.used, !single));
    add_term_conditions(
        random, problem.terms.back(), (problem.fixed.rows.trials.array() <= 1.0).all(), conditions);
  }
  if (has_error(conditions)) {
    return std::nullopt;
  }
  if (single) {
    problem.grouped = grouped_rows(problem.fixed.space.basis,
                                   problem.fixed.rows,
                                   problem.terms[0].codes,
                                   problem.terms[0].levels.size());
  }
  return problem;
}

Eigen::MatrixXd factor_of(const TermRows& term, const Eigen::Ref<const Eigen::VectorXd>& thetas) {
  const Eigen::Index q = term.scale.size();
  Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(q, q);
  Eigen::Index at = 0;
  for (Eigen::Index j = 0; j < q; ++j) {
    const double sign = thetas[at] < 0.0 ? -1.0 : 1.0;
    for (Eigen::Index i = j; i < q; ++i) {
      factor(i, j) = sign * thetas[at++] / term.scale[i];
    }
  }
  return factor;
}

bool is_single_intercept(const GlmmInput& input) noexcept {
  return input.random.size() == 1 && is_intercept(input.random[0]);
}

}  // namespace tcert::statistics
