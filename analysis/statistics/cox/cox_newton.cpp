#include <statistics/cox/cox_newton.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <statistics/basics/linalg.hpp>
#include <statistics/cox/cox_columns.hpp>
#include <statistics/cox/cox_recession.hpp>
#include <utility>

namespace tcert::statistics {
namespace {

constexpr std::size_t kHalvings = 40;
constexpr std::size_t kStalled = 4;   ///< Steps without gain before the fit is judged.
constexpr double kRunaway = 1e-3;     ///< A step as large, without gain, is no rounding.
constexpr double kErrors = 1e-6;      ///< A step of that many standard errors is the last.
constexpr double kMostErrors = 1e-5;  ///< The largest that rounding may leave at the end.
constexpr double kRounding = 1e-13;   ///< Of a log-likelihood: a change as small is rounding.
constexpr double kVanished = 1e-12;   ///< As little is no more than rounding: no step there.
constexpr double kPart = 1e-3;        ///< Of a column's length: it is part of a lost direction.
constexpr double kMoves = 1e-8;       ///< Of the largest: it is part of a certified direction.

/// p x k: directions that span the `kept` columns, with information 1 each at beta = 0.
Eigen::MatrixXd unit_directions(const CoxDerivatives& null, const std::vector<Eigen::Index>& kept) {
  const auto size = static_cast<Eigen::Index>(kept.size());
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(null.score.size(), size);
  if (size == 0) {
    return basis;
  }
  Eigen::MatrixXd information = null.information(kept, kept);
  const Eigen::VectorXd unit = information.diagonal().cwiseSqrt().cwiseInverse();
  information = unit.asDiagonal() * information * unit.asDiagonal();
  const Eigensystem eigen = eigensystem_of(information);
  const Eigen::VectorXd inverse_root = eigen.values.cwiseMax(1e-15).cwiseSqrt().cwiseInverse();
  basis(kept, Eigen::all) = unit.asDiagonal() * eigen.vectors * inverse_root.asDiagonal();
  return basis;
}

/// The information at some coefficients in the unit directions: 1 is what there is at 0.
Eigensystem share_of_information(const CoxDerivatives& at, const Eigen::MatrixXd& basis) {
  return eigensystem_of(basis.transpose() * at.information * basis);
}

/// Solves information step = score for the `kept` columns; 0 for the others. Directions whose share
/// of information is at most `smallest` are not taken.
Eigen::VectorXd newton_step(const CoxDerivatives& at,
                            const std::vector<Eigen::Index>& kept,
                            const Eigen::MatrixXd& basis,
                            double smallest = kVanished) {
  Eigen::VectorXd step = Eigen::VectorXd::Zero(at.score.size());
  if (kept.empty()) {
    return step;
  }
  const auto share = share_of_information(at, basis);
  if (share.values(0) > kLimitTolerance) {
    const Eigen::VectorXd score = at.score(kept);
    const Eigen::MatrixXd information = at.information(kept, kept);
    const Eigen::VectorXd solution = solve_symmetric(information, score);
    step(kept) = solution;
    return step;
  }
  Eigen::VectorXd along = share.vectors.transpose() * (basis.transpose() * at.score);
  for (Eigen::Index k = 0; k < along.size(); ++k) {
    const double left = share.values(k);
    along(k) = left > smallest ? along(k) / left : 0.0;
  }
  return basis * (share.vectors * along);
}

double relative_size(const Eigen::VectorXd& step, const Eigen::VectorXd& beta) {
  return step.size() == 0 ? 0.0 : (step.array().abs() / (1.0 + beta.array().abs())).maxCoeff();
}

/// Columns that have a part in the certified direction, or in one whose information is lost.
void name_infinite(const Eigen::MatrixXd& basis, const Eigensystem& share, CoxMaximum& maximum) {
  Eigen::Index lost = 0;
  while (lost < basis.cols() && share.values(lost) <= kLimitTolerance) {
    ++lost;
  }
  const Eigen::MatrixXd directions = basis * share.vectors.leftCols(lost);
  for (const Eigen::Index j : ranked_columns(maximum.columns)) {
    const double length = basis.row(j).norm();
    if (directions.row(j).norm() > kPart * length ||
        std::abs(maximum.recession(j)) > kMoves * maximum.recession.cwiseAbs().maxCoeff()) {
      maximum.columns[static_cast<std::size_t>(j)] = ColumnState::infinite;
    }
  }
}

/// Says what the end of the iteration is. A fit that has lost the information of a direction is
/// believed only if the data allow a maximum there.
/// \param errors the step that Newton's method would take next, in standard errors.
void judge(const CoxRows& rows,
           Ties ties,
           const Eigen::MatrixXd& basis,
           bool settled,
           double errors,
           CoxMaximum& maximum) {
  const auto share = share_of_information(maximum.fitted, basis);
  const double least = share.values(0);
  CoxTermination& termination = maximum.summary.termination;
  const bool converged = settled && errors <= kMostErrors;
  termination = converged ? CoxTermination::converged : CoxTermination::iteration_limit;
  if (converged && least > kLimitTolerance) {
    return;
  }
  const auto direction =
      recession_direction(rows, ties, basis, basis.transpose() * maximum.null.score);
  if (!direction) {
    termination = least > kVanished ? termination : CoxTermination::iteration_limit;
    return;
  }
  const Eigen::VectorXd rest =
      newton_step(maximum.fitted, ranked_columns(maximum.columns), basis, kLimitTolerance);
  termination = CoxTermination::monotone;
  maximum.recession = *direction;
  if (least > kLimitTolerance || relative_size(rest, maximum.beta) > kRunaway) {
    // Rounding has stopped the fit before its limit: it has no numbers beside the infinite ones.
    maximum.at_limit = false;
    for (const Eigen::Index j : ranked_columns(maximum.columns)) {
      maximum.columns[static_cast<std::size_t>(j)] = ColumnState::infinite;
    }
    return;
  }
  name_infinite(basis, share, maximum);
}

/// The length of the score where a direction of information 1 at beta = 0 has length 1.
double score_length(const CoxDerivatives& at, const Eigen::MatrixXd& basis) {
  return (basis.transpose() * at.score).norm();
}

/// Moves by `step`, halved until the log-likelihood does not fall; false if it always does. Where
/// the step promises less than the log-likelihood's rounding, the score must fall instead.
bool climb(const CoxRows& rows,
           Ties ties,
           const Eigen::MatrixXd& basis,
           Eigen::VectorXd step,
           CoxMaximum& maximum) {
  const double size = std::max(1.0, std::abs(maximum.fitted.loglik));
  // What a sum over the rows may lose.
  const double noise = std::numeric_limits<double>::epsilon() * static_cast<double>(rows.rows());
  const double length = score_length(maximum.fitted, basis);
  for (std::size_t halving = 0; halving < kHalvings; ++halving) {
    const Eigen::VectorXd beta = maximum.beta + step;
    CoxDerivatives next = cox_derivatives(rows, beta, ties);
    const bool is_finite =
        std::isfinite(next.loglik) && next.score.allFinite() && next.information.allFinite();
    const double fall = maximum.fitted.loglik - next.loglik;
    const bool is_small = 0.5 * maximum.fitted.score.dot(step) <= kRounding * size;
    if (is_finite && (fall <= kRounding * size ||
                      (is_small && fall <= noise * size && score_length(next, basis) < length))) {
      maximum.beta = beta;
      maximum.fitted = std::move(next);
      return true;
    }
    step *= 0.5;
  }
  return false;
}

}  // namespace

CoxMaximum maximise(const CoxRows& rows, const CoxOptions& options) {
  CoxMaximum maximum;
  maximum.beta = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows.columns));
  maximum.null = cox_derivatives(rows, maximum.beta, options.ties);
  maximum.fitted = maximum.null;
  maximum.columns = column_states(rows, maximum.null, options.rank_tolerance);
  const std::vector<Eigen::Index> kept = ranked_columns(maximum.columns);

  const Eigen::MatrixXd basis = unit_directions(maximum.null, kept);

  CoxSummary& summary = maximum.summary;
  summary.loglik_tolerance = options.loglik_tolerance;
  summary.step_tolerance = options.step_tolerance;
  summary.rank_tolerance = options.rank_tolerance;
  Eigen::VectorXd step = newton_step(maximum.null, kept, basis);
  std::size_t stalled = 0;
  bool level = kept.empty();
  bool settled = false;
  double errors = 0.0;
  while (true) {
    summary.last_step = relative_size(step, maximum.beta);
    // Newton's decrement: the step in standard errors.
    errors = std::sqrt(std::max(0.0, maximum.fitted.score.dot(step)));
    settled = level && summary.last_step <= options.step_tolerance && errors <= kErrors;
    // A direction that runs away is followed until its information has vanished.
    stalled = level && summary.last_step <= kRunaway ? stalled + 1 : 0;
    if (settled || summary.iterations == options.iterations) {
      break;
    }
    ++summary.iterations;
    const double before = maximum.fitted.loglik;
    if (stalled == kStalled || !climb(rows, options.ties, basis, step, maximum)) {
      // Without gain a small step is rounding.
      settled = summary.last_step <= kRunaway;
      break;
    }
    level = std::abs(maximum.fitted.loglik - before) <=
            options.loglik_tolerance * std::max(1.0, std::abs(before));
    step = newton_step(maximum.fitted, kept, basis);
  }
  if (kept.empty()) {
    summary.termination = CoxTermination::converged;
  } else {
    judge(rows, options.ties, basis, settled, errors, maximum);
  }
  summary.gradient_norm = kept.empty() ? 0.0 : maximum.fitted.score(kept).cwiseAbs().maxCoeff();
  return maximum;
}

}  // namespace tcert::statistics
