#include <statistics/cox/cox_zph.hpp>

#include <algorithm>
#include <cmath>
#include <statistics/basics/wald_chi_squared.hpp>
#include <statistics/cox/cox_likelihood.hpp>
#include <statistics/cox/cox_risk_pass.hpp>
#include <statistics/cox/time_transform.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

constexpr double kAlpha = 0.05;

/// Score of x g(t), and the information of (x, x g(t)), in scaled columns.
struct ExtendedScore {
  Eigen::VectorXd score;        ///< p.
  Eigen::MatrixXd information;  ///< 2p x 2p.
};

/// `g` per row of the data.
ExtendedScore extended_score(const CoxRows& rows,
                             const Eigen::VectorXd& beta,
                             Ties ties,
                             const std::vector<double>& g) {
  const std::size_t p = rows.columns;
  const auto size = static_cast<Eigen::Index>(p);
  RiskScores risks;
  risk_scores(rows, beta, risks);
  ExtendedScore sum{Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Zero(2 * size, 2 * size)};
  // About its mean: far from 0 x g(t) is x but for a factor.
  double centre = 0.0;
  for (std::size_t t = 0; t < rows.sets.times(); ++t) {
    centre +=
        g[rows.sets.order[rows.sets.events_begin[t]]] / static_cast<double>(rows.sets.times());
  }
  std::vector<double> score(p);
  std::vector<double> triangle(p * (p + 1) / 2);
  for_each_risk_set(rows, risks, true, [&](const RiskSet& set) {
    std::fill(score.begin(), score.end(), 0.0);
    std::fill(triangle.begin(), triangle.end(), 0.0);
    add_risk_set(rows, set, ties, score, triangle);
    const double at = g[rows.sets.order[rows.sets.events_begin[set.time]]] - centre;
    const double* value = triangle.data();
    for (Eigen::Index a = 0; a < size; ++a) {
      sum.score(a) += at * score[static_cast<std::size_t>(a)];
      for (Eigen::Index b = 0; b <= a; ++b) {
        const double information = *value++;
        sum.information(a, b) += information;
        sum.information(size + a, b) += at * information;
        sum.information(size + a, size + b) += at * at * information;
      }
    }
  });
  for (Eigen::Index a = 0; a < size; ++a) {
    for (Eigen::Index b = 0; b < a; ++b) {
      sum.information(size + b, a) = sum.information(size + a, b);
    }
  }
  sum.information = Eigen::MatrixXd(sum.information.selfadjointView<Eigen::Lower>());
  return sum;
}

/// Tests x g(t) for `tested` beside x for all `known` columns, on `df` degrees of freedom.
std::optional<ChiSquareTest> score_test(const ExtendedScore& extended,
                                        const std::vector<Eigen::Index>& known,
                                        const std::vector<Eigen::Index>& tested,
                                        std::size_t df) {
  const Eigen::Index p = extended.score.size();
  std::vector<Eigen::Index> columns = known;
  for (const Eigen::Index j : tested) {
    columns.push_back(p + j);
  }
  Eigen::VectorXd score = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < tested.size(); ++k) {
    score(static_cast<Eigen::Index>(known.size() + k)) = extended.score(tested[k]);
  }
  const auto form = wald_test(score, extended.information(columns, columns));
  return form && !tested.empty() ? std::optional(chi_square_test(form->statistic, df))
                                 : std::nullopt;
}

/// Without a column to test there is nothing that could be singular.
void note_rejection(const std::string& name,
                    bool is_tested,
                    const std::optional<ChiSquareTest>& test,
                    ProportionalityTests& result) {
  if (is_tested && !test) {
    result.conditions.push_back({ConditionKind::singular_information,
                                 ConditionSeverity::warning,
                                 name,
                                 "no test of proportional hazards"});
  }
  if (test && test->p_value < kAlpha) {
    result.conditions.push_back(
        {ConditionKind::not_proportional, ConditionSeverity::note, name, ""});
  }
}

/// A term or a column: those of its columns that are tested, and how many have a part in the
/// likelihood.
struct Part {
  std::string name;
  std::vector<Eigen::Index> tested;
  std::size_t df = 0;
};

/// At a finite maximum: one that has run away has no estimate that is told, but a score as any.
bool is_finite(const CoxFit& fit, std::size_t column) {
  const auto j = static_cast<Eigen::Index>(column);
  const CoxCoefficient& coefficient = fit.coefficients[column];
  return coefficient.estimate || (!coefficient.is_infinite && fit.limit_model_vcov(j, j) > 0.0);
}

std::vector<Part> parts_of(const CoxData& data, const CoxFit& fit, bool by_term) {
  std::vector<Part> parts;
  std::size_t last_term = data.terms.size();
  for (std::size_t j = 0; j < data.columns.size(); ++j) {
    const bool tested = is_finite(fit, j);
    if (!tested && !fit.coefficients[j].is_infinite) {
      continue;
    }
    if (!by_term || parts.empty() || data.term_of[j] != last_term) {
      parts.push_back({by_term ? data.terms[data.term_of[j]] : data.columns[j], {}, 0});
    }
    last_term = data.term_of[j];
    ++parts.back().df;
    if (tested) {
      parts.back().tested.push_back(static_cast<Eigen::Index>(j));
    }
  }
  return parts;
}

}  // namespace

std::string_view to_string(TimeTransform transform) noexcept {
  switch (transform) {
    case TimeTransform::km:
      return "km";
    case TimeTransform::rank:
      return "rank";
    case TimeTransform::identity:
      return "identity";
    case TimeTransform::log:
      return "log";
  }
  return "";
}

ProportionalityTests cox_zph(const CoxData& data,
                             const CoxFit& fit,
                             TimeTransform transform,
                             bool by_term) {
  if (fit.ties == Ties::exact) {
    throw std::invalid_argument("Test of proportional hazards: not with exact ties");
  }
  ProportionalityTests result;
  result.transform = transform;
  if (fit.summary.termination == CoxTermination::no_fit) {
    result.conditions = fit.conditions;
    return result;
  }
  const std::vector<Part> parts = parts_of(data, fit, by_term);
  // What has information in the limit, and of that the coefficients that are finite.
  std::vector<Eigen::Index> known;
  std::vector<Eigen::Index> finite;
  for (Eigen::Index j = 0; j < fit.beta.size(); ++j) {
    if (fit.limit_model_vcov(j, j) > 0.0) {
      known.push_back(j);
    }
    if (is_finite(fit, static_cast<std::size_t>(j))) {
      finite.push_back(j);
    }
  }
  if (parts.empty()) {
    return result;
  }
  const CoxRows rows = cox_rows(data);
  const ExtendedScore extended = extended_score(rows,
                                                fit.beta.cwiseProduct(rows.scale),
                                                fit.ties,
                                                transformed_times(data.outcome, transform));
  for (const Part& part : parts) {
    result.parts.push_back({part.name, score_test(extended, known, part.tested, part.df)});
    note_rejection(part.name, !part.tested.empty(), result.parts.back().test, result);
  }
  result.global = score_test(extended, known, finite, fit.df);
  note_rejection("", !finite.empty(), result.global, result);
  return result;
}

}  // namespace tcert::statistics
