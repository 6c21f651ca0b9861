#include <statistics/lmm/lmm_spread.hpp>

#include <cmath>
#include <statistics/basics/linalg.hpp>

namespace tcert::statistics {
namespace {

/// Second derivatives of the deviance at unprofiled sigma, by the elements and sigma.
Eigen::MatrixXd deviance_hessian(LmmLikelihood& likelihood,
                                 const Eigen::VectorXd& thetas,
                                 const LmmPoint& at,
                                 double sigma) {
  constexpr double kStep = 1e-3;
  const Eigen::Index count = thetas.size();
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(count + 1, count + 1);
  for (Eigen::Index j = 0; j < count; ++j) {
    for (const int shift : {-2, -1, 1, 2}) {
      Eigen::VectorXd moved = thetas;
      moved[j] += shift * kStep;
      LmmPoint there;
      if (!likelihood.parts_at(moved, true, there)) {
        continue;
      }
      const double weight = (std::abs(shift) == 1 ? 8.0 * shift : -0.5 * shift) / (12.0 * kStep);
      hessian.col(j).head(count) +=
          weight * (there.determinant_slope + there.residual_slope / (sigma * sigma));
    }
    hessian(count, j) = -2.0 * at.residual_slope[j] / std::pow(sigma, 3);
  }
  hessian.topLeftCorner(count, count) =
      0.5 * (hessian.topLeftCorner(count, count) +
             Eigen::MatrixXd(hessian.topLeftCorner(count, count).transpose()));
  hessian.col(count).head(count) = hessian.row(count).head(count).transpose();
  hessian(count, count) =
      (6.0 * at.residual / (sigma * sigma) - 2.0 * likelihood.df()) / (sigma * sigma);
  return hessian;
}

/// The inverse; directions without curvature count as known.
Eigen::MatrixXd inverse_where_curved(const Eigen::MatrixXd& hessian) {
  const Eigensystem system = eigensystem_of(hessian);
  const double least = 1e-10 * system.values.maxCoeff();
  const Eigen::VectorXd inverse =
      system.values.unaryExpr([least](double value) { return value > least ? 1.0 / value : 0.0; });
  return system.vectors * inverse.asDiagonal() * system.vectors.transpose();
}

}  // namespace

void add_spread(LmmLikelihood& likelihood,
                const Eigen::VectorXd& thetas,
                const Eigen::MatrixXd& back,
                const std::vector<std::size_t>& kept,
                LmmFit& fit) {
  LmmPoint at;
  if (!likelihood.parts_at(thetas, true, at)) {
    return;
  }
  const double sigma = fit.residual_sd;
  const std::vector<Eigen::Index> places(kept.begin(), kept.end());
  const Eigen::MatrixXd inverse =
      kept.empty() ? Eigen::MatrixXd(0, 0) : Cholesky(at.information).inverse();
  const auto placed = [&](const Eigen::MatrixXd& along) {
    Eigen::MatrixXd all =
        Eigen::MatrixXd::Constant(fit.covariance.rows(), fit.covariance.cols(), std::nan(""));
    all(places, places) = back * along * back.transpose();
    return all;
  };
  fit.covariance = placed(sigma * sigma * inverse);
  for (const Eigen::MatrixXd& slope : at.information_slopes) {
    fit.covariance_slopes.push_back(placed(-sigma * sigma * inverse * slope * inverse));
  }
  fit.covariance_slopes.push_back(placed(2.0 * sigma * inverse));
  fit.parameter_covariance =
      2.0 * inverse_where_curved(deviance_hessian(likelihood, thetas, at, sigma));
}

ClusterT lmm_contrast(const LmmFit& fit, const Eigen::VectorXd& weights) {
  std::vector<Eigen::Index> places;
  double estimate = 0.0;
  for (Eigen::Index j = 0; j < weights.size(); ++j) {
    if (weights[j] != 0.0) {
      const auto& one = fit.coefficients[static_cast<std::size_t>(j)];
      if (!one.estimate) {
        return {};
      }
      estimate += weights[j] * *one.estimate;
      places.push_back(j);
    }
  }
  const Eigen::VectorXd own = weights(places);
  const auto form = [&](const Eigen::MatrixXd& matrix) {
    return own.dot(matrix(places, places) * own);
  };
  const double variance = form(fit.covariance);
  Eigen::VectorXd slope(static_cast<Eigen::Index>(fit.covariance_slopes.size()));
  for (Eigen::Index k = 0; k < slope.size(); ++k) {
    slope[k] = form(fit.covariance_slopes[static_cast<std::size_t>(k)]);
  }
  const double df = 2.0 * variance * variance / slope.dot(fit.parameter_covariance * slope);
  return by_student_t(estimate, std::sqrt(variance), df, fit.options.level);
}

}  // namespace tcert::statistics
