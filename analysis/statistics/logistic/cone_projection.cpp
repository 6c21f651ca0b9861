#include <statistics/logistic/cone_projection.hpp>

#include <Eigen/QR>
#include <vector>

namespace tcert::statistics {
namespace {

/// A row is on the wrong side if its cosine with the direction is below minus this.
constexpr double kWrongSide = 1e-10;

/// The rows that carry weight, and their weights: target + A(active)' u is the residual.
class ActiveSet {
 public:
  ActiveSet(const Eigen::MatrixXd& rows, const Eigen::VectorXd& target)
      : rows_(rows), target_(target), residual_(target) {}

  [[nodiscard]] const Eigen::VectorXd& residual() const noexcept { return residual_; }
  [[nodiscard]] bool full() const noexcept {
    return static_cast<Eigen::Index>(active_.size()) >= rows_.cols();
  }

  /// Lets row `entering` carry weight and takes weight from those that would need less than none.
  void add(Eigen::Index entering) {
    active_.push_back(entering);
    weights_.push_back(0.0);
    while (!active_.empty()) {
      Eigen::MatrixXd a(rows_.cols(), static_cast<Eigen::Index>(active_.size()));
      for (std::size_t k = 0; k < active_.size(); ++k) {
        a.col(static_cast<Eigen::Index>(k)) = rows_.row(active_[k]).transpose();
      }
      const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a);
      const Eigen::VectorXd wanted = qr.solve(-target_);
      if (wanted.minCoeff() > 0.0) {
        for (std::size_t k = 0; k < active_.size(); ++k) {
          weights_[k] = wanted[static_cast<Eigen::Index>(k)];
        }
        residual_ = target_ + a * wanted;
        // What is left is orthogonal to the active rows; say so again after rounding.
        residual_ -= a * qr.solve(residual_);
        return;
      }
      move_towards(wanted);
    }
    residual_ = target_;
  }

 private:
  /// As far as all weights stay non-negative; drops those that reach 0.
  void move_towards(const Eigen::VectorXd& wanted) {
    double share = 1.0;
    std::size_t blocking = active_.size();
    for (std::size_t k = 0; k < active_.size(); ++k) {
      const double to = wanted[static_cast<Eigen::Index>(k)];
      if (to <= 0.0) {
        const double reach = weights_[k] > to ? weights_[k] / (weights_[k] - to) : 0.0;
        if (blocking == active_.size() || reach < share) {
          share = reach;
          blocking = k;
        }
      }
    }
    std::vector<Eigen::Index> active;
    std::vector<double> weights;
    for (std::size_t k = 0; k < active_.size(); ++k) {
      const double weight =
          weights_[k] + share * (wanted[static_cast<Eigen::Index>(k)] - weights_[k]);
      if (k != blocking && weight > 0.0) {
        active.push_back(active_[k]);
        weights.push_back(weight);
      }
    }
    active_ = std::move(active);
    weights_ = std::move(weights);
  }

  const Eigen::MatrixXd& rows_;
  const Eigen::VectorXd& target_;
  Eigen::VectorXd residual_;
  std::vector<Eigen::Index> active_;
  std::vector<double> weights_;
};

}  // namespace

std::optional<Eigen::VectorXd> project_on_cone(const Eigen::MatrixXd& rows,
                                               const Eigen::VectorXd& target,
                                               double smallest) {
  ActiveSet set(rows, target);
  const Eigen::Index most = 50 * (rows.cols() + 10);
  for (Eigen::Index iteration = 0; iteration < most; ++iteration) {
    const double length = set.residual().norm();
    if (set.full() || length <= smallest) {
      return Eigen::VectorXd::Zero(target.size());
    }
    if (rows.rows() == 0) {
      return set.residual();
    }
    Eigen::Index worst = 0;
    const double margin = (rows * (set.residual() / length)).minCoeff(&worst);
    if (margin >= -kWrongSide) {
      return set.residual();
    }
    set.add(worst);
  }
  return std::nullopt;
}

}  // namespace tcert::statistics
