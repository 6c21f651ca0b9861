#include <statistics/logistic/cone_projection.hpp>

#include <utility>

namespace tcert::statistics {
namespace {

/// A row is on the wrong side if its cosine with the direction is below minus this.
constexpr double kWrongSide = 1e-10;

/// What is left of `vector` beside the orthonormal columns; a second time for what rounding leaves.
template <class Columns>
Eigen::VectorXd beside(const Columns& columns, Eigen::VectorXd vector) {
  vector -= columns * (columns.transpose() * vector);
  vector -= columns * (columns.transpose() * vector);
  return vector;
}

}  // namespace

ConeProjection::ConeProjection(Eigen::VectorXd target)
    : target_(std::move(target)),
      residual_(target_),
      orthogonal_(target_.size(), target_.size()),
      triangle_(target_.size(), target_.size()) {}

/// \pre `active_` has the row already, as its last.
void ConeProjection::append(const Eigen::VectorXd& row) {
  const Eigen::Index k = size() - 1;
  const auto known = orthogonal_.leftCols(k);
  const Eigen::VectorXd rest = beside(known, row);
  triangle_.col(k).head(k) = known.transpose() * row;
  triangle_(k, k) = rest.norm();
  orthogonal_.col(k) = rest / triangle_(k, k);
}

/// Lets row `entering` carry weight and takes weight from those that would need less than none.
void ConeProjection::let_in(const Eigen::MatrixXd& rows, Eigen::Index entering) {
  active_.push_back(entering);
  weights_.push_back(0.0);
  append(rows.row(entering).transpose());
  while (!active_.empty()) {
    const auto columns = orthogonal_.leftCols(size());
    const Eigen::VectorXd wanted = triangle_.topLeftCorner(size(), size())
                                       .triangularView<Eigen::Upper>()
                                       .solve(columns.transpose() * -target_);
    if (wanted.minCoeff() > 0.0) {
      weights_.assign(wanted.begin(), wanted.end());
      residual_ = beside(columns, target_);
      return;
    }
    move_towards(rows, wanted);
  }
  residual_ = target_;
}

/// As far as all weights stay non-negative; drops those that reach 0.
void ConeProjection::move_towards(const Eigen::MatrixXd& rows, const Eigen::VectorXd& wanted) {
  double share = 1.0;
  std::size_t blocking = active_.size();
  for (std::size_t k = 0; k < active_.size(); ++k) {
    const double to = wanted[static_cast<Eigen::Index>(k)];
    // A number that is none, of rows that depend on each other, blocks too.
    if (!(to > 0.0)) {
      const double reach = weights_[k] > to ? weights_[k] / (weights_[k] - to) : 0.0;
      if (blocking == active_.size() || reach < share) {
        share = reach;
        blocking = k;
      }
    }
  }
  const std::vector<Eigen::Index> active = std::exchange(active_, {});
  const std::vector<double> weights = std::exchange(weights_, {});
  for (std::size_t k = 0; k < active.size(); ++k) {
    const double weight = weights[k] + share * (wanted[static_cast<Eigen::Index>(k)] - weights[k]);
    if (k == blocking || !(weight > 0.0)) {
      continue;
    }
    active_.push_back(active[k]);
    weights_.push_back(weight);
    // The factors stand up to the first row that is gone.
    if (active_.size() <= k) {
      append(rows.row(active[k]).transpose());
    }
  }
}

std::optional<Eigen::VectorXd> ConeProjection::onto(const Eigen::MatrixXd& rows, double smallest) {
  const Eigen::Index most = 50 * (target_.size() + 10);
  for (Eigen::Index iteration = 0; iteration < most; ++iteration) {
    const double length = residual_.norm();
    if (size() >= target_.size() || length <= smallest) {
      return Eigen::VectorXd::Zero(target_.size());
    }
    if (rows.rows() == 0) {
      return residual_;
    }
    Eigen::Index worst = 0;
    const double margin = (rows * (residual_ / length)).minCoeff(&worst);
    if (margin >= -kWrongSide) {
      return residual_;
    }
    let_in(rows, worst);
  }
  return std::nullopt;
}

std::optional<Eigen::VectorXd> project_on_cone(const Eigen::MatrixXd& rows,
                                               const Eigen::VectorXd& target,
                                               double smallest) {
  return ConeProjection(target).onto(rows, smallest);
}

}  // namespace tcert::statistics
