#include "analysis/cox/cox_zph.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/cox/cox_likelihood.hpp"
#include "analysis/cox/cox_risk_pass.hpp"
#include "analysis/cox/time_transform.hpp"

namespace tcert {
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
  std::vector<double> score(p);
  std::vector<double> triangle(p * (p + 1) / 2);
  for_each_risk_set(rows, risks, true, [&](const RiskSet& set) {
    std::fill(score.begin(), score.end(), 0.0);
    std::fill(triangle.begin(), triangle.end(), 0.0);
    add_risk_set(rows, set, ties, score, triangle);
    const double at = g[rows.sets.order[rows.sets.events_begin[set.time]]];
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

/// Tests x g(t) for `tested` beside x for all `known` columns.
ChiSquareTest score_test(const ExtendedScore& extended,
                         const std::vector<Eigen::Index>& known,
                         const std::vector<Eigen::Index>& tested) {
  const Eigen::Index p = extended.score.size();
  std::vector<Eigen::Index> columns = known;
  for (const Eigen::Index j : tested) {
    columns.push_back(p + j);
  }
  Eigen::VectorXd score = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < tested.size(); ++k) {
    score(static_cast<Eigen::Index>(known.size() + k)) = extended.score(tested[k]);
  }
  // Powers of g may be far from 1: put every column on its own scale.
  Eigen::MatrixXd information = extended.information(columns, columns);
  const Eigen::VectorXd scale = information.diagonal().cwiseSqrt().cwiseInverse();
  information = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::VectorXd scaled = score.cwiseProduct(scale);
  const Eigen::VectorXd solution = information.ldlt().solve(scaled);
  return chi_square_test(scaled.dot(solution), tested.size());
}

void note_rejection(const std::string& name,
                    const ChiSquareTest& test,
                    ProportionalityTests& result) {
  if (test.p_value < kAlpha) {
    result.conditions.push_back(
        {ConditionKind::not_proportional, ConditionSeverity::note, name, ""});
  }
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
  std::vector<Eigen::Index> known;
  std::vector<std::string> names;
  std::vector<std::vector<Eigen::Index>> parts;
  std::size_t last_term = data.terms.size();
  for (std::size_t j = 0; j < data.columns.size(); ++j) {
    if (!fit.coefficients[j].estimate) {
      continue;
    }
    known.push_back(static_cast<Eigen::Index>(j));
    if (!by_term || parts.empty() || data.term_of[j] != last_term) {
      names.push_back(by_term ? data.terms[data.term_of[j]] : data.columns[j]);
      parts.emplace_back();
    }
    last_term = data.term_of[j];
    parts.back().push_back(static_cast<Eigen::Index>(j));
  }
  if (known.empty()) {
    return result;
  }
  const CoxRows rows = cox_rows(data);
  const ExtendedScore extended = extended_score(rows,
                                                fit.beta.cwiseProduct(rows.scale),
                                                fit.ties,
                                                transformed_times(data.outcome, transform));
  for (std::size_t k = 0; k < parts.size(); ++k) {
    result.parts.push_back({names[k], score_test(extended, known, parts[k])});
    note_rejection(names[k], result.parts.back().test, result);
  }
  result.global = score_test(extended, known, known);
  note_rejection("", result.global, result);
  return result;
}

}  // namespace tcert
